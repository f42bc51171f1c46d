#include "mbs/solids/mesh.hpp"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace liesl {
namespace {

using Eigen::Vector3d;

/// Reference coordinates of the corners.
Vector3d corner(int dim, int c) {
  return {(c + 1) / 2 % 2 ? 1.0 : -1.0, c / 2 % 2 ? 1.0 : -1.0,
          dim == 2 ? 0.0
          : c / 4  ? 1.0
                   : -1.0};
}

double jacobian_determinant(int dim, const Eigen::Matrix3Xd& corners, const Vector3d& xi) {
  const Eigen::MatrixXd J = corners.topRows(dim) * corner_functions(dim, xi).dN.transpose();
  return dim == 2 ? J.topLeftCorner<2, 2>().determinant() : J.topLeftCorner<3, 3>().determinant();
}

SolidMesh grid(int dim, const Vector3d& from, const Vector3d& to, std::array<int, 3> n) {
  for (int i = 0; i < dim; ++i)
    if (n[i] < 1 || !(to[i] > from[i]))
      throw std::invalid_argument("a grid needs at least one cell and from < to in each direction");
  SolidMesh mesh;
  mesh.dim = dim;
  const int mx = n[0] + 1, my = n[1] + 1, mz = dim == 2 ? 1 : n[2] + 1;
  const int layers = dim == 2 ? 1 : n[2];
  mesh.nodes.resize(3, static_cast<Eigen::Index>(mx) * my * mz);
  mesh.cells.resize(mesh.corners(), static_cast<Eigen::Index>(n[0]) * n[1] * layers);
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
        for (int c = 0; c < mesh.corners(); ++c)
          mesh.cells(c, cell) = ((k + c / 4) * my + j + c / 2 % 2) * mx + i + (c + 1) / 2 % 2;
  return mesh;
}

}  // namespace

Eigen::Matrix3Xd SolidMesh::corners_of(int cell) const {
  Eigen::Matrix3Xd x(3, corners());
  for (int c = 0; c < corners(); ++c) x.col(c) = nodes.col(cells(c, cell));
  return x;
}

double SolidMesh::cell_size(int cell) const {
  const Eigen::Matrix3Xd x = corners_of(cell);
  const double g = 1 / std::sqrt(3.0);  // Gauss, exact for the Jacobian
  double size = 0;
  for (int c = 0; c < corners(); ++c) size += jacobian_determinant(dim, x, g * corner(dim, c));
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

CornerFunctions corner_functions(int dim, const Vector3d& xi) {
  const int n = dim == 2 ? 4 : 8;
  CornerFunctions f;
  f.N.resize(n);
  f.dN.resize(dim, n);
  for (int c = 0; c < n; ++c) {
    const Vector3d s = corner(dim, c);
    std::array<double, 3> factor = {(1 + s[0] * xi[0]) / 2, (1 + s[1] * xi[1]) / 2, 1};
    if (dim == 3) factor[2] = (1 + s[2] * xi[2]) / 2;
    f.N[c] = factor[0] * factor[1] * factor[2];
    for (int a = 0; a < dim; ++a) f.dN(a, c) = s[a] / 2 * factor[(a + 1) % 3] * factor[(a + 2) % 3];
  }
  return f;
}

double smallest_jacobian(int dim, const Eigen::Matrix3Xd& corners) {
  double least = std::numeric_limits<double>::infinity();
  for (int c = 0; c < corners.cols(); ++c)
    least = std::min(least, jacobian_determinant(dim, corners, corner(dim, c)));
  return least;
}

std::vector<std::array<int, 4>> side_nodes(const SolidMesh& mesh, int cell) {
  static constexpr std::array<std::array<int, 4>, 6> faces = {
      {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
  std::vector<std::array<int, 4>> sides;
  for (int s = 0; s < (mesh.dim == 2 ? 4 : 6); ++s) {
    std::array<int, 4> side = {mesh.cells(s % 4, cell), mesh.cells((s + 1) % 4, cell), -1, -1};
    if (mesh.dim == 3)
      for (int i = 0; i < 4; ++i) side[i] = mesh.cells(faces[s][i], cell);
    sides.push_back(side);
  }
  return sides;
}

}  // namespace liesl
