#pragma once
/// @file
/// Products of the small matrices of the groups, coefficient by coefficient. The groups are in
/// every source of the engine, and what their inline functions take from Eigen is compiled in each:
/// as expressions, these products took half a second of every source.

#include <Eigen/Core>

namespace liesl {

template <int N, class S = double>
using SquareMatrix = Eigen::Matrix<S, N, N>;
template <int N, class S = double>
using ColumnVector = Eigen::Matrix<S, N, 1>;

/// A B
template <int N, class S>
SquareMatrix<N, S> product(const SquareMatrix<N, S>& A, const SquareMatrix<N, S>& B) {
  SquareMatrix<N, S> C;
  for (int j = 0; j < N; ++j)
    for (int i = 0; i < N; ++i) {
      C(i, j) = A(i, 0) * B(0, j);
      for (int k = 1; k < N; ++k) C(i, j) += A(i, k) * B(k, j);
    }
  return C;
}

/// A a + b
template <int N, class S>
ColumnVector<N, S> product_plus(const SquareMatrix<N, S>& A, const ColumnVector<N, S>& a,
                                const ColumnVector<N, S>& b) {
  ColumnVector<N, S> c;
  for (int i = 0; i < N; ++i) {
    S sum = A(i, 0) * a[0];
    for (int k = 1; k < N; ++k) sum += A(i, k) * a[k];
    c[i] = sum + b[i];
  }
  return c;
}

/// A'
template <int N, class S>
SquareMatrix<N, S> transpose(const SquareMatrix<N, S>& A) {
  SquareMatrix<N, S> C;
  for (int j = 0; j < N; ++j)
    for (int i = 0; i < N; ++i) C(i, j) = A(j, i);
  return C;
}

/// -A' a
template <int N, class S>
ColumnVector<N, S> minus_transposed_product(const SquareMatrix<N, S>& A,
                                            const ColumnVector<N, S>& a) {
  ColumnVector<N, S> c;
  for (int i = 0; i < N; ++i) {
    S sum = A(0, i) * a[0];
    for (int k = 1; k < N; ++k) sum += A(k, i) * a[k];
    c[i] = -sum;
  }
  return c;
}

/// One Newton step R <- R (3 I - R'R)/2 towards the nearest rotation (polar factor).
template <int N, class S>
void newton_step_to_rotation(SquareMatrix<N, S>& R) {
  SquareMatrix<N, S> C = product<N>(transpose<N>(R), R);
  for (int j = 0; j < N; ++j)
    for (int i = 0; i < N; ++i) C(i, j) = (i == j ? 1.5 : 0) - 0.5 * C(i, j);
  R = product<N>(R, C);
}

}  // namespace liesl
