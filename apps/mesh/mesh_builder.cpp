#include "apps/mesh/mesh_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace liesl {
namespace {

constexpr int kMostMeshProblems = 20;

/// A side of a cell by its corners, growing, and which way round the cell has them, seen from
/// outside.
struct SideOfCell {
  std::array<int, 4> corners;
  int cell;
  bool forward;
};

/// An edge of a cell whose node is off the middle between its corners.
struct EdgeOffMiddle {
  int edge = 0;
  double share = 0;  ///< how far, of its length
};

/// The one that is farthest off, of a cell of order 2. @param x 3 x nodes of the cell
EdgeOffMiddle farthest_off_middle(const CellKind& kind, const Eigen::Matrix3Xd& x) {
  EdgeOffMiddle farthest;
  const auto edges = cell_edges(kind);
  for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
    const auto [a, b] = edges[static_cast<std::size_t>(e)];
    const double off = (x.col(kind.corners + e) - (x.col(a) + x.col(b)) / 2).norm(),
                 share = off / (x.col(b) - x.col(a)).norm();
    if (share > farthest.share) farthest = {e, share};
  }
  return farthest;
}

/// All sides of all cells, those with the same corners in a row.
std::vector<SideOfCell> sides_by_corners(const SolidMesh& mesh) {
  const int n = side_kind(mesh.kind()).corners;
  std::vector<SideOfCell> all;
  for (int e = 0; e < mesh.cell_count(); ++e)
    for (const CellSide& side : side_nodes(mesh, e)) {
      const int least =
          static_cast<int>(std::min_element(side.begin(), side.begin() + n) - side.begin());
      const int after = side[std::size_t((least + 1) % n)],
                before = side[std::size_t((least + n - 1) % n)];
      SideOfCell own{{-1, -1, -1, -1}, e, n == 2 ? least == 0 : after < before};
      std::copy(side.begin(), side.begin() + n, own.corners.begin());
      std::sort(own.corners.begin(), own.corners.begin() + n);
      all.push_back(own);
    }
  std::sort(all.begin(), all.end(), [](const SideOfCell& a, const SideOfCell& b) {
    return std::tie(a.corners, a.cell) < std::tie(b.corners, b.cell);
  });
  return all;
}

}  // namespace

void MeshBuilder::problem(int line, std::string what, std::string expected, std::string hint) {
  if (++reported_ <= kMostMeshProblems)
    problems_.add(
        {problems_.file(), line, 1, std::move(what), std::move(expected), std::move(hint)});
}

void MeshBuilder::add_node(std::size_t tag, const Eigen::Vector3d& x, int line) {
  if (!x.allFinite())
    problem(line, fmt::format("node {} lies at ({}, {}, {})", tag, x[0], x[1], x[2]),
            "finite coordinates (m)");
  if (!positions_.try_emplace(tag, x).second)
    problem(line, fmt::format("node {} is there twice", tag), "each node once", hints_.twice_node);
}

void MeshBuilder::add_cell(const CellKind& kind, std::vector<std::size_t> nodes, int line) {
  cells_.push_back({&kind, std::move(nodes), line});
}

/// Cells of the highest dimension; all of the kind of the first of them.
void MeshBuilder::choose_kind(SolidMesh& mesh) {
  for (const Cell& cell : cells_) mesh.dim = std::max(mesh.dim, cell.kind->dim);
  std::erase_if(cells_, [&](const Cell& cell) { return cell.kind->dim != mesh.dim; });
  const auto other = std::find_if(cells_.begin(), cells_.end(), [&](const Cell& cell) {
    return cell.kind != cells_.front().kind;
  });
  if (other == cells_.end()) return;
  problem(other->line,
          fmt::format("several kinds of cells: {} here, {} in line {}", other->kind->name,
                      cells_.front().kind->name, cells_.front().line),
          "cells of one kind", hints_.several_kinds);
  problems_.throw_if_any();
}

void MeshBuilder::number_nodes(SolidMesh& mesh) {
  std::vector<Eigen::Vector3d> used;
  bool planar = true;
  for (const Cell& cell : cells_)
    for (const std::size_t tag : cell.nodes) {
      const auto it = positions_.find(tag);
      if (it == positions_.end()) {
        problem(cell.line, fmt::format("node {} does not exist", tag), "a node of the file");
        continue;
      }
      if (!number_.try_emplace(tag, static_cast<int>(used.size())).second) continue;
      used.push_back(it->second);
      if (mesh.dim == 2 && planar && std::abs(it->second[2]) > 1e-12) {
        problem(cell.line, fmt::format("node {} lies at z = {}", tag, it->second[2]),
                "planar cells in z = 0");
        planar = false;
      }
    }
  problems_.throw_if_any();
  mesh.nodes.resize(3, static_cast<Eigen::Index>(used.size()));
  for (std::size_t i = 0; i < used.size(); ++i)
    mesh.nodes.col(static_cast<Eigen::Index>(i)) = used[i];
}

void MeshBuilder::add_cells(SolidMesh& mesh) {
  const int nodes_per_cell = cells_.front().kind->nodes;
  mesh.cells.resize(nodes_per_cell, static_cast<Eigen::Index>(cells_.size()));
  std::map<std::vector<std::size_t>, int> lines;  // of the cells, by their sorted nodes
  int number = 0;
  for (const Cell& cell : cells_) {
    std::vector<std::size_t> nodes = cell.nodes;
    std::sort(nodes.begin(), nodes.end());
    if (const auto [first, fresh] = lines.try_emplace(std::move(nodes), cell.line); !fresh)
      problem(cell.line,
              fmt::format("the cell has the nodes of the cell in line {}", first->second),
              "each cell once", hints_.twice_cell);
    for (int c = 0; c < nodes_per_cell; ++c)
      mesh.cells(c, number) = number_.at(cell.nodes[static_cast<std::size_t>(c)]);
    require_shape(cell, mesh.nodes_of(number));
    ++number;
  }
}

/// Its Jacobian is positive. If that of its corners alone is, nodes at its edges fold it.
void MeshBuilder::require_shape(const Cell& cell, const Eigen::Matrix3Xd& x) {
  const CellKind& kind = *cell.kind;
  if (smallest_jacobian(kind.dim, x) > 0) return;
  if (kind.order == 2 && smallest_jacobian(kind.dim, x.leftCols(kind.corners)) > 0) {
    const EdgeOffMiddle worst = farthest_off_middle(kind, x);
    const auto [a, b] = cell_edges(kind)[static_cast<std::size_t>(worst.edge)];
    const auto tag = [&cell](int node) { return cell.nodes[static_cast<std::size_t>(node)]; };
    problem(cell.line,
            fmt::format("the cell is folded by its nodes at edges: node {} is {:.2g} of the edge "
                        "between nodes {} and {} off its middle",
                        tag(kind.corners + worst.edge), worst.share, tag(a), tag(b)),
            "nodes at edges in their middle or near it", hints_.folded);
    return;
  }
  problem(cell.line, "the cell is inverted or flat",
          kind.dim == 2 ? "corners counter-clockwise, angles below 180 degrees"
          : kind.family == CellFamily::Simplex
              ? "the fourth corner where the first three are counter-clockwise seen from it"
              : "corners of the lower side counter-clockwise seen from above",
          kind.dim == 2 ? hints_.inverted : "");
}

/// Cells that share a side lie beyond it of each other: they have its corners in opposite order.
void MeshBuilder::find_folds(const SolidMesh& mesh) {
  const auto sides = sides_by_corners(mesh);
  std::set<int> told;
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const SideOfCell& here = sides[i];
    if (here.corners != sides[i - 1].corners) continue;
    const bool alike = here.forward == sides[i - 1].forward,
               third = i > 1 && here.corners == sides[i - 2].corners;
    if ((!alike && !third) || !told.insert(here.cell).second) continue;
    const SideOfCell& before = sides[alike ? i - 1 : i - 2];
    problem(cells_[static_cast<std::size_t>(here.cell)].line,
            fmt::format("the mesh is folded: the cell overlaps that in line {}, with which it "
                        "shares a side",
                        cells_[static_cast<std::size_t>(before.cell)].line),
            "cells that share a side on both sides of it",
            "a node beyond its neighbours, or a part that is meshed twice");
  }
}

SolidMesh MeshBuilder::build() {
  SolidMesh mesh;
  problems_.throw_if_any();
  choose_kind(mesh);
  number_nodes(mesh);
  if (cells_.empty()) {
    problem(1, "the file has no cells", "triangles, quadrilaterals, tetrahedra or hexahedra",
            hints_.no_cells);
    problems_.throw_if_any();
  }
  add_cells(mesh);
  if (reported_ == 0) find_folds(mesh);
  for (const auto& [name, tags] : sets_) {
    std::set<int> nodes;
    for (const std::size_t tag : tags)
      if (const auto n = number_.find(tag); n != number_.end()) nodes.insert(n->second);
    mesh.sets[name] = {nodes.begin(), nodes.end()};
  }
  problems_.throw_if_any();
  return mesh;
}

}  // namespace liesl
