/// @file
/// Factors of matrices with groups of unknowns that are dense, against the matrices themselves.

#include "mbs/linalg/dense_groups.hpp"

#include <algorithm>
#include <limits>

#include "mbs/linalg/dense.hpp"
#include "mbs/linalg/sparse_lu.hpp"
#include "mbs/run.hpp"

namespace liesl::test::dense_groups_test {
namespace {

using Eigen::MatrixXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr int kSize = 48, kRest = 12;

/// 0: rows 4 to 21; 1: rows 22 to 41 but for 25 and 30; -1: those left.
int group_of(int row) {
  if (row < 4 || row > 41 || row == 25 || row == 30) return -1;
  return row < 22 ? 0 : 1;
}

/// Unsymmetric; groups are dense and joined with rows 0 to 3 and 25, the second with row 46. The
/// last two rows are of joints: nothing is on their diagonal.
MatrixXd machine(Random& random) {
  MatrixXd A = random.matrix(kSize, kSize);
  for (int i = 0; i < kSize; ++i)
    for (int j = 0; j < kSize; ++j) {
      const int a = group_of(i), b = group_of(j), other = a < 0 ? i : j;
      const bool both = a >= 0 && b >= 0, none = a < 0 && b < 0;
      if (both && a != b) A(i, j) = 0;
      if (!both && !none && other > 3 && other != 25 && !(other == 46 && std::max(a, b) == 1))
        A(i, j) = 0;
      if (none && i >= 46 && j >= 46) A(i, j) = 0;
      if (i == j && i < 46) A(i, j) += 8;
    }
  return A;
}

void expect_solved(const SparseLu& lu, const MatrixXd& A, Random& random) {
  const MatrixXd b = random.matrix(A.rows(), 3);
  MatrixXd x = b, y = b;
  lu.solve(x);
  lu.solve_transposed(y);
  EXPECT_LT((A * x - b).norm(), 1e-11 * b.norm());
  EXPECT_LT((A.transpose() * y - b).norm(), 1e-11 * b.norm());
  EXPECT_EQ(lu.determinant_sign(), linalg::determinant(A) > 0 ? 1 : -1);
  EXPECT_GT(lu.reciprocal_condition(), 1e-6);
  EXPECT_LE(lu.reciprocal_condition(), 1);
}

TEST(DenseGroups, AreFoundAndCondensed) {
  Random random{3};
  const MatrixXd A = machine(random);
  DenseGroups groups(A.sparseView());
  ASSERT_FALSE(groups.empty());
  const Sparse* rest = groups.condense(A.sparseView());
  ASSERT_TRUE(rest);
  ASSERT_EQ(rest->rows(), kRest);
  std::vector<int> left, inner;
  for (int k = 0; k < kSize; ++k) (group_of(k) < 0 ? left : inner).push_back(k);
  for (int k = 0; k < kRest; ++k) EXPECT_EQ(groups.left(k), left[std::size_t(k)]);
  const MatrixXd expected =
      A(left, left) - A(left, inner) * linalg::solve(A(inner, inner), A(inner, left));
  EXPECT_LT((MatrixXd(*rest) - expected).norm(), 1e-12 * expected.norm());
}

TEST(DenseGroups, AreNoneOfChainsOrOfAMatrixThatIsDense) {
  Random random{5};
  MatrixXd chain = MatrixXd::Zero(60, 60);
  for (int k = 0; k + 12 <= 60; k += 6) chain.block(k, k, 12, 12) = random.matrix(12, 12);
  EXPECT_TRUE(DenseGroups(chain.sparseView()).empty());
  EXPECT_TRUE(DenseGroups(random.matrix(40, 40).sparseView()).empty());
}

TEST(DenseGroups, SolveWithAMatrixAndItsTransposed) {
  Random random{7};
  SparseLu lu;
  for (int i = 0; i < 3; ++i) {  // one pattern, other numbers
    const MatrixXd A = machine(random);
    ASSERT_TRUE(lu.factor(A.sparseView()));
    expect_solved(lu, A, random);
  }
}

/// Of two groups that are joined one is left to the others.
TEST(DenseGroups, MayBeJoined) {
  Random random{9};
  MatrixXd A = machine(random);
  for (int i = 0; i < kSize; ++i)
    for (int j = 0; j < kSize; ++j)
      if (group_of(i) == 0 && group_of(j) == 1) A(i, j) = random.matrix(1, 1)(0, 0);
  SparseLu lu;
  ASSERT_TRUE(lu.factor(A.sparseView()));
  expect_solved(lu, A, random);
}

/// A group is singular, all of the matrix is not: pivots come from elsewhere, now and later.
TEST(DenseGroups, MayBeSingular) {
  Random random{11};
  SparseLu lu;
  for (int i = 0; i < 3; ++i) {
    MatrixXd A = machine(random);
    const MatrixXd regular = A;
    if (i > 0)
      for (int j = 0; j < kSize; ++j)
        if (group_of(j) == 0) A(5, j) = A(4, j);
    ASSERT_TRUE(lu.factor(A.sparseView()));
    expect_solved(lu, A, random);
    ASSERT_TRUE(lu.factor(regular.sparseView()));
    expect_solved(lu, regular, random);
  }
}

TEST(DenseGroups, SingularOrNotFiniteIsSaidSo) {
  Random random{13};
  const MatrixXd A = machine(random);
  SparseLu lu;
  const auto factors = [&](int row, double value) {  // entries stay in the pattern
    Sparse changed = A.sparseView();
    for (int j = 0; j < changed.outerSize(); ++j)
      for (Sparse::InnerIterator it(changed, j); it; ++it)
        if (it.row() == row) it.valueRef() *= value;
    return lu.factor(changed);
  };
  EXPECT_TRUE(factors(0, 1));
  EXPECT_FALSE(factors(47, 0));  // of what is left
  EXPECT_GE(lu.singular_column(), 0);
  EXPECT_EQ(lu.determinant_sign(), 0);
  EXPECT_FALSE(factors(9, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(factors(0, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_TRUE(factors(0, 1));
  EXPECT_FALSE(factors(9, 0));  // of a group
  EXPECT_TRUE(factors(0, 1));
}

}  // namespace
}  // namespace liesl::test::dense_groups_test
