#pragma once
/// @file
/// Formalisms against the first of a comparison, over its rows.

#include "apps/compare/row_table.hpp"
#include "apps/output/summary.hpp"

namespace liesl {

/// For each formalism after the first of the axis `formalism`: medians of error and time over those
/// of the first, over the pairs of rows that are equal in all other columns and have both figures.
/// Empty without such an axis.
std::vector<output::FormalismRatio> formalism_ratios(const CaseList& runs, const RowTable& table);

}  // namespace liesl
