#pragma once
/// @file
/// What a level set leaves of a mesh, for a picture: triangles that move with its nodes.

#include <array>
#include <cstdint>
#include <vector>

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

/// @param corners 4 or 8 nodes a cell, in the order of VTK  @param nodes x, y, z of each node
/// @param level at the nodes, > 0: material; empty: all is material
CutMesh cut_mesh(int corners, const std::vector<int>& cells, const std::vector<double>& nodes,
                 const std::vector<double>& level);

}  // namespace liesl::output
