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
/// of the eigenvalues, then with one of that size. A Krylov space holds one vector of an eigenvalue
/// that occurs several times, the others only by round-off; hence `free`.
/// @param K, M lower triangles; positive semidefinite, positive definite together
/// @param count at most n - 1 - free.cols()
/// @param free independent columns with K free = 0: the modes are sought M-orthogonal to them and
/// do not hold them
SymmetricModes symmetric_modes(const Eigen::SparseMatrix<double>& K,
                               const Eigen::SparseMatrix<double>& M, int count,
                               const Eigen::MatrixXd& free = {});

}  // namespace liesl
