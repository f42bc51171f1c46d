/// @file
/// Derivatives of the inertia of beams in a floating frame. Nodes move with
///   v_k = (I - ad(u_k)) A_k v_0 + (I - ad(u_k)/2) du_k, u = Psi e, A_k = Ad(X_k^-1),
/// forces on them reach [v_0; edot] by the transposed of that; what lies between is
/// block-tridiagonal, so that one dense product with Psi^T is left.

#include "mbs/bodies/modal.hpp"
#include "mbs/linalg/block_product.hpp"
#include "mbs/linalg/dense.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A X
template <int N>
MatrixXd times(const BlockTridiagonal<N>& A, const MatrixXd& X) {
  MatrixXd Y = MatrixXd::Zero(X.rows(), X.cols());
  const int n = A.blocks();
  for (int k = 0; k < n; ++k) {
    add_block_product(A.D[k], X, N * k, Y, N * k);
    if (k > 0) add_block_product(A.L[k - 1], X, N * (k - 1), Y, N * k);
    if (k + 1 < n) add_block_product(A.U[k], X, N * (k + 1), Y, N * k);
  }
  return Y;
}

/// What changes velocities and accelerations of each node, blocks of both.
template <FrameGroup G>
using Change =
    std::pair<const typename Body<G>::Matrices::Blocks&, const typename Body<G>::Matrices::Blocks&>;

/// Forces on the nodes, G(v) by_v + M by_a over the elements, for each of the changes.
template <FrameGroup G>
std::vector<BlockTridiagonal<G::dim>> force_tangents(const Beam<G>& beam, const VectorXd& v,
                                                     const std::vector<Change<G>>& changes) {
  constexpr int dim = G::dim;
  std::vector<BlockTridiagonal<dim>> chains(changes.size(), BlockTridiagonal<dim>(beam.nodes()));
  Eigen::Matrix<double, 2 * dim, 2 * dim> forces;
  for (int e = 0; e < beam.elements(); ++e) {
    const auto& element = beam.element(e);
    const auto gyroscopic =
        element.gyroscopic_tangent(beam.reference[e], beam.reference[e + 1], v.data() + dim * e);
    for (std::size_t c = 0; c < changes.size(); ++c) {
      for (int i = 0; i < 2; ++i) {
        const int at = dim * i;
        forces.template middleCols<dim>(at).noalias() =
            gyroscopic.template middleCols<dim>(at).lazyProduct(changes[c].first[e + i]) +
            element.mass().template middleCols<dim>(at).lazyProduct(changes[c].second[e + i]);
      }
      chains[c].add_element(e, forces);
    }
  }
  return chains;
}

}  // namespace

template <FrameGroup G>
BlockTridiagonal<G::dim> ModalBody<G>::force_tangent(const VectorXd& v, const Blocks& by_v,
                                                     const Blocks& by_a) const {
  return std::move(force_tangents<G>(*beam_, v, {{by_v, by_a}})[0]);
}

template <FrameGroup G>
MatrixXd ModalBody<G>::on_coordinates(const VectorXd& u, const MatrixXd& forces,
                                      const Blocks& turn) const {
  using Matrix = typename G::Matrix;
  MatrixXd on_u = MatrixXd::Zero(forces.rows(), forces.cols());
  MatrixXd on_frame = MatrixXd::Zero(dim, forces.cols());
  for (int k = 0; k < this->nodes(); ++k) {
    const int at = dim * k;
    const Matrix half =
        Matrix::Identity() - 0.5 * G::ad(Tangent(u.template segment<dim>(at))).transpose();
    add_block_product(half, forces, at, on_u, at);
    if (!turn.empty()) add_block_product(Matrix(0.5 * turn[k]), Psi_, at, on_u, at);
    // I - ad = 2 (I - ad/2) - I
    const Matrix carry = A_[k].transpose();
    add_block_product(Matrix(carry * (2 * half - Matrix::Identity())), forces, at, on_frame, 0);
    if (!turn.empty()) add_block_product(Matrix(carry * turn[k]), Psi_, at, on_frame, 0);
  }
  MatrixXd out(dim + Psi_.cols(), forces.cols());
  out << on_frame, linalg::transposed_product(Psi_, on_u);
  return out;
}

/// Pi^T M Pi, velocities of all nodes = Pi [v_0; edot].
template <FrameGroup G>
MatrixXd ModalBody<G>::inertia_matrix(const Motion& m, int columns) const {
  using Matrix = typename G::Matrix;
  const VectorXd u = Psi_ * m.e;
  const MatrixXd Psi = Psi_.leftCols(columns - dim);
  MatrixXd Pi = MatrixXd::Zero(this->size(), columns);
  for (int k = 0; k < this->nodes(); ++k) {
    const int at = dim * k;
    const Matrix ad_u = G::ad(Tangent(u.template segment<dim>(at)));
    Pi.template block<dim, dim>(at, 0) = A_[k] - ad_u * A_[k];
    auto rates = Pi.rightCols(columns - dim);
    add_block_product(Matrix(Matrix::Identity() - 0.5 * ad_u), Psi, at, rates, at);
  }
  return on_coordinates(u, times(beam_->mass(), Pi));
}

/// By u: dv_k = ad(A_k v_0 + du_k/2), da_k = ad(A_k a_0 + ddu_k/2), and the arms turn.
template <FrameGroup G>
MatrixXd ModalBody<G>::inertia_by_e(const Motion& m, const Tangent& v_0, const Tangent& a_0) const {
  using Pair = typename Beam<G>::Pair;
  const int n = this->nodes();
  Field field;
  spread(m, field);
  VectorXd v(this->size()), a(this->size()), force = VectorXd::Zero(this->size());
  nodal_rates(field, v_0, a_0, v, a);
  Pair g;
  for (int e = 0; e < beam_->elements(); ++e) {
    beam_->element(e).inertia_force(this->reference[e], this->reference[e + 1], v.data() + dim * e,
                                    a.template segment<2 * dim>(dim * e), g);
    force.template segment<2 * dim>(dim * e) += g;
  }
  Blocks by_v(n), by_a(n), turn(n);
  for (int k = 0; k < n; ++k) {
    const int at = dim * k;
    const Tangent du = field.du.template segment<dim>(at),
                  ddu = field.ddu.template segment<dim>(at);
    by_v[k] = G::ad(Tangent(A_[k] * v_0 + 0.5 * du));
    by_a[k] = G::ad(Tangent(A_[k] * a_0 + 0.5 * ddu));
    for (int j = 0; j < dim; ++j)
      turn[k].col(j) = -(G::ad(Tangent::Unit(j)).transpose() * force.template segment<dim>(at));
  }
  return on_coordinates(field.u, times(force_tangent(v, by_v, by_a), Psi_), turn);
}

/// By du: dv_k = I - ad(u_k)/2, da_k = ad(A_k v_0); by v_0: dv_k = (I - ad(u_k)) A_k,
/// da_k = -ad(du_k) A_k.
template <FrameGroup G>
MatrixXd ModalBody<G>::inertia_by_rates(const Motion& m, const Tangent& v_0, const Tangent& a_0,
                                        int rates) const {
  using Matrix = typename G::Matrix;
  const int n = this->nodes();
  Field field;
  spread(m, field);
  VectorXd v(this->size()), a(this->size());
  nodal_rates(field, v_0, a_0, v, a);
  Blocks by_v(n), by_a(n), frame_v(n), frame_a(n);
  for (int k = 0; k < n; ++k) {
    const int at = dim * k;
    const Matrix ad_u = G::ad(Tangent(field.u.template segment<dim>(at)));
    by_v[k] = Matrix::Identity() - 0.5 * ad_u;
    by_a[k] = G::ad(Tangent(A_[k] * v_0));
    frame_v[k] = A_[k] - ad_u * A_[k];
    frame_a[k] = -G::ad(Tangent(field.du.template segment<dim>(at))) * A_[k];
  }
  const auto tangents = force_tangents<G>(*beam_, v, {{by_v, by_a}, {frame_v, frame_a}});
  const BlockTridiagonal<dim>& by_frame = tangents[1];
  MatrixXd forces = MatrixXd::Zero(this->size(), rates + dim);
  forces.leftCols(rates) = times(tangents[0], Psi_.leftCols(rates));
  for (int k = 0; k < n; ++k) {
    auto on_node = forces.template block<dim, dim>(dim * k, rates);
    on_node += by_frame.D[k];
    if (k > 0) on_node += by_frame.L[k - 1];
    if (k + 1 < n) on_node += by_frame.U[k];
  }
  return on_coordinates(field.u, forces);
}

template auto ModalBody<SE2>::force_tangent(const VectorXd&, const Blocks&, const Blocks&) const
    -> BlockTridiagonal<dim>;
template MatrixXd ModalBody<SE2>::on_coordinates(const VectorXd&, const MatrixXd&,
                                                 const Blocks&) const;
template MatrixXd ModalBody<SE2>::inertia_matrix(const Motion&, int) const;
template MatrixXd ModalBody<SE2>::inertia_by_e(const Motion&, const Tangent&, const Tangent&) const;
template MatrixXd ModalBody<SE2>::inertia_by_rates(const Motion&, const Tangent&, const Tangent&,
                                                   int) const;
template auto ModalBody<SE3>::force_tangent(const VectorXd&, const Blocks&, const Blocks&) const
    -> BlockTridiagonal<dim>;
template MatrixXd ModalBody<SE3>::on_coordinates(const VectorXd&, const MatrixXd&,
                                                 const Blocks&) const;
template MatrixXd ModalBody<SE3>::inertia_matrix(const Motion&, int) const;
template MatrixXd ModalBody<SE3>::inertia_by_e(const Motion&, const Tangent&, const Tangent&) const;
template MatrixXd ModalBody<SE3>::inertia_by_rates(const Motion&, const Tangent&, const Tangent&,
                                                   int) const;

}  // namespace liesl
