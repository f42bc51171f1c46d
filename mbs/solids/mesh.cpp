#include "mbs/solids/mesh.hpp"

#include <Eigen/LU>
#include <array>
#include <limits>
#include <stdexcept>

namespace liesl {
namespace {

using Eigen::Vector3d;

double jacobian_determinant(const CellKind& kind, const Eigen::Matrix3Xd& nodes,
                            const Vector3d& xi) {
  const Eigen::MatrixXd J = nodes.topRows(kind.dim) * cell_functions(kind, xi).dN.transpose();
  return kind.dim == 2 ? J.topLeftCorner<2, 2>().determinant()
                       : J.topLeftCorner<3, 3>().determinant();
}

SolidMesh grid(int dim, const Vector3d& from, const Vector3d& to, std::array<int, 3> n) {
  for (int i = 0; i < dim; ++i)
    if (n[i] < 1 || !(to[i] > from[i]))
      throw std::invalid_argument("a grid needs at least one cell and from < to in each direction");
  SolidMesh mesh;
  mesh.dim = dim;
  const int mx = n[0] + 1, my = n[1] + 1, mz = dim == 2 ? 1 : n[2] + 1;
  const int layers = dim == 2 ? 1 : n[2], corners = dim == 2 ? 4 : 8;
  mesh.nodes.resize(3, static_cast<Eigen::Index>(mx) * my * mz);
  mesh.cells.resize(corners, static_cast<Eigen::Index>(n[0]) * n[1] * layers);
  const char axes[] = "xyz";
  for (int k = 0, node = 0; k < mz; ++k) {
    for (int j = 0; j < my; ++j) {
      for (int i = 0; i < mx; ++i, ++node) {
        const std::array<int, 3> at = {i, j, k};
        Vector3d x = from;
        for (int a = 0; a < dim; ++a) {
          x[a] = at[a] == n[a] ? to[a] : from[a] + (to[a] - from[a]) * at[a] / n[a];
          if (at[a] == 0) mesh.sets[std::string(1, axes[a]) + "_min"].push_back(node);
          if (at[a] == n[a]) mesh.sets[std::string(1, axes[a]) + "_max"].push_back(node);
        }
        mesh.nodes.col(node) = x;
      }
    }
  }
  for (int k = 0, cell = 0; k < layers; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i, ++cell)
        for (int c = 0; c < corners; ++c)
          mesh.cells(c, cell) = ((k + c / 4) * my + j + c / 2 % 2) * mx + i + (c + 1) / 2 % 2;
  return mesh;
}

}  // namespace

Eigen::Matrix3Xd SolidMesh::nodes_of(int cell) const {
  Eigen::Matrix3Xd x(3, nodes_per_cell());
  for (int c = 0; c < nodes_per_cell(); ++c) x.col(c) = nodes.col(cells(c, cell));
  return x;
}

Eigen::Matrix3Xd SolidMesh::corners_of(int cell) const {
  return nodes_of(cell).leftCols(corners());
}

double SolidMesh::cell_size(int cell) const {
  const Eigen::Matrix3Xd x = nodes_of(cell);
  double size = 0;
  for (const QuadraturePoint& p : cell_quadrature(kind(), QuadratureUse::Mass))
    size += p.weight * jacobian_determinant(kind(), x, p.xi);
  return size;
}

SolidMesh quad_grid(const Eigen::Vector2d& from, const Eigen::Vector2d& to, int nx, int ny) {
  return grid(2, {from[0], from[1], 0}, {to[0], to[1], 0}, {nx, ny, 0});
}

SolidMesh hex_grid(const Vector3d& from, const Vector3d& to, int nx, int ny, int nz) {
  return grid(3, from, to, {nx, ny, nz});
}

std::vector<int> nodes_where(const SolidMesh& mesh,
                             const std::function<bool(const Vector3d&)>& condition) {
  std::vector<int> found;
  for (int i = 0; i < mesh.node_count(); ++i)
    if (condition(mesh.nodes.col(i))) found.push_back(i);
  return found;
}

CellFunctions corner_functions(int dim, const Vector3d& xi) {
  return cell_functions(cell_kind(dim, dim == 2 ? 4 : 8), xi);
}

double smallest_jacobian(int dim, const Eigen::Matrix3Xd& nodes) {
  const CellKind& kind = cell_kind(dim, static_cast<int>(nodes.cols()));
  double least = std::numeric_limits<double>::infinity();
  for (int n = 0; n < kind.nodes; ++n)
    least = std::min(least, jacobian_determinant(kind, nodes, reference_node(kind, n)));
  for (const QuadraturePoint& p : cell_quadrature(kind, QuadratureUse::Mass))
    least = std::min(least, jacobian_determinant(kind, nodes, p.xi));
  return least;
}

std::vector<CellSide> side_nodes(const SolidMesh& mesh, int cell) {
  std::vector<CellSide> sides;
  for (CellSide side : cell_sides(mesh.kind())) {
    for (int& node : side)
      if (node >= 0) node = mesh.cells(node, cell);
    sides.push_back(side);
  }
  return sides;
}

}  // namespace liesl
