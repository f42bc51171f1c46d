#pragma once
/// @file
/// Entry to the solvers: the simulation that options.type names, as states with a report.

#include "mbs/solvers/dynamics.hpp"
#include "mbs/solvers/statics.hpp"

namespace liesl {

template <FrameGroup G>
struct Simulation {
  Trajectory<G> trajectory;
  Report report;
  InitialState start;
  std::vector<CriticalPoint> critical;  ///< statics
};

/// Dynamics or statics, by options.type. Modes have their own result: solve_modes.
/// @param tape of dynamics; null: none
template <FrameGroup G>
Simulation<G> run_simulation(const Model<G>& model, const SimulationOptions& options,
                             const Progress& progress = {}, Tape<G>* tape = nullptr) {
  if (options.type == SimulationType::Dynamic) {
    auto r = simulate(model, options, progress, tape);
    return {std::move(r.trajectory), std::move(r.report), std::move(r.start), {}};
  }
  auto r = solve_static(model, options, progress);
  return {std::move(r.trajectory), std::move(r.report), std::move(r.start), std::move(r.critical)};
}

}  // namespace liesl
