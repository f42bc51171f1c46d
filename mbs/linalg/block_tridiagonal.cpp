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

/// `last` is the row just computed, not read back from x: each row waits for the one before.
template <int N>
void BlockTridiagonalLU<N>::solve(double* x) const {
  using Map = Eigen::Map<Segment>;
  const int n = static_cast<int>(inverse_.size());
  if (n == 0) return;
  if (!upper2_.empty()) return solve_wide(x);
  Segment last = Map(x);
  const auto next = [&](int k, const Segment& s) { Map(x + N * k) = last = s; };
  for (int k = 1; k < n; ++k) next(k, Map(x + N * k) - lower_[k - 1].lazyProduct(last));
  next(n - 1, inverse_[n - 1].lazyProduct(last));
  for (int k = n - 2; k >= 0; --k) {
    const Segment own = inverse_[k].lazyProduct(Map(x + N * k));
    next(k, own - upper_[k].lazyProduct(last));
  }
}

template <int N>
void BlockTridiagonalLU<N>::solve_wide(double* x) const {
  using Map = Eigen::Map<Segment>;
  const int n = static_cast<int>(inverse_.size());
  Segment before, last = Map(x);
  const auto next = [&](int k, const Segment& s) {
    before = last;
    Map(x + N * k) = last = s;
  };
  next(1, Map(x + N) - lower_[0].lazyProduct(last));
  for (int k = 2; k < n; ++k) {
    const Segment own = Map(x + N * k) - lower2_[k - 2].lazyProduct(before);
    next(k, own - lower_[k - 1].lazyProduct(last));
  }
  next(n - 1, inverse_[n - 1].lazyProduct(last));
  next(n - 2, inverse_[n - 2].lazyProduct(Map(x + N * (n - 2))) - upper_[n - 2].lazyProduct(last));
  for (int k = n - 3; k >= 0; --k) {
    Segment own = inverse_[k].lazyProduct(Map(x + N * k));
    own -= upper2_[k].lazyProduct(before);
    next(k, own - upper_[k].lazyProduct(last));
  }
}

template class BlockTridiagonalLU<3>;
template class BlockTridiagonalLU<6>;

}  // namespace liesl
