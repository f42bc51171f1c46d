#include "mbs/linalg/dense_groups.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "mbs/linalg/dense.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;

constexpr std::size_t kLeastGroup = 16;    // fewer are factored as fast with all others
constexpr double kLeastGroupPivot = 1e-8;  // of rows whose largest entry is 1

/// Rows of a column.
std::pair<const int*, const int*> rows_of(const DenseGroups::Matrix& A, int column) {
  const int* at = A.outerIndexPtr() + column;
  return {A.innerIndexPtr() + at[0], A.innerIndexPtr() + at[1]};
}

/// Columns with the same rows, by the first of them. Told apart by a hash (FNV-1a) of the rows.
std::vector<std::vector<int>> alike(const DenseGroups::Matrix& A) {
  std::unordered_map<std::uint64_t, std::vector<int>> by_hash;
  for (int j = 0; j < A.cols(); ++j) {
    const auto [first, last] = rows_of(A, j);
    if (last - first < static_cast<std::ptrdiff_t>(kLeastGroup)) continue;
    std::uint64_t hash = 14695981039346656037u;
    for (const int* row = first; row != last; ++row)
      hash = (hash ^ static_cast<std::uint64_t>(*row)) * 1099511628211u;
    auto& columns = by_hash[hash];
    const auto of_first = rows_of(A, columns.empty() ? j : columns.front());
    if (std::equal(first, last, of_first.first, of_first.second) &&
        std::binary_search(first, last, j))
      columns.push_back(j);
  }
  std::vector<std::vector<int>> all;
  for (auto& [hash, columns] : by_hash) {
    if (columns.size() < kLeastGroup) continue;
    const auto [first, last] = rows_of(A, columns.front());
    if (2 * columns.size() >= static_cast<std::size_t>(last - first))
      all.push_back(std::move(columns));
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

/// Of groups that are joined the first is taken.
DenseGroups::DenseGroups(const Matrix& A) {
  const auto n = static_cast<std::size_t>(A.cols());
  std::vector<int> group_of(n, -1);
  std::vector<bool> joined(n, false);  // with a group that is taken
  place_.assign(n, 0);
  for (std::vector<int>& columns : alike(A)) {
    const auto [first, last] = rows_of(A, columns.front());
    const bool apart = std::none_of(first, last, [&](int row) { return group_of[row] >= 0; });
    if (!apart || std::any_of(columns.begin(), columns.end(), [&](int k) { return joined[k]; }))
      continue;
    for (const int* row = first; row != last; ++row) joined[*row] = true;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      group_of[columns[i]] = static_cast<int>(groups_.size());
      place_[columns[i]] = static_cast<int>(i);
    }
    groups_.emplace_back().rows = std::move(columns);
  }
  for (std::size_t k = 0; k < n; ++k)
    if (group_of[k] < 0) {
      place_[k] = static_cast<int>(left_.size());
      left_.push_back(static_cast<int>(k));
    }
  if (left_.empty()) groups_.clear();
  if (groups_.empty()) return;
  rest_ = SparseAssembly(static_cast<int>(left_.size()));
  find_borders(A, group_of);
  find_places(A, group_of);
}

/// Before the places: D, U and L must not move once entries go there.
void DenseGroups::find_borders(const Matrix& A, const std::vector<int>& group_of) {
  for (int j = 0; j < A.outerSize(); ++j)
    for (Matrix::InnerIterator it(A, j); it; ++it) {
      const int of_row = group_of[it.row()], of_column = group_of[j];
      if (of_row == of_column) continue;
      groups_[std::max(of_row, of_column)].border.push_back(place_[of_row < 0 ? it.row() : j]);
    }
  for (Group& g : groups_) {
    std::sort(g.border.begin(), g.border.end());
    g.border.erase(std::unique(g.border.begin(), g.border.end()), g.border.end());
    const auto inner = static_cast<Eigen::Index>(g.rows.size()),
               border = static_cast<Eigen::Index>(g.border.size());
    g.D.setZero(inner, inner);
    g.U.setZero(inner, border);
    g.L.setZero(border, inner);
  }
}

void DenseGroups::find_places(const Matrix& A, const std::vector<int>& group_of) {
  for (int j = 0; j < A.outerSize(); ++j)
    for (Matrix::InnerIterator it(A, j); it; ++it) {
      const auto row = it.row();
      const int of_row = group_of[row], of_column = group_of[j];
      if (of_row < 0 && of_column < 0) {
        targets_.push_back(nullptr);
        continue;
      }
      Group& g = groups_[std::max(of_row, of_column)];
      const auto on_border = [&](int place) {
        return std::lower_bound(g.border.begin(), g.border.end(), place) - g.border.begin();
      };
      targets_.push_back(of_row < 0      ? &g.L(on_border(place_[row]), place_[j])
                         : of_column < 0 ? &g.U(place_[row], on_border(place_[j]))
                                         : &g.D(place_[row], place_[j]));
    }
}

bool DenseGroups::factor(Group& g) const {
  g.scale = g.D.cwiseAbs().rowwise().maxCoeff();
  if (g.U.cols() > 0) g.scale = g.scale.cwiseMax(g.U.cwiseAbs().rowwise().maxCoeff());
  if (!(g.scale.minCoeff() > 0)) return false;
  g.scale = g.scale.cwiseInverse().eval();
  g.D = (g.scale.asDiagonal() * g.D).eval();
  g.U = (g.scale.asDiagonal() * g.U).eval();
  g.lu.compute(g.D);
  if (!(g.lu.matrixLU().diagonal().cwiseAbs().minCoeff() > kLeastGroupPivot)) return false;
  if (g.U.cols() > 0)
    g.X = g.lu.solve(g.U);
  else
    g.X = g.U;  // Eigen would dereference a null pointer
  return true;
}

auto DenseGroups::condense(const Matrix& A) -> const Matrix* {
  rest_.begin();
  auto target = targets_.begin();
  for (int j = 0; j < A.outerSize(); ++j)
    for (Matrix::InnerIterator it(A, j); it; ++it, ++target) {
      if (*target)
        **target = it.value();
      else
        rest_.add(place_[it.row()], place_[j], it.value());
    }
  for (Group& g : groups_) {
    if (!factor(g)) return nullptr;
    const MatrixXd change = linalg::product(g.L, g.X);
    for (Eigen::Index j = 0; j < change.cols(); ++j)
      for (Eigen::Index i = 0; i < change.rows(); ++i)
        rest_.add(g.border[i], g.border[j], -change(i, j));
  }
  return &rest_.finish();
}

/// b_R - L D^-1 b_D, and x_D = D^-1 b_D - X x_R.
MatrixXd DenseGroups::eliminate(Eigen::Ref<MatrixXd> b) const {
  MatrixXd left = b(left_, Eigen::all);
  for (const Group& g : groups_) {
    const MatrixXd inner = g.lu.solve(MatrixXd(g.scale.asDiagonal() * b(g.rows, Eigen::all)));
    left(g.border, Eigen::all) -= linalg::product(g.L, inner);
    b(g.rows, Eigen::all) = inner;
  }
  return left;
}

void DenseGroups::substitute(const MatrixXd& left, Eigen::Ref<MatrixXd> b) const {
  for (const Group& g : groups_) {
    const MatrixXd of_border = left(g.border, Eigen::all);
    b(g.rows, Eigen::all) -= linalg::product(g.X, of_border);
  }
  b(left_, Eigen::all) = left;
}

/// b_R - X^T b_D, and x_D = D^-T (b_D - L^T x_R).
MatrixXd DenseGroups::eliminate_transposed(Eigen::Ref<MatrixXd> b) const {
  MatrixXd left = b(left_, Eigen::all);
  for (const Group& g : groups_) {
    const MatrixXd inner = b(g.rows, Eigen::all);
    left(g.border, Eigen::all) -= linalg::transposed_product(g.X, inner);
  }
  return left;
}

void DenseGroups::substitute_transposed(const MatrixXd& left, Eigen::Ref<MatrixXd> b) const {
  for (const Group& g : groups_) {
    const MatrixXd of_border = left(g.border, Eigen::all);
    const MatrixXd inner = b(g.rows, Eigen::all) - linalg::transposed_product(g.L, of_border);
    b(g.rows, Eigen::all) = g.scale.asDiagonal() * MatrixXd(g.lu.transpose().solve(inner));
  }
  b(left_, Eigen::all) = left;
}

int DenseGroups::determinant_sign() const {
  int sign = 1;
  for (const Group& g : groups_) {
    const auto negative = (g.lu.matrixLU().diagonal().array() < 0).count();
    if ((negative % 2 == 1) != (g.lu.permutationP().determinant() < 0)) sign = -sign;
  }
  return sign;
}

std::pair<double, double> DenseGroups::pivots() const {
  double least = INFINITY, largest = 0;
  for (const Group& g : groups_) {
    const Eigen::VectorXd size = g.lu.matrixLU().diagonal().cwiseAbs();
    least = std::min(least, size.minCoeff());
    largest = std::max(largest, size.maxCoeff());
  }
  return {least, largest};
}

}  // namespace liesl
