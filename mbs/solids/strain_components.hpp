#pragma once
/// @file
/// Symmetric tensors as columns, ordered as in `CellMatrices`: [xx, yy, xy] in the plane,
/// [xx, yy, zz, xy, yz, zx] in space.

#include <Eigen/Core>

namespace liesl {

/// out = those of sym(A^T B), shear twice; A and B are D x D: a_i . b_i, a_i . b_j + a_j . b_i.
template <int D, class A, class B, class Out>
void symmetric_components(const A& a, const B& b, Out&& out) {
  for (int i = 0; i < D; ++i) out[i] = a.col(i).dot(b.col(i));
  constexpr int shear = D == 2 ? 1 : 3;
  for (int s = 0; s < shear; ++s) {
    const int i = s, j = (s + 1) % D;
    out[D + s] = a.col(i).dot(b.col(j)) + a.col(j).dot(b.col(i));
  }
}

/// The tensor of components with shear once, as those of a stress are.
template <int D, class Stress>
Eigen::Matrix<double, D, D> as_tensor(const Stress& s) {
  Eigen::Matrix<double, D, D> S;
  if constexpr (D == 2)
    S << s[0], s[2], s[2], s[1];
  else
    S << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
  return S;
}

}  // namespace liesl
