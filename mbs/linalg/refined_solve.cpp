#include "mbs/linalg/refined_solve.hpp"

#include <cmath>

namespace liesl {

using Eigen::MatrixXd;

namespace {

constexpr int kRefinements = 2;
constexpr double kExact = 1e-10;  // of the solution: the square of such a correction is below 1e-16
constexpr double kKept = 1e-5;    // beyond that two corrections do not come to round-off
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

/// Are displacements and multipliers corrected by at most this share of them?
bool within(double share, const MatrixXd& correction, const MatrixXd& x, Eigen::Index n) {
  for (Eigen::Index j = 0; j < x.cols(); ++j) {
    const auto c = correction.col(j), of = x.col(j);
    const auto m = x.rows() - n;
    if (c.head(n).template lpNorm<Eigen::Infinity>() >
        share * of.head(n).template lpNorm<Eigen::Infinity>())
      return false;
    if (m > 0 && c.tail(m).template lpNorm<Eigen::Infinity>() >
                     share * of.tail(m).template lpNorm<Eigen::Infinity>())
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

bool RefinedSolve::solve_kept(SparseLu& lu, const Eigen::SparseMatrix<double>& A, bool transposed,
                              Eigen::Index n, MatrixXd& x) {
  b_ = x;
  if (refine(lu, A, transposed, n, kKept, x)) return true;
  x = b_;
  return lu.factor(A) && refine(lu, A, transposed, n, kAny, x);
}

/// Corrections shrink by the ratio of the first one to the solution.
bool RefinedSolve::refine(const SparseLu& lu, const Eigen::SparseMatrix<double>& A, bool transposed,
                          Eigen::Index n, double largest, MatrixXd& x) {
  const auto solve = [&](MatrixXd& y) { transposed ? lu.solve_transposed(y) : lu.solve(y); };
  solve(x);
  for (int i = 0; i < kRefinements && x.allFinite(); ++i) {
    take_residual(A, transposed, x);
    solve(correction_);
    x += correction_;
    if (within(kExact, correction_, x, n)) break;
    if (i == 0 && !within(largest, correction_, x, n)) return false;
  }
  return x.allFinite();
}

}  // namespace liesl
