#pragma once
/// @file
/// Block-tridiagonal matrices: what a chain of nodes is to linear algebra. Where elements join
/// three nodes the chain is wide: block-pentadiagonal.

#include <Eigen/Core>
#include <Eigen/StdVector>
#include <vector>

namespace liesl {

/// n x n blocks of N x N: diagonal D_k, upper U_k (row k, column k+1), lower L_k (row k+1, column
/// k); of a wide chain U2_k (row k, column k + 2) and L2_k (row k + 2, column k), too. Linear cost
/// in n. The blocks need not be symmetric.
template <int N>
class BlockTridiagonal {
 public:
  using Block = Eigen::Matrix<double, N, N>;
  using Segment = Eigen::Matrix<double, N, 1>;
  using Blocks = std::vector<Block, Eigen::aligned_allocator<Block>>;

  BlockTridiagonal() = default;
  explicit BlockTridiagonal(int n) { resize(n); }
  void resize(int n) {
    D.resize(n);
    U.resize(n > 0 ? n - 1 : 0);
    L.resize(n > 0 ? n - 1 : 0);
    U2.clear();
    L2.clear();
    set_zero();
  }
  /// Makes the chain wide, with zeros.
  void widen() {
    U2.assign(D.size() > 2 ? D.size() - 2 : 0, Block::Zero());
    L2 = U2;
  }
  void set_zero() {
    for (auto* blocks : {&D, &U, &L, &U2, &L2})
      for (auto& b : *blocks) b.setZero();
  }
  int blocks() const { return static_cast<int>(D.size()); }
  int size() const { return N * blocks(); }

  /// Adds the 2N x 2N matrix of element k, which joins nodes k and k + 1.
  template <class Element>
  void add_element(int k, const Eigen::MatrixBase<Element>& m) {
    D[k] += m.template topLeftCorner<N, N>();
    U[k] += m.template topRightCorner<N, N>();
    L[k] += m.template bottomLeftCorner<N, N>();
    D[k + 1] += m.template bottomRightCorner<N, N>();
  }

  /// this = a A + b B (same size).
  void set_sum(double a, const BlockTridiagonal& A, double b, const BlockTridiagonal& B) {
    for (size_t k = 0; k < D.size(); ++k) D[k] = a * A.D[k] + b * B.D[k];
    for (size_t k = 0; k < U.size(); ++k) {
      U[k] = a * A.U[k] + b * B.U[k];
      L[k] = a * A.L[k] + b * B.L[k];
    }
    for (size_t k = 0; k < U2.size(); ++k) {
      U2[k] = a * A.U2[k] + b * B.U2[k];
      L2[k] = a * A.L2[k] + b * B.L2[k];
    }
  }

  /// y += A x; x and y hold N * blocks() numbers.
  void multiply_add(const double* x, double* y) const {
    using In = Eigen::Map<const Segment>;
    using Out = Eigen::Map<Segment>;
    const int n = blocks();
    for (int k = 0; k < n; ++k) {
      Segment s = D[k].lazyProduct(In(x + N * k));
      if (k > 0) s += L[k - 1].lazyProduct(In(x + N * (k - 1)));
      if (k + 1 < n) s += U[k].lazyProduct(In(x + N * (k + 1)));
      if (!U2.empty() && k > 1) s += L2[k - 2].lazyProduct(In(x + N * (k - 2)));
      if (!U2.empty() && k + 2 < n) s += U2[k].lazyProduct(In(x + N * (k + 2)));
      Out(y + N * k) += s;
    }
  }

  Blocks D, U, L;
  Blocks U2, L2;  ///< of a wide chain, else empty
};

/// LU factors of a block-tridiagonal matrix, wide or not, without pivoting between blocks (the
/// matrices here are inertia plus stiffness, near to symmetric positive definite).
template <int N>
class BlockTridiagonalLU {
 public:
  using Matrix = BlockTridiagonal<N>;
  using Block = typename Matrix::Block;
  using Segment = typename Matrix::Segment;

  /// @returns false if a pivot block is singular; the factors are then unusable.
  bool factor(const Matrix& A);
  /// x <- A^-1 x, in place. Allocates nothing.
  void solve(double* x) const;

 private:
  void solve_wide(double* x) const;

  typename Matrix::Blocks inverse_, lower_, upper_, lower2_, upper2_;
};

extern template class BlockTridiagonalLU<3>;
extern template class BlockTridiagonalLU<6>;

}  // namespace liesl
