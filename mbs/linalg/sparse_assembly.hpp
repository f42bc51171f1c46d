#pragma once
/// @file
/// Sums entries into a sparse matrix whose pattern is found once.

#include <Eigen/SparseCore>
#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace liesl {

/// begin, add ..., finish: the entries must come in the same order each time. The first round
/// finds the pattern and where each entry goes; later rounds write straight into the values. Copies
/// share where the entries go.
class SparseAssembly {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  explicit SparseAssembly(int size) : A_(size, size) {}

  void begin() {
    next_ = slots_ ? slots_->data() : nullptr;
    if (slots_) A_.coeffs().setZero();
  }

  void add(int row, int column, double value) {
    if (!slots_)
      entries_.emplace_back(row, column, value);
    else
      A_.valuePtr()[*next_++] += value;
  }

  template <class Block>
  void add_block(int row, int column, const Eigen::MatrixBase<Block>& m) {
    for (int j = 0; j < m.cols(); ++j)
      for (int i = 0; i < m.rows(); ++i) add(row + i, column + j, m(i, j));
  }

  const Matrix& finish() & {
    if (!slots_) find_pattern();
    return A_;
  }
  Matrix finish() && { return static_cast<SparseAssembly&>(*this).finish(), std::move(A_); }

 private:
  void find_pattern() {
    A_.setFromTriplets(entries_.begin(), entries_.end());
    auto slots = std::make_shared<std::vector<int>>();
    slots->reserve(entries_.size());
    for (const auto& e : entries_) {
      const int* first = A_.innerIndexPtr() + A_.outerIndexPtr()[e.col()];
      const int* last = A_.innerIndexPtr() + A_.outerIndexPtr()[e.col() + 1];
      slots->push_back(
          static_cast<int>(std::lower_bound(first, last, e.row()) - A_.innerIndexPtr()));
    }
    slots_ = std::move(slots);
    entries_.clear();
    entries_.shrink_to_fit();
  }

  Matrix A_;
  std::vector<Eigen::Triplet<double>> entries_;
  std::shared_ptr<const std::vector<int>> slots_;  ///< by entry: in the values of A
  const int* next_ = nullptr;
};

}  // namespace liesl
