/// @file
/// SparseCholesky by MUMPS, where the build asks for it (-DLIESL_FACTORISATION=mumps): multifrontal
/// L D L^T without pivoting (Amestoy, Duff, L'Excellent, Koster 2001, SIAM J. Matrix Anal. Appl.
/// 23, 15-41). Slower than CHOLMOD; none of it is under the GPL (docs/licences.md).
#ifdef LIESL_MUMPS

#include <dmumps_c.h>

#include <algorithm>
#include <mutex>
#include <new>
#include <vector>

#include "mbs/linalg/blas_threads.hpp"
#include "mbs/linalg/sparse_cholesky.hpp"
#include "mbs/linalg/stop_request.hpp"

namespace liesl {
namespace {

constexpr Eigen::Index kMumpsBlock = 64;  // columns solved together
constexpr int kInitialise = -1, kEnd = -2, kAnalyse = 1, kFactor = 2, kSolve = 3;  // its JOBs
constexpr int kOutOfSpace = -9, kSingular = -10;                                   // its INFOG(1)
constexpr int kMostSpace = 800;  // percent of what the analysis has estimated

/// The library keeps data of its own between calls.
std::mutex& mumps_lock() {
  static std::mutex lock;
  return lock;
}

}  // namespace

struct SparseCholesky::Factors {
  mutable DMUMPS_STRUC_C mumps{};
  std::vector<int> rows, columns;  ///< from 1; of the first matrix
  std::vector<double> values;
  bool analysed = false, valid = false;
  mutable Eigen::MatrixXd x;

  Factors() {
    mumps.comm_fortran = -987654;  // one process
    mumps.par = 1;
    mumps.sym = 1;  // positive definite
    run(kInitialise);
    for (int i = 0; i < 4; ++i) icntl(i + 1) = i < 3 ? -1 : 0;  // says nothing
    icntl(7) = 5;                                               // METIS, as with CHOLMOD
  }
  ~Factors() { run(kEnd); }
  Factors(const Factors&) = delete;
  Factors& operator=(const Factors&) = delete;

  int& icntl(int i) const { return mumps.icntl[i - 1]; }
  int infog(int i) const { return mumps.infog[i - 1]; }
  /// @returns INFOG(1)
  int run(int job) const {
    const std::lock_guard<std::mutex> alone(mumps_lock());
    mumps.job = job;
    dmumps_c(&mumps);
    return infog(1);
  }

  void read_pattern(const Matrix& A) {
    for (int j = 0; j < A.outerSize(); ++j)
      for (Matrix::InnerIterator it(A, j); it; ++it)
        if (it.row() >= it.col()) {
          rows.push_back(static_cast<int>(it.row()) + 1);
          columns.push_back(j + 1);
        }
    values.resize(rows.size());
    mumps.n = static_cast<int>(A.cols());
    mumps.nnz = static_cast<MUMPS_INT8>(rows.size());
    mumps.irn = rows.data();
    mumps.jcn = columns.data();
    mumps.a = values.data();
  }
  void read_values(const Matrix& A) {
    std::size_t at = 0;
    for (int j = 0; j < A.outerSize(); ++j)
      for (Matrix::InnerIterator it(A, j); it; ++it)
        if (it.row() >= it.col()) values[at++] = it.value();
  }
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
  if (!f.analysed) f.read_pattern(A);
  f.read_values(A);
  if (!f.analysed && f.run(kAnalyse) < 0) throw std::bad_alloc();
  f.analysed = true;
  if (looks_for_stop_) look_for_stop();
  int end = f.run(kFactor);
  while (end == kOutOfSpace && f.icntl(14) < kMostSpace) {
    f.icntl(14) *= 2;
    end = f.run(kFactor);
  }
  if (end < 0 && end != kSingular) throw std::bad_alloc();
  f.valid = end >= 0 && f.infog(12) == 0;  // no negative pivot
  return f.valid;
}

Eigen::Map<const Eigen::MatrixXd> SparseCholesky::solve(
    const Eigen::Ref<const Eigen::MatrixXd>& b) const {
  if (b.size() == 0) return {b.data(), b.rows(), b.cols()};
  const Factors& f = *f_;
  one_blas_thread();
  f.x = b;
  for (Eigen::Index first = 0; first < b.cols(); first += kMumpsBlock) {
    if (looks_for_stop_) look_for_stop();
    f.mumps.rhs = f.x.col(first).data();
    f.mumps.nrhs = static_cast<int>(std::min(kMumpsBlock, b.cols() - first));
    f.mumps.lrhs = static_cast<int>(b.rows());
    if (f.run(kSolve) < 0) throw std::bad_alloc();
  }
  return {f.x.data(), b.rows(), b.cols()};
}

double SparseCholesky::nonzeros() const {
  if (!f_->valid) return 0;
  const int entries = f_->infog(29);  // below zero: millions
  return entries >= 0 ? entries : -1e6 * entries;
}

}  // namespace liesl

#endif
