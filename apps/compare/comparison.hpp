#pragma once
/// @file
/// Comparisons: one scene under many formalisms, meshes and steps, or one study by many methods.
/// Keys: docs/scene_reference.md.

#include <array>
#include <functional>
#include <optional>

#include "apps/batch/batch.hpp"
#include "apps/batch/grid.hpp"
#include "apps/output/series.hpp"

namespace liesl {

/// One of the runs that a reference is made of: its share in the extrapolation, and its changes.
struct ReferenceRun {
  double weight = 1;
  std::vector<std::string> changes;
};

/// Two fine runs, extrapolated or not.
struct ReferenceSpec {
  std::array<std::string, 2> formalisms;
  std::optional<int> elements;
  double step = 0;       ///< s
  double tolerance = 0;  ///< of the residual
  std::optional<double> rho_inf;
  bool mesh = false, time = false;  ///< extrapolated to fine meshes, small steps
  InputPlace place;
};

struct Comparison {
  Batch rows;            ///< its cases are the rows; `of` is the scene, or the study if `optimize`
  std::string response;  ///< of a scene
  output::Norm norm = output::Norm::Final;
  int repeats = 3;
  double time_limit = 60;              ///< s, CPU time of one run
  std::vector<std::string> mesh_keys;  ///< keys of the numbers of elements
  std::optional<ReferenceSpec> reference;
  double smallest_step = 0;  ///< s, of all rows

  /// Changes of a row that make it another mechanism or motion; rows that have them in common share
  /// a reference.
  std::vector<std::string> physics(std::size_t row) const;
  /// The runs of one side (0 or 1) of the reference of a row. Their weights add up to one.
  std::vector<ReferenceRun> reference_runs(std::size_t row, int side) const;
};

/// Reads the rows of a comparison of methods: `study`, the axes of `grid` and `vary`, and every row
/// as the study that it will be. @pre rows.name, rows.file and rows.set are known
void read_methods(const toml::table& root, const std::filesystem::path& path,
                  Comparison& comparison, Problems& problems);
/// Those of `vary` and of the `grid`, whose axes change these keys, in the order of the file.
std::vector<Axis> axes_of(const toml::table& root,
                          const std::function<std::vector<std::string>(std::string_view)>& keys,
                          Problems& problems);
/// `set` as changes of every row.
void read_changes(const toml::table& root, Comparison& comparison);

/// Refuses changes of every row that rows make themselves: by "--set", or by `set` where it can
/// have no effect. @pre rows.cases and rows.set are known, those of the file last
void check_changes(const toml::table& root, const Batch& rows, Problems& problems);

/// Reads a comparison, its scene and every row. Overrides change keys of the comparison, else keys
/// of the scene in all runs.
/// @throws InputError with the problems of all files; of a row at the place of its value
Comparison load_comparison(const std::filesystem::path& path,
                           const std::vector<std::string>& overrides = {});

}  // namespace liesl
