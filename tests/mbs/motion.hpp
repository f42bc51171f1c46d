#pragma once
/// @file
/// A mechanism that is simulated as its options say, in the plane or in space.

#include "mbs/run.hpp"
#include "mbs/solvers/simulation.hpp"

namespace liesl::test {

/// A mechanism and its motion.
template <FrameGroup G>
struct Motion {
  Mechanism mechanism;
  Model<G> model;
  Simulation<G> simulation;

  Motion(const Mechanism& m, const SimulationOptions& options)
      : mechanism(m),
        model(Model<G>::build(mechanism, space_of<G>(mechanism))),
        simulation(run_simulation(model, options)) {}
  bool good() const { return simulation.report.status == SolveStatus::Converged; }
  const Trajectory<G>& trajectory() const { return simulation.trajectory; }
};

}  // namespace liesl::test
