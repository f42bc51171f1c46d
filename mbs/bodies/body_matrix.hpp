#pragma once
/// @file
/// The matrices of a body: block-tridiagonal for a chain of nodes that all carry unknowns, dense
/// over the few nodes that do where the others follow them (rigid chains, modal bodies), sparse for
/// a mesh whose nodes all move.

#include <algorithm>

#include "mbs/linalg/block_tridiagonal.hpp"
#include "mbs/linalg/dense.hpp"
#include "mbs/linalg/sparse_factors.hpp"

namespace liesl {

template <int N>
struct BodyMatrix : BlockTridiagonal<N> {
  using Chain = BlockTridiagonal<N>;
  using Chain::Chain;

  std::vector<int> nodes;  ///< dense form: the nodes of its blocks
  Eigen::MatrixXd dense;
  /// Sparse form: of all freedoms of the body, compressed; matrices of one body have one pattern.
  Eigen::SparseMatrix<double> sparse;

  bool is_dense() const { return dense.size() > 0; }
  bool is_sparse() const { return sparse.size() > 0; }
  void set_dense(std::vector<int> at, Eigen::MatrixXd matrix) {
    nodes = std::move(at);
    dense = std::move(matrix);
  }
  void set_sparse(Eigen::SparseMatrix<double> matrix) {
    this->resize(0);
    sparse = std::move(matrix);
  }
  /// this = a A + b B (same shape).
  void set_sum(double a, const BodyMatrix& A, double b, const BodyMatrix& B) {
    if (is_sparse())
      sparse.coeffs() = a * A.sparse.coeffs() + b * B.sparse.coeffs();
    else if (is_dense())
      dense.noalias() = a * A.dense + b * B.dense;
    else
      Chain::set_sum(a, A, b, B);
  }
  void set_zero() {
    if (is_sparse())
      sparse.coeffs().setZero();
    else if (is_dense())
      dense.setZero();
    else
      Chain::set_zero();
  }
  /// Takes the form of another matrix of the body, with zeros.
  void set_form(const BodyMatrix& A) {
    if (A.is_sparse()) {
      set_sparse(A.sparse);
      set_zero();
    }
    if (A.is_dense()) set_dense(A.nodes, Eigen::MatrixXd::Zero(A.dense.rows(), A.dense.cols()));
    if (!A.U2.empty()) this->widen();
  }
  /// Adds to the block on the diagonal of a node with unknowns. @pre sparse: a frame
  void add_to_node(int node, const typename Chain::Block& block) {
    if (is_sparse()) {
      for (int j = 0; j < N; ++j)
        for (int i = 0; i < N; ++i) sparse.coeffRef(N * node + i, N * node + j) += block(i, j);
      return;
    }
    if (!is_dense()) {
      this->D[node] += block;
      return;
    }
    const auto at = std::find(nodes.begin(), nodes.end(), node) - nodes.begin();
    dense.template block<N, N>(N * at, N * at) += block;
  }
  /// Entry on the diagonal of a component of a node with unknowns.
  double diagonal(int node, int component) const {
    if (is_sparse()) return sparse.coeff(N * node + component, N * node + component);
    if (!is_dense()) return this->D[node](component, component);
    const auto at = N * (std::find(nodes.begin(), nodes.end(), node) - nodes.begin()) + component;
    return dense(at, at);
  }
  /// this += A diag(X_k), X_k a block for each node of the body (same shape as A).
  template <class Blocks>
  void add_scaled_columns(const BodyMatrix& A, const Blocks* X) {
    if (is_sparse()) return add_scaled_sparse(A, X);
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

 private:
  /// X of a node that is no frame is a multiple of the identity: it stays within its column.
  template <class Blocks>
  void add_scaled_sparse(const BodyMatrix& A, const Blocks* X) {
    const double* value = A.sparse.valuePtr();
    for (int column = 0; column < A.sparse.cols(); ++column) {
      const auto& block = X[column / N];
      for (int at = A.sparse.outerIndexPtr()[column]; at < A.sparse.outerIndexPtr()[column + 1];
           ++at) {
        if (value[at] == 0) continue;
        const int row = A.sparse.innerIndexPtr()[at];
        for (int j = 0; j < N; ++j) {
          const double x = block(column % N, j);
          const int to = column - column % N + j;
          if (x == 0) continue;
          if (to == column)
            sparse.valuePtr()[at] += value[at] * x;
          else
            sparse.coeffRef(row, to) += value[at] * x;
        }
      }
    }
  }
};

/// Factors of any form; a solution is zero at the nodes that follow.
template <int N>
class BodyLU {
 public:
  /// @returns false if the matrix is singular; the factors are then unusable.
  bool factor(const BodyMatrix<N>& A) {
    sparse_ = A.is_sparse();
    if (sparse_) return sparse_factors_.factor(A.sparse);
    dense_ = A.is_dense();
    if (!dense_) return chain_.factor(A);
    nodes_ = A.nodes;
    x_.setZero(A.dense.rows());
    y_.setZero(A.dense.rows());
    lu_.factor(A.dense);
    const double smallest = lu_.smallest_pivot();
    return std::isfinite(smallest) && smallest > 0;
  }
  /// x <- A^-1 x for the `size` numbers of the body, in place. Allocates nothing after its first
  /// call.
  void solve(double* x, int size) {
    if (sparse_) return sparse_factors_.solve(Eigen::Map<Eigen::MatrixXd>(x, size, 1));
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
  bool dense_ = false, sparse_ = false;
  SparseFactors sparse_factors_;
  BlockTridiagonalLU<N> chain_;
  std::vector<int> nodes_;
  linalg::LU lu_;
  Eigen::VectorXd x_, y_;
};

}  // namespace liesl
