/// @file
/// Derivatives of the inertia of beams in a floating frame. Nodes move with v = Pi [v_0; du],
///   v_k = (I - ad(u_k)) A_k v_0 + (I - ad(u_k)/2) Psi_k de, u = Psi e, A_k = Ad(X_k^-1),
/// forces on them reach [v_0; edot] by Pi^T; what lies between is block-tridiagonal, so that one
/// dense product with Pi^T is left. All but that is done transposed: blocks then act on whole
/// columns.

#include "mbs/bodies/modal.hpp"
#include "mbs/linalg/dense.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// (A X)^T from X^T
template <int N>
MatrixXd transposed_times(const BlockTridiagonal<N>& A, const MatrixXd& Xt) {
  MatrixXd Yt(Xt.rows(), Xt.cols());
  const int n = A.blocks();
  for (int k = 0; k < n; ++k) {
    const auto block = [&Xt](int j) { return Xt.template middleCols<N>(N * j); };
    auto y = Yt.template middleCols<N>(N * k);
    y.noalias() = block(k).lazyProduct(A.D[k].transpose());
    if (k > 0) y.noalias() += block(k - 1).lazyProduct(A.L[k - 1].transpose());
    if (k + 1 < n) y.noalias() += block(k + 1).lazyProduct(A.U[k].transpose());
  }
  return Yt;
}

/// What changes velocities and accelerations of each node, blocks of both.
template <FrameGroup G>
using Change =
    std::pair<const typename Body<G>::Matrices::Blocks&, const typename Body<G>::Matrices::Blocks&>;

/// Forces on the nodes by nodal numbers that change velocities and accelerations of each node by
/// these blocks, G(v) by_v + M by_a over the elements, for each of the changes.
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
MatrixXd ModalBody<G>::velocity_map(const VectorXd& u) const {
  MatrixXd Pi_t(dim + Psi_t_.rows(), this->size());
  for (int k = 0; k < this->nodes(); ++k) {
    const int at = dim * k;
    const typename G::Matrix turns = -G::ad(Tangent(u.template segment<dim>(at))).transpose();
    auto node = Pi_t.template middleCols<dim>(at);
    node.template topRows<dim>() = A_[k].transpose() + A_[k].transpose() * turns;
    const auto Psi_k = Psi_t_.template middleCols<dim>(at);
    node.bottomRows(Psi_t_.rows()).noalias() = Psi_k + 0.5 * Psi_k.lazyProduct(turns);
  }
  return Pi_t;
}

/// Pi^T M Pi
template <FrameGroup G>
MatrixXd ModalBody<G>::inertia_matrix(const Motion& m, int columns) const {
  const MatrixXd Pi_t = velocity_map(Psi_ * m.e);
  return linalg::product_transposed(Pi_t,
                                    transposed_times<dim>(beam_->mass(), Pi_t.topRows(columns)));
}

/// By u: dv_k = ad(A_k v_0 + du_k/2), da_k = ad(A_k a_0 + ddu_k/2), and forces f_k reach the frame
/// and e by other arms, A_k^T D_k and Psi_k^T D_k/2 with D_k = -D_u [ad(u_k)^T f_k].
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
  Blocks by_v(n), by_a(n);
  MatrixXd arms_t(dim + Psi_t_.rows(), this->size()), turned_t(Psi_t_.rows(), this->size());
  arms_t.bottomRows(Psi_t_.rows()) = 0.5 * Psi_t_;
  for (int k = 0; k < n; ++k) {
    const int at = dim * k;
    const Tangent du = field.du.template segment<dim>(at),
                  ddu = field.ddu.template segment<dim>(at), f = force.template segment<dim>(at);
    by_v[k] = G::ad(Tangent(A_[k] * v_0 + 0.5 * du));
    by_a[k] = G::ad(Tangent(A_[k] * a_0 + 0.5 * ddu));
    typename G::Matrix D;
    for (int j = 0; j < dim; ++j) D.col(j) = -(G::ad(Tangent::Unit(j)).transpose() * f);
    arms_t.template block<dim, dim>(0, at) = A_[k].transpose();
    turned_t.template middleCols<dim>(at).noalias() =
        Psi_t_.template middleCols<dim>(at).lazyProduct(D.transpose());
  }
  const auto tangents = force_tangents<G>(*beam_, v, {{by_v, by_a}});
  return linalg::product_transposed(velocity_map(field.u), transposed_times(tangents[0], Psi_t_)) +
         linalg::product_transposed(arms_t, turned_t);
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
  MatrixXd forces_t(rates + dim, this->size());
  forces_t.topRows(rates) = transposed_times<dim>(tangents[0], Psi_t_.topRows(rates));
  for (int k = 0; k < n; ++k) {
    Matrix on_node = by_frame.D[k];
    if (k > 0) on_node += by_frame.L[k - 1];
    if (k + 1 < n) on_node += by_frame.U[k];
    forces_t.template block<dim, dim>(rates, dim * k) = on_node.transpose();
  }
  return linalg::product_transposed(velocity_map(field.u), forces_t);
}

template MatrixXd ModalBody<SE2>::velocity_map(const VectorXd&) const;
template MatrixXd ModalBody<SE2>::inertia_matrix(const Motion&, int) const;
template MatrixXd ModalBody<SE2>::inertia_by_e(const Motion&, const Tangent&, const Tangent&) const;
template MatrixXd ModalBody<SE2>::inertia_by_rates(const Motion&, const Tangent&, const Tangent&,
                                                   int) const;
template MatrixXd ModalBody<SE3>::velocity_map(const VectorXd&) const;
template MatrixXd ModalBody<SE3>::inertia_matrix(const Motion&, int) const;
template MatrixXd ModalBody<SE3>::inertia_by_e(const Motion&, const Tangent&, const Tangent&) const;
template MatrixXd ModalBody<SE3>::inertia_by_rates(const Motion&, const Tangent&, const Tangent&,
                                                   int) const;

}  // namespace liesl
