#pragma once
/// @file
/// Tables of a results folder as charts, designs, outlines and cases of a page.

#include <filesystem>

#include "apps/report/blob.hpp"

namespace liesl::report {

/// Points of one line of a chart; of each stretch the smallest and the largest are kept.
inline constexpr std::size_t kFewestPoints = 100, kMostPoints = 800;
/// Points of all charts, of which each line has its share, but no fewer than the fewest.
inline constexpr std::size_t kMostChartPoints = 6000;
/// Designs whose outlines a page holds at most.
inline constexpr std::size_t kMostOutlines = 60;

/// Limits before and after (optimize), else responses and energies: a list of {"title", "unit",
/// "abscissa", "lines": [{"label", "x", "y"}]}, with "limit" and "at" where a limit is known.
Json charts(const std::filesystem::path& folder, const Json& summary, Blob& blob);

/// Rows of design.csv: {"variable", "body", "element", "dimensions"}.
Json sized_elements(const std::filesystem::path& folder);

/// Outlines of planar parts over the designs, PART_outlines.csv: [{"part", "steps": [{"step",
/// "lines": [array of x, y]}]}], with "cells" and "stress" of the final design.
Json outlines(const std::filesystem::path& folder, Blob& blob);

/// A table of cases or rows: {"columns": [{"name", "unit", "number", "cells"}]}.
/// @param least how many it has  @throws output::IoError if it has fewer
Json cases(const std::filesystem::path& table, std::size_t least = 0);

}  // namespace liesl::report
