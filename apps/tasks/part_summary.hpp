#pragma once
/// @file
/// What a summary says of the meshed parts: are there enough modes for what drives them?

#include "apps/output/summary.hpp"
#include "mbs/solvers/trajectory.hpp"
#include "mbs/system/model.hpp"

namespace liesl {

/// The key `parts`: free-free frequencies with the unknowns of each part beside those of the full
/// mesh; the highest harmonic of its equivalent static loads over the motion (`bandwidth`); the
/// fewest modes with which all frequencies up to twice that are right to 1 %, and a warning if the
/// part has fewer.
/// @param motion  whether the records are instants of time; the loads of statics have no harmonics
template <FrameGroup G>
void describe_parts(output::RunSummary& summary, const Mechanism& mechanism, const Model<G>& model,
                    const Trajectory<G>& trajectory, bool motion);

}  // namespace liesl
