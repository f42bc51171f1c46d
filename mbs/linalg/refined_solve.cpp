#include "mbs/linalg/refined_solve.hpp"

#include <cmath>

namespace liesl {

using Eigen::MatrixXd;

namespace {

constexpr int kRefinements = 2;
constexpr Eigen::Index kAtOnce = 4;  // columns: those of one AVX register

/// (to + rest) -= a x of `kAtOnce` numbers in twice the precision, error-free products and sums
/// (Ogita, Rump, Oishi 2005, "Accurate sum and dot product", SIAM J. Sci. Comput. 26). A function
/// of its own: inlined, the compiler forgets that nothing overlaps and takes one number at a time.
[[gnu::noinline]] void subtract(double a, const double* __restrict x, double* __restrict to,
                                double* __restrict rest) {
  for (Eigen::Index k = 0; k < kAtOnce; ++k) {
    const double product = a * x[k], product_error = std::fma(a, x[k], -product);
    const double sum = to[k] - product, part = sum - to[k];
    rest[k] += ((to[k] - (sum - part)) - (product + part)) - product_error;
    to[k] = sum;
  }
}

/// Is the next correction below round-off, in displacements and in multipliers? Corrections shrink
/// by the ratio of the first one to the solution.
bool exact(const MatrixXd& correction, const MatrixXd& x, Eigen::Index n) {
  constexpr double kSmall = 1e-10;  // its square is far below 1e-16
  for (Eigen::Index j = 0; j < x.cols(); ++j) {
    const auto c = correction.col(j), of = x.col(j);
    const auto m = x.rows() - n;
    if (c.head(n).template lpNorm<Eigen::Infinity>() >
        kSmall * of.head(n).template lpNorm<Eigen::Infinity>())
      return false;
    if (m > 0 && c.tail(m).template lpNorm<Eigen::Infinity>() >
                     kSmall * of.tail(m).template lpNorm<Eigen::Infinity>())
      return false;
  }
  return true;
}

}  // namespace

/// b - A x, or b - A^T x, in twice the precision; by rows, so that the columns of x lie side by
/// side.
void RefinedSolve::take_residual(const Eigen::SparseMatrix<double>& A, bool transposed,
                                 const MatrixXd& x) {
  const auto columns = (x.cols() + kAtOnce - 1) / kAtOnce * kAtOnce;
  for (Rows* rows : {&x_, &r_, &rest_}) rows->setZero(x.rows(), columns);
  x_.leftCols(x.cols()) = x;
  r_.leftCols(x.cols()) = b_;
  for (int j = 0; j < A.outerSize(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(A, j); it; ++it) {
      const auto from = columns * (transposed ? it.row() : it.col()),
                 to = columns * (transposed ? it.col() : it.row());
      for (Eigen::Index k = 0; k < columns; k += kAtOnce)
        subtract(it.value(), x_.data() + from + k, r_.data() + to + k, rest_.data() + to + k);
    }
  correction_ = (r_ + rest_).leftCols(x.cols());
}

bool RefinedSolve::solve(const SparseLu& lu, const Eigen::SparseMatrix<double>& A, bool transposed,
                         Eigen::Index n, MatrixXd& x) {
  const auto solve = [&](MatrixXd& y) { transposed ? lu.solve_transposed(y) : lu.solve(y); };
  b_ = x;
  solve(x);
  for (int i = 0; i < kRefinements && x.allFinite(); ++i) {
    take_residual(A, transposed, x);
    solve(correction_);
    x += correction_;
    if (exact(correction_, x, n)) break;
  }
  return x.allFinite();
}

}  // namespace liesl
