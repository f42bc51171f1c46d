#include "mbs/solids/cell.hpp"

#include <cmath>

#include "mbs/linalg/dense.hpp"
#include "mbs/solids/mesh.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;

int strains(int dim) { return dim == 2 ? 3 : 6; }

/// Isotropic law: plane stress, or space.
MatrixXd elasticity(int dim, const Material& m) {
  MatrixXd D = MatrixXd::Zero(strains(dim), strains(dim));
  if (dim == 2) {
    const double c = m.E / (1 - m.nu * m.nu);
    D.topLeftCorner(2, 2) << c, c * m.nu, c * m.nu, c;
    D(2, 2) = m.G();
  } else {
    const double lame = m.E * m.nu / ((1 + m.nu) * (1 - 2 * m.nu));
    D.topLeftCorner(3, 3).setConstant(lame);
    D.diagonal().head(3).array() += 2 * m.G();
    D.diagonal().tail(3).setConstant(m.G());
  }
  return D;
}

/// Strain-displacement matrix of functions with gradients dN (dim x functions).
MatrixXd strain_matrix(int dim, const MatrixXd& dN) {
  MatrixXd B = MatrixXd::Zero(strains(dim), dim * dN.cols());
  for (Eigen::Index c = 0; c < dN.cols(); ++c) {
    for (int i = 0; i < dim; ++i) B(i, dim * c + i) = dN(i, c);
    for (int s = dim; s < strains(dim); ++s) {  // xy, yz, zx
      const int i = s - dim, j = (i + 1) % dim;
      B(s, dim * c + i) = dN(j, c);
      B(s, dim * c + j) = dN(i, c);
    }
  }
  return B;
}

/// dx/dxi transposed: rows xi, columns x.
MatrixXd jacobian(int dim, const Eigen::Matrix3Xd& corners, const MatrixXd& dN) {
  return dN * corners.topRows(dim).transpose();
}

}  // namespace

CellMatrices cell_matrices(int dim, const Eigen::Matrix3Xd& corners, const Material& material,
                           double thickness) {
  const auto n = corners.cols();
  const MatrixXd D = elasticity(dim, material);
  const MatrixXd dN0 = corner_functions(dim, Vector3d::Zero()).dN;
  const MatrixXd J0 = jacobian(dim, corners, dN0), J0inverse = linalg::inverse(J0);
  const double det0 = linalg::determinant(J0), depth = dim == 2 ? thickness : 1;
  CellMatrices cell;
  cell.stress = D * strain_matrix(dim, J0inverse * dN0);
  cell.K = MatrixXd::Zero(dim * n, dim * n);
  cell.M = MatrixXd::Zero(n, n);
  MatrixXd K_ua = MatrixXd::Zero(dim * n, dim * dim), K_aa = MatrixXd::Zero(dim * dim, dim * dim);
  const double g = 1 / std::sqrt(3.0);
  for (int point = 0; point < (dim == 2 ? 4 : 8); ++point) {
    const Vector3d xi(point & 1 ? g : -g, point & 2 ? g : -g, point & 4 ? g : -g);
    const CornerFunctions f = corner_functions(dim, xi);
    const MatrixXd J = jacobian(dim, corners, f.dN);
    const double det = linalg::determinant(J), w = det * depth;
    const MatrixXd B = strain_matrix(dim, linalg::inverse(J) * f.dN);
    // d(1 - xi_i^2)/dxi = -2 xi_i, mapped with the Jacobian of the centre.
    const MatrixXd modes = (-2 * xi.head(dim)).asDiagonal();
    const MatrixXd G = strain_matrix(dim, det0 / det * J0inverse * modes);
    cell.K += w * B.transpose() * D * B;
    K_ua += w * B.transpose() * D * G;
    K_aa += w * G.transpose() * D * G;
    cell.M += w * material.rho * f.N * f.N.transpose();
    cell.volume += w;
  }
  cell.K -= K_ua * linalg::LDLT(K_aa).solve(K_ua.transpose());
  cell.K = (0.5 * (cell.K + cell.K.transpose())).eval();
  return cell;
}

}  // namespace liesl
