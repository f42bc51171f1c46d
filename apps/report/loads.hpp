#pragma once
/// @file
/// The loads of every cycle of an optimisation, as a page draws them.

#include <filesystem>

#include "apps/report/blob.hpp"

namespace liesl::report {

/// Rows of cycle_loads.csv by cycle, part and instant: [{"cycle", "scenario", "body", "at",
/// "nodes", "load": array [nodes, 6] of forces and moments, "places": array [nodes, 3] of a meshed
/// part}]; empty without that file.
/// @throws output::IoError for a table that is not whole
Json cycle_loads(const std::filesystem::path& folder, Blob& blob);

}  // namespace liesl::report
