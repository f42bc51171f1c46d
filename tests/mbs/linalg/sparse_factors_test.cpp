#include "mbs/linalg/sparse_factors.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "mbs/linalg/stop_request.hpp"

namespace liesl::test::sparse_factors_test {
namespace {

using Eigen::MatrixXd;
using Sparse = Eigen::SparseMatrix<double>;

/// A chain of springs on n points: `diagonal` on it, `left` and `right` beside it.
Sparse chain(int n, double diagonal, double left, double right) {
  std::vector<Eigen::Triplet<double>> t;
  for (int k = 0; k < n; ++k) {
    t.emplace_back(k, k, diagonal);
    if (k + 1 < n) t.emplace_back(k + 1, k, left);
    if (k + 1 < n) t.emplace_back(k, k + 1, right);
  }
  Sparse A(n, n);
  A.setFromTriplets(t.begin(), t.end());
  return A;
}

/// One object goes through all kinds of matrices of a pattern, there and back.
TEST(SparseFactors, TakeTheFormThatAMatrixAllows) {
  SparseFactors factors;
  const auto expect_solved = [&](const Sparse& A, bool symmetric) {
    ASSERT_TRUE(factors.factor(A));
    EXPECT_EQ(factors.symmetric(), symmetric);
    const MatrixXd b = MatrixXd::Random(A.rows(), 3);
    MatrixXd x = b;
    factors.solve(x);
    EXPECT_LT((A * x - b).norm(), 1e-12 * b.norm());
  };
  expect_solved(chain(40, 2.5, -1, -1), true);
  expect_solved(chain(40, 2.5, -1, -1 - 1e-14), true);  // round-off
  expect_solved(chain(40, 2.5, -1, -1.001), false);     // a gyroscopic term
  expect_solved(chain(40, -2.5, -1, -1), false);        // not positive definite
  expect_solved(chain(40, 3, -1, -1), true);
}

TEST(SparseFactors, SingularOrNotFiniteIsSaidSo) {
  SparseFactors factors;
  EXPECT_FALSE(factors.factor(chain(3, 0, 0, 0)));
  EXPECT_FALSE(factors.factor(chain(3, 2, -1, std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(factors.factor(chain(3, 2, -1, -1)));
}

/// The steps of a motion look for stops and keep what they have: its factors must not end it.
TEST(SparseFactors, LeaveStopsToWhoStepsInTime) {
  ask_for_stop([] { return true; });
  SparseFactors factors;
  const Sparse A = chain(5, 3, -1, -1);
  MatrixXd b = MatrixXd::Ones(5, 1);
  EXPECT_NO_THROW({
    EXPECT_TRUE(factors.factor(A));
    factors.solve(b);
  });
  EXPECT_TRUE(factors.symmetric());
  SparseCholesky cholesky;
  EXPECT_THROW(cholesky.factor(A), Stopped);
  ask_for_stop(nullptr);
}

}  // namespace
}  // namespace liesl::test::sparse_factors_test
