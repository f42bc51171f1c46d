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
/// A warning if the integrator lost or made more than a few per cent of the largest kinetic and
/// elastic energy, over all accepted steps; above a tenth a converged run is Inaccurate.
/// @returns the status, that of the summary too
SolveStatus describe_energy(output::RunSummary& summary, const output::Results& results,
                            SolveStatus status);

/// "done" for a converged run, else the status.
std::string status_word(SolveStatus status);

}  // namespace liesl
