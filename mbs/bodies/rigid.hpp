#pragma once
/// @file
/// Rigid body: M vdot - ad(v)^T M v = g, in the frame of its origin; or a beam taken as rigid,
/// whose further nodes follow the first one.

#include "liegroup/se2.hpp"
#include "liegroup/se3.hpp"
#include "mbs/bodies/body.hpp"

namespace liesl {

template <FrameGroup G>
class Rigid final : public Body<G> {
 public:
  using Body<G>::dim;
  using typename Body<G>::Tangent;
  using typename Body<G>::Vector;
  using typename Body<G>::Matrices;

  /// @param inertia generalized inertia about the origin of the frame, conjugate to [u; w]; it
  /// holds the centre of mass, too
  Rigid(std::string body_name, const G& frame, const typename G::Matrix& inertia)
      : Body<G>(std::move(body_name), {frame}), inertia_(inertia) {
    set_matrices();
  }

  /// A flexible body made rigid: H_k = H_0 X_k with X_k as at reference, J_k = Ad(X_k^-1),
  /// M = sum_kl J_k^T M_kl J_l, loads per length likewise.
  Rigid(std::string body_name, std::shared_ptr<const Body<G>> flexible);

  NodeKind kind(int node) const override {
    return node == 0 ? NodeKind::Frame : NodeKind::Follower;
  }
  void complete(G* H, double* v, double* vdot, const double* w) const override;
  Eigen::MatrixXd load_share(bool follower) const override;

  void add_inertia(const BodyState<G>& s, const Vector& gravity, double* r,
                   ForceScale& scale) const override;
  void add_internal(const BodyState<G>&, double*, ForceScale&) const override {}
  void exact_tangent(const BodyState<G>& s, const Vector& gravity, TangentWeights w, const Tangent*,
                     Matrices& A) const override;
  BodyEnergy energy(const BodyState<G>& s, const Vector& gravity) const override;
  double total_mass() const override { return inertia_(0, 0); }
  std::unique_ptr<Body<G>> derivative(const LawDerivative<G>& law) const override;
  void add_energy_gradient(const BodyState<G>& s, const Vector& gravity, const BodyEnergy& weight,
                           double* h, double* v) const override;
  void to_unknowns(const BodyState<G>& s, double* h, double* v) const override;
  void rates_to_unknowns(const BodyState<G>& s, double* h, double* v, double* vdot) const override;

 private:
  using Matrix = typename G::Matrix;
  void set_matrices();
  /// Takes cotangents of all nodes to the first one.
  void to_first(double* x) const;

  Matrix inertia_;                                 ///< about node 0
  Vector first_moment_ = Vector::Zero();           ///< int rho x from node 0, kg m, in its axes
  std::shared_ptr<const Body<G>> flexible_;        ///< what it was made of, null = nothing
  std::vector<G, Eigen::aligned_allocator<G>> X_;  ///< H_0^-1 H_k
  Eigen::MatrixXd dead_share_, follower_share_;
};

extern template class Rigid<SE2>;
extern template class Rigid<SE3>;

}  // namespace liesl
