#pragma once
/// @file
/// What `liesl optimize` prints.

#include "apps/tasks/optimize.hpp"

namespace liesl {

/// A row of the table of cycles; with the objective where it is not the mass.
void print_cycle(const Cycle& c, SolidResponse objective, bool quiet);
/// A new hole that is tried now.
void print_hole(const std::string& feature, const Nucleus& nucleus, bool quiet);
/// @param most holes that were allowed
void print_holes(const Holes& holes, int most);
void print_result(const output::OptimizeSummary& s, const std::string& folder, bool quiet);

}  // namespace liesl
