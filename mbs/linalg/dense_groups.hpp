#pragma once
/// @file
/// Unknowns of a sparse matrix that are joined with each other and all with the same others, as the
/// amplitudes of the modes of a body: eliminated before the others are factored.

#include <Eigen/LU>
#include <Eigen/SparseCore>
#include <utility>
#include <vector>

#include "mbs/linalg/sparse_assembly.hpp"

namespace liesl {

/// Each group has a dense LU of its own, [D U; L R] -> R - L D^-1 U with R of all that are left:
/// entry by entry, as sparse matrices are factored, that takes longer. Rows of the groups are
/// divided by their largest entry, as KLU does with all.
class DenseGroups {
 public:
  using Matrix = SparseAssembly::Matrix;

  DenseGroups() = default;
  /// The groups of a matrix: columns with the same rows, their own among them, that are many and no
  /// fewer than the others that they are joined with. No two of them are joined, and they are not
  /// all unknowns. @pre A is compressed and square, here and below
  explicit DenseGroups(const Matrix& A);
  DenseGroups(DenseGroups&&) noexcept = default;  // copies would share where entries go
  DenseGroups& operator=(DenseGroups&&) noexcept = default;

  bool empty() const { return groups_.empty(); }
  /// R - L D^-1 U. @pre the pattern is that of the first matrix
  /// @returns null if a group has no factors worth having: a pivot is nearly zero
  const Matrix* condense(const Matrix& A);
  /// Number of an unknown that is left.
  int left(int row) const { return left_[static_cast<std::size_t>(row)]; }

  /// Right sides of those that are left, and solutions of the groups from theirs. In between b
  /// holds D^-1 b, or b; any number of columns. @pre the last `condense` did not return null, from
  /// here on
  Eigen::MatrixXd eliminate(Eigen::Ref<Eigen::MatrixXd> b) const;
  void substitute(const Eigen::MatrixXd& left, Eigen::Ref<Eigen::MatrixXd> b) const;
  /// The same with the transposed matrix.
  Eigen::MatrixXd eliminate_transposed(Eigen::Ref<Eigen::MatrixXd> b) const;
  void substitute_transposed(const Eigen::MatrixXd& left, Eigen::Ref<Eigen::MatrixXd> b) const;

  /// Sign of the product of det D.
  int determinant_sign() const;
  /// Least and largest |pivot|.
  std::pair<double, double> pivots() const;

 private:
  struct Group {
    std::vector<int> rows, border;  ///< of the matrix; what it is joined with, of those left
    Eigen::MatrixXd D, U, L, X;     ///< X = D^-1 U
    Eigen::VectorXd scale;          ///< of its rows
    Eigen::PartialPivLU<Eigen::MatrixXd> lu;
  };
  void find_places(const Matrix& A, const std::vector<int>& group_of);
  void find_borders(const Matrix& A, const std::vector<int>& group_of);
  bool factor(Group& g) const;

  std::vector<Group> groups_;
  std::vector<int> left_;         ///< unknowns that are in no group
  std::vector<int> place_;        ///< by unknown: in its group, or among those that are left
  std::vector<double*> targets_;  ///< by entry: in a group; null: of what is left
  SparseAssembly rest_{0};
};

}  // namespace liesl
