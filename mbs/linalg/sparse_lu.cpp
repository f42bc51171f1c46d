#include "mbs/linalg/sparse_lu.hpp"

#include <klu.h>

#include <new>
#include <vector>

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

struct SparseLu::Factors {
  klu_common common;
  klu_symbolic* symbolic = nullptr;
  klu_numeric* numeric = nullptr;
  int singular = -1;

  Factors() { klu_defaults(&common); }
  ~Factors() {
    klu_free_numeric(&numeric, &common);
    klu_free_symbolic(&symbolic, &common);
  }
  Factors(const Factors&) = delete;
  Factors& operator=(const Factors&) = delete;

  bool refactor(int* columns, int* rows, double* values) {
    if (!numeric || !klu_refactor(columns, rows, values, symbolic, numeric, &common)) return false;
    return common.status == KLU_OK &&
           klu_rgrowth(columns, rows, values, symbolic, numeric, &common) &&
           common.rgrowth > kSmallestGrowth && zero_pivot() < 0;
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
  Factors& f = *f_;
  const int n = static_cast<int>(A.cols());
  f.singular = -1;
  if (n == 0) return true;
  // KLU takes pointers to non-const and does not write through them.
  auto* columns = const_cast<int*>(A.outerIndexPtr());
  auto* rows = const_cast<int*>(A.innerIndexPtr());
  auto* values = const_cast<double*>(A.valuePtr());
  if (!A.coeffs().allFinite()) return f.drop(0);
  if (!f.symbolic) f.symbolic = klu_analyze(n, columns, rows, &f.common);
  if (!f.symbolic) return f.drop(0);
  if (f.refactor(columns, rows, values)) return true;
  klu_free_numeric(&f.numeric, &f.common);
  f.numeric = klu_factor(columns, rows, values, f.symbolic, &f.common);
  if (!f.numeric || f.common.status != KLU_OK) {
    const int column = f.common.singular_col;
    return f.drop(column >= 0 && column < n ? column : 0);
  }
  const int zero = f.zero_pivot();
  return zero < 0 || f.drop(zero);
}

void SparseLu::solve(Eigen::Ref<Eigen::MatrixXd> b) const {
  if (b.rows() == 0) return;
  klu_solve(f_->symbolic, f_->numeric, static_cast<int>(b.outerStride()),
            static_cast<int>(b.cols()), b.data(), &f_->common);
}

void SparseLu::solve_transposed(Eigen::Ref<Eigen::MatrixXd> b) const {
  if (b.rows() == 0) return;
  klu_tsolve(f_->symbolic, f_->numeric, static_cast<int>(b.outerStride()),
             static_cast<int>(b.cols()), b.data(), &f_->common);
}

int SparseLu::determinant_sign() const {
  if (!f_->numeric) return 0;
  const int n = f_->symbolic->n;
  int sign = parity(f_->numeric->Pnum, n) * parity(f_->symbolic->Q, n);
  const auto* diagonal = static_cast<const double*>(f_->numeric->Udiag);
  for (int k = 0; k < n; ++k)
    if (diagonal[k] < 0) sign = -sign;
  return sign;
}

double SparseLu::reciprocal_condition() const {
  if (!f_->numeric || !klu_rcond(f_->symbolic, f_->numeric, &f_->common)) return 0;
  return f_->common.rcond;
}

int SparseLu::singular_column() const { return f_->singular; }

}  // namespace liesl
