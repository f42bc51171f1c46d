#pragma once
/// @file
/// How many eigenvalues of a symmetric matrix are negative on the null space of another.

#include <Eigen/SparseCore>
#include <optional>

namespace liesl {

/// Negative eigenvalues of sym(K) on the null space of B, without computing any: with
/// S = B K_p^-1 B^T and K_p = sym(K) + p B^T B, for every p that leaves K_p regular,
///   In [K_p B^T; B 0] = In(K_p) + In(-S)  (Haynsworth),
///   negative(K on null B) = negative(K_p) - negative(S);
/// the first from a sparse L D L^T, the second from the eigenvalues of the small dense S. Rows of
/// B must be independent. Where a pivot vanishes for every p tried the null space is taken dense.
/// @param A saddle-point matrix [K B^T; B 0]  @param n rows of K
/// @returns nothing if the matrices are not finite
std::optional<int> negative_on_null_space(const Eigen::SparseMatrix<double>& A, int n);

/// The same from a dense basis of the null space and all eigenvalues: cubic cost; for tests.
int negative_on_null_space_dense(const Eigen::SparseMatrix<double>& A, int n);

/// Size of the part of K that is not symmetric, on the null space of B, over that of K, all scaled
/// by the diagonal of K. 0 at once where K is symmetric; else by a dense basis of the null space.
double skew_on_null_space(const Eigen::SparseMatrix<double>& A, int n);

/// 1 if det K < 0 on the null space of B, else 0, K symmetric or not: det A = (-1)^m |det B B^T|
/// det.
/// @returns nothing if A is singular
std::optional<int> negative_determinant(const Eigen::SparseMatrix<double>& A, int n);

/// Orthonormal basis of the null space of B, dense. @pre rows of B are independent
Eigen::MatrixXd null_space(const Eigen::SparseMatrix<double>& B);

}  // namespace liesl
