#pragma once
/// @file
/// New holes of a study as figures.

#include <optional>
#include <string>
#include <vector>

#include "apps/output/summary.hpp"
#include "optim/cycle/topology_cycle.hpp"

namespace liesl {

/// New holes of a study: those that were tried, and the next that would reduce the objective.
struct Holes {
  std::vector<std::string> bodies;  ///< what the bodies of the mechanism are called
  std::vector<HoleRound> tried;
  std::optional<Nucleus> next;
  int body = 0;        ///< of `next`
  std::string reason;  ///< why there is no next one
  std::string unit;    ///< of the objective
};

std::vector<std::string> body_names(const Mechanism& mechanism);

/// Fills in the key `nucleation`.
void describe_holes(output::OptimizeSummary& summary, const Holes& holes);

}  // namespace liesl
