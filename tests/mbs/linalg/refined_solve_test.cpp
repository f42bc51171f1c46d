/// @file
/// Solutions of equations in bad scales, with pivots that were kept from another matrix.

#include "mbs/linalg/refined_solve.hpp"

#include <Eigen/LU>

#include "mbs/run.hpp"

namespace liesl::test::refined_solve_test {
namespace {

using Eigen::MatrixXd;
using Wide = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

constexpr int kDisplacements = 20, kMultipliers = 4, kSize = kDisplacements + kMultipliers;

/// [S B^T; B 0] with rows of S of 1e9.
MatrixXd joined(Random& random) {
  MatrixXd A = random.matrix(kSize, kSize);
  A.topLeftCorner(kDisplacements, kDisplacements) *= 1e9;
  A.topLeftCorner(kDisplacements, kDisplacements).diagonal().array() += 4e9;
  A.bottomRightCorner(kMultipliers, kMultipliers).setZero();
  return A;
}

/// Displacements and multipliers to round-off, of A and of A^T, whatever pivots were kept.
TEST(RefinedSolve, IsExactToRoundOff) {
  Random random(5);
  const MatrixXd first = joined(random);
  MatrixXd then = joined(random);
  for (int i = 0; i < 6; ++i) then(i, i) = 1e3;  // the pivots of the first
  SparseLu lu;
  RefinedSolve refined;
  for (const MatrixXd& A : {first, then}) {
    const Eigen::SparseMatrix<double> S = A.sparseView();
    ASSERT_TRUE(lu.factor(S));
    for (const bool transposed : {false, true})
      for (const int columns : {1, 4, 6}) {
        const MatrixXd b = random.matrix(kSize, columns);
        const Wide W = (transposed ? MatrixXd(A.transpose()) : A).cast<long double>();
        const MatrixXd exact = W.partialPivLu().solve(b.cast<long double>()).cast<double>();
        MatrixXd x = b;
        ASSERT_TRUE(refined.solve(lu, S, transposed, kDisplacements, x));
        for (int j = 0; j < columns; ++j) {
          const Eigen::VectorXd error = x.col(j) - exact.col(j);
          EXPECT_LT(error.head(kDisplacements).norm(),
                    4e-16 * exact.col(j).head(kDisplacements).norm());
          EXPECT_LT(error.tail(kMultipliers).norm(),
                    4e-16 * exact.col(j).tail(kMultipliers).norm());
        }
      }
  }
}

/// Pivots of another matrix that lose all digits here, are seen by the first correction.
TEST(RefinedSolve, ChoosesPivotsAnewWhereKeptOnesLoseTheDigits) {
  Random random(7);
  MatrixXd A = MatrixXd::Identity(kSize, kSize) + 0.1 * random.matrix(kSize, kSize);
  for (int i = 0; i < kSize; ++i)  // a band: dense groups choose their pivots each time
    for (int j = 0; j < kSize; ++j)
      if (std::abs(i - j) > 2) A(i, j) = 0;
  SparseLu lu;
  ASSERT_TRUE(lu.factor_kept(Eigen::SparseMatrix<double>(A.sparseView())));
  A.diagonal().setConstant(1e-18);  // the pivots of the first
  const Eigen::SparseMatrix<double> S = A.sparseView();
  const MatrixXd exact = random.matrix(kSize, 3);
  for (const bool transposed : {false, true}) {
    ASSERT_TRUE(lu.factor_kept(S));
    const MatrixXd b = (transposed ? MatrixXd(A.transpose()) : A) * exact;
    MatrixXd plain = b, x = b;
    transposed ? lu.solve_transposed(plain) : lu.solve(plain);
    if (!transposed)
      EXPECT_GT((plain - exact).norm(), 1e-3 * exact.norm());  // or nothing is tested
    ASSERT_TRUE(RefinedSolve().solve_kept(lu, S, transposed, kDisplacements, x));
    EXPECT_LT((x - exact).norm(), 1e-13 * exact.norm());
  }
}

TEST(RefinedSolve, SaysWhatIsNotFinite) {
  const Eigen::SparseMatrix<double> I = MatrixXd(MatrixXd::Identity(3, 3)).sparseView();
  SparseLu lu;
  ASSERT_TRUE(lu.factor(I));
  MatrixXd x = MatrixXd::Constant(3, 2, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(RefinedSolve().solve(lu, I, false, 3, x));
}

}  // namespace
}  // namespace liesl::test::refined_solve_test
