#pragma once
/// @file
/// The loads of every cycle of an optimisation.

#include <string>
#include <vector>

#include "apps/study/study.hpp"
#include "optim/cycle/topology_cycle.hpp"

namespace liesl {

/// Of one part in one motion of one cycle.
struct LoadsOfCycle {
  int cycle = 0;  ///< from 1, as in the summary
  std::string body, scenario;
  CycleLoads kept;
  Eigen::Matrix3Xd places;  ///< of a meshed part, m, axes of its mesh; empty of a beam
};

/// Those of all rounds, cycles numbered through.
std::vector<LoadsOfCycle> loads_of_cycles(const RoundHistory& rounds, const Study& study);

/// Those of the models before, which had so many cycles, then those of the present one.
std::vector<LoadsOfCycle> joined_loads(std::vector<LoadsOfCycle> before,
                                       std::vector<LoadsOfCycle> now, std::size_t cycles_before);

}  // namespace liesl
