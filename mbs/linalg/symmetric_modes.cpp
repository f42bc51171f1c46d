#include "mbs/linalg/symmetric_modes.hpp"

#include <Spectra/MatOp/SparseSymMatProd.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mbs/linalg/shift_invert_lanczos.hpp"
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
  return shift_invert_lanczos(op, mass, count, static_cast<int>(M.rows()), -shift, tolerance,
                              out.lambda, out.phi);
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
