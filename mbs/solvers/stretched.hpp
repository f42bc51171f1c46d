#pragma once
/// @file
/// The same motion in another duration: drives, recorded instants and steps are stretched, so that
/// it takes as many steps.

#include "mbs/model/mechanism.hpp"
#include "mbs/solvers/options.hpp"

namespace liesl {

/// @param factor new duration over the old one, > 0
SimulationOptions stretched(SimulationOptions options, double factor);
/// The motions of its drives. Nothing else may depend on time: see follows_time.
Mechanism stretched(Mechanism mechanism, double factor);

/// Loads, forces and a factor of gravity that depend on time, by name: they do not follow when a
/// motion is stretched.
std::vector<std::string> follows_time(const Mechanism& mechanism);

}  // namespace liesl
