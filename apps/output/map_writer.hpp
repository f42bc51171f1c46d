#pragma once
/// @file
/// Maps over two design variables as a table and as one HDF5 file. Layout: docs/outputs.md.

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace liesl::output {

/// nx x ny points, x fastest. NaN: no value.
struct DesignMap {
  struct Axis {
    std::string name, unit;
    std::vector<double> values;  ///< growing
  };
  struct Quantity {
    std::string name, unit;
    std::optional<double> limit;  ///< none: the objective
    std::vector<double> global;   ///< of the study itself, ny x nx
    std::vector<double> local;    ///< of the model of one step, ny x nx; empty: there is none
  };
  /// A design that an optimisation has analysed.
  struct Stop {
    int cycle = 0;
    std::array<double, 2> at = {};
  };
  std::array<Axis, 2> axes;
  std::vector<Quantity> of;
  std::vector<std::string> reasons;  ///< by point: why it has no values; empty: it has
  std::vector<Stop> path;
  /// Where the local model is that of the study, and what all other variables have.
  std::vector<std::pair<std::string, double>> centre;

  std::size_t points() const { return axes[0].values.size() * axes[1].values.size(); }
};

struct MapSummary {
  std::string name, status, reason;
  std::string local;  ///< which model it is, or why there is none
  int designs = 0, failed = 0;
  double wall_s = 0;
  std::vector<std::string> warnings, overrides;
  std::string input;  ///< file, as it was named
  std::string input_sha256;
};
nlohmann::ordered_json to_json(const MapSummary& summary, const DesignMap& map);

/// A row a point: both variables, `NAME [unit]` and `NAME local [unit]` of each quantity, `reason`.
/// @throws IoError (all below)
void write_map_csv(const std::filesystem::path& path, const DesignMap& map);

/// A row a design of the path: `cycle` and both variables.
void write_path_csv(const std::filesystem::path& path, const DesignMap& map);

///   /x [nx], /y [ny], /global/<name>, /local/<name> [ny,nx], /path/{cycle, at [k,2]}
void write_map_h5(const std::filesystem::path& path, const DesignMap& map);

}  // namespace liesl::output
