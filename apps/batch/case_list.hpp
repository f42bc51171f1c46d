#pragma once
/// @file
/// The cases of a batch as data: which keys change, and to what in each case.

#include <optional>
#include <string>
#include <vector>

#include "apps/input/problem.hpp"

namespace liesl {

/// Place in an input file, from 1; line 0: the file as a whole.
struct InputPlace {
  std::string file;
  int line = 0, column = 0;
};

/// A value as it is written behind `--set key.path=`, and where it stands.
struct CaseValue {
  std::string text;
  InputPlace place;
  /// Changes "key.path=value" in the place of those of the column's keys.
  std::optional<std::vector<std::string>> instead = std::nullopt;
};

/// What one column of the cases changes: one key, or several that share the value.
struct CaseColumn {
  std::string name;
  std::vector<std::string> keys;
  InputPlace place;
};

struct CaseList {
  /// Value number i belongs to column i.
  struct Row {
    std::string name;  ///< of the case and its folder
    std::vector<CaseValue> values;
  };
  std::vector<CaseColumn> columns;
  std::vector<Row> rows;
};

/// The changes "key.path=value" of a case.
std::vector<std::string> overrides(const CaseList& list, std::size_t row);

/// Largest number of cases that are read.
inline constexpr std::size_t kMostCases = 100000;

}  // namespace liesl
