#pragma once
/// @file
/// LU factors of a sparse unsymmetric matrix: analysed once, factored many times (KLU; Davis,
/// Palamadai Natarajan 2010, "Algorithm 907", ACM Trans. Math. Softw. 37).

#include <Eigen/SparseCore>
#include <memory>

namespace liesl {

class SparseLu {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  SparseLu();
  ~SparseLu();
  SparseLu(SparseLu&&) noexcept;
  SparseLu& operator=(SparseLu&&) noexcept;

  /// Factors A. The first call analyses the pattern; later ones keep the order of the pivots as
  /// long as it is stable. @pre the pattern is that of the first call, A is compressed and square
  /// @returns false if A is singular or not finite: then `singular_column` is the place, and there
  /// are no factors.
  bool factor(const Matrix& A);
  /// The same for solutions that are refined (`RefinedSolve`): later calls keep the pivots, without
  /// a look at their growth, which the refinement shows, and rows are not scaled. @pre all calls
  /// are of this kind, but for `factor` where pivots have to be chosen anew
  bool factor_kept(const Matrix& A);

  /// b <- A^-1 b, any number of columns. @pre the last `factor` returned true
  void solve(Eigen::Ref<Eigen::MatrixXd> b) const;

  /// b <- A^-T b
  void solve_transposed(Eigen::Ref<Eigen::MatrixXd> b) const;

  /// Sign of det A: +1 or -1; 0 without factors.
  int determinant_sign() const;
  /// min |U_kk| / max |U_kk|, rows scaled: near 1e-16 a singular matrix was not recognised.
  double reciprocal_condition() const;
  /// Column in which no pivot was found, -1 if there was one in all.
  int singular_column() const;

 private:
  /// Of an earlier factor, their growth measured; of an earlier factor; chosen anew.
  enum class Pivots { Measured, Kept, Anew };
  struct Factors;
  bool factor(const Matrix& A, Pivots pivots);
  std::unique_ptr<Factors> f_;
};

}  // namespace liesl
