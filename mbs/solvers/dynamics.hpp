#pragma once
/// @file
/// A simulation in time: start, steps, recovery, records.

#include <functional>

#include "mbs/solvers/generalized_alpha.hpp"
#include "mbs/solvers/initial_state.hpp"
#include "mbs/solvers/replay.hpp"
#include "mbs/solvers/trajectory.hpp"

namespace liesl {

template <FrameGroup G>
struct DynamicResult {
  Trajectory<G> trajectory;
  Report report;
  InitialState start;
};

/// Called after each step with the time reached; return false to stop (Interrupted).
using Progress = std::function<bool(double t)>;

/// Called with the state at the start and after each accepted step, completed, and whether it is
/// recorded: what is largest somewhere is looked for here, since records may be thinned.
template <FrameGroup G>
using Observer = std::function<void(const State<G>& s, bool recorded)>;

/// Runs the model over options.duration. A step that does not converge is tried with the tangent
/// at the current state, then with half the step, down to options.step_min; then the run stops with
/// a reason, and the records until there are kept. Steps grow back on the grid of options.step,
/// whose multiples are met exactly; adaptive ones are chosen by `StepControl`.
/// Never throws for non-convergence; no record holds a NaN.
/// options.start: from where the scene puts the bodies, or from the static equilibrium at t = 0
/// with the velocities given; without one the run does not start, with the reason of the statics.
/// @param tape for a replay of the steps; null: none
/// @throws std::invalid_argument for options that have errors()
template <FrameGroup G>
DynamicResult<G> simulate(const Model<G>& model, const SimulationOptions& options,
                          const Progress& progress = {}, Tape<G>* tape = nullptr,
                          const Observer<G>& observe = {});

extern template DynamicResult<SE2> simulate(const Model<SE2>&, const SimulationOptions&,
                                            const Progress&, Tape<SE2>*, const Observer<SE2>&);
extern template DynamicResult<SE3> simulate(const Model<SE3>&, const SimulationOptions&,
                                            const Progress&, Tape<SE3>*, const Observer<SE3>&);

}  // namespace liesl
