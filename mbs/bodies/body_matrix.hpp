#pragma once
/// @file
/// The matrices of a body: block-tridiagonal for a chain of nodes that all carry unknowns, dense
/// over the few nodes that do where the others follow them (rigid chains, modal bodies).

#include <algorithm>

#include "mbs/linalg/block_tridiagonal.hpp"
#include "mbs/linalg/dense.hpp"

namespace liesl {

template <int N>
struct BodyMatrix : BlockTridiagonal<N> {
  using Chain = BlockTridiagonal<N>;
  using Chain::Chain;

  std::vector<int> nodes;  ///< dense form: the nodes of its blocks
  Eigen::MatrixXd dense;

  bool is_dense() const { return dense.size() > 0; }
  void set_dense(std::vector<int> at, Eigen::MatrixXd matrix) {
    nodes = std::move(at);
    dense = std::move(matrix);
  }
  /// this = a A + b B (same shape).
  void set_sum(double a, const BodyMatrix& A, double b, const BodyMatrix& B) {
    if (is_dense())
      dense.noalias() = a * A.dense + b * B.dense;
    else
      Chain::set_sum(a, A, b, B);
  }
  void set_zero() {
    if (is_dense())
      dense.setZero();
    else
      Chain::set_zero();
  }
  /// Takes the form of another matrix of the body, with zeros.
  void set_form(const BodyMatrix& A) {
    if (A.is_dense()) set_dense(A.nodes, Eigen::MatrixXd::Zero(A.dense.rows(), A.dense.cols()));
    if (!A.U2.empty()) this->widen();
  }
  /// The block on the diagonal of a node with unknowns.
  Eigen::Ref<typename Chain::Block, 0, Eigen::OuterStride<>> node_block(int node) {
    if (!is_dense()) return this->D[node];
    const auto at = std::find(nodes.begin(), nodes.end(), node) - nodes.begin();
    return dense.template block<N, N>(N * at, N * at);
  }
  /// this += A diag(X_k), X_k a block for each node of the body (same shape as A).
  template <class Blocks>
  void add_scaled_columns(const BodyMatrix& A, const Blocks* X) {
    if (is_dense()) {
      for (size_t j = 0; j < nodes.size(); ++j) {
        const int at = N * static_cast<int>(j);
        dense.template middleCols<N>(at).noalias() +=
            A.dense.template middleCols<N>(at) * X[nodes[j]];
      }
      return;
    }
    for (size_t k = 0; k < this->D.size(); ++k) this->D[k].noalias() += A.D[k] * X[k];
    for (size_t k = 0; k < this->U.size(); ++k) {
      this->U[k].noalias() += A.U[k] * X[k + 1];
      this->L[k].noalias() += A.L[k] * X[k];
    }
    for (size_t k = 0; k < this->U2.size(); ++k) {
      this->U2[k].noalias() += A.U2[k] * X[k + 2];
      this->L2[k].noalias() += A.L2[k] * X[k];
    }
  }
};

/// LU factors of either form; a solution is zero at the nodes that follow.
template <int N>
class BodyLU {
 public:
  /// @returns false if the matrix is singular; the factors are then unusable.
  bool factor(const BodyMatrix<N>& A) {
    dense_ = A.is_dense();
    if (!dense_) return chain_.factor(A);
    nodes_ = A.nodes;
    x_.setZero(A.dense.rows());
    y_.setZero(A.dense.rows());
    lu_.factor(A.dense);
    const double smallest = lu_.smallest_pivot();
    return std::isfinite(smallest) && smallest > 0;
  }
  /// x <- A^-1 x for the `size` numbers of the body, in place. Allocates nothing.
  void solve(double* x, int size) {
    if (!dense_) return chain_.solve(x);
    Eigen::Map<Eigen::VectorXd> all(x, size);
    for (size_t i = 0; i < nodes_.size(); ++i)
      x_.template segment<N>(N * static_cast<int>(i)) = all.template segment<N>(N * nodes_[i]);
    lu_.solve(x_, y_);
    all.setZero();
    for (size_t i = 0; i < nodes_.size(); ++i)
      all.template segment<N>(N * nodes_[i]) = y_.template segment<N>(N * static_cast<int>(i));
  }

 private:
  bool dense_ = false;
  BlockTridiagonalLU<N> chain_;
  std::vector<int> nodes_;
  linalg::LU lu_;
  Eigen::VectorXd x_, y_;
};

}  // namespace liesl
