#pragma once
/// @file
/// A meshed part in a floating frame: interfaces and modes of the mesh, inertia by integrals.

#include <mutex>

#include "mbs/bodies/floating.hpp"
#include "mbs/solids/mode_derivative.hpp"
#include "mbs/solids/reduction.hpp"
#include "mbs/solids/solid_spec.hpp"

namespace liesl {

/// The frame H_0 is that of the first interface, which the mesh is held at, so that its own
/// displacement is zero. Material points are at x_0 + R_0 r, r = s + phi e; with the velocity
/// w = v + omega x r + phi edot in the axes of the frame, T = int rho |w|^2 / 2 is integrated
/// exactly (Shabana 2013, ch. 5; the integrals are those of `InertiaIntegrals`):
///   a = v' + omega x v - g + (alpha~ + omega~ omega~) r + 2 omega~ phi edot + phi eddot,
///   f_v = int rho a,  f_omega = int rho r x a,  q = int rho phi^T a,
/// centrifugal and Coriolis forces and the weight of the modes among them. Elasticity is linear:
/// K_e has no stiffening by stress.
///
/// Nodes: the interfaces, then `slots` of amplitudes, which are at the first interface.
template <FrameGroup G>
class SolidBody : public FloatingBody<G> {
 public:
  using Body<G>::dim;
  using typename Body<G>::Tangent;
  using typename Body<G>::Vector;

  /// @param ports frames of the interfaces  @param turn components in their axes from components
  /// in the axes of the mesh
  /// @throws std::invalid_argument for a part that cannot be built, std::runtime_error if its
  /// modes are not found
  SolidBody(std::string body_name, const SolidSpec& spec, std::vector<G> ports,
            const Eigen::Matrix3d& turn);

  /// The body as a mesh in a floating frame, null if it is none.
  static const SolidBody* of(const Body<G>& body) { return dynamic_cast<const SolidBody*>(&body); }
  int points() const override { return ports_; }
  /// The mesh, and how much of its cells is material.
  const SolidModel& model() const { return *model_; }
  const Eigen::VectorXd& fractions() const { return fractions_; }
  std::unique_ptr<BodyWorkspace> make_workspace() const override;
  void complete(G* H, double* v, double* vdot, const double* w) const override;
  double damping() const override { return damping_; }
  BodyEnergy energy(const BodyState<G>& s, const Vector& gravity) const override;
  double dissipation(const BodyState<G>& s) const override;
  double total_mass() const override { return integrals_.mass; }
  double axial_stiffness() const override;
  std::unique_ptr<Body<G>> derivative(const LawDerivative<G>& law) const override;
  void add_energy_gradient(const BodyState<G>& s, const Vector& gravity, const BodyEnergy& weight,
                           double* h, double* v) const override;

  Eigen::VectorXd stress_shares() const override { return shares_; }
  Eigen::MatrixXd cell_stresses(const BodyState<G>& s) const override;
  Eigen::VectorXd cell_stress(const BodyState<G>& s, int cell) const override;
  void add_cell_stress_gradient(const BodyState<G>& s, int cell, const Eigen::VectorXd& f,
                                double* h) const override;

  /// e = [u_i; eta] at a state, without padding: the displacements of the mesh are basis() * e.
  Eigen::VectorXd coordinates(const BodyState<G>& s) const;
  /// Adds the gradient of c . e by the unknowns of the body to h [size()].
  void add_coordinates_gradient(const BodyState<G>& s, const Eigen::VectorXd& c, double* h) const;
  /// Psi, in the coordinates q of SolidModel and the axes of the mesh, seen from the frame.
  const Eigen::MatrixXd& basis() const { return basis_; }
  /// Lowest elastic frequencies of the free body, Hz, with the motions of its ports and the first
  /// `kept` of its internal modes as unknowns; all of them if it has fewer than `count`.
  Eigen::VectorXd free_frequencies(int count, int kept) const;
  /// K(v) Psi: the loads f = K Psi e in q whose static answer is the displacement Psi e.
  const Eigen::MatrixXd& loads() const { return loads_; }

 protected:
  using typename FloatingBody<G>::Motion;

  /// Derivatives of the inertia force by e and by [v_0; edot].
  virtual Eigen::MatrixXd inertia_by_e(const Motion& m, const Tangent& v_0,
                                       const Tangent& a_0) const;
  virtual Eigen::MatrixXd inertia_by_rates(const Motion& m, const Tangent& v_0) const;
  /// dT/de at constant velocities [v_0; edot].
  virtual Eigen::VectorXd kinetic_by_e(const Motion& m, const Tangent& v_0) const;

  Eigen::Vector3d origin_;  ///< first interface, in the axes of the mesh
  Eigen::Matrix3d turn_;    ///< axes of the mesh to those of the ports
  /// About the first interface, in its axes; mode is 3 x n, padded.
  InertiaIntegrals integrals_;

 private:
  using typename FloatingBody<G>::InertiaTangents;

  /// The derivative of a body by fractions of cells, which Psi follows.
  SolidBody(const SolidBody& body, const FractionDerivative& law);
  /// By a scale of all its matrices, which the modes do not notice.
  SolidBody(const SolidBody& body, const ScaleDerivative& law);
  Eigen::MatrixXd basis_derivative(const FractionDerivative& law) const;
  /// Stress of a cell from e, Pa: 3 or 6 x n.
  Eigen::MatrixXd stress_basis(int cell) const;
  void set_integrals(const InertiaIntegrals& mesh);

  struct Room final : FloatingBody<G>::Workspace {
    Eigen::MatrixXd C, D;  ///< 9 x n: moments at e, and their share that goes with the rates
  };
  /// int rho r phi_k^T at e, a column each (3 x 3 by columns).
  Eigen::MatrixXd moments(const Eigen::VectorXd& e) const;
  void inertia_force(const Motion& m, const Tangent& v_0, const Tangent& a_0, Tangent& f_0,
                     Eigen::VectorXd& q, ForceScale& scale,
                     typename FloatingBody<G>::Workspace& work) const override;
  Eigen::MatrixXd inertia_matrix(const Motion& m) const override;
  InertiaTangents inertia_tangents(const Motion& m, const Tangent& v_0,
                                   const Tangent& a_0) const override;

  int ports_;
  double damping_;
  std::shared_ptr<const SolidModel> model_;
  Eigen::VectorXd fractions_;  ///< of cells; by an outline: their derivative
  Eigen::VectorXd shares_;     ///< of the stress that cells show; of a derivative: theirs
  /// Psi and K Psi; of a derivative what has the derivative of the stresses: Psi', or Psi E'/E.
  Eigen::MatrixXd basis_, loads_;
  Eigen::MatrixXd M_e_;  ///< of edot, padded as e
  /// Of the parameters that were asked for last: its factor is theirs in common.
  mutable std::shared_ptr<const ModeDerivative> modes_;
  mutable std::shared_ptr<std::mutex> asking_ = std::make_shared<std::mutex>();
  Eigen::MatrixXd cross_;    ///< 9 x n: int rho s phi_k^T
  Eigen::MatrixXd product_;  ///< 9 n x n: int rho phi_l phi_k^T at rows 9 k, column l
};

extern template class SolidBody<SE2>;
extern template class SolidBody<SE3>;

}  // namespace liesl
