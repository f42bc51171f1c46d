#pragma once
/// @file
/// What the readers of a meshed part share; private to the folder.

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "apps/scene/reader.hpp"
#include "mbs/solids/solid_model.hpp"

namespace liesl {

constexpr double kMostCells = 1e6;  ///< of a grid

/// State of reading one meshed part.
struct PartReader {
  Reader& reader;
  const std::string& name;
  toml::table& table;
  SolidMesh mesh = {};
  std::optional<NodalMatrices> matrices = {};  ///< then the mesh has nodes alone
  Material material = {};
  std::vector<Interface> interfaces = {};
  SolidModel::Options options = {};
  SolidSpec solid = {};  ///< its model is built of these at last
  bool ok = true;        ///< false: it cannot be built

  /// "part 'rod' <what>" as a problem at a place of the file.
  template <class Place>
  void refuse(const Place& at, const std::string& what, const std::string& expected,
              const std::string& hint = "") {
    reader.problems.add(at, fmt::format("part '{}' {}", name, what), expected, hint);
    ok = false;
  }
  toml::table& table_of(const char* key) { return *table.get(key)->as_table(); }
  int dim() const { return mesh.dim; }
  /// A point in the coordinates of the mesh, [x, y] or [x, y, z]; empty (and reported) if it has
  /// another number of coordinates.
  std::optional<Vec3> point(const toml::table& in, const char* key, int dim);
};

/// A file that is named relative to the scene, which the run then depends on.
struct NamedFile {
  std::string path, text;
};
/// @throws InputError if it cannot be read
NamedFile load_named_file(PartReader& part, const toml::node& name, const std::string& expected);
/// Problems of a file, at their lines, or at the key that names it.
void add_problems(PartReader& part, const InputError& error, const toml::node& name);

/// Where an entry of a table inside of a body is written.
inline const toml::key& key_of(const toml::table& table, const std::string& name) {
  return table.find(name)->first;
}

// Parts of a part, in this order.
void read_mesh(PartReader& part);
void read_matrices(PartReader& part);
void read_interfaces(PartReader& part);
void read_outline(PartReader& part);

}  // namespace liesl
