#pragma once
/// @file
/// The task of `liesl run`: from a scene to its figures and records. No files, no printing.

#include "apps/output/results.hpp"
#include "apps/output/summary.hpp"
#include "apps/scene/space.hpp"
#include "mbs/solvers/simulation.hpp"

namespace liesl {

struct RunOutcome {
  SolveStatus status = SolveStatus::Converged;
  output::RunSummary summary;
  output::Results results;  ///< without records where nothing was found
};

/// Simulates a scene in its space: motion, equilibria, or natural frequencies with their shapes
/// (records over frequency). Non-convergence is a status.
/// @param sink takes the series of bodies, but of natural frequencies: see `collect`
RunOutcome run_task(const Scene& scene, const ChosenSpace& space, const Progress& progress = {},
                    output::BodySink* sink = nullptr);

}  // namespace liesl
