#ifndef LIESL_MUMPS  // else sparse_cholesky_mumps.cpp

#include "mbs/linalg/sparse_cholesky.hpp"

#include <cholmod.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <new>

#include "mbs/linalg/blas_threads.hpp"
#include "mbs/linalg/stop_request.hpp"

namespace liesl {
namespace {

constexpr Eigen::Index kBlock = 64;  // columns solved together

/// What a thread needs to solve, kept between solutions.
struct Lane {
  cholmod_common common;
  cholmod_dense *X = nullptr, *Y = nullptr, *E = nullptr;

  Lane() {
    cholmod_start(&common);
    common.print = 0;
  }
  ~Lane() {
    for (cholmod_dense** d : {&X, &Y, &E}) cholmod_free_dense(d, &common);
    cholmod_finish(&common);
  }
  Lane(const Lane&) = delete;
  Lane& operator=(const Lane&) = delete;

  /// x = A^-1 b; false: out of memory.
  bool solve(cholmod_factor* L, const Eigen::Ref<const Eigen::MatrixXd>& b,
             Eigen::Ref<Eigen::MatrixXd> x) {
    one_blas_thread();
    cholmod_dense view{};
    view.nrow = static_cast<std::size_t>(b.rows());
    view.ncol = static_cast<std::size_t>(b.cols());
    view.d = static_cast<std::size_t>(b.outerStride());
    view.nzmax = view.d * view.ncol;
    // CHOLMOD takes pointers to non-const and does not write through them.
    view.x = const_cast<double*>(b.data());
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    if (!cholmod_solve2(CHOLMOD_A, L, &view, nullptr, &X, nullptr, &Y, &E, &common)) return false;
    x = Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(X->x), b.rows(), b.cols());
    return true;
  }
};

}  // namespace

struct SparseCholesky::Factors {
  mutable cholmod_common common;
  cholmod_factor* L = nullptr;
  bool valid = false;
  mutable tbb::enumerable_thread_specific<Lane> lanes;
  mutable Eigen::MatrixXd x;

  Factors() {
    cholmod_start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_METIS;
    common.postorder = 1;
  }
  ~Factors() {
    cholmod_free_factor(&L, &common);
    cholmod_finish(&common);
  }
  Factors(const Factors&) = delete;
  Factors& operator=(const Factors&) = delete;
};

SparseCholesky::SparseCholesky(bool looks_for_stop)
    : f_(std::make_unique<Factors>()), looks_for_stop_(looks_for_stop) {}
SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

bool SparseCholesky::factor(const Matrix& A) {
  Factors& f = *f_;
  f.valid = false;
  if (looks_for_stop_) look_for_stop();
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
  if (!f.L) throw std::bad_alloc();
  if (looks_for_stop_) look_for_stop();
  cholmod_factorize(&view, f.L, &f.common);
  if (f.common.status < CHOLMOD_OK) throw std::bad_alloc();
  f.valid = f.common.status == CHOLMOD_OK && f.L->minor == f.L->n;
  return f.valid;
}

Eigen::Map<const Eigen::MatrixXd> SparseCholesky::solve(
    const Eigen::Ref<const Eigen::MatrixXd>& b) const {
  if (b.size() == 0) return {b.data(), b.rows(), b.cols()};
  const Factors& f = *f_;
  f.x.resize(b.rows(), b.cols());
  std::atomic<bool> solved = true;
  const auto solve_block = [&](Eigen::Index k) {
    if (looks_for_stop_) look_for_stop();
    const Eigen::Index first = k * kBlock, count = std::min(kBlock, b.cols() - first);
    if (!f.lanes.local().solve(f.L, b.middleCols(first, count), f.x.middleCols(first, count)))
      solved = false;
  };
  if (b.cols() <= kBlock)
    solve_block(0);
  else
    tbb::parallel_for(Eigen::Index{0}, (b.cols() + kBlock - 1) / kBlock, solve_block);
  if (!solved) throw std::bad_alloc();
  return {f.x.data(), b.rows(), b.cols()};
}

double SparseCholesky::nonzeros() const { return f_->valid ? f_->common.lnz : 0; }

}  // namespace liesl

#endif
