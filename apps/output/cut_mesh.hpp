#pragma once
/// @file
/// A mesh, or what a level set leaves of it, for a picture: triangles that move with its nodes.

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "mbs/solids/cell_kind.hpp"

namespace liesl::output {

/// Vertices are points on lines between two nodes (or nodes, i = j), so that they go where the
/// nodes go.
struct CutMesh {
  struct Vertex {
    int i = 0, j = 0;
    double t = 0;  ///< x = (1 - t) x_i + t x_j
  };
  std::vector<Vertex> vertices;
  /// Planar: of the whole area. In space: of the surface, counter-clockwise seen from outside.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// Planar: sides of the outline, material on the left.
  std::vector<std::array<std::uint32_t, 2>> sides;
};

/// Cells of order 2 are drawn as flat triangles between their nodes.
/// @param cells nodes of each cell, in the order of VTK  @param nodes x, y, z of each node
/// @param level at the nodes, > 0: material; empty: all is material. Only of 4-node quadrilaterals
/// and 8-node hexahedra
CutMesh cut_mesh(const CellKind& kind, const std::vector<int>& cells,
                 const std::vector<double>& nodes, const std::vector<double>& level);

/// The kind of cells that a results file names; without a name, as earlier versions wrote them,
/// 4-node quadrilaterals or 8-node hexahedra.
const CellKind& stored_cells(std::string_view name, int nodes);

}  // namespace liesl::output
