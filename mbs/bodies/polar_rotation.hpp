#pragma once
/// @file
/// The rotation in a deformation gradient.

#include <Eigen/LU>

namespace liesl {

/// R of F = R U (N. J. Higham, Computing the polar decomposition, SIAM J. Sci. Stat. Comput. 7
/// (1986)); `otherwise` for a gradient that is inverted.
template <int D>
inline Eigen::Matrix<double, D, D> polar_rotation(const Eigen::Matrix<double, D, D>& F,
                                                  const Eigen::Matrix<double, D, D>& otherwise) {
  if (!(F.determinant() > 0)) return otherwise;
  constexpr int kIterations = 30;
  constexpr double kDone = 1e-15;
  Eigen::Matrix<double, D, D> R = F;
  for (int i = 0; i < kIterations; ++i) {
    const Eigen::Matrix<double, D, D> next = 0.5 * (R + R.inverse().transpose());
    const double change = (next - R).norm();
    R = next;
    if (change <= kDone) break;
  }
  return R;
}

}  // namespace liesl
