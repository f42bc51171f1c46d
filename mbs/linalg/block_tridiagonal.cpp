#include "mbs/linalg/block_tridiagonal.hpp"

#include <Eigen/LU>

namespace liesl {

/// Row k is done with when its pivot is: rows k + 1 and k + 2 have lost what it says of them. `U`
/// and `L` are what is left of the off-diagonal blocks beside the pivot.
template <int N>
bool BlockTridiagonalLU<N>::factor(const Matrix& A) {
  const int n = A.blocks();
  inverse_.resize(n);
  lower_.resize(A.L.size());
  upper_.resize(A.U.size());
  lower2_.resize(A.L2.size());
  upper2_.resize(A.U2.size());
  const int wide = static_cast<int>(A.U2.size());
  if (n == 0) return true;
  Block pivot = A.D[0], next = n > 1 ? A.D[1] : Block();
  Block U = n > 1 ? A.U[0] : Block(), L = n > 1 ? A.L[0] : Block();
  for (int k = 0; k < n; ++k) {
    Eigen::PartialPivLU<Block> lu(pivot);
    inverse_[k] = lu.inverse();
    if (!inverse_[k].allFinite()) return false;
    if (k + 1 == n) break;
    lower_[k] = L * inverse_[k];
    upper_[k] = inverse_[k] * U;
    pivot = next - lower_[k] * U;
    if (k + 2 == n) continue;
    next = A.D[k + 2];
    if (k < wide) {
      lower2_[k] = A.L2[k] * inverse_[k];
      upper2_[k] = inverse_[k] * A.U2[k];
      const Block U1 = A.U[k + 1] - lower_[k] * A.U2[k], L1 = A.L[k + 1] - lower2_[k] * U;
      next -= lower2_[k] * A.U2[k];
      U = U1;
      L = L1;
    } else {
      U = A.U[k + 1];
      L = A.L[k + 1];
    }
  }
  return true;
}

template <int N>
void BlockTridiagonalLU<N>::solve(double* x) const {
  using Map = Eigen::Map<Segment>;
  const int n = static_cast<int>(inverse_.size());
  if (!upper2_.empty()) return solve_wide(x);
  for (int k = 1; k < n; ++k) Map(x + N * k) -= lower_[k - 1].lazyProduct(Map(x + N * (k - 1)));
  for (int k = 0; k < n; ++k) Map(x + N * k) = Segment(inverse_[k].lazyProduct(Map(x + N * k)));
  for (int k = n - 2; k >= 0; --k) Map(x + N * k) -= upper_[k].lazyProduct(Map(x + N * (k + 1)));
}

template <int N>
void BlockTridiagonalLU<N>::solve_wide(double* x) const {
  using Map = Eigen::Map<Segment>;
  const int n = static_cast<int>(inverse_.size());
  for (int k = 1; k < n; ++k) {
    Segment s = Map(x + N * k);
    s -= lower_[k - 1].lazyProduct(Map(x + N * (k - 1)));
    if (k > 1) s -= lower2_[k - 2].lazyProduct(Map(x + N * (k - 2)));
    Map(x + N * k) = s;
  }
  for (int k = n - 1; k >= 0; --k) {
    Segment s = inverse_[k].lazyProduct(Map(x + N * k));
    if (k + 1 < n) s -= upper_[k].lazyProduct(Map(x + N * (k + 1)));
    if (k + 2 < n) s -= upper2_[k].lazyProduct(Map(x + N * (k + 2)));
    Map(x + N * k) = s;
  }
}

template class BlockTridiagonalLU<3>;
template class BlockTridiagonalLU<6>;

}  // namespace liesl
