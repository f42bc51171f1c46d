#pragma once
/// @file
/// Grids over keys: named axes, each a key (or several that share the value) and a list of values.
///
///     [grid]
///     speed = { key = "joints.motor.drive.rate", values = [100, 150] }
///     limit = { key = "constraints.bending.limit", values = [5e-4, 1e-3, 2e-3] }
///
/// holds 6 cases; the last axis varies fastest.

#include <vector>

#include "apps/batch/case_list.hpp"

namespace liesl {

struct Axis {
  CaseColumn column;              ///< name and keys
  std::vector<CaseValue> values;  ///< one or more
};

/// Axes of a validated table of axes, in the order of the file; none of a table that is empty.
std::vector<Axis> read_axes(const toml::table& grid);

/// A value as TOML on one line; numbers with the fewest digits that give back the same double.
std::string toml_text(const toml::node& node);
/// Where a value stands; nowhere if it comes from --set or is a default.
InputPlace place_of(const toml::node& node);

/// Number of combinations; kMostCases + 1 if there are more than kMostCases.
std::size_t combinations(const std::vector<Axis>& axes);

/// All combinations, named by their number from 1 with leading zeros.
CaseList expand(const std::vector<Axis>& axes);

}  // namespace liesl
