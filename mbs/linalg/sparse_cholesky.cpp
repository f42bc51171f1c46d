#include "mbs/linalg/sparse_cholesky.hpp"

#include <cholmod.h>

#include <stdexcept>

#include "mbs/linalg/blas_threads.hpp"

namespace liesl {
struct SparseCholesky::Factors {
  mutable cholmod_common common;
  cholmod_factor* L = nullptr;
  bool valid = false;
  mutable cholmod_dense *X = nullptr, *Y = nullptr, *E = nullptr;  // kept between solutions

  Factors() {
    cholmod_start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_METIS;
    common.postorder = 1;
  }
  ~Factors() {
    for (cholmod_dense** d : {&X, &Y, &E}) cholmod_free_dense(d, &common);
    cholmod_free_factor(&L, &common);
    cholmod_finish(&common);
  }
  Factors(const Factors&) = delete;
  Factors& operator=(const Factors&) = delete;
};

SparseCholesky::SparseCholesky() : f_(std::make_unique<Factors>()) {}
SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

bool SparseCholesky::factor(const Matrix& A) {
  Factors& f = *f_;
  f.valid = false;
  one_blas_thread();
  if (!A.coeffs().allFinite()) return false;
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<std::size_t>(A.cols());
  view.nzmax = static_cast<std::size_t>(A.nonZeros());
  // CHOLMOD takes pointers to non-const and does not write through them.
  view.p = const_cast<int*>(A.outerIndexPtr());
  view.i = const_cast<int*>(A.innerIndexPtr());
  view.x = const_cast<double*>(A.valuePtr());
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = view.packed = 1;
  if (!f.L) f.L = cholmod_analyze(&view, &f.common);
  if (!f.L) throw std::runtime_error("CHOLMOD could not analyse a matrix (out of memory)");
  cholmod_factorize(&view, f.L, &f.common);
  if (f.common.status < CHOLMOD_OK) throw std::runtime_error("CHOLMOD ran out of memory");
  f.valid = f.common.status == CHOLMOD_OK && f.L->minor == f.L->n;
  return f.valid;
}

Eigen::Map<const Eigen::MatrixXd> SparseCholesky::solve(
    const Eigen::Ref<const Eigen::MatrixXd>& b) const {
  if (b.size() == 0) return {b.data(), b.rows(), b.cols()};
  const Factors& f = *f_;
  one_blas_thread();
  cholmod_dense view{};
  view.nrow = static_cast<std::size_t>(b.rows());
  view.ncol = static_cast<std::size_t>(b.cols());
  view.d = static_cast<std::size_t>(b.outerStride());
  view.nzmax = view.d * view.ncol;
  view.x = const_cast<double*>(b.data());
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  if (!cholmod_solve2(CHOLMOD_A, f.L, &view, nullptr, &f.X, nullptr, &f.Y, &f.E, &f.common))
    throw std::runtime_error("CHOLMOD could not solve: out of memory");
  return {static_cast<const double*>(f.X->x), b.rows(), b.cols()};
}

double SparseCholesky::nonzeros() const { return f_->valid ? f_->common.lnz : 0; }

}  // namespace liesl
