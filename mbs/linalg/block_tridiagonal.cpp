#include "mbs/linalg/block_tridiagonal.hpp"

#include <Eigen/LU>

namespace liesl {

template <int N>
bool BlockTridiagonalLU<N>::factor(const Matrix& A) {
  const int n = A.blocks();
  inverse_.resize(n);
  lower_.resize(A.L.size());
  upper_.resize(A.U.size());
  Block pivot = n > 0 ? A.D[0] : Block();
  for (int k = 0; k < n; ++k) {
    Eigen::PartialPivLU<Block> lu(pivot);
    inverse_[k] = lu.inverse();
    if (!inverse_[k].allFinite()) return false;
    if (k + 1 == n) break;
    lower_[k] = A.L[k] * inverse_[k];
    upper_[k] = inverse_[k] * A.U[k];
    pivot = A.D[k + 1] - lower_[k] * A.U[k];
  }
  return true;
}

template <int N>
void BlockTridiagonalLU<N>::solve(double* x) const {
  using Map = Eigen::Map<Segment>;
  const int n = static_cast<int>(inverse_.size());
  for (int k = 1; k < n; ++k) Map(x + N * k) -= lower_[k - 1].lazyProduct(Map(x + N * (k - 1)));
  for (int k = 0; k < n; ++k) Map(x + N * k) = Segment(inverse_[k].lazyProduct(Map(x + N * k)));
  for (int k = n - 2; k >= 0; --k) Map(x + N * k) -= upper_[k].lazyProduct(Map(x + N * (k + 1)));
}

template class BlockTridiagonalLU<3>;
template class BlockTridiagonalLU<6>;

}  // namespace liesl
