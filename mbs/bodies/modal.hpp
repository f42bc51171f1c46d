#pragma once
/// @file
/// Floating frame of reference: a flexible body that is linear in a frame that moves with it,
/// reduced to the frames it is held at and to modes (Craig, Bampton 1968; Shabana 2013,
/// "Dynamics of Multibody Systems", chapter 5). With all modes it is the linear finite element
/// model in a moving frame.
///
/// The floating frame is the body's first node, H_0. The further interface frames H_i are unknowns
/// of their own, so that couplings hold on to them as to any node:
///   u_i = log(X_i^-1 H_0^-1 H_i),  X_k = H_0^-1 H_k at reference,  e = [u_i; eta],  u = Psi e,
/// Psi = [static shapes of unit u_i, modes with all interfaces held], V = e^T K_e e / 2 with K_e
/// constant. Inertia is that of the finite element nodes, to first order in their displacements:
///   v_k = (I - ad(u_k)) Ad(X_k^-1) v_0 + (I - ad(u_k)/2) Psi_k edot.

#include <memory>

#include "mbs/bodies/beam.hpp"

namespace liesl {

template <FrameGroup G>
class ModalBody final : public Body<G> {
 public:
  using Body<G>::dim;
  using typename Body<G>::Tangent;
  using typename Body<G>::Vector;
  using typename Body<G>::Matrices;

  /// @param beam the linear finite element model  @param interfaces nodes that couplings and loads
  /// hold on to  @param modes internal modes kept, lowest first; < 0 = all
  ModalBody(std::unique_ptr<Beam<G>> beam, const std::vector<int>& interfaces, int modes);

  NodeKind kind(int node) const override { return kind_[node]; }
  void complete(G* H, double* v, double* vdot, const double* w) const override;
  int elements() const override { return beam_->elements(); }
  double damping() const override { return beam_->damping(); }
  const Beam<G>& beam() const { return *beam_; }
  int modes() const { return static_cast<int>(omega2_.size()); }
  /// Squares of the circular frequencies of the internal modes, 1/s^2.
  const Eigen::VectorXd& omega2() const { return omega2_; }

  void add_inertia(const BodyState<G>& s, const Vector& gravity, double* r,
                   ForceScale& scale) const override;
  void add_internal(const BodyState<G>& s, double* r, ForceScale& scale) const override;
  /// With the mass at this state, and K_e. The mass matters where the frame is held by a hinge: a
  /// turn of the frame is then nearly a motion of the modes, and the mass at reference nearly
  /// singular.
  void exact_tangent(const BodyState<G>& s, const Vector& gravity, TangentWeights w,
                     const Tangent* stress, Matrices& A) const override;
  Eigen::MatrixXd load_share(bool follower) const override;
  /// Displacements of all nodes in the floating frame, [u_k; w_k] in their own axes, from the
  /// frames of a completed state.
  Eigen::VectorXd displacements(const G* H) const;
  /// Of a completed state; linear in the displacements.
  Tangent strain(const BodyState<G>& s, int e) const override;
  Tangent section_force(const BodyState<G>& s, int e) const override;
  BodyEnergy energy(const BodyState<G>& s, const Vector& gravity) const override;
  double total_mass() const override { return beam_->total_mass(); }
  double axial_stiffness() const override { return beam_->axial_stiffness(); }

 private:
  /// Unknowns of the reduced body and their rates at one state.
  struct Motion {
    Eigen::VectorXd e, rate, acceleration;          ///< [u_i; eta]
    Eigen::VectorXd u, du, ddu;                     ///< Psi of them
    std::vector<G, Eigen::aligned_allocator<G>> Y;  ///< H_0^-1 H_i
  };

  void reduce(int modes);
  void set_constant_matrices();
  void set_matrix(const Motion& m, double mass, double stiffness, Matrices& A) const;
  void measure(const BodyState<G>& s, bool rates, Motion& m) const;
  /// r += forces q conjugate to e, on the interfaces, the frame and the amplitudes.
  void add_conjugate(const Motion& m, const Eigen::VectorXd& q, double* r, ForceScale& scale) const;
  /// E: d[u_i; eta] = E [h_0; h_i; deta].
  Eigen::MatrixXd increments(const Motion& m) const;
  /// Velocity of node k, and its rate from the acceleration a_0 of the frame.
  Tangent velocity(const Motion& m, int k, const Tangent& v0) const;
  Tangent acceleration(const Motion& m, int k, const Tangent& v0, const Tangent& a0) const;
  int interface_size() const { return dim * static_cast<int>(interfaces_.size()); }

  std::unique_ptr<Beam<G>> beam_;
  std::vector<NodeKind> kind_;
  std::vector<int> interfaces_, slots_;  ///< nodes: without node 0; that hold amplitudes
  std::vector<G, Eigen::aligned_allocator<G>> X_;
  std::vector<typename G::Matrix, Eigen::aligned_allocator<typename G::Matrix>> A_;  ///< Ad(X^-1)
  Eigen::MatrixXd Psi_;  ///< size x [interfaces, amplitudes]
  Eigen::MatrixXd K_e_;  ///< of e
  int unused_ = 0;       ///< amplitudes of the last slot
  Eigen::VectorXd omega2_;
  mutable Motion motion_;  ///< workspace, so that a step allocates nothing
  mutable Eigen::VectorXd full_, vel_, acc_, q_;
};

extern template class ModalBody<SE2>;
extern template class ModalBody<SE3>;

}  // namespace liesl
