#pragma once
/// @file
/// Batches: many cases of one study or scene. Keys: docs/scene_reference.md.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "apps/batch/case_list.hpp"
#include "apps/input/problem.hpp"

namespace liesl {

struct Batch {
  std::string name;
  std::string file;                   ///< where it was read
  bool optimize = false;              ///< each case sizes a study; else it simulates a scene
  std::filesystem::path of;           ///< the study or scene
  std::vector<std::string> defaults;  ///< changes to all cases that `set` and cases come after
  std::vector<std::string> set;       ///< changes to all cases
  CaseList cases;                     ///< one or more
  std::optional<double> time;         ///< s, wall time of a case
  std::optional<double> memory;       ///< MB, address space of a case
  std::string input;  ///< texts of study and scene, and all cases, for the input's hash

  /// All changes of a case, those to all cases first.
  std::vector<std::string> changes(std::size_t row) const;
};

/// Reads a batch with its table, and every one of its cases as the study or scene that it will be.
/// Overrides change keys of the batch (name, table, grid, limits, and study or scene as a whole),
/// else keys of all cases.
/// @throws InputError with the problems of all files; of a case at the place of its value
Batch load_batch(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

/// Reads every case as the scene or study that it will be, and puts the texts into `input`.
/// @throws InputError for columns that are no keys and cases that are refused, at their places
void check_cases(Batch& batch, Problems& problems);

/// Unit of the key that a column changes, or that all of its keys have; empty if they have none, or
/// none that the keys alone tell.
std::string unit_of(const Batch& batch, const CaseColumn& column);

/// A key that rows set themselves, each to its own value.
struct RowKey {
  std::string by;  ///< the column or, for a value that makes other changes, that value
  std::string key;
};
/// What rows set of a key path: it, a key below it, or a table that holds it. "scene.KEY" of a
/// study is KEY.
std::optional<RowKey> set_by_rows(const Batch& batch, const std::string& path);

/// Changes of all rows by "--set" that rows make themselves, and that would have no effect.
/// @param changes each "key.path=value"
void refuse_changes_of_rows(const Batch& batch, const std::vector<std::string>& changes,
                            Problems& problems);

/// One of n shares of the cases, as jobs of a cluster take them: every n-th case.
struct Shard {
  int number = 1, of = 1;  ///< 1 <= number <= of
  bool has(std::size_t row) const {
    return static_cast<int>(row % static_cast<std::size_t>(of)) == number - 1;
  }
};
/// "i/n", or "" for all. @throws InputError if it is none or outside the range
Shard read_shard(const std::string& text);

}  // namespace liesl
