#pragma once
/// @file
/// Dense decompositions behind plain functions. The algorithms are Eigen's (G. H. Golub, C. F. Van
/// Loan, Matrix Computations, 4th ed., ch. 3-8); the templates behind each take seconds to compile,
/// which is done here once for all who need them. Nothing throws: a singular matrix gives entries
/// that are not finite, as with Eigen.

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <optional>
#include <variant>

namespace liesl::linalg {

/// A B, A^T B and A B^T of any sizes: for products outside of the loops of a step, of fixed sizes
/// or of blocks, each of which would be templates of its own.
using Dense = Eigen::Ref<const Eigen::MatrixXd>;
Eigen::MatrixXd product(const Dense& A, const Dense& B);
Eigen::MatrixXd transposed_product(const Dense& A, const Dense& B);
Eigen::MatrixXd product_transposed(const Dense& A, const Dense& B);
/// C -= A^T B
void subtract_transposed_product(const Dense& A, const Dense& B, Eigen::Ref<Eigen::MatrixXd> C);

/// L U = P A with partial pivoting; no allocation once the size is known. Up to six rows, as many
/// as a joint may have, are of a size that Eigen knows when it is compiled: the work of so few is
/// bookkeeping for the most part where it does not.
class LU {
 public:
  void factor(const Eigen::MatrixXd& A);
  /// Least |U_ii|, 0 if A is singular. @pre factored
  double smallest_pivot() const;
  /// x = A^-1 b; x and b are different vectors.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const;

 private:
  template <int N>
  using Fixed = Eigen::PartialPivLU<Eigen::Matrix<double, N, N>>;

  std::variant<Fixed<Eigen::Dynamic>, Fixed<1>, Fixed<2>, Fixed<3>, Fixed<4>, Fixed<5>, Fixed<6>>
      lu_;
};

/// U^T U = A, A symmetric and positive definite; no allocation once the size is known.
class Cholesky {
 public:
  /// @returns false if A is not positive definite.
  bool factor(const Eigen::MatrixXd& A);
  /// x <- A^-1 x
  void solve_in_place(Eigen::VectorXd& x) const;
  /// X U^-1: columns that are normal with A = X^T M X become orthonormal in M.
  Eigen::MatrixXd times_inverse_factor(const Eigen::MatrixXd& X) const;

 private:
  Eigen::LLT<Eigen::MatrixXd> llt_;
};

/// P^T L D L^T P = A, A symmetric, of either sign.
class LDLT {
 public:
  explicit LDLT(const Eigen::MatrixXd& A);
  Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const;

 private:
  Eigen::LDLT<Eigen::MatrixXd> ldlt_;
};

/// A^-1 B by LU with partial pivoting.
Eigen::MatrixXd solve(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);
Eigen::MatrixXd inverse(const Eigen::MatrixXd& A);
/// N = 3 and 6.
template <int N>
Eigen::Matrix<double, N, N> inverse(const Eigen::Matrix<double, N, N>& A);
double determinant(const Eigen::MatrixXd& A);
/// Rank by QR with column pivoting: pivots above `threshold` times the largest.
int rank(const Eigen::MatrixXd& A, double threshold);

/// Least squares min |A x - b| for independent columns, by QR with column pivoting.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);
/// The shortest of the least-squares solutions, by a complete orthogonal decomposition; pivots
/// below `threshold` times the largest are zero.
Eigen::VectorXd shortest_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                                       double threshold);
/// Columns of A in the order in which QR with column pivoting takes them, and how many span the
/// rest.
struct PivotedColumns {
  Eigen::VectorXi order;
  int rank = 0;
};
PivotedColumns pivoted_columns(const Eigen::MatrixXd& A);
/// Q X, A = Q R by Householder reflections; Q is square.
Eigen::MatrixXd times_q(const Eigen::MatrixXd& A, Eigen::MatrixXd X);

/// A phi = lambda phi, lambda ascending, phi^T phi = 1. Without vectors, phi is empty.
struct SymmetricEigen {
  Eigen::VectorXd lambda;
  Eigen::MatrixXd phi;
};
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A);
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& A);
/// A phi = lambda B phi, B positive definite, phi^T B phi = 1. @returns nothing if it does not
/// converge.
std::optional<SymmetricEigen> generalized_eigen(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);
std::optional<Eigen::VectorXd> generalized_eigenvalues(const Eigen::MatrixXd& A,
                                                       const Eigen::MatrixXd& B);

/// A = U diag(sigma) V^T, sigma descending; V is square.
struct RightSingular {
  Eigen::VectorXd sigma;
  Eigen::MatrixXd V;
};
RightSingular right_singular(const Eigen::MatrixXd& A);

}  // namespace liesl::linalg
