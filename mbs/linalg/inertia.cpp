#include "mbs/linalg/inertia.hpp"

#include <Eigen/SparseCholesky>

#include "mbs/linalg/dense.hpp"
#include "mbs/linalg/sparse_lu.hpp"

namespace liesl {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Symmetric K and B, scaled to comparable entries: K by 1/sqrt|K_ii| on both sides, the rows of
/// B to length 1. A congruence: no sign changes.
struct Scaled {
  Sparse K, B;
  Sparse skew;  ///< of K, scaled as K

  Scaled(const Sparse& A, int n) {
    const int m = static_cast<int>(A.rows()) - n;
    K = A.topLeftCorner(n, n);
    B = A.bottomLeftCorner(m, n);
    skew = 0.5 * (K - Sparse(K.transpose()));
    K = (0.5 * (K + Sparse(K.transpose()))).eval();
    Eigen::VectorXd d = K.diagonal().cwiseAbs();
    const double largest = d.size() ? d.maxCoeff() : 0;
    d = d.cwiseMax(largest > 0 ? 1e-12 * largest : 1).cwiseSqrt().cwiseInverse();
    K = (d.asDiagonal() * K * d.asDiagonal()).eval();
    skew = (d.asDiagonal() * skew * d.asDiagonal()).eval();
    B = (B * d.asDiagonal()).eval();
    Eigen::VectorXd rows = Eigen::VectorXd::Zero(m);
    for (int j = 0; j < n; ++j)
      for (Sparse::InnerIterator b(B, j); b; ++b) rows[b.row()] += b.value() * b.value();
    B = (rows.cwiseSqrt().cwiseInverse().asDiagonal() * B).eval();
  }
};

int negative(const Eigen::VectorXd& d) { return static_cast<int>((d.array() < 0).count()); }

std::optional<int> count(const Scaled& s, double p) {
  const Sparse K = s.K + p * Sparse(s.B.transpose() * s.B);
  Eigen::SimplicialLDLT<Sparse> ldlt(K);
  if (ldlt.info() != Eigen::Success) return std::nullopt;
  const Eigen::VectorXd d = ldlt.vectorD();
  if (!d.allFinite() || d.cwiseAbs().minCoeff() == 0) return std::nullopt;
  if (s.B.rows() == 0) return negative(d);
  const Eigen::MatrixXd X = ldlt.solve(Eigen::MatrixXd(s.B.transpose()));
  const Eigen::MatrixXd S = s.B * X;
  if (!S.allFinite()) return std::nullopt;
  return negative(d) - negative(linalg::symmetric_eigenvalues(0.5 * (S + S.transpose())));
}

int count_dense(const Scaled& s) {
  const Eigen::MatrixXd Z = null_space(s.B);
  if (Z.cols() == 0) return 0;
  return negative(linalg::symmetric_eigenvalues(Z.transpose() * (s.K * Z)));
}

}  // namespace

Eigen::MatrixXd null_space(const Sparse& B) {
  const int n = static_cast<int>(B.cols()), m = static_cast<int>(B.rows());
  if (m == 0) return Eigen::MatrixXd::Identity(n, n);
  Eigen::MatrixXd Z = Eigen::MatrixXd::Zero(n, n - m);
  Z.bottomRows(n - m).setIdentity();
  return linalg::times_q(B.transpose(), Z);
}

std::optional<int> negative_on_null_space(const Sparse& A, int n) {
  if (!A.coeffs().allFinite()) return std::nullopt;
  const Scaled scaled(A, n);
  if (!scaled.B.coeffs().allFinite()) return std::nullopt;
  for (double p : {1.0, 2.7})
    if (const auto found = count(scaled, p)) return found;
  return count_dense(scaled);
}

double skew_on_null_space(const Sparse& A, int n) {
  constexpr double kSymmetric = 1e-8;
  const Scaled s(A, n);
  const double size = s.K.norm();
  if (!(s.skew.norm() > kSymmetric * size)) return 0;
  const Eigen::MatrixXd Z = null_space(s.B);
  return (Z.transpose() * (s.skew * Z)).norm() / size;
}

std::optional<int> negative_determinant(const Sparse& A, int n) {
  Sparse compressed = A;
  compressed.makeCompressed();
  SparseLu lu;
  if (!lu.factor(compressed)) return std::nullopt;
  const bool odd = (A.rows() - n) % 2 == 1;
  return lu.determinant_sign() * (odd ? -1 : 1) < 0 ? 1 : 0;
}

int negative_on_null_space_dense(const Sparse& A, int n) { return count_dense(Scaled(A, n)); }

}  // namespace liesl
