#pragma once
/// @file
/// What `liesl optimize` says of new holes.

#include <string>
#include <vector>

#include "apps/output/summary.hpp"
#include "optim/cycle/topology_cycle.hpp"

namespace liesl {

/// New holes of a study: those that were tried, and the next that would pay.
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
/// One that is tried now.
void print_hole(const std::string& feature, const Nucleus& nucleus, bool quiet);
/// @param most holes that were allowed
void print_holes(const Holes& holes, int most);

}  // namespace liesl
