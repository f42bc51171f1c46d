#include "mbs/linalg/symmetric_modes.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mbs/linalg/dense.hpp"
#include "mbs/linalg/shift_invert_lanczos.hpp"
#include "mbs/linalg/sparse_cholesky.hpp"

namespace liesl {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr double kFirstShift = 1e-11;  // of trace K / trace M
constexpr double kTolerance = 1e-12;

/// M-normal columns Z, taken out of vectors (y -= Z Z^T M y) and of loads (x -= M Z Z^T x).
struct Deflation {
  Eigen::MatrixXd Z, MZ;
  Deflation(const Sparse& M, const Eigen::MatrixXd& free) : Z(M.rows(), free.cols()) {
    MZ = M.selfadjointView<Eigen::Lower>() * free;
    linalg::Cholesky gram;
    gram.factor(free.transpose() * MZ);
    Z = gram.times_inverse_factor(free);
    MZ = gram.times_inverse_factor(MZ);
  }
};

/// y = (K - sigma M)^-1 x on what the deflation leaves.
class DeflatedInverse final : public ShiftedInverse {
 public:
  DeflatedInverse(const Sparse& K, const Sparse& M, const Eigen::MatrixXd& free)
      : K_(K), M_(M), d_(M, free), load_(M.rows()) {}
  void deflate(const Eigen::MatrixXd& columns) { d_ = Deflation(M_, columns); }
  Eigen::Index rows() const override { return K_.rows(); }
  void set_shift(double sigma) override {
    if (regular_ && sigma == sigma_) return;
    Sparse A = K_ - sigma * M_;
    A.makeCompressed();
    regular_ = factor_.factor(A);
    sigma_ = sigma;
  }
  void perform_op(const double* x, double* y) const override {
    Eigen::Map<Eigen::VectorXd> out(y, rows());
    if (!regular_) {
      out.setZero();
      return;
    }
    load_ = Eigen::Map<const Eigen::VectorXd>(x, rows());
    if (d_.Z.cols() > 0) load_ -= d_.MZ * (d_.Z.transpose() * load_);
    out = factor_.solve(load_);
    if (d_.Z.cols() > 0) out -= d_.Z * (d_.MZ.transpose() * out);
  }
  bool regular() const override { return regular_; }
  int deflated() const { return static_cast<int>(d_.Z.cols()); }

 private:
  const Sparse &K_, &M_;
  Deflation d_;
  SparseCholesky factor_;
  mutable Eigen::VectorXd load_;
  bool regular_ = false;
  double sigma_ = 0;
};

/// y = M x, of the lower triangle of M.
class SymmetricProduct final : public LinearOperator {
 public:
  explicit SymmetricProduct(const Sparse& M) : M_(M) {}
  Eigen::Index rows() const override { return M_.rows(); }
  void perform_op(const double* x, double* y) const override {
    Eigen::Map<Eigen::VectorXd>(y, rows()).noalias() =
        M_.selfadjointView<Eigen::Lower>() * Eigen::Map<const Eigen::VectorXd>(x, rows());
  }

 private:
  const Sparse& M_;
};

bool lanczos(DeflatedInverse& op, const Sparse& M, int count, double shift, double tolerance,
             SymmetricModes& out) {
  const SymmetricProduct mass(M);
  return shift_invert_lanczos(op, mass, count, static_cast<int>(M.rows()) - op.deflated(), -shift,
                              tolerance, out.lambda, out.phi);
}

/// A Krylov space may miss modes of an eigenvalue that occurs several times: as long as what the
/// modes found leave has a lower one than the highest of them, that one takes its place.
bool complete(DeflatedInverse& op, const Sparse& M, const Eigen::MatrixXd& free, double shift,
              SymmetricModes& out) {
  const auto count = out.lambda.size();
  for (;;) {
    if (free.cols() + count + 1 >= M.rows()) return true;
    Eigen::MatrixXd known(M.rows(), free.cols() + count);
    known << free, out.phi;
    op.deflate(known);
    SymmetricModes next;
    if (!lanczos(op, M, 1, shift, kTolerance, next)) return false;
    if (next.lambda[0] >= out.lambda[count - 1] * (1 - 1e-9)) return true;
    const auto place =
        std::upper_bound(out.lambda.begin(), out.lambda.end(), next.lambda[0]) - out.lambda.begin();
    for (auto i = count - 1; i > place; --i) {
      out.lambda[i] = out.lambda[i - 1];
      out.phi.col(i) = out.phi.col(i - 1);
    }
    out.lambda[place] = next.lambda[0];
    out.phi.col(place) = next.phi;
  }
}

}  // namespace

SymmetricModes symmetric_modes(const Sparse& K, const Sparse& M, int count,
                               const Eigen::MatrixXd& free) {
  SymmetricModes out;
  const int n = static_cast<int>(K.rows());
  if (count <= 0) {
    out.converged = true;
    out.phi.resize(n, 0);
    return out;
  }
  if (count + free.cols() >= n)
    throw std::invalid_argument("more modes asked for than a part has coordinates");
  const double size = K.diagonal().sum() / M.diagonal().sum();
  if (!(size > 0 && std::isfinite(size))) return out;
  const Eigen::MatrixXd none(n, 0), &known = free.size() > 0 ? free : none;
  DeflatedInverse op(K, M, known);
  if (!lanczos(op, M, count, kFirstShift * size, 1e-4, out)) return out;
  const double wanted = std::max(out.lambda.cwiseAbs().maxCoeff(), kFirstShift * size);
  out.converged = lanczos(op, M, count, 0.1 * wanted, kTolerance, out) &&
                  complete(op, M, known, 0.1 * wanted, out);
  return out;
}

}  // namespace liesl
