#include "mbs/solids/incompatible_modes.hpp"

#include "mbs/linalg/dense.hpp"

namespace liesl {

using Eigen::MatrixXd;

MatrixXd strain_matrix(int dim, const MatrixXd& dN) {
  MatrixXd B = MatrixXd::Zero(strain_count(dim), dim * dN.cols());
  for (Eigen::Index c = 0; c < dN.cols(); ++c) {
    for (int i = 0; i < dim; ++i) B(i, dim * c + i) = dN(i, c);
    for (int s = dim; s < strain_count(dim); ++s) {  // xy, yz, zx
      const int i = s - dim, j = (i + 1) % dim;
      B(s, dim * c + i) = dN(j, c);
      B(s, dim * c + j) = dN(i, c);
    }
  }
  return B;
}

MatrixXd cell_jacobian(int dim, const Eigen::Ref<const MatrixXd>& nodes, const MatrixXd& dN) {
  return dN * nodes.topRows(dim).transpose();
}

IncompatibleModes::IncompatibleModes(const MatrixXd& J0)
    : J0inverse_(linalg::inverse(J0)), det0_(linalg::determinant(J0)) {}

MatrixXd IncompatibleModes::strains(const Eigen::Vector3d& xi, double det) const {
  const int dim = static_cast<int>(J0inverse_.rows());
  const MatrixXd modes = (-2 * xi.head(dim)).asDiagonal();
  return strain_matrix(dim, det0_ / det * J0inverse_ * modes);
}

/// d(J0^-1) = -J0^-1 dJ0 J0^-1, d(det J0) = det J0 tr(J0^-1 dJ0).
MatrixXd IncompatibleModes::strains_variation(const Eigen::Vector3d& xi, double det,
                                              const MatrixXd& dJ0, double relative) const {
  const int dim = static_cast<int>(J0inverse_.rows());
  const MatrixXd modes = (-2 * xi.head(dim)).asDiagonal(), turned = J0inverse_ * dJ0;
  return strain_matrix(
      dim, det0_ / det * ((turned.trace() - relative) * J0inverse_ - turned * J0inverse_) * modes);
}

}  // namespace liesl
