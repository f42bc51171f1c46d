#pragma once
/// @file
/// The loads of every cycle of an optimisation, as a page draws them.

#include <filesystem>

#include "apps/report/blob.hpp"

namespace liesl::report {

/// Rows of cycle_loads.csv that a page holds at most: beyond, cycles are left out.
inline constexpr std::size_t kMostLoads = 3000;

/// cycle_loads.csv by cycle, part and instant: {"cases": [{"cycle", "scenario", "body", "at",
/// "nodes", "places": array [nodes, 3] of a meshed part}], "load": forces and moments of the nodes
/// of all cases one behind the other, by components, "thinned": were cycles left out?}. No cases
/// without that file.
/// @throws output::IoError for a table that is not whole
Json cycle_loads(const std::filesystem::path& folder, Blob& blob);

}  // namespace liesl::report
