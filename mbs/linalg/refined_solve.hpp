#pragma once
/// @file
/// Solutions of sparse equations to round-off, whatever pivots their factors were kept with.

#include <Eigen/SparseCore>
#include <limits>

#include "mbs/linalg/sparse_lu.hpp"

namespace liesl {

/// Iterative refinement with residuals in twice the precision (N. J. Higham, Accuracy and Stability
/// of Numerical Algorithms, SIAM 2002, ch. 12). Rows of S range from 1 (joints) to 1e9 (EA/L, beta'
/// M), and the pivots that KLU keeps from step to step may cost half of the digits; w' = beta' x +
/// w0 takes as many again. Keeps its workspace from solve to solve.
class RefinedSolve {
 public:
  /// x <- A^-1 x or A^-T x.
  /// @param n number of displacements, the first rows of x; multipliers are judged apart
  /// @returns false if the solution is not finite
  bool solve(const SparseLu& lu, const Eigen::SparseMatrix<double>& A, bool transposed,
             Eigen::Index n, Eigen::MatrixXd& x) {
    b_ = x;
    return refine(lu, A, transposed, n, kAny, x);
  }
  /// The same with factors of A by `factor_kept`: where the first correction is not small against
  /// the solution, pivots are chosen anew and the solution begins again.
  bool solve_kept(SparseLu& lu, const Eigen::SparseMatrix<double>& A, bool transposed,
                  Eigen::Index n, Eigen::MatrixXd& x);

 private:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  static constexpr double kAny = std::numeric_limits<double>::infinity();

  /// @param largest share of the solution that the first correction may be
  bool refine(const SparseLu& lu, const Eigen::SparseMatrix<double>& A, bool transposed,
              Eigen::Index n, double largest, Eigen::MatrixXd& x);
  void take_residual(const Eigen::SparseMatrix<double>& A, bool transposed,
                     const Eigen::MatrixXd& x);

  Eigen::MatrixXd b_, correction_;
  Rows x_, r_, rest_;  ///< columns side by side, filled up to a multiple of those at once
};

}  // namespace liesl
