#pragma once
/// @file
/// Meshes of quadrilaterals (planar) and hexahedra, with named sets of nodes.

#include <Eigen/Core>
#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace liesl {

/// Cells have 4 or 8 corners in the order of Gmsh and VTK: counter-clockwise, for hexahedra seen
/// from above, first below, then above.
struct SolidMesh {
  int dim = 2;                                   ///< 2: quadrilaterals in z = 0; 3: hexahedra
  Eigen::Matrix3Xd nodes;                        ///< m, by columns
  Eigen::MatrixXi cells;                         ///< 4 or 8 x number of cells
  std::map<std::string, std::vector<int>> sets;  ///< name -> nodes, growing

  int node_count() const { return static_cast<int>(nodes.cols()); }
  int cell_count() const { return static_cast<int>(cells.cols()); }
  int corners() const { return dim == 2 ? 4 : 8; }
  Eigen::Matrix3Xd corners_of(int cell) const;
  /// Area (m^2) or volume (m^3) of a cell.
  double cell_size(int cell) const;
};

/// nx x ny equal cells between two corners; sets "x_min", "x_max", "y_min", "y_max".
/// @throws std::invalid_argument if a count is below 1 or the box is empty
SolidMesh quad_grid(const Eigen::Vector2d& from, const Eigen::Vector2d& to, int nx, int ny);
/// nx x ny x nz equal cells; sets as above and "z_min", "z_max".
SolidMesh hex_grid(const Eigen::Vector3d& from, const Eigen::Vector3d& to, int nx, int ny, int nz);

/// Nodes whose position satisfies a condition, growing.
std::vector<int> nodes_where(const SolidMesh& mesh,
                             const std::function<bool(const Eigen::Vector3d&)>& condition);

/// Nodes of the sides of a cell in their order round the side: 4 sides of 2 (then -1, -1), or 6
/// of 4.
std::vector<std::array<int, 4>> side_nodes(const SolidMesh& mesh, int cell);

/// Values and gradients of the (bi-, tri-)linear functions of the corners at reference coordinates
/// xi in [-1, 1]^dim: N [corners], dN [dim x corners].
struct CornerFunctions {
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 8, 1> N;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 8> dN;
};
CornerFunctions corner_functions(int dim, const Eigen::Vector3d& xi);

/// Smallest determinant of the Jacobian dx/dxi at the corners of a cell: <= 0 for a cell that is
/// inverted or flat.
double smallest_jacobian(int dim, const Eigen::Matrix3Xd& corners);

}  // namespace liesl
