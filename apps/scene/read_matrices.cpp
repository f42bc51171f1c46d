/// @file
/// Parts whose stiffness and mass come from another program.

#include "apps/input/document.hpp"
#include "apps/mesh/matrix_file.hpp"
#include "apps/mesh/matrix_market.hpp"
#include "apps/scene/part_reader.hpp"

namespace liesl {

namespace {

/// One of the files; problems are reported.
template <class Read>
auto read_market(PartReader& part, const char* key, Read read)
    -> std::optional<decltype(read(std::string(), std::string_view()))> {
  const toml::node& name = *part.table_of("matrices").get(key);
  try {
    const NamedFile file = load_named_file(part, name, "a MatrixMarket file");
    return read(file.path, file.text);
  } catch (const InputError& error) {
    add_problems(part, error, name);
    return {};
  }
}

/// Keys that a part of matrices has no use for.
void refuse_keys_of_meshes(PartReader& part) {
  for (const char* key : {"material", "thickness", "outline", "ersatz"})
    if (part.table.contains(key) && written(*part.table.get(key)))
      part.refuse(key_of(part.table, key),
                  fmt::format("has '{}', although it is given by matrices", key),
                  fmt::format("no '{}'", key));
}

/// From one HDF5 file.
std::optional<PartMatrices> read_one_file(PartReader& part, const toml::node& name) {
  try {
    return read_matrix_file(load_named_file(part, name, "an HDF5 file of a part").path);
  } catch (const InputError& error) {
    add_problems(part, error, name);
    return {};
  }
}

/// From three MatrixMarket files.
std::optional<PartMatrices> read_three_files(PartReader& part) {
  const auto nodes = read_market(part, "nodes", read_dense);
  auto K = read_market(part, "stiffness", read_sparse), M = read_market(part, "mass", read_sparse);
  if (!nodes || !K || !M) return {};
  if (nodes->cols() != 2 && nodes->cols() != 3) {
    part.refuse(*part.table_of("matrices").get("nodes"),
                fmt::format("has nodes with {} coordinates", nodes->cols()),
                "a row [x, y] or [x, y, z] a node");
    return {};
  }
  PartMatrices out;
  out.nodes.dim = static_cast<int>(nodes->cols());
  out.nodes.nodes = Eigen::Matrix3Xd::Zero(3, nodes->rows());
  out.nodes.nodes.topRows(out.nodes.dim) = nodes->transpose();
  out.matrices = {std::move(*K), std::move(*M)};
  return out;
}

/// Either `file`, or the three others.
bool has_its_files(PartReader& part) {
  const toml::table& table = part.table_of("matrices");
  for (const char* key : {"stiffness", "mass", "nodes"})
    if (table.contains(key) == table.contains("file")) {
      part.refuse(table,
                  fmt::format("has matrices {} '{}'",
                              table.contains(key) ? "in a 'file', and" : "without", key),
                  "'file' alone, or 'stiffness', 'mass' and 'nodes'");
      return false;
    }
  return true;
}

}  // namespace

void read_matrices(PartReader& part) {
  refuse_keys_of_meshes(part);
  if (!has_its_files(part)) return;
  const toml::node* file = part.table_of("matrices").get("file");
  std::optional<PartMatrices> read = file ? read_one_file(part, *file) : read_three_files(part);
  if (!read) return;
  part.mesh = std::move(read->nodes);
  part.mesh.cells.resize(part.mesh.dim == 2 ? 4 : 8, 0);
  part.matrices = std::move(read->matrices);
  try {
    require_free_part(part.mesh, *part.matrices);
    require_positive_stiffness(*part.matrices);
  } catch (const std::invalid_argument& error) {
    part.refuse(key_of(part.table, "matrices"), std::string("cannot be made: ") + error.what(),
                "K and M of the free part, freedoms node by node, rotations behind displacements "
                "(m, N, kg)");
  }
}

}  // namespace liesl
