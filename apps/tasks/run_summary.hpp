#pragma once
/// @file
/// The summary of a simulation: status, space, counts, responses, warnings.

#include "apps/output/results.hpp"
#include "apps/output/summary.hpp"
#include "apps/scene/space.hpp"
#include "mbs/solvers/simulation.hpp"

namespace liesl {

void describe(output::RunSummary& summary, const Scene& scene, const ChosenSpace& space);
void describe(output::RunSummary& summary, const Report& report, const InitialState& start,
              const Mechanism& mechanism);
void describe_responses(output::RunSummary& summary, const output::Results& results);
/// A warning if the integrator lost or made more energy than a few per cent.
void describe_energy(output::RunSummary& summary, const output::Results& results);

/// "done" for a converged run, else the status.
std::string status_word(SolveStatus status);

}  // namespace liesl
