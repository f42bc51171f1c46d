#pragma once
/// @file
/// What a summary says of the meshed parts: are there enough modes for what drives them, and do
/// they, and beams in floating frames, stay where linear deformation is right?

#include "apps/output/summary.hpp"
#include "mbs/solvers/trajectory.hpp"
#include "mbs/system/model.hpp"

namespace liesl {

/// The key `parts`: free-free frequencies with the unknowns of each part beside those of the full
/// mesh; the highest harmonic of its equivalent static loads over the motion (`bandwidth`); the
/// fewest modes with which all frequencies up to twice that are right to 1 %, and a warning if the
/// part has fewer. Warnings of `part_range` and `beam_range`.
/// @param motion  whether the records are instants of time; the loads of statics have no harmonics
template <FrameGroup G>
void describe_parts(output::RunSummary& summary, const Mechanism& mechanism, const Model<G>& model,
                    const Trajectory<G>& trajectory, bool motion);

}  // namespace liesl
