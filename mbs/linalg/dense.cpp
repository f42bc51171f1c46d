#include "mbs/linalg/dense.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace liesl::linalg {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd product(const Dense& A, const Dense& B) { return A * B; }

MatrixXd transposed_product(const Dense& A, const Dense& B) { return A.transpose() * B; }

MatrixXd product_transposed(const Dense& A, const Dense& B) { return A * B.transpose(); }

void subtract_transposed_product(const Dense& A, const Dense& B, Eigen::Ref<MatrixXd> C) {
  C.noalias() -= A.transpose() * B;
}

void LU::factor(const MatrixXd& A) {
  const auto as = [&]<int N>() {
    if (!std::holds_alternative<Fixed<N>>(lu_)) lu_.emplace<Fixed<N>>();
    std::get<Fixed<N>>(lu_).compute(A);
  };
  switch (A.rows()) {
    case 1:
      return as.operator()<1>();
    case 2:
      return as.operator()<2>();
    case 3:
      return as.operator()<3>();
    case 4:
      return as.operator()<4>();
    case 5:
      return as.operator()<5>();
    case 6:
      return as.operator()<6>();
    default:
      return as.operator()<Eigen::Dynamic>();
  }
}

double LU::smallest_pivot() const {
  return std::visit([](const auto& lu) { return lu.matrixLU().diagonal().cwiseAbs().minCoeff(); },
                    lu_);
}

void LU::solve(const VectorXd& b, VectorXd& x) const {
  x.resize(b.size());
  const auto by = [&]<int N>(const Fixed<N>& lu) {
    using Vector = Eigen::Matrix<double, N, 1>;
    Eigen::Map<Vector>(x.data(), x.size()).noalias() =
        lu.solve(Eigen::Map<const Vector>(b.data(), b.size()));
  };
  std::visit(by, lu_);
}

bool Cholesky::factor(const MatrixXd& A) {
  llt_.compute(A);
  return llt_.info() == Eigen::Success;
}

void Cholesky::solve_in_place(VectorXd& x) const { llt_.solveInPlace(x); }

MatrixXd Cholesky::times_inverse_factor(const MatrixXd& X) const {
  return llt_.matrixU().solve<Eigen::OnTheRight>(X);
}

LDLT::LDLT(const MatrixXd& A) : ldlt_(A) {}

MatrixXd LDLT::solve(const MatrixXd& B) const { return ldlt_.solve(B); }

MatrixXd solve(const MatrixXd& A, const MatrixXd& B) { return A.partialPivLu().solve(B); }

MatrixXd inverse(const MatrixXd& A) { return A.inverse(); }

template <int N>
Eigen::Matrix<double, N, N> inverse(const Eigen::Matrix<double, N, N>& A) {
  return A.inverse();
}
template Eigen::Matrix3d inverse(const Eigen::Matrix3d&);
template Eigen::Matrix<double, 6, 6> inverse(const Eigen::Matrix<double, 6, 6>&);

double determinant(const MatrixXd& A) { return A.determinant(); }

int rank(const MatrixXd& A, double threshold) {
  Eigen::ColPivHouseholderQR<MatrixXd> qr(A);
  return static_cast<int>(qr.setThreshold(threshold).rank());
}

VectorXd least_squares(const MatrixXd& A, const VectorXd& b) {
  return A.colPivHouseholderQr().solve(b);
}

VectorXd shortest_least_squares(const MatrixXd& A, const VectorXd& b, double threshold) {
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition;
  decomposition.setThreshold(threshold);
  return decomposition.compute(A).solve(b);
}

PivotedColumns pivoted_columns(const MatrixXd& A) {
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(A);
  return {qr.colsPermutation().indices(), static_cast<int>(qr.rank())};
}

MatrixXd times_q(const MatrixXd& A, MatrixXd X) {
  const Eigen::HouseholderQR<MatrixXd> qr(A);
  X.applyOnTheLeft(qr.householderQ());
  return X;
}

SymmetricEigen symmetric_eigen(const MatrixXd& A) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(A);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

VectorXd symmetric_eigenvalues(const MatrixXd& A) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(A, Eigen::EigenvaluesOnly).eigenvalues();
}

std::optional<SymmetricEigen> generalized_eigen(const MatrixXd& A, const MatrixXd& B) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> eigen(A, B);
  if (eigen.info() != Eigen::Success) return {};
  return SymmetricEigen{eigen.eigenvalues(), eigen.eigenvectors()};
}

std::optional<VectorXd> generalized_eigenvalues(const MatrixXd& A, const MatrixXd& B) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> eigen(A, B, Eigen::EigenvaluesOnly);
  if (eigen.info() != Eigen::Success) return {};
  return eigen.eigenvalues();
}

RightSingular right_singular(const MatrixXd& A) {
  const Eigen::JacobiSVD<MatrixXd> svd(A, Eigen::ComputeFullV);
  return {svd.singularValues(), svd.matrixV()};
}

}  // namespace liesl::linalg
