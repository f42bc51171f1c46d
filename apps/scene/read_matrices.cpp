/// @file
/// Parts whose stiffness and mass come from another program.

#include "apps/input/document.hpp"
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
    const NamedFile file = load_beside(part, name, "a MatrixMarket file");
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
                  fmt::format("has '{}' beside the matrices that it is given by", key),
                  fmt::format("no '{}'", key));
}

}  // namespace

void read_matrices(PartReader& part) {
  refuse_keys_of_meshes(part);
  const auto nodes = read_market(part, "nodes", read_dense);
  auto K = read_market(part, "stiffness", read_sparse), M = read_market(part, "mass", read_sparse);
  if (!part.ok) return;
  const toml::node& name = *part.table_of("matrices").get("nodes");
  if (nodes->cols() != 2 && nodes->cols() != 3)
    return part.refuse(name, fmt::format("has nodes with {} coordinates", nodes->cols()),
                       "a row [x, y] or [x, y, z] a node");
  part.mesh.dim = static_cast<int>(nodes->cols());
  part.mesh.nodes = Eigen::Matrix3Xd::Zero(3, nodes->rows());
  part.mesh.nodes.topRows(part.mesh.dim) = nodes->transpose();
  part.mesh.cells.resize(part.mesh.dim == 2 ? 4 : 8, 0);
  part.matrices = NodalMatrices{std::move(*K), std::move(*M)};
  try {
    component_mass(part.mesh, *part.matrices);
  } catch (const std::invalid_argument& error) {
    part.refuse(key_of(part.table, "matrices"), std::string("cannot be made: ") + error.what(),
                "K and M of the free part, freedoms node by node (m, N, kg)");
  }
}

}  // namespace liesl
