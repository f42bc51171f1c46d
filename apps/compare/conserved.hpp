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

/// Drifts over the records from when on no load acts; of fewer than two records there is none.
template <FrameGroup G>
Drift drift(const Mechanism& mechanism, const Model<G>& model, const Trajectory<G>& trajectory);

extern template Drift drift(const Mechanism&, const Model<SE2>&, const Trajectory<SE2>&);
extern template Drift drift(const Mechanism&, const Model<SE3>&, const Trajectory<SE3>&);

}  // namespace liesl
