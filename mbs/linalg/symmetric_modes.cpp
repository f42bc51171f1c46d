#include "mbs/linalg/symmetric_modes.hpp"

#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/SymGEigsShiftSolver.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mbs/linalg/sparse_cholesky.hpp"

namespace liesl {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr double kFirstShift = 1e-11;  // of trace K / trace M

/// y = (K - sigma M)^-1 x.
class ShiftInverse {
 public:
  using Scalar = double;
  ShiftInverse(const Sparse& K, const Sparse& M) : K_(K), M_(M) {}
  Eigen::Index rows() const { return K_.rows(); }
  Eigen::Index cols() const { return K_.cols(); }
  void set_shift(double sigma) {
    Sparse A = K_ - sigma * M_;
    A.makeCompressed();
    regular_ = factor_.factor(A);
  }
  void perform_op(const double* x, double* y) const {
    Eigen::Map<Eigen::VectorXd> out(y, rows());
    if (regular_)
      out = factor_.solve(Eigen::Map<const Eigen::VectorXd>(x, rows()));
    else
      out.setZero();
  }
  bool regular() const { return regular_; }

 private:
  const Sparse &K_, &M_;
  SparseCholesky factor_;
  bool regular_ = false;
};

bool lanczos(ShiftInverse& op, const Sparse& M, int count, double shift, double tolerance,
             SymmetricModes& out) {
  Spectra::SparseSymMatProd<double, Eigen::Lower> mass(M);
  const int n = static_cast<int>(M.rows());
  const int basis = std::min(n, std::max(2 * count + 20, 3 * count));
  Spectra::SymGEigsShiftSolver<ShiftInverse, decltype(mass), Spectra::GEigsMode::ShiftInvert>
      solver(op, mass, count, basis, -shift);
  if (!op.regular()) return false;
  Eigen::VectorXd start(n), image(n);  // in the range of the operator: M may be singular
  for (int i = 0; i < n; ++i) start[i] = std::sin(1.0 + 1.7 * i);
  op.perform_op(Eigen::VectorXd(M.selfadjointView<Eigen::Lower>() * start).data(), image.data());
  if (!image.allFinite() || image.norm() == 0) return false;
  image /= image.cwiseAbs().maxCoeff();
  try {
    solver.init(image.data());
    solver.compute(Spectra::SortRule::LargestMagn, 300, tolerance, Spectra::SortRule::SmallestAlge);
  } catch (const std::exception&) {  // Spectra's way to say that the start is in too small a space
    return false;
  }
  if (solver.info() != Spectra::CompInfo::Successful) return false;
  out.lambda = solver.eigenvalues();
  out.phi = solver.eigenvectors();
  return out.lambda.allFinite() && out.phi.allFinite();
}

}  // namespace

SymmetricModes symmetric_modes(const Sparse& K, const Sparse& M, int count) {
  SymmetricModes out;
  const int n = static_cast<int>(K.rows());
  if (count <= 0) {
    out.converged = true;
    out.phi.resize(n, 0);
    return out;
  }
  if (count >= n) throw std::invalid_argument("more modes asked for than a part has coordinates");
  const double size = K.diagonal().sum() / M.diagonal().sum();
  if (!(size > 0 && std::isfinite(size))) return out;
  ShiftInverse op(K, M);
  if (!lanczos(op, M, count, kFirstShift * size, 1e-4, out)) return out;
  const double wanted = std::max(out.lambda.cwiseAbs().maxCoeff(), kFirstShift * size);
  out.converged = lanczos(op, M, count, 0.1 * wanted, 1e-12, out);
  return out;
}

}  // namespace liesl
