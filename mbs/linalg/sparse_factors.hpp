#pragma once
/// @file
/// Factors of a sparse matrix of which it is not known beforehand whether it is symmetric and
/// positive definite: L L^T where it is, else L U.

#include "mbs/linalg/sparse_cholesky.hpp"
#include "mbs/linalg/sparse_lu.hpp"

namespace liesl {

class SparseFactors {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  /// @pre the pattern is that of the first call, A is compressed and square
  /// @returns false if A is singular or not finite: there are no factors then.
  bool factor(const Matrix& A);
  /// b <- A^-1 b. @pre the last `factor` returned true
  void solve(Eigen::Ref<Eigen::MatrixXd> b) const;
  /// Whether the last `factor` took L L^T.
  bool symmetric() const { return symmetric_; }

 private:
  SparseCholesky cholesky_{false};  // the steps of a solver look for stops
  SparseLu lu_;
  bool symmetric_ = false;
};

}  // namespace liesl
