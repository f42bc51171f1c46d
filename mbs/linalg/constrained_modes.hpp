#pragma once
/// @file
/// Lowest eigenpairs of a symmetric pencil on a null space.

#include <Eigen/SparseCore>

namespace liesl {

/// K phi + B^T nu = lambda M phi, B phi = 0, phi^T M phi = 1.
struct ConstrainedModes {
  bool converged = false;
  Eigen::VectorXd lambda;  ///< growing; free motions exactly 0
  Eigen::MatrixXd phi;
  std::vector<double> residuals;  ///< |K phi + B^T nu - lambda M phi| / | |K| |phi| |
};

/// @param A [K B^T; B 0]; K is used as its symmetric part  @param M n x n, positive definite on the
/// null space of B  @param count how many; fewer if the null space is smaller
enum class ModesMethod { Auto, Dense, Lanczos };
ConstrainedModes constrained_modes(const Eigen::SparseMatrix<double>& A,
                                   const Eigen::SparseMatrix<double>& M, int count,
                                   ModesMethod method = ModesMethod::Auto);

}  // namespace liesl
