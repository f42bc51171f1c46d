#pragma once
/// @file
/// The kinds of cells that a mesh may have, as a table, with functions and quadrature of their
/// reference cells.

#include <Eigen/Core>
#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace liesl {

/// Reference cells. Cube: xi in [-1, 1]^dim. Simplex: xi_i >= 0, their sum at most 1.
enum class CellFamily { Cube, Simplex };

/// Order 1: nodes at the corners. Order 2: also one at each edge, serendipity on cubes. Nodes are
/// in the order of VTK (and Abaqus): corners counter-clockwise, in space seen from above, first
/// below, then above; then the edges in the order of `cell_edges`.
struct CellKind {
  std::string_view name;  ///< "10-node tetrahedron"
  int dim;
  CellFamily family;
  int order;
  int nodes, corners;
  int gmsh;                 ///< type number of Gmsh
  std::string_view abaqus;  ///< without what stands behind it: "C3D10"
  int vtk;                  ///< cell type of VTK
  std::string_view xdmf;    ///< topology type of XDMF
};

/// All rows: planar cells, cells in space, and the lines that are sides of planar cells.
std::span<const CellKind> cell_kinds();
/// The one with so many nodes. @throws std::invalid_argument if there is none
const CellKind& cell_kind(int dim, int nodes);
/// That of the sides of a cell.
const CellKind& side_kind(const CellKind& kind);

/// Pairs of corners.
std::span<const std::array<int, 2>> cell_edges(const CellKind& kind);

/// Nodes of one side: corners in their order round it, then those at its edges, then -1.
using CellSide = std::array<int, 8>;
/// Local nodes of each side, in the order that makes its normal point outwards.
std::span<const CellSide> cell_sides(const CellKind& kind);

/// Local numbers in the order of VTK -> where Gmsh has that node.
std::span<const int> gmsh_order(const CellKind& kind);

/// Values and gradients of the functions of the nodes at reference coordinates xi: N [nodes],
/// dN [dim x nodes].
struct CellFunctions {
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 20, 1> N;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 20> dN;
};
CellFunctions cell_functions(const CellKind& kind, const Eigen::Vector3d& xi);

/// Where the nodes are in the reference cell, and its centre.
Eigen::Vector3d reference_node(const CellKind& kind, int node);
Eigen::Vector3d reference_centre(const CellKind& kind);

struct QuadraturePoint {
  Eigen::Vector3d xi;
  double weight;
};
enum class QuadratureUse { Stiffness, Mass };
/// Cubes: 2 (order 1) or 3 points of Gauss a direction. Simplices: exact for the stiffness (order
/// 1: a constant, order 2: degree 2) and the mass (degree 2; 4) of cells with straight edges
/// (Dunavant 1985, Int. J. Numer. Meth. Engng 21, 1129-1148; Walkington 2000, "Quadrature on
/// simplices of arbitrary dimension").
const std::vector<QuadraturePoint>& cell_quadrature(const CellKind& kind, QuadratureUse use);

}  // namespace liesl
