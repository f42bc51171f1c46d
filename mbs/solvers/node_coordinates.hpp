#pragma once
/// @file
/// The unknowns in which a formalism integrates the frames of its nodes. Bodies and couplings speak
/// of left-invariant velocities v and increments delta in local frames, whatever the unknowns; here
/// is the map between the two. Per node, with H = (R, x), v = [u; w]:
///
///   Screw      H_{n+1} = H_n exp(dq);                 rates v,  vdot
///   R3SO3      x += dq_u, R_{n+1} = R_n exp(dq_w);    rates [R u; w],  [R (udot + w x u); wdot]
///   RotationVector  x += dq_u, psi += dq_w, R = exp(psi);  rates [R u; psidot],
///              w = T(psi) psidot, wdot = T psiddot + D_psi[T psidot] psidot
///              (Geradin, Cardona 2001; thesis section 2.2.1)
///
/// In a plane the last two are the same. A node that is a position has x += R dq_u with R held
/// within a step, and rates v, vdot, in all of them.

#include <initializer_list>

#include "mbs/system/model.hpp"

namespace liesl {

/// How the rates of a node follow the correction delta of its frame within a step: dv = v delta,
/// dvdot = vdot delta, by node. Zero for nodes that follow others.
template <FrameGroup G>
struct RateTangents {
  using Blocks = typename BlockTridiagonal<G::dim>::Blocks;
  Blocks v, vdot;
};

template <FrameGroup G>
class NodeCoordinates {
 public:
  /// @param rescale Classical: psi <- psi (1 - 2 pi/|psi|) once |psi| > pi. Without, T(psi) is
  /// singular at 2 pi.
  NodeCoordinates(const Model<G>& model, bool rescale);

  /// Sets the rotation vectors of a state.
  void start(State<G>& s) const;
  /// Rates of the coordinates at a state, from its v and vdot.
  void rates(const State<G>& s, Eigen::VectorXd& u, Eigen::VectorXd& udot) const;
  /// s.H and s.w = those of `old` moved by dq, then s.v and s.vdot from the rates.
  void place(const State<G>& old, const Eigen::VectorXd& dq, const Eigen::VectorXd& u,
             const Eigen::VectorXd& udot, State<G>& s) const;
  /// e = increment of dq that moves the frames of `s` by delta (left-invariant).
  void increment(const State<G>& s, const Eigen::VectorXd& dq, const Eigen::VectorXd& delta,
                 Eigen::VectorXd& e) const;
  /// E of e = E delta, by node.
  void increments(const State<G>& s, const Eigen::VectorXd& dq,
                  typename RateTangents<G>::Blocks& E) const;
  /// Derivatives of v and vdot by delta at the state `s` of a step, where dq, u and udot change by
  /// e, w.damping e and w.mass e. Screw: gamma' T^-1(dq) and beta' T^-1(dq).
  void rate_tangents(const State<G>& s, const Eigen::VectorXd& dq, const Eigen::VectorXd& u,
                     const Eigen::VectorXd& udot, TangentWeights w, RateTangents<G>& out) const;
  /// dq between two states, so that place(old, dq, ...) gives the frames of s. @pre `s` was not
  /// rescaled since
  void difference(const State<G>& old, const State<G>& s, Eigen::VectorXd& dq) const;
  /// Turns the axes of positions to where the bodies are, and what is in them: v, vdot and a of the
  /// state, and further vectors.
  void turn_positions(State<G>& s, std::initializer_list<Eigen::VectorXd*> further) const;
  /// Where vectors are not rescaled: whether one comes near 2 pi or a multiple of it, |T^-1| > 30,
  /// or passes it between two states.
  bool passes_full_turn(const State<G>& old, const State<G>& s) const;
  /// Takes rounding out of the rotations; rescales. @returns true if coordinates were changed.
  bool finish(State<G>& s) const;

 private:
  static constexpr int dim = G::dim, sd = G::space_dim, rd = G::rotation_dim;
  using Rot = RotationOf<G>;
  using Angular = typename Rot::Vector;
  Angular psi(const State<G>& s, int node) const {
    return s.w.template segment<rd>(dim * node + sd);
  }
  void local_rates(const Eigen::VectorXd& u, const Eigen::VectorXd& udot, State<G>& s) const;

  const Model<G>& model_;
  bool rescale_;
  mutable Frames<G> turned_;  ///< of turn_positions, kept for its memory
};

extern template class NodeCoordinates<SE2>;
extern template class NodeCoordinates<SE3>;

}  // namespace liesl
