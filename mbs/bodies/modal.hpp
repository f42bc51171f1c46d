#pragma once
/// @file
/// A beam in a floating frame. With all modes it is the linear finite element model in a moving
/// frame.

#include "mbs/bodies/beam.hpp"
#include "mbs/bodies/floating.hpp"

namespace liesl {

/// Inertia is that of the finite element nodes, to first order in their displacements:
///   v_k = (I - ad(u_k)) Ad(X_k^-1) v_0 + (I - ad(u_k)/2) Psi_k edot.
template <FrameGroup G>
class ModalBody final : public FloatingBody<G> {
 public:
  using Body<G>::dim;
  using typename Body<G>::Tangent;
  using typename Body<G>::Vector;
  using typename Body<G>::Matrices;

  /// @param beam the linear finite element model  @param interfaces nodes that couplings and loads
  /// hold on to  @param modes internal modes kept, lowest first; < 0 = all
  ModalBody(std::unique_ptr<Beam<G>> beam, const std::vector<int>& interfaces, int modes);

  /// The body as a beam in a floating frame, null if it is none.
  static const ModalBody* of(const Body<G>& body) { return dynamic_cast<const ModalBody*>(&body); }

  std::unique_ptr<BodyWorkspace> make_workspace() const override;
  void complete(G* H, double* v, double* vdot, const double* w) const override;
  int elements() const override { return beam_->elements(); }
  double damping() const override { return beam_->damping(); }
  const Beam<G>& beam() const { return *beam_; }

  const Matrices& free_stiffness() const override { return beam_->stiffness(); }
  void add_elastic_force(const G* H, double* f) const override;
  Eigen::MatrixXd load_share(bool follower) const override;
  /// Displacements of all nodes in the floating frame, [u_k; w_k] in their own axes, from the
  /// frames of a completed state.
  Eigen::VectorXd displacements(const G* H) const;
  /// Of a completed state; linear in the displacements.
  Tangent strain(const BodyState<G>& s, int e) const override;
  Tangent section_force(const BodyState<G>& s, int e, ElementPlace at) const override;
  BodyEnergy energy(const BodyState<G>& s, const Vector& gravity) const override;
  double dissipation(const BodyState<G>& s) const override;
  double total_mass() const override { return beam_->total_mass(); }
  double axial_stiffness() const override { return beam_->axial_stiffness(); }
  std::unique_ptr<Body<G>> derivative(const LawDerivative<G>& law) const override;
  void add_section_force_gradient(const BodyState<G>& s, int e, ElementPlace at, const Tangent& f,
                                  double* h) const override;
  void add_energy_gradient(const BodyState<G>& s, const Vector& gravity, const BodyEnergy& weight,
                           double* h, double* v) const override;
  void to_unknowns(const BodyState<G>& s, double* h, double* v) const override;
  void rates_to_unknowns(const BodyState<G>& s, double* h, double* v, double* vdot) const override;
  /// Psi: displacements of all nodes from e, [u_k; w_k] in their own axes.
  const Eigen::MatrixXd& basis() const { return Psi_; }

 private:
  /// The derivative of a body with the derivative of its beam: the same Psi.
  ModalBody(const ModalBody& body, std::unique_ptr<Beam<G>> beam);
  using typename FloatingBody<G>::Motion;
  using typename FloatingBody<G>::InertiaTangents;
  using FloatingBody<G>::X_;

  void inertia_force(const Motion& m, const Tangent& v_0, const Tangent& a_0, Tangent& f_0,
                     Eigen::VectorXd& q, ForceScale& scale,
                     typename FloatingBody<G>::Workspace& work) const override;
  Eigen::MatrixXd inertia_matrix(const Motion& m) const override;
  InertiaTangents inertia_tangents(const Motion& m, const Tangent& v_0,
                                   const Tangent& a_0) const override;
  void reduce(std::vector<NodeKind> kind, int modes);
  /// Displacements of all nodes and their rates, Psi times those of e.
  struct Field {
    Eigen::VectorXd u, du, ddu;
  };
  struct Room final : FloatingBody<G>::Workspace {
    Field field;
    Eigen::VectorXd full, velocity, acceleration;  ///< of all nodes
  };
  void spread(const Motion& m, Field& field) const;
  using Blocks = typename Matrices::Blocks;  ///< one a node
  /// Pi^T, velocities of all nodes = Pi [v_0; edot] at displacements u.
  Eigen::MatrixXd velocity_map(const Eigen::VectorXd& u) const;
  /// Velocities and accelerations of all nodes.
  void nodal_rates(const Field& field, const Tangent& v0, const Tangent& a0, Eigen::VectorXd& v,
                   Eigen::VectorXd& a) const;
  /// Velocity of node k, and its rate from the acceleration a_0 of the frame.
  Tangent velocity(int k, const Field& field, const Tangent& v0) const;
  Tangent acceleration(int k, const Field& field, const Tangent& v0, const Tangent& a0) const;

  std::unique_ptr<Beam<G>> beam_;
  std::vector<typename G::Matrix, Eigen::aligned_allocator<typename G::Matrix>> A_;  ///< Ad(X^-1)
  Eigen::MatrixXd Psi_;    ///< size x [interfaces, amplitudes]
  Eigen::MatrixXd Psi_t_;  ///< Psi^T: blocks of nodes act on its columns
};

extern template class ModalBody<SE2>;
extern template class ModalBody<SE3>;

}  // namespace liesl
