#pragma once
/// @file
/// What `liesl optimize` prints.

#include "apps/tasks/optimize.hpp"

namespace liesl {

void print_cycle(const Cycle& c, bool quiet);
void print_step(const ShapeStep& s, SolidResponse goal, bool quiet);
/// A new hole that is tried now.
void print_hole(const std::string& feature, const Nucleus& nucleus, bool quiet);
/// @param most holes that were allowed
void print_holes(const Holes& holes, int most);
/// The end of a study of a motion; of one under fixed loads.
void print_result(const output::OptimizeSummary& s, const std::string& folder, bool quiet);
void print_part_result(const output::OptimizeSummary& s, const std::string& folder, bool quiet);

}  // namespace liesl
