#include "mbs/linalg/sparse_cholesky.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace liesl::test::sparse_cholesky_test {
namespace {

using Eigen::MatrixXd;
using Sparse = Eigen::SparseMatrix<double>;

/// Lower triangle of the five-point Laplacian on n x n, plus d on the diagonal.
Sparse laplacian(int n, double d) {
  std::vector<Eigen::Triplet<double>> t;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int k = j * n + i;
      t.emplace_back(k, k, 4 + d);
      if (i + 1 < n) t.emplace_back(k + 1, k, -1);
      if (j + 1 < n) t.emplace_back(k + n, k, -1);
    }
  Sparse A(n * n, n * n);
  A.setFromTriplets(t.begin(), t.end());
  return A;
}

TEST(SparseCholesky, SolvesManyColumnsAndFactorsAgain) {
  SparseCholesky factor;
  for (double d : {0.1, 3.0}) {
    const Sparse A = laplacian(30, d);
    ASSERT_TRUE(factor.factor(A));
    EXPECT_GT(factor.nonzeros(), A.nonZeros());
    const MatrixXd b = MatrixXd::Random(900, 17);
    const MatrixXd x = factor.solve(b);
    EXPECT_LT((A.selfadjointView<Eigen::Lower>() * x - b).norm(), 1e-12 * b.norm());
  }
}

/// Blocks are the same whatever the number of threads: neighbours do not change a column's block.
TEST(SparseCholesky, BlocksOfColumnsOnSeveralThreads) {
  SparseCholesky factor;
  const Sparse A = laplacian(30, 0.1);
  ASSERT_TRUE(factor.factor(A));
  const MatrixXd b = MatrixXd::Random(900, 201);
  const MatrixXd x = factor.solve(b);
  EXPECT_LT((A.selfadjointView<Eigen::Lower>() * x - b).norm(), 1e-12 * b.norm());
  EXPECT_EQ(x, MatrixXd(factor.solve(b)));
  EXPECT_EQ(x.leftCols(64), MatrixXd(factor.solve(b.leftCols(64))));
}

TEST(SparseCholesky, WhatIsNotPositiveDefiniteIsSaidSo) {
  SparseCholesky factor;
  EXPECT_FALSE(factor.factor(laplacian(10, -4.5)));
  EXPECT_EQ(factor.nonzeros(), 0);
  Sparse A = laplacian(10, 1);
  A.coeffRef(3, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(factor.factor(A));
  EXPECT_TRUE(factor.factor(laplacian(10, 1)));
}

}  // namespace
}  // namespace liesl::test::sparse_cholesky_test
