#include "mbs/linalg/sparse_factors.hpp"

namespace liesl {
namespace {

constexpr double kRoundOff = 1e-13;  // of the larger of two diagonal entries: no difference

/// A = A^T up to the round-off of an assembly?
bool is_symmetric(const Eigen::SparseMatrix<double>& A) {
  const Eigen::SparseMatrix<double> T = A.transpose();
  const Eigen::VectorXd diagonal = A.diagonal().cwiseAbs();
  for (int j = 0; j < A.outerSize(); ++j) {
    Eigen::SparseMatrix<double>::InnerIterator a(A, j), t(T, j);
    for (; a && t; ++a, ++t) {
      if (a.row() != t.row()) return false;
      const double size = std::max(diagonal[a.row()], diagonal[j]);
      if (!(std::abs(a.value() - t.value()) <= kRoundOff * size)) return false;
    }
    if (a || t) return false;
  }
  return true;
}

}  // namespace

bool SparseFactors::factor(const Matrix& A) {
  symmetric_ = is_symmetric(A) && cholesky_.factor(A);
  return symmetric_ || lu_.factor(A);
}

void SparseFactors::solve(Eigen::Ref<Eigen::MatrixXd> b) const {
  if (symmetric_)
    b = cholesky_.solve(b);
  else
    lu_.solve(b);
}

}  // namespace liesl
