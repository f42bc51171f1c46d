#include "mbs/linalg/sparse_lu.hpp"

#include <klu.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <vector>

#include "mbs/linalg/dense_groups.hpp"

namespace liesl {
namespace {

constexpr double kSmallestGrowth = 1e-8;  // reciprocal pivot growth that kept pivots may have

/// +1 for an even permutation, -1 for an odd one.
int parity(const int* permutation, int n) {
  std::vector<bool> seen(n, false);
  int sign = 1;
  for (int i = 0; i < n; ++i) {
    if (seen[i]) continue;
    int length = 0;
    for (int k = i; !seen[k]; k = permutation[k], ++length) seen[k] = true;
    if (length % 2 == 0) sign = -sign;
  }
  return sign;
}

}  // namespace

/// KLU's, of the matrix or of what its dense groups leave of it.
struct SparseLu::Factors {
  klu_common common;
  klu_symbolic* symbolic = nullptr;
  klu_numeric* numeric = nullptr;
  int singular = -1;
  bool analysed = false, refined = false;
  DenseGroups groups;

  Factors() { klu_defaults(&common); }
  ~Factors() {
    klu_free_numeric(&numeric, &common);
    klu_free_symbolic(&symbolic, &common);
  }
  Factors(const Factors&) = delete;
  Factors& operator=(const Factors&) = delete;

  /// @param measure false: whatever their growth
  bool refactor(int* columns, int* rows, double* values, bool measure) {
    if (!numeric || !klu_refactor(columns, rows, values, symbolic, numeric, &common)) return false;
    if (common.status != KLU_OK || zero_pivot() >= 0) return false;
    return !measure || (klu_rgrowth(columns, rows, values, symbolic, numeric, &common) &&
                        common.rgrowth > kSmallestGrowth);
  }
  bool factor(const Matrix& A, Pivots pivots) {
    const int n = static_cast<int>(A.cols());
    // KLU takes pointers to non-const and does not write through them.
    auto* columns = const_cast<int*>(A.outerIndexPtr());
    auto* rows = const_cast<int*>(A.innerIndexPtr());
    auto* values = const_cast<double*>(A.valuePtr());
    if (!A.coeffs().allFinite()) return drop(0);
    if (!symbolic) symbolic = klu_analyze(n, columns, rows, &common);
    if (!symbolic) return drop(0);
    if (pivots != Pivots::Anew && refactor(columns, rows, values, pivots == Pivots::Measured))
      return true;
    klu_free_numeric(&numeric, &common);
    numeric = klu_factor(columns, rows, values, symbolic, &common);
    if (!numeric || common.status != KLU_OK) {
      const int column = common.singular_col;
      return drop(column >= 0 && column < n ? column : 0);
    }
    const int zero = zero_pivot();
    return zero < 0 || drop(zero);
  }
  /// All unknowns are KLU's from now on, whose pivots come from any group.
  void leave_groups() {
    groups = DenseGroups();
    klu_free_numeric(&numeric, &common);
    klu_free_symbolic(&symbolic, &common);
  }
  void solve(Eigen::Ref<Eigen::MatrixXd> b) {
    klu_solve(symbolic, numeric, static_cast<int>(b.outerStride()), static_cast<int>(b.cols()),
              b.data(), &common);
  }
  void solve_transposed(Eigen::Ref<Eigen::MatrixXd> b) {
    klu_tsolve(symbolic, numeric, static_cast<int>(b.outerStride()), static_cast<int>(b.cols()),
               b.data(), &common);
  }
  /// Column of a pivot that is zero, -1 if none is: KLU looks inside its blocks only.
  int zero_pivot() const {
    const auto* diagonal = static_cast<const double*>(numeric->Udiag);
    for (int k = 0; k < symbolic->n; ++k)
      if (diagonal[k] == 0) return symbolic->Q[k];
    return -1;
  }
  /// No factor: singular at a column.
  /// @throws std::bad_alloc if memory is what was missing
  bool drop(int column) {
    if (common.status == KLU_OUT_OF_MEMORY) throw std::bad_alloc();
    klu_free_numeric(&numeric, &common);
    singular = column;
    return false;
  }
};

SparseLu::SparseLu() : f_(std::make_unique<Factors>()) {}
SparseLu::~SparseLu() = default;
SparseLu::SparseLu(SparseLu&&) noexcept = default;
SparseLu& SparseLu::operator=(SparseLu&&) noexcept = default;

bool SparseLu::factor(const Matrix& A) {
  return factor(A, f_->refined ? Pivots::Anew : Pivots::Measured);
}

bool SparseLu::factor_kept(const Matrix& A) {
  f_->refined = true;
  f_->common.scale = 0;
  return factor(A, Pivots::Kept);
}

bool SparseLu::factor(const Matrix& A, Pivots pivots) {
  Factors& f = *f_;
  f.singular = -1;
  if (A.cols() == 0) return true;
  if (!f.analysed) f.groups = DenseGroups(A);
  f.analysed = true;
  if (f.groups.empty()) return f.factor(A, pivots);
  if (!A.coeffs().allFinite()) return f.drop(0);
  const Matrix* rest = f.groups.condense(A);
  if (!rest) {
    f.leave_groups();
    return f.factor(A, pivots);
  }
  if (f.factor(*rest, pivots)) return true;
  f.singular = f.groups.left(f.singular);
  return false;
}

void SparseLu::solve(Eigen::Ref<Eigen::MatrixXd> b) const {
  if (b.rows() == 0) return;
  if (f_->groups.empty()) return f_->solve(b);
  Eigen::MatrixXd left = f_->groups.eliminate(b);
  f_->solve(left);
  f_->groups.substitute(left, b);
}

void SparseLu::solve_transposed(Eigen::Ref<Eigen::MatrixXd> b) const {
  if (b.rows() == 0) return;
  if (f_->groups.empty()) return f_->solve_transposed(b);
  Eigen::MatrixXd left = f_->groups.eliminate_transposed(b);
  f_->solve_transposed(left);
  f_->groups.substitute_transposed(left, b);
}

int SparseLu::determinant_sign() const {
  if (!f_->numeric) return 0;
  const int n = f_->symbolic->n;
  int sign = parity(f_->numeric->Pnum, n) * parity(f_->symbolic->Q, n);
  const auto* diagonal = static_cast<const double*>(f_->numeric->Udiag);
  for (int k = 0; k < n; ++k)
    if (diagonal[k] < 0) sign = -sign;
  return sign * f_->groups.determinant_sign();
}

double SparseLu::reciprocal_condition() const {
  if (!f_->numeric) return 0;
  auto [least, largest] = f_->groups.pivots();
  const auto* diagonal = static_cast<const double*>(f_->numeric->Udiag);
  for (int k = 0; k < f_->symbolic->n; ++k) {
    least = std::min(least, std::abs(diagonal[k]));
    largest = std::max(largest, std::abs(diagonal[k]));
  }
  return least / largest;
}

int SparseLu::singular_column() const { return f_->singular; }

}  // namespace liesl
