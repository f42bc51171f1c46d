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
MatrixXd jacobian(int dim, const Eigen::Matrix3Xd& nodes, const MatrixXd& dN) {
  return dN * nodes.topRows(dim).transpose();
}

/// Strains of the incompatible modes: d(1 - xi_i^2)/dxi = -2 xi_i, mapped with the Jacobian J0 of
/// the centre and det J0 / det J.
struct IncompatibleModes {
  MatrixXd K_ua, K_aa, J0inverse;
  double det0;

  IncompatibleModes(int dim, Eigen::Index freedoms, const MatrixXd& J0)
      : K_ua(MatrixXd::Zero(freedoms, dim * dim)),
        K_aa(MatrixXd::Zero(dim * dim, dim * dim)),
        J0inverse(linalg::inverse(J0)),
        det0(linalg::determinant(J0)) {}

  void add(const Vector3d& xi, double det, double w, const MatrixXd& B, const MatrixXd& D) {
    const int dim = static_cast<int>(J0inverse.rows());
    const MatrixXd modes = (-2 * xi.head(dim)).asDiagonal();
    const MatrixXd G = strain_matrix(dim, det0 / det * J0inverse * modes);
    K_ua += w * B.transpose() * D * G;
    K_aa += w * G.transpose() * D * G;
  }
};

}  // namespace

CellMatrices cell_matrices(int dim, const Eigen::Matrix3Xd& nodes, const Material& material,
                           double thickness) {
  const auto n = nodes.cols();
  const CellKind& kind = cell_kind(dim, static_cast<int>(n));
  const MatrixXd D = elasticity(dim, material);
  const MatrixXd dN0 = cell_functions(kind, reference_centre(kind)).dN;
  const MatrixXd J0 = jacobian(dim, nodes, dN0);
  const double depth = dim == 2 ? thickness : 1;
  IncompatibleModes modes(dim, dim * n, J0);
  const bool incompatible = kind.family == CellFamily::Cube && kind.order == 1;
  CellMatrices cell;
  cell.stress = D * strain_matrix(dim, modes.J0inverse * dN0);
  cell.K = MatrixXd::Zero(dim * n, dim * n);
  cell.M = MatrixXd::Zero(n, n);
  for (const QuadraturePoint& p : cell_quadrature(kind, QuadratureUse::Stiffness)) {
    const CellFunctions f = cell_functions(kind, p.xi);
    const MatrixXd J = jacobian(dim, nodes, f.dN);
    const double det = linalg::determinant(J), w = p.weight * det * depth;
    const MatrixXd B = strain_matrix(dim, linalg::inverse(J) * f.dN);
    cell.K += w * B.transpose() * D * B;
    if (incompatible) modes.add(p.xi, det, w, B, D);
  }
  for (const QuadraturePoint& p : cell_quadrature(kind, QuadratureUse::Mass)) {
    const CellFunctions f = cell_functions(kind, p.xi);
    const double w = p.weight * linalg::determinant(jacobian(dim, nodes, f.dN)) * depth;
    cell.M += w * material.rho * f.N * f.N.transpose();
    cell.volume += w;
  }
  if (incompatible) cell.K -= modes.K_ua * linalg::LDLT(modes.K_aa).solve(modes.K_ua.transpose());
  cell.K = (0.5 * (cell.K + cell.K.transpose())).eval();
  return cell;
}

}  // namespace liesl
