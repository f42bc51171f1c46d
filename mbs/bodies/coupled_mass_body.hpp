#pragma once
/// @file
/// A part given by matrices whose mass couples components or nodes with rotations, as those of a
/// static condensation: the mass in a floating frame is that of all its motions.

#include "mbs/bodies/solid_body.hpp"

namespace liesl {

/// `SolidBody` with the inertia of T = y^T W^T M W y / 2, y = [v; omega; edot; omega_b e]
/// (`motion_mass`), in the place of integrals over a mesh. With p = W^T M W y, and momenta
/// pi = dT/d[v; omega; edot], in which L_b = p_b + e . p_(omega_b e):
///   f_0 = d[P; L]/dt - ad(v_0)^T [P; L],  q = p_edot' - sum_b omega_b p_(omega_b e),
/// the equations of Poincare and Lagrange, so that energy is kept. Where components are not coupled
/// both are the same to round-off.
template <FrameGroup G>
class CoupledMassBody final : public SolidBody<G> {
 public:
  using Body<G>::dim;
  using typename Body<G>::Tangent;

  /// As of SolidBody.  @pre spec.model->coupled_mass()
  CoupledMassBody(std::string body_name, const SolidSpec& spec, std::vector<G> ports,
                  const Eigen::Matrix3d& turn);

  std::unique_ptr<BodyWorkspace> make_workspace() const override;
  /// @throws std::invalid_argument: matrices have no parameters
  std::unique_ptr<Body<G>> derivative(const LawDerivative<G>& law) const override;

 private:
  using typename SolidBody<G>::Motion;
  static constexpr int kTurns = G::rotation_dim;

  struct Room final : FloatingBody<G>::Workspace {
    Eigen::MatrixXd y, p;  ///< y and its rate, and the mass times them
  };
  void inertia_force(const Motion& m, const Tangent& v_0, const Tangent& a_0, Tangent& f_0,
                     Eigen::VectorXd& q, ForceScale& scale,
                     typename FloatingBody<G>::Workspace& work) const override;
  Eigen::MatrixXd inertia_matrix(const Motion& m) const override;
  Eigen::MatrixXd inertia_by_e(const Motion& m, const Tangent& v_0,
                               const Tangent& a_0) const override;
  Eigen::MatrixXd inertia_by_rates(const Motion& m, const Tangent& v_0) const override;
  Eigen::VectorXd kinetic_by_e(const Motion& m, const Tangent& v_0) const override;

  Eigen::Index n() const { return this->reduced_size(); }
  /// First of the numbers omega_b e in y.
  Eigen::Index at(int b) const { return dim + (1 + b) * n(); }
  /// y of velocities and e, and the part of its rate that is of products of velocities.
  void set_motion(const Motion& m, const Tangent& v_0, const Tangent& a_0,
                  Eigen::MatrixXd& y) const;
  /// J: y = J [v_0; edot] at e, or its rate if e is edot.
  Eigen::MatrixXd by_velocities(const Eigen::VectorXd& e, bool rate) const;

  Eigen::MatrixXd mass_;  ///< W^T M W, e padded
};

extern template class CoupledMassBody<SE2>;
extern template class CoupledMassBody<SE3>;

}  // namespace liesl
