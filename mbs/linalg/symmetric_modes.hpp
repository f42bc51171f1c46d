#pragma once
/// @file
/// Lowest eigenpairs of a large sparse symmetric pencil, with Cholesky factors.

#include <Eigen/SparseCore>

namespace liesl {

struct SymmetricModes {
  bool converged = false;
  Eigen::VectorXd lambda;  ///< growing
  Eigen::MatrixXd phi;     ///< phi^T M phi = I
};

/// K phi = lambda M phi by Lanczos (Spectra) on (K + tau M)^-1, where tau > 0 keeps K + tau M
/// positive definite when K has free motions: first with a tau next to zero, which finds the size
/// of the eigenvalues, then with one of that size.
/// @param K, M lower triangles; positive semidefinite, positive definite together
/// @param count at most n - 1
SymmetricModes symmetric_modes(const Eigen::SparseMatrix<double>& K,
                               const Eigen::SparseMatrix<double>& M, int count);

}  // namespace liesl
