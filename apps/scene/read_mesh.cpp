/// @file
/// Meshes of parts: grids and files.

#include <cmath>

#include "apps/input/document.hpp"
#include "apps/mesh/abaqus_mesh.hpp"
#include "apps/mesh/gmsh_mesh.hpp"
#include "apps/output/file.hpp"
#include "apps/scene/part_reader.hpp"

namespace liesl {

namespace {

namespace fs = std::filesystem;

void read_file(PartReader& part, const toml::node& node) {
  try {
    const NamedFile file = load_named_file(part, node, "a mesh");
    const std::string end = fs::path(file.path).extension();
    const auto read = end == ".inp" || end == ".INP" ? read_abaqus : read_gmsh;
    part.mesh = read(file.path, file.text);
    const CellKind& kind = part.mesh.kind();
    if (kind.family == CellFamily::Simplex && kind.order == 1)
      part.reader.scene.warnings.push_back(
          fmt::format("part '{}': cells of constant strain ({}) bend too stiffly; use those with "
                      "nodes at their "
                      "edges",
                      part.name, kind.name));
  } catch (const InputError& error) {
    add_problems(part, error, node);
  }
}

}  // namespace

NamedFile load_named_file(PartReader& part, const toml::node& name, const std::string& expected) {
  const fs::path given(name.value_or(std::string()));
  const fs::path path =
      given.is_absolute() ? given : fs::path(part.reader.scene.file).parent_path() / given;
  NamedFile file{path.lexically_normal().string(), load_text(path, expected)};
  part.reader.scene.input += file.text;
  part.reader.scene.files.push_back({file.path, output::sha256(file.text)});
  return file;
}

void add_problems(PartReader& part, const InputError& error, const toml::node& name) {
  part.ok = false;
  for (const InputProblem& problem : error.problems)
    if (problem.line > 0)
      part.reader.problems.add(problem);
    else
      part.refuse(name, "cannot be read: " + problem.file + ": " + problem.what, problem.expected,
                  "paths are relative to the scene");
}

void read_mesh(PartReader& part) {
  if (part.table.contains("matrices")) return read_matrices(part);
  const toml::table& mesh = part.table_of("mesh");
  if (const toml::node* file = mesh.get("file")) return read_file(part, *file);
  for (const char* key : {"to", "cells"})
    if (!mesh.get(key))
      return part.refuse(mesh, fmt::format("has a grid without '{}'", key),
                         "'from', 'to' and 'cells'",
                         "as in mesh = { from = [0, 0], to = [0.2, 0.03], cells = [100, 15] }");
  const int dim = static_cast<int>(numbers(*mesh.get("from")).size());
  const auto from = part.point(mesh, "from", dim), to = part.point(mesh, "to", dim),
             cells = part.point(mesh, "cells", dim);
  if (!from || !to || !cells) return;
  double count = 1;
  for (int i = 0; i < dim; ++i) {
    if (!((*to)[i] > (*from)[i]))
      return part.refuse(*mesh.get("to"), "has an empty grid",
                         "'to' above 'from' in each direction");
    if ((*cells)[i] != std::floor((*cells)[i]))
      return part.refuse(*mesh.get("cells"), "has a number of cells that is not whole", "integers");
    count *= (*cells)[i];
  }
  if (count > kMostCells)
    return part.refuse(*mesh.get("cells"), fmt::format("has {:.3g} cells", count),
                       fmt::format("at most {:.0e}", kMostCells));
  const Eigen::Vector3i n = cells->cast<int>();
  part.mesh = dim == 2 ? quad_grid(from->head<2>(), to->head<2>(), n[0], n[1])
                       : hex_grid(*from, *to, n[0], n[1], n[2]);
}

}  // namespace liesl
