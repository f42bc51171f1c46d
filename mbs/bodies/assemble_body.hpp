#pragma once
/// @file
/// The matrix of a body in the sparse matrix of a model.

#include "mbs/bodies/body_matrix.hpp"
#include "mbs/linalg/sparse_assembly.hpp"

namespace liesl {

/// Adds the blocks of K; the body's first node is at row `first`.
template <int N>
void add_body(const BodyMatrix<N>& K, int first, SparseAssembly& assembly) {
  if (K.is_dense()) {
    const auto block = [&](size_t i, size_t j) {
      return K.dense.template block<N, N>(N * static_cast<int>(i), N * static_cast<int>(j));
    };
    for (size_t i = 0; i < K.nodes.size(); ++i)
      for (size_t j = 0; j < K.nodes.size(); ++j)
        assembly.add_block(first + N * K.nodes[i], first + N * K.nodes[j], block(i, j));
    return;
  }
  for (int k = 0; k < K.blocks(); ++k) {
    const int at = first + N * k;
    assembly.add_block(at, at, K.D[k]);
    if (k + 1 == K.blocks()) continue;
    assembly.add_block(at, at + N, K.U[k]);
    assembly.add_block(at + N, at, K.L[k]);
    if (k >= static_cast<int>(K.U2.size())) continue;
    assembly.add_block(at, at + 2 * N, K.U2[k]);
    assembly.add_block(at + 2 * N, at, K.L2[k]);
  }
}

}  // namespace liesl
