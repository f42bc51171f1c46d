#pragma once
/// @file
/// Products of small blocks with rows of a matrix, four columns at a time: of so few rows Eigen's
/// general product takes longer to arrange its operands than to multiply them.

#include <Eigen/Core>

namespace liesl {

/// Rows `to` .. of y += T times rows `from` .. of x. @param T N x N, its size known when compiled
template <class Block, class Y>
void add_block_product(const Eigen::MatrixBase<Block>& T, const Eigen::MatrixXd& x,
                       Eigen::Index from, Eigen::MatrixBase<Y>& y, Eigen::Index to) {
  constexpr int N = Block::RowsAtCompileTime, kAtOnce = 4;
  Eigen::Index j = 0;
  for (; j + kAtOnce <= x.cols(); j += kAtOnce)
    y.template block<N, kAtOnce>(to, j) += T.lazyProduct(x.template block<N, kAtOnce>(from, j));
  for (; j < x.cols(); ++j)
    y.template block<N, 1>(to, j) += T.lazyProduct(x.template block<N, 1>(from, j));
}

}  // namespace liesl
