#pragma once
/// @file
/// Grids of any kind of cell.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "mbs/solids/mesh.hpp"

namespace liesl::test {

/// Quadrilaterals as two triangles, hexahedra as six tetrahedra about the diagonal 0-6.
inline SolidMesh split(SolidMesh mesh) {
  const std::vector<std::array<int, 4>> triangles = {{0, 1, 2}, {0, 2, 3}},
                                        tetrahedra = {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6},
                                                      {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}};
  const auto& pieces = mesh.dim == 2 ? triangles : tetrahedra;
  Eigen::MatrixXi cells(mesh.dim + 1, static_cast<int>(pieces.size()) * mesh.cell_count());
  for (int e = 0, n = 0; e < mesh.cell_count(); ++e)
    for (const auto& piece : pieces) {
      for (int c = 0; c <= mesh.dim; ++c) cells(c, n) = mesh.cells(piece[std::size_t(c)], e);
      ++n;
    }
  mesh.cells = cells;
  return mesh;
}

/// With a node at the middle of each edge, in the sets of both of its ends.
inline SolidMesh of_order_two(SolidMesh mesh) {
  const CellKind& kind = mesh.kind();
  const auto edges = cell_edges(kind);
  std::map<std::pair<int, int>, int> middle;
  Eigen::MatrixXi cells(kind.nodes + static_cast<int>(edges.size()), mesh.cell_count());
  cells.topRows(kind.nodes) = mesh.cells;
  const auto in = [](const std::vector<int>& set, int node) {
    return std::find(set.begin(), set.end(), node) != set.end();
  };
  std::vector<Eigen::Vector3d> more;
  const int first = mesh.node_count();
  auto sets = mesh.sets;
  for (int e = 0; e < mesh.cell_count(); ++e)
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const int a = mesh.cells(edges[k][0], e), b = mesh.cells(edges[k][1], e);
      const auto [at, fresh] =
          middle.try_emplace(std::minmax(a, b), first + static_cast<int>(more.size()));
      cells(kind.nodes + static_cast<int>(k), e) = at->second;
      if (!fresh) continue;
      more.push_back((mesh.nodes.col(a) + mesh.nodes.col(b)) / 2);
      for (auto& [name, nodes] : sets)
        if (in(mesh.sets.at(name), a) && in(mesh.sets.at(name), b)) nodes.push_back(at->second);
    }
  mesh.nodes.conservativeResize(Eigen::NoChange, first + static_cast<int>(more.size()));
  for (std::size_t i = 0; i < more.size(); ++i)
    mesh.nodes.col(first + static_cast<int>(i)) = more[i];
  mesh.cells = cells;
  mesh.sets = sets;
  return mesh;
}

/// A grid of quadrilaterals or hexahedra, in cells of another kind of the same dimension.
inline SolidMesh in_cells(SolidMesh grid, const CellKind& kind) {
  if (kind.family == CellFamily::Simplex) grid = split(std::move(grid));
  return kind.order == 2 ? of_order_two(std::move(grid)) : grid;
}

/// Cook's membrane (R. D. Cook, Improved two-dimensional finite element, J. Struct. Div. ASCE 100
/// (1974)), n x n quadrilaterals in cells of a kind: 48 wide, clamped at x = 0, 0 <= y <= 44,
/// loaded at x = 48, 44 <= y <= 60.
inline SolidMesh cooks_membrane(const CellKind& kind, int n) {
  SolidMesh mesh = quad_grid({0, 0}, {48, 1}, n, n);
  for (int i = 0; i < mesh.node_count(); ++i) {
    const double x = mesh.nodes(0, i) / 48;
    mesh.nodes(1, i) = 44 * x + mesh.nodes(1, i) * (44 - 28 * x);
  }
  return in_cells(std::move(mesh), kind);
}
/// Its node at the middle of the loaded side. @pre n is even
inline int middle_of_its_side(const SolidMesh& membrane) {
  return nodes_where(membrane,
                     [](const Eigen::Vector3d& x) {
                       return std::abs(x[0] - 48) + std::abs(x[1] - 52) < 1e-9;
                     })
      .at(0);
}

/// Is a node of `distorted` off the sides of the box?
inline bool inside(const SolidMesh& mesh, int node) {
  const Eigen::Vector3d x = mesh.nodes.col(node), to(2, 1, 1);
  bool off = true;
  for (int a = 0; a < mesh.dim; ++a) off = off && x[a] > 0 && x[a] < to[a];
  return off;
}

/// A box of 2 m x 1 m (x 1 m) from the origin in cells of a kind, as irregular as patch tests need
/// it: its inner corners are moved about.
inline SolidMesh distorted(const CellKind& kind) {
  SolidMesh mesh =
      kind.dim == 2 ? quad_grid({0, 0}, {2, 1}, 4, 3) : hex_grid({0, 0, 0}, {2, 1, 1}, 3, 3, 3);
  for (int i = 0; i < mesh.node_count(); ++i)
    if (inside(mesh, i))
      for (int a = 0; a < kind.dim; ++a) mesh.nodes(a, i) += 0.07 * std::sin(3.0 * i + 2 * a + 1);
  return in_cells(mesh, kind);
}

/// Its inner edges bent, of cells with nodes at their edges.
inline SolidMesh with_bent_edges(SolidMesh mesh) {
  const int corners = mesh.cells.topRows(mesh.corners()).maxCoeff() + 1;
  for (int i = corners; i < mesh.node_count(); ++i)
    if (inside(mesh, i))
      for (int a = 0; a < mesh.dim; ++a) mesh.nodes(a, i) += 0.02 * std::sin(5.0 * i + 3 * a);
  return mesh;
}

}  // namespace liesl::test
