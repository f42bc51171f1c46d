/// @file
/// Derivatives of the inertia of beams in a floating frame, all in one pass. Nodes move with
///   v_k = F_k v_0 + N_k du_k,  vdot_k = F_k a_0 + N_k ddu_k + F'_k v_0,  u = Psi e,
///   F_k = (I - ad(u_k)) A_k, N_k = I - ad(u_k)/2, F'_k = -ad(du_k) A_k, A_k = Ad(X_k^-1),
/// and forces on them reach v_0 and edot by F_k^T and Psi_k^T N_k^T. What lies between Psi^T and
/// Psi is block-tridiagonal, so that one dense product with Psi^T is left. All but that is done
/// transposed: blocks then act on whole columns.

#include "mbs/bodies/modal.hpp"
#include "mbs/linalg/dense.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

template <FrameGroup G>
using NodeBlocks = typename Body<G>::Matrices::Blocks;

/// Y^T = (A X)^T from X^T; the three blocks of a row of A at once.
template <int N>
void transposed_times(const BlockTridiagonal<N>& A, const MatrixXd& Xt, Eigen::Ref<MatrixXd> Yt) {
  const int n = A.blocks();
  Eigen::Matrix<double, 3 * N, N> row;
  for (int k = 0; k < n; ++k) {
    const auto block = [&Xt](int j) { return Xt.template middleCols<N>(N * j); };
    auto y = Yt.template middleCols<N>(N * k);
    if (k > 0 && k + 1 < n) {
      row << A.L[k - 1].transpose(), A.D[k].transpose(), A.U[k].transpose();
      y.noalias() = Xt.template middleCols<3 * N>(N * (k - 1)).lazyProduct(row);
      continue;
    }
    y.noalias() = block(k).lazyProduct(A.D[k].transpose());
    if (k > 0) y.noalias() += block(k - 1).lazyProduct(A.L[k - 1].transpose());
    if (k + 1 < n) y.noalias() += block(k + 1).lazyProduct(A.U[k].transpose());
  }
}

/// What v_k and vdot_k change by: with v_0, edot and u_k; with a_0 and eddot by `frame` and
/// `modes`.
template <FrameGroup G>
struct NodeMaps {
  NodeBlocks<G> frame, modes, bend;                 ///< v_k: F, N, ad(A v_0 + du/2)
  NodeBlocks<G> frame_turn, modes_turn, bend_turn;  ///< vdot_k: F', ad(A v_0), ad(A a_0 + ddu/2)
};

template <FrameGroup G>
NodeMaps<G> node_maps(const NodeBlocks<G>& A, const VectorXd& u, const VectorXd& du,
                      const VectorXd& ddu, const typename G::Tangent& v_0,
                      const typename G::Tangent& a_0) {
  using Tangent = typename G::Tangent;
  const NodeBlocks<G> none(A.size());
  NodeMaps<G> maps{none, none, none, none, none, none};
  for (std::size_t k = 0; k < A.size(); ++k) {
    const auto of = [&](const VectorXd& x) {
      return Tangent(x.template segment<G::dim>(G::dim * static_cast<Eigen::Index>(k)));
    };
    const typename G::Matrix ad_u = G::ad(of(u));
    const Tangent carried = A[k] * v_0;
    maps.frame[k] = A[k] - ad_u * A[k];
    maps.modes[k] = G::Matrix::Identity() - 0.5 * ad_u;
    maps.bend[k] = G::ad(Tangent(carried + 0.5 * of(du)));
    maps.frame_turn[k] = -G::ad(of(du)) * A[k];
    maps.modes_turn[k] = G::ad(carried);
    maps.bend_turn[k] = G::ad(Tangent(A[k] * a_0 + 0.5 * of(ddu)));
  }
  return maps;
}

/// Forces on the nodes, and by nodal numbers ddu, du and u, and by v_0 and a_0.
template <FrameGroup G>
struct NodeForces {
  VectorXd value;
  BlockTridiagonal<G::dim> by_ddu, by_du, by_u;
  MatrixXd by_frame_t;  ///< [by v_0, by a_0]^T
};

template <FrameGroup G>
NodeForces<G> node_forces(const Beam<G>& beam, const VectorXd& v, const VectorXd& a,
                          const NodeMaps<G>& maps) {
  constexpr int dim = G::dim;
  const BlockTridiagonal<dim> none(beam.nodes());
  NodeForces<G> out{VectorXd::Zero(beam.size()), none, none, none,
                    MatrixXd::Zero(2 * dim, beam.size())};
  typename Beam<G>::Pair g;
  Eigen::Matrix<double, 2 * dim, 2 * dim> by_ddu, by_du, by_u, by_frame;
  for (int e = 0; e < beam.elements(); ++e) {
    const auto& element = beam.element(e);
    const G &A = beam.reference[e], &B = beam.reference[e + 1];
    const int at = dim * e;
    element.inertia_force(A, B, v.data() + at, a.template segment<2 * dim>(at), g);
    out.value.template segment<2 * dim>(at) += g;
    const auto gyroscopic = element.gyroscopic_tangent(A, B, v.data() + at);
    by_frame.setZero();
    for (int i = 0; i < 2; ++i) {
      const int k = e + i;
      const auto C = gyroscopic.template middleCols<dim>(dim * i);
      const auto M = element.mass().template middleCols<dim>(dim * i);
      by_ddu.template middleCols<dim>(dim * i).noalias() = M.lazyProduct(maps.modes[k]);
      by_du.template middleCols<dim>(dim * i).noalias() =
          C.lazyProduct(maps.modes[k]) + M.lazyProduct(maps.modes_turn[k]);
      by_u.template middleCols<dim>(dim * i).noalias() =
          C.lazyProduct(maps.bend[k]) + M.lazyProduct(maps.bend_turn[k]);
      by_frame.template leftCols<dim>().noalias() +=
          C.lazyProduct(maps.frame[k]) + M.lazyProduct(maps.frame_turn[k]);
      by_frame.template rightCols<dim>().noalias() += M.lazyProduct(maps.frame[k]);
    }
    out.by_ddu.add_element(e, by_ddu);
    out.by_du.add_element(e, by_du);
    out.by_u.add_element(e, by_u);
    out.by_frame_t.template middleCols<2 * dim>(at) += by_frame.transpose();
  }
  return out;
}

/// f(block, node of its row, node of its column)
template <int N, class F>
void each_chain_block(BlockTridiagonal<N>& chain, F f) {
  for (int k = 0; k < chain.blocks(); ++k) {
    if (k > 0) f(chain.L[k - 1], k, k - 1);
    f(chain.D[k], k, k);
    if (k + 1 < chain.blocks()) f(chain.U[k], k, k + 1);
  }
}

/// Forces on the nodes become what Psi^T takes to e; what they are on the frame is added.
template <FrameGroup G>
void take_to_e(const NodeMaps<G>& maps, BlockTridiagonal<G::dim>& chain,
               Eigen::Ref<MatrixXd> on_frame) {
  constexpr int dim = G::dim;
  each_chain_block(chain, [&](typename G::Matrix& block, int row, int column) {
    on_frame.template middleCols<dim>(dim * column).noalias() +=
        maps.frame[row].transpose().lazyProduct(block);
    block = maps.modes[row].transpose().lazyProduct(block).eval();
  });
}

/// u_k turns the arms by which forces f_k reach e and the frame: A_k^T D_k and Psi_k^T D_k/2, D_k =
/// -D_u [ad(u_k)^T f_k].
template <FrameGroup G>
void add_arms(const NodeBlocks<G>& A, const VectorXd& force, BlockTridiagonal<G::dim>& chain,
              Eigen::Ref<MatrixXd> on_frame) {
  using Tangent = typename G::Tangent;
  constexpr int dim = G::dim;
  for (int k = 0; k < chain.blocks(); ++k) {
    const Tangent f = force.template segment<dim>(dim * k);
    typename G::Matrix D;
    for (int j = 0; j < dim; ++j) D.col(j) = -(G::ad(Tangent::Unit(j)).transpose() * f);
    chain.D[k] += 0.5 * D;
    on_frame.template middleCols<dim>(dim * k) += A[k].transpose() * D;
  }
}

}  // namespace

/// Pi^T, velocities of all nodes = Pi [v_0; edot].
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
MatrixXd ModalBody<G>::inertia_matrix(const Motion& m) const {
  const MatrixXd Pi_t = velocity_map(Psi_ * m.e);
  MatrixXd forces_t(Pi_t.rows(), Pi_t.cols());
  transposed_times<dim>(beam_->mass(), Pi_t, forces_t);
  return linalg::product_transposed(Pi_t, forces_t);
}

/// Psi^T times, side by side: forces by eddot, edot and e, by v_0, and the transposed of those on
/// the frame by eddot, edot and e. Forces on e by a_0 are the transposed of those on the frame by
/// eddot.
template <FrameGroup G>
auto ModalBody<G>::inertia_tangents(const Motion& m, const Tangent& v_0, const Tangent& a_0) const
    -> InertiaTangents {
  const auto n = Psi_t_.rows(), size = Psi_t_.cols(), frame = 3 * n;
  Field field;
  spread(m, field);
  VectorXd v(size), a(size);
  nodal_rates(field, v_0, a_0, v, a);
  const NodeMaps<G> maps = node_maps<G>(A_, field.u, field.du, field.ddu, v_0, a_0);
  NodeForces<G> forces = node_forces<G>(*beam_, v, a, maps);

  MatrixXd right(frame + 4 * dim, size);
  right.bottomRows(3 * dim).setZero();
  BlockTridiagonal<dim>* chains[] = {&forces.by_ddu, &forces.by_du, &forces.by_u};
  for (int i = 0; i < 3; ++i) {
    auto on_frame = right.template middleRows<dim>(frame + dim * (i + 1));
    take_to_e<G>(maps, *chains[i], on_frame);
    if (i == 2) add_arms<G>(A_, forces.value, *chains[i], on_frame);
    transposed_times<dim>(*chains[i], Psi_t_, right.middleRows(i * n, n));
  }
  MatrixXd frame_by_frame = MatrixXd::Zero(dim, 2 * dim);  // by v_0 and a_0
  VectorXd on_modes(size);  // forces on the nodes as Psi^T takes them
  for (int k = 0; k < this->nodes(); ++k) {
    const int at = dim * k;
    const auto on_node = forces.by_frame_t.template middleCols<dim>(at);
    right.template block<dim, dim>(frame, at).noalias() =
        on_node.template topRows<dim>().lazyProduct(maps.modes[k]);
    frame_by_frame.noalias() += maps.frame[k].transpose().lazyProduct(on_node.transpose());
    on_modes.template segment<dim>(at).noalias() =
        maps.modes[k].transpose() * forces.value.template segment<dim>(at);
  }
  const auto moving = size - dim;  // the first node does not move in its own frame
  const MatrixXd all =
      linalg::product_transposed(Psi_t_.rightCols(moving), right.rightCols(moving));
  const auto on_frame = [&](int i) { return all.middleCols(frame + dim * (i + 1), dim); };

  InertiaTangents out;
  out.q.noalias() = Psi_t_ * on_modes;
  out.by_e.resize(dim + n, n);
  out.by_e.topRows(dim) = on_frame(2).transpose();
  out.by_e.bottomRows(n) = all.middleCols(2 * n, n);
  out.by_rates.resize(dim + n, dim + n);
  out.by_rates.topLeftCorner(dim, dim) = frame_by_frame.leftCols(dim);
  out.by_rates.topRightCorner(dim, n) = on_frame(1).transpose();
  out.by_rates.bottomLeftCorner(n, dim) = all.middleCols(frame, dim);
  out.by_rates.bottomRightCorner(n, n) = all.middleCols(n, n);
  out.mass.resize(dim + n, dim + n);
  out.mass.topLeftCorner(dim, dim) = frame_by_frame.rightCols(dim);
  out.mass.topRightCorner(dim, n) = on_frame(0).transpose();
  out.mass.bottomLeftCorner(n, dim) = on_frame(0);
  out.mass.bottomRightCorner(n, n) = all.leftCols(n);
  return out;
}

template MatrixXd ModalBody<SE2>::velocity_map(const VectorXd&) const;
template MatrixXd ModalBody<SE3>::velocity_map(const VectorXd&) const;
template MatrixXd ModalBody<SE2>::inertia_matrix(const Motion&) const;
template MatrixXd ModalBody<SE3>::inertia_matrix(const Motion&) const;
template auto ModalBody<SE2>::inertia_tangents(const Motion&, const Tangent&, const Tangent&) const
    -> InertiaTangents;
template auto ModalBody<SE3>::inertia_tangents(const Motion&, const Tangent&, const Tangent&) const
    -> InertiaTangents;

}  // namespace liesl
