#pragma once
/// @file
/// What a mechanism must keep where nothing acts on it, and how far a simulation drifts from it.

#include <optional>

#include "mbs/solvers/trajectory.hpp"
#include "mbs/system/model.hpp"

namespace liesl {

/// Largest distance from the first value of the free part of the motion; empty where something
/// acts.
struct Drift {
  std::optional<double> energy;            ///< J; nothing drives, damps or loads the mechanism
  std::optional<double> momentum;          ///< N s; and no gravity, nothing tied to the ground
  std::optional<double> angular_momentum;  ///< N m s, about the origin
};

/// Momentum of a state about the origin, [linear; angular] in the axes of the model. It is the
/// derivative of the kinetic energy by rigid velocities of the whole mechanism; the energy is
/// quadratic in the velocities, so that its central difference is exact.
/// @param s completed (Model::complete)
template <FrameGroup G>
typename G::Tangent momentum(const Model<G>& model, const State<G>& s);

/// Drifts over the records from when on no load acts; of fewer than two records there is none.
template <FrameGroup G>
Drift drift(const Mechanism& mechanism, const Model<G>& model, const Trajectory<G>& trajectory);

extern template SE2::Tangent momentum(const Model<SE2>&, const State<SE2>&);
extern template SE3::Tangent momentum(const Model<SE3>&, const State<SE3>&);
extern template Drift drift(const Mechanism&, const Model<SE2>&, const Trajectory<SE2>&);
extern template Drift drift(const Mechanism&, const Model<SE3>&, const Trajectory<SE3>&);

}  // namespace liesl
