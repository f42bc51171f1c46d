#include "mbs/solids/cell.hpp"

#include <cmath>

#include "mbs/linalg/dense.hpp"
#include "mbs/solids/incompatible_modes.hpp"
#include "mbs/solids/mesh.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;

/// Isotropic law: plane stress, or space.
MatrixXd elasticity(int dim, const Material& m) {
  MatrixXd D = MatrixXd::Zero(strain_count(dim), strain_count(dim));
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

}  // namespace

CellMatrices cell_matrices(int dim, const Eigen::Matrix3Xd& nodes, const Material& material,
                           double thickness) {
  const auto n = nodes.cols();
  const CellKind& kind = cell_kind(dim, static_cast<int>(n));
  const MatrixXd D = elasticity(dim, material);
  const MatrixXd dN0 = cell_functions(kind, reference_centre(kind)).dN;
  const MatrixXd J0 = cell_jacobian(dim, nodes, dN0);
  const double depth = dim == 2 ? thickness : 1;
  const IncompatibleModes modes(J0);
  const bool incompatible = kind.family == CellFamily::Cube && kind.order == 1;
  MatrixXd K_ua = MatrixXd::Zero(dim * n, dim * dim), K_aa = MatrixXd::Zero(dim * dim, dim * dim);
  CellMatrices cell;
  cell.stress = D * strain_matrix(dim, modes.inverse() * dN0);
  cell.K = MatrixXd::Zero(dim * n, dim * n);
  cell.M = MatrixXd::Zero(n, n);
  for (const QuadraturePoint& p : cell_quadrature(kind, QuadratureUse::Stiffness)) {
    const CellFunctions f = cell_functions(kind, p.xi);
    const MatrixXd J = cell_jacobian(dim, nodes, f.dN);
    const double det = linalg::determinant(J), w = p.weight * det * depth;
    const MatrixXd B = strain_matrix(dim, linalg::inverse(J) * f.dN);
    cell.K += w * B.transpose() * D * B;
    if (!incompatible) continue;
    const MatrixXd G = modes.strains(p.xi, det);
    K_ua += w * B.transpose() * D * G;
    K_aa += w * G.transpose() * D * G;
  }
  for (const QuadraturePoint& p : cell_quadrature(kind, QuadratureUse::Mass)) {
    const CellFunctions f = cell_functions(kind, p.xi);
    const double w = p.weight * linalg::determinant(cell_jacobian(dim, nodes, f.dN)) * depth;
    cell.M += w * material.rho * f.N * f.N.transpose();
    cell.volume += w;
  }
  if (incompatible) cell.K -= K_ua * linalg::LDLT(K_aa).solve(K_ua.transpose());
  cell.K = (0.5 * (cell.K + cell.K.transpose())).eval();
  return cell;
}

}  // namespace liesl
