#include "mbs/linalg/constrained_modes.hpp"

#include <numeric>
#include <vector>

#include "mbs/linalg/dense.hpp"
#include "mbs/linalg/inertia.hpp"
#include "mbs/linalg/shift_invert_lanczos.hpp"
#include "mbs/linalg/sparse_lu.hpp"

namespace liesl {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr int kDense = 150;       // unknowns up to which the dense solver is taken
constexpr double kFree = 1e-13;   // phi^T K phi of a free motion, of |phi|^T |K| |phi|
constexpr double kShift = 1e-10;  // first shift, of the largest K_ii / M_ii

struct Pencil {
  Sparse A, K, M, B;
  int n, m;
};

/// y = top of [K - sigma M, B^T; B, 0]^-1 [x; 0].
class ShiftInvert final : public ShiftedInverse {
 public:
  explicit ShiftInvert(const Pencil& p) : p_(p), work_(p.n + p.m, 1) {}
  Eigen::Index rows() const override { return p_.n; }
  void set_shift(double sigma) override {
    Sparse shifted = p_.A;
    Sparse mass = p_.M;
    mass.conservativeResize(p_.n + p_.m, p_.n + p_.m);
    shifted = (shifted - sigma * mass).eval();
    shifted.makeCompressed();
    SparseLu lu;
    regular_ = lu.factor(shifted);
    lu_ = std::move(lu);
  }
  void perform_op(const double* x, double* y) const override {
    if (!regular_) {
      std::fill(y, y + p_.n, 0.0);
      return;
    }
    work_.topRows(p_.n) = Eigen::Map<const Eigen::VectorXd>(x, p_.n);
    work_.bottomRows(p_.m).setZero();
    lu_.solve(work_);
    Eigen::Map<Eigen::VectorXd>(y, p_.n) = work_.topRows(p_.n);
  }
  bool regular() const override { return regular_; }

 private:
  const Pencil& p_;
  SparseLu lu_;
  bool regular_ = false;
  mutable Eigen::MatrixXd work_;
};

class MassProduct final : public LinearOperator {
 public:
  explicit MassProduct(const Sparse& M) : M_(M) {}
  Eigen::Index rows() const override { return M_.rows(); }
  void perform_op(const double* x, double* y) const override {
    Eigen::Map<Eigen::VectorXd>(y, rows()) = M_ * Eigen::Map<const Eigen::VectorXd>(x, cols());
  }

 private:
  const Sparse& M_;
};

bool lanczos(const Pencil& p, int count, double sigma, double tolerance, ConstrainedModes& out) {
  ShiftInvert op(p);
  const MassProduct mass(p.M);
  return shift_invert_lanczos(op, mass, count, p.n - p.m, sigma, tolerance, out.lambda, out.phi);
}

/// First with a shift next to zero, which finds the size of the lowest eigenvalues, then with one
/// of that size, so that free motions do not drown the others in round-off.
bool lanczos(const Pencil& p, int count, ConstrainedModes& out) {
  double largest = 0;
  for (int i = 0; i < p.n; ++i)
    if (p.M.coeff(i, i) > 0) largest = std::max(largest, p.K.coeff(i, i) / p.M.coeff(i, i));
  if (largest == 0) largest = 1;
  if (!lanczos(p, count, -kShift * largest, 1e-4, out)) return false;
  const double wanted = out.lambda.cwiseAbs().maxCoeff();
  return lanczos(p, count, -0.1 * std::max(wanted, kShift * largest), 1e-12, out);
}

bool dense(const Pencil& p, int count, ConstrainedModes& out) {
  const Eigen::MatrixXd Z = null_space(p.B);
  const auto eigen =
      linalg::generalized_eigen(Z.transpose() * (p.K * Z), Z.transpose() * (p.M * Z));
  if (!eigen) return false;
  out.lambda = eigen->lambda.head(count);
  out.phi = Z * eigen->phi.leftCols(count);
  return out.lambda.allFinite() && out.phi.allFinite();
}

/// Mass-normalises, sets free motions to zero, computes residuals with nu by least squares.
void finish(const Pencil& p, ConstrainedModes& out) {
  const Eigen::MatrixXd BBt = p.B * Sparse(p.B.transpose());
  const linalg::LDLT normal(BBt);
  for (int j = 0; j < out.lambda.size(); ++j) {
    auto phi = out.phi.col(j);
    phi /= std::sqrt(phi.dot(p.M * phi));
    const Eigen::VectorXd Kphi = p.K * phi;
    const Eigen::VectorXd size = p.K.cwiseAbs() * phi.cwiseAbs();
    if (std::abs(phi.dot(Kphi)) <= kFree * phi.cwiseAbs().dot(size)) out.lambda[j] = 0;
    Eigen::VectorXd r = Kphi - out.lambda[j] * (p.M * phi);
    if (p.m > 0) r -= p.B.transpose() * normal.solve(p.B * r);
    out.residuals.push_back(size.norm() > 0 ? r.norm() / size.norm() : r.norm());
  }
}

}  // namespace

ConstrainedModes constrained_modes(const Sparse& A, const Sparse& M, int count,
                                   ModesMethod method) {
  Pencil p;
  p.n = static_cast<int>(M.rows());
  p.m = static_cast<int>(A.rows()) - p.n;
  p.A = 0.5 * (A + Sparse(A.transpose()));
  p.K = p.A.topLeftCorner(p.n, p.n);
  p.B = p.A.bottomLeftCorner(p.m, p.n);
  p.M = M;
  ConstrainedModes out;
  count = std::min(count, p.n - p.m);
  if (count <= 0) {
    out.converged = true;
    out.phi.resize(p.n, 0);
    return out;
  }
  const bool small = p.n <= kDense || 3 * count + 20 > p.n - p.m;
  const bool by_dense = method == ModesMethod::Dense || (method == ModesMethod::Auto && small);
  out.converged = by_dense ? dense(p, count, out) : lanczos(p, count, out);
  if (!out.converged && method == ModesMethod::Auto && !by_dense)
    out.converged = dense(p, count, out);
  if (out.converged) finish(p, out);
  return out;
}

}  // namespace liesl
