#pragma once
/// @file
/// Derivatives of a state in local frames, and in the coordinates that a formalism integrates. With
/// eta the left-invariant sensitivity of a frame, u and udot the rates of the coordinates, a their
/// acceleration-like variable (`NodeCoordinates`), by node:
///   v' = B u' + V eta,  vdot' = B udot' + D B u' + W eta,  alpha' = B a' + D B u' + A eta,
/// alpha: a as an acceleration in local frames, which stays what it is where rotation vectors are
/// rescaled. R^3 x SO(3): v = R^T u, hence B = R^T, V = [v~]; classical: B = T(psi) of rotations.
/// On the group the two are one: B = I, the rest zero, and nothing is done.

#include <optional>

#include "mbs/sensitivity/state_sensitivity.hpp"
#include "mbs/solvers/node_coordinates.hpp"

namespace liesl {

/// Rotation vectors: s as a step from `old` reached it, before those beyond pi were rescaled.
template <FrameGroup G>
void undo_rescale(const Model<G>& model, const NodeCoordinates<G>& coordinates, const State<G>& old,
                  State<G>& s);

template <FrameGroup G>
class RateMap {
 public:
  explicit RateMap(const Model<G>& model);

  /// The matrices at a state; at once if it is the one before.
  void take(const NodeCoordinates<G>& coordinates, const State<G>& s);

  /// v', w', a' of a state in local frames from those of the coordinates, and back.
  void to_local(StateSensitivity& x) const;
  void to_coordinates(StateSensitivity& x) const;
  /// The transposed maps: cotangents of local rates into those of the coordinates, and back.
  void to_local_transposed(StateSensitivity& bars) const;
  void to_coordinates_transposed(StateSensitivity& bars) const;

  /// At held frames: v <- B v, w <- B w + D B v; n x columns. And the transposed map of cotangents.
  void at_held_frames(Eigen::MatrixXd& v, Eigen::MatrixXd& w) const;
  void at_held_frames_transposed(Eigen::MatrixXd& v, Eigen::MatrixXd& w) const;

 private:
  static constexpr int dim = G::dim;
  using Blocks = typename RateTangents<G>::Blocks;
  template <class Each>
  void each_frame(Each each) const;

  const Model<G>* model_;
  std::optional<State<G>> at_;
  Blocks B_, inverse_, D_, V_, W_, A_;
};

extern template class RateMap<SE2>;
extern template class RateMap<SE3>;

}  // namespace liesl
