#pragma once
/// @file
/// Meshes of cells of one kind, with named sets of nodes.

#include <Eigen/Core>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "mbs/solids/cell_kind.hpp"

namespace liesl {

/// Cells of one kind, which their dimension and number of nodes tell.
struct SolidMesh {
  int dim = 2;                                   ///< 2: planar, in z = 0; 3: in space
  Eigen::Matrix3Xd nodes;                        ///< m, by columns
  Eigen::MatrixXi cells;                         ///< nodes per cell x number of cells
  std::map<std::string, std::vector<int>> sets;  ///< name -> nodes, growing

  int node_count() const { return static_cast<int>(nodes.cols()); }
  int cell_count() const { return static_cast<int>(cells.cols()); }
  int nodes_per_cell() const { return static_cast<int>(cells.rows()); }
  /// @throws std::invalid_argument for a number of nodes that no kind has
  const CellKind& kind() const { return cell_kind(dim, nodes_per_cell()); }
  int corners() const { return kind().corners; }
  Eigen::Matrix3Xd corners_of(int cell) const;
  Eigen::Matrix3Xd nodes_of(int cell) const;
  /// Area (m^2) or volume (m^3) of a cell.
  double cell_size(int cell) const;
};

/// nx x ny equal quadrilaterals between two corners; sets "x_min", "x_max", "y_min", "y_max".
/// @throws std::invalid_argument if a count is below 1 or the box is empty
SolidMesh quad_grid(const Eigen::Vector2d& from, const Eigen::Vector2d& to, int nx, int ny);
/// nx x ny x nz equal hexahedra; sets as above and "z_min", "z_max".
SolidMesh hex_grid(const Eigen::Vector3d& from, const Eigen::Vector3d& to, int nx, int ny, int nz);

/// Nodes whose position satisfies a condition, growing.
std::vector<int> nodes_where(const SolidMesh& mesh,
                             const std::function<bool(const Eigen::Vector3d&)>& condition);

/// Nodes of the sides of a cell, as `cell_sides` orders them.
std::vector<CellSide> side_nodes(const SolidMesh& mesh, int cell);

/// Functions of the 4-node quadrilateral or the 8-node hexahedron.
CellFunctions corner_functions(int dim, const Eigen::Vector3d& xi);

/// Smallest determinant of the Jacobian dx/dxi at the nodes and the points of quadrature of a cell:
/// <= 0 for a cell that is inverted or flat. @param nodes 3 x nodes of the cell
double smallest_jacobian(int dim, const Eigen::Matrix3Xd& nodes);

}  // namespace liesl
