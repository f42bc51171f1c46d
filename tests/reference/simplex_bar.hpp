#pragma once
/// @file
/// A bar of triangles or tetrahedra, as a mesh and as the file that Gmsh writes of it.

#include <fmt/format.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mbs/solids/mesh.hpp"

namespace liesl::test {

/// Each quadrilateral as two triangles, each hexahedron as six tetrahedra about its diagonal, those
/// of neighbours with sides in common (H. W. Kuhn 1960). @param order 2: nodes at the edges, too
inline SolidMesh simplices_of(const SolidMesh& boxes, int order) {
  static constexpr int kParts[2][6][4] = {
      {{0, 1, 2, -1}, {0, 2, 3, -1}},
      {{0, 1, 2, 6}, {0, 1, 5, 6}, {0, 3, 2, 6}, {0, 3, 7, 6}, {0, 4, 5, 6}, {0, 4, 7, 6}}};
  const int dim = boxes.dim, corners = dim + 1, parts = dim == 2 ? 2 : 6;
  std::vector<Eigen::Vector3d> nodes;
  for (int i = 0; i < boxes.node_count(); ++i) nodes.push_back(boxes.nodes.col(i));
  const auto at = [&nodes](int i) -> const Eigen::Vector3d& { return nodes[std::size_t(i)]; };
  std::map<std::pair<int, int>, int> middle;  // of an edge between two corners
  std::vector<std::vector<int>> cells;
  for (int e = 0; e < boxes.cell_count(); ++e)
    for (int k = 0; k < parts; ++k) {
      std::vector<int> cell;
      for (int c = 0; c < corners; ++c) cell.push_back(boxes.cells(kParts[dim - 2][k][c], e));
      if (dim == 3) {
        Eigen::Matrix3d J;
        for (int c = 1; c < 4; ++c) J.col(c - 1) = at(cell[std::size_t(c)]) - at(cell[0]);
        if (J.determinant() < 0) std::swap(cell[2], cell[3]);
      }
      for (const auto& [i, j] : cell_edges(cell_kind(dim, corners))) {
        if (order == 1) break;
        const std::pair<int, int> edge = std::minmax(cell[std::size_t(i)], cell[std::size_t(j)]);
        const auto [found, fresh] = middle.try_emplace(edge, int(nodes.size()));
        if (fresh) nodes.push_back((at(edge.first) + at(edge.second)) / 2);
        cell.push_back(found->second);
      }
      cells.push_back(cell);
    }
  SolidMesh mesh;
  mesh.dim = dim;
  mesh.nodes.resize(3, int(nodes.size()));
  for (int i = 0; i < mesh.node_count(); ++i) mesh.nodes.col(i) = at(i);
  mesh.cells.resize(int(cells[0].size()), int(cells.size()));
  for (int e = 0; e < mesh.cell_count(); ++e)
    mesh.cells.col(e) = Eigen::VectorXi::Map(cells[std::size_t(e)].data(), mesh.cells.rows());
  return mesh;
}

/// Format 4.1 in ASCII. Physical groups "left" and "right": the sides at x = 0 and x = length.
inline std::string gmsh_text(const SolidMesh& mesh, double length) {
  const CellKind &kind = mesh.kind(), &side = side_kind(kind);
  const int n = mesh.node_count(), count = mesh.cell_count(), on = mesh.dim - 1;
  std::vector<std::string> ends[2];
  for (int e = 0; e < count; ++e)
    for (const CellSide& nodes : side_nodes(mesh, e))
      for (const int end : {0, 1}) {
        std::string line;
        bool there = true;
        for (int c = 0; c < side.nodes; ++c) {
          const int node = nodes[std::size_t(c)];
          there = there && std::abs(mesh.nodes(0, node) - end * length) < 1e-12;
          line += fmt::format(" {}", node + 1);
        }
        if (there) ends[end].push_back(line);
      }
  std::string text = fmt::format(
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n{0} 1 \"left\"\n{0} 2 \"right\"\n"
      "$EndPhysicalNames\n$Entities\n0 {1}\n1 0 0 0 0 0 0 1 1 0\n2 0 0 0 0 0 0 1 2 0\n"
      "1 0 0 0 0 0 0 0 0\n$EndEntities\n$Nodes\n1 {2} 1 {2}\n{3} 1 0 {2}\n",
      on, on == 1 ? "2 1 0" : "0 2 1", n, mesh.dim);
  for (int i = 1; i <= n; ++i) text += fmt::format("{}\n", i);
  for (int i = 0; i < n; ++i)
    text += fmt::format("{} {} {}\n", mesh.nodes(0, i), mesh.nodes(1, i), mesh.nodes(2, i));
  const int all = count + int(ends[0].size() + ends[1].size());
  text += fmt::format("$EndNodes\n$Elements\n3 {0} 1 {0}\n", all);
  int number = 0;
  for (const int end : {0, 1}) {
    text += fmt::format("{} {} {} {}\n", on, end + 1, side.gmsh, ends[end].size());
    for (const std::string& line : ends[end]) text += fmt::format("{}{}\n", ++number, line);
  }
  text += fmt::format("{} 1 {} {}\n", mesh.dim, kind.gmsh, count);
  for (int e = 0; e < count; ++e) {
    std::vector<int> cell(std::size_t(kind.nodes));
    for (int c = 0; c < kind.nodes; ++c)
      cell[std::size_t(gmsh_order(kind)[std::size_t(c)])] = mesh.cells(c, e) + 1;
    text += fmt::format("{}", ++number);
    for (const int node : cell) text += fmt::format(" {}", node);
    text += '\n';
  }
  return text + "$EndElements\n";
}

/// A bar from the origin along x, about the x axis, of size[0] x size[1] (x size[2]).
/// @param boxes in each direction, of two triangles or six tetrahedra each; the last 0: in the
/// plane
inline SolidMesh simplex_bar(const Eigen::Vector3d& size, const Eigen::Vector3i& boxes, int order) {
  const Eigen::Vector3d half(0, size[1] / 2, size[2] / 2), end(size[0], 0, 0);
  return simplices_of(
      boxes[2] > 0 ? hex_grid(-half, end + half, boxes[0], boxes[1], boxes[2])
                   : quad_grid((-half).head<2>(), (end + half).head<2>(), boxes[0], boxes[1]),
      order);
}

}  // namespace liesl::test
