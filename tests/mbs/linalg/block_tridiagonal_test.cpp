/// @file
/// Block-tridiagonal matrices against dense ones.

#include "mbs/linalg/block_tridiagonal.hpp"

#include "mbs/run.hpp"

namespace liesl::test::block_tridiagonal_test {
namespace {

using test::Random;

template <class Size>
class BlockTridiagonalTest : public ::testing::Test {
 protected:
  static constexpr int size = Size::value;
  /// Unsymmetric, with a dominant diagonal.
  BlockTridiagonal<size> matrix(int n) {
    BlockTridiagonal<size> A(n);
    for (auto& b : A.D)
      b = random.matrix(size, size) + 4.0 * size * Eigen::MatrixXd::Identity(size, size);
    for (auto& b : A.U) b = random.matrix(size, size);
    for (auto& b : A.L) b = random.matrix(size, size);
    return A;
  }
  static Eigen::MatrixXd dense(const BlockTridiagonal<size>& A) {
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(A.size(), A.size());
    for (int k = 0; k < A.blocks(); ++k) {
      m.block<size, size>(size * k, size * k) = A.D[std::size_t(k)];
      if (k + 1 == A.blocks()) break;
      m.block<size, size>(size * k, size * (k + 1)) = A.U[std::size_t(k)];
      m.block<size, size>(size * (k + 1), size * k) = A.L[std::size_t(k)];
    }
    return m;
  }
  Random random{3};
};

using Sizes = ::testing::Types<std::integral_constant<int, 3>, std::integral_constant<int, 6>>;
TYPED_TEST_SUITE(BlockTridiagonalTest, Sizes);

TYPED_TEST(BlockTridiagonalTest, MultipliesLikeTheDenseMatrix) {
  for (const int n : {1, 2, 7}) {
    const auto A = this->matrix(n);
    const Eigen::VectorXd x = this->random.vector(A.size());
    Eigen::VectorXd y = x;
    A.multiply_add(x.data(), y.data());
    EXPECT_LT((y - x - this->dense(A) * x).norm(), 1e-13 * y.norm()) << n;
  }
}

TYPED_TEST(BlockTridiagonalTest, SolvesLikeTheDenseMatrix) {
  for (const int n : {1, 2, 7, 100}) {
    const auto A = this->matrix(n);
    const Eigen::VectorXd b = this->random.vector(A.size());
    BlockTridiagonalLU<TypeParam::value> lu;
    ASSERT_TRUE(lu.factor(A));
    Eigen::VectorXd x = b;
    lu.solve(x.data());
    EXPECT_LT((this->dense(A) * x - b).norm(), 1e-13 * b.norm()) << n;
  }
}

TYPED_TEST(BlockTridiagonalTest, AssemblesElementsAndSums) {
  constexpr int N = TypeParam::value;
  BlockTridiagonal<N> A(3), S(3);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(3 * N, 3 * N);
  for (int k = 0; k < 2; ++k) {
    const Eigen::Matrix<double, 2 * N, 2 * N> e = this->random.matrix(2 * N, 2 * N);
    A.add_element(k, e);
    expected.block(N * k, N * k, 2 * N, 2 * N) += e;
  }
  EXPECT_LT((this->dense(A) - expected).norm(), 1e-15);
  const auto B = this->matrix(3);
  S.set_sum(2, A, -3, B);
  EXPECT_LT((this->dense(S) - 2 * expected + 3 * this->dense(B)).norm(), 1e-13);
}

TYPED_TEST(BlockTridiagonalTest, RefusesASingularPivot) {
  auto A = this->matrix(4);
  A.D[0].setZero();
  BlockTridiagonalLU<TypeParam::value> lu;
  EXPECT_FALSE(lu.factor(A));
}

}  // namespace
}  // namespace liesl::test::block_tridiagonal_test
