#pragma once
/// @file
/// What `liesl optimize` says of new holes.

#include <string>
#include <vector>

#include "apps/output/summary.hpp"
#include "optim/cycle/topology_cycle.hpp"

namespace liesl {

/// New holes of a study: those that were tried, and the next that would pay, in which part.
struct Holes {
  std::vector<HoleRound> tried;
  std::optional<Nucleus> next;
  std::string part;    ///< of `next`
  std::string reason;  ///< why there is no next one
  std::string unit;    ///< of the objective
};

/// Fills in the key `nucleation`.
void describe_holes(output::OptimizeSummary& summary, const Holes& holes);
/// @param most holes that were allowed
void print_holes(const Holes& holes, int most);

}  // namespace liesl
