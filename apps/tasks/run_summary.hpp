#pragma once
/// @file
/// The summary of a simulation: status, space, counts, responses, warnings.

#include "apps/output/results.hpp"
#include "apps/output/summary.hpp"
#include "apps/scene/space.hpp"
#include "apps/tasks/part_range.hpp"
#include "mbs/solvers/simulation.hpp"

namespace liesl {

void describe(output::RunSummary& summary, const Scene& scene, const ChosenSpace& space);
void describe(output::RunSummary& summary, const Report& report, const InitialState& start,
              const Mechanism& mechanism, SimulationType type);
/// The key `penalty`, where there are some.
void describe(output::RunSummary& summary, const PenaltyReport& p, ConstraintForm form);
void describe_responses(output::RunSummary& summary, const output::Results& results);
/// A warning for each beam whose largest stress at the records is above a twentieth of its modulus,
/// since materials are linear, and if the integrator lost or made more than a few per cent of the
/// largest kinetic and elastic energy, over all accepted steps; above a half and a tenth a
/// converged run is Inaccurate, because of a drive that it does not follow if there is one.
/// @param mechanism of the scene, or a design of it
/// @returns the status, that of the summary too
SolveStatus describe_doubts(output::RunSummary& summary, const Scene& scene,
                            const Mechanism& mechanism, const output::Results& results,
                            SolveStatus status);

/// Notes on the ranges of parts and beams, and, of a motion in a plane that was found
/// (`simulation.space = "auto"`), on beams that could leave it; beyond a range a converged run is
/// Inaccurate.
/// @returns the status, that of the summary too
template <FrameGroup G>
SolveStatus describe_ranges(output::RunSummary& summary, const SimulationOptions& o,
                            const PartRanges<G>& ranges, SolveStatus status);

/// "done" for a converged run, else the status.
std::string status_word(SolveStatus status);

extern template SolveStatus describe_ranges(output::RunSummary&, const SimulationOptions&,
                                            const PartRanges<SE2>&, SolveStatus);
extern template SolveStatus describe_ranges(output::RunSummary&, const SimulationOptions&,
                                            const PartRanges<SE3>&, SolveStatus);

}  // namespace liesl
