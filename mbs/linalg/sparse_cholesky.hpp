#pragma once
/// @file
/// L L^T factors of a sparse symmetric positive definite matrix: analysed once, factored many times
/// (CHOLMOD, supernodal, METIS ordering; Chen, Davis, Hager, Rajamanickam 2008, "Algorithm 887",
/// ACM Trans. Math. Softw. 35).

#include <Eigen/SparseCore>
#include <memory>

namespace liesl {

class SparseCholesky {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  /// @param looks_for_stop false: within a loop that looks for stops itself (`look_for_stop`)
  explicit SparseCholesky(bool looks_for_stop = true);
  ~SparseCholesky();
  SparseCholesky(SparseCholesky&&) noexcept;
  SparseCholesky& operator=(SparseCholesky&&) noexcept;

  /// Factors A, of which the lower triangle is read. The first call analyses the pattern.
  /// @pre the pattern is that of the first call, A is compressed and square
  /// @throws Stopped, see look_for_stop; so does `solve`, between the blocks
  /// @returns false if A is not positive definite or not finite: there are no factors then.
  bool factor(const Matrix& A);

  /// A^-1 b, by blocks of columns on the threads of the process: the result is the same whatever
  /// their number. The view holds until the next call. Not to be called from several threads.
  /// @pre the last `factor` returned true
  Eigen::Map<const Eigen::MatrixXd> solve(const Eigen::Ref<const Eigen::MatrixXd>& b) const;

  /// Numbers in the factor; 0 without one.
  double nonzeros() const;

 private:
  struct Factors;
  std::unique_ptr<Factors> f_;
  bool looks_for_stop_;
};

}  // namespace liesl
