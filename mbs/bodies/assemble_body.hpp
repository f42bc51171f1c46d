#pragma once
/// @file
/// The matrix of a body in the sparse matrix of a model: its blocks.

#include "mbs/bodies/body_matrix.hpp"
#include "mbs/linalg/sparse_assembly.hpp"

namespace liesl {

/// f(row, column, block) of each block of K, single numbers of a sparse one; the body's first node
/// is at row `first`.
template <int N, class F>
void each_block(const BodyMatrix<N>& K, int first, F f) {
  for (int column = 0; column < K.sparse.cols(); ++column)
    for (typename Eigen::SparseMatrix<double>::InnerIterator at(K.sparse, column); at; ++at)
      f(first + static_cast<int>(at.row()), first + column,
        Eigen::Matrix<double, 1, 1>(at.value()));
  if (K.is_dense()) {
    for (size_t i = 0; i < K.nodes.size(); ++i)
      for (size_t j = 0; j < K.nodes.size(); ++j)
        f(first + N * K.nodes[i], first + N * K.nodes[j],
          K.dense.template block<N, N>(N * static_cast<int>(i), N * static_cast<int>(j)));
    return;
  }
  for (int k = 0; k < K.blocks(); ++k) {
    const int at = first + N * k;
    f(at, at, K.D[k]);
    if (k + 1 == K.blocks()) continue;
    f(at, at + N, K.U[k]);
    f(at + N, at, K.L[k]);
    if (k >= static_cast<int>(K.U2.size())) continue;
    f(at, at + 2 * N, K.U2[k]);
    f(at + 2 * N, at, K.L2[k]);
  }
}

/// Adds the blocks of K.
template <int N>
void add_body(const BodyMatrix<N>& K, int first, SparseAssembly& assembly) {
  each_block(K, first, [&](int row, int column, const auto& block) {
    assembly.add_block(row, column, block);
  });
}

}  // namespace liesl
