#include "mbs/bodies/modal.hpp"

#include <stdexcept>

#include "mbs/linalg/constrained_modes.hpp"

namespace liesl {
namespace {

template <int N>
Eigen::MatrixXd dense(const BlockTridiagonal<N>& A) {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(A.size(), A.size());
  for (int k = 0; k < A.blocks(); ++k) {
    out.block<N, N>(N * k, N * k) = A.D[k];
    if (k + 1 == A.blocks()) break;
    out.block<N, N>(N * k, N * (k + 1)) = A.U[k];
    out.block<N, N>(N * (k + 1), N * k) = A.L[k];
  }
  return out;
}

Eigen::MatrixXd select(const Eigen::MatrixXd& A, const std::vector<int>& rows,
                       const std::vector<int>& columns) {
  return A(rows, columns);
}

}  // namespace

template <FrameGroup G>
ModalBody<G>::ModalBody(std::unique_ptr<Beam<G>> beam, const std::vector<int>& interfaces,
                        int modes)
    : Body<G>(beam->name, beam->reference), beam_(std::move(beam)) {
  kind_.assign(this->nodes(), NodeKind::Follower);
  kind_[0] = NodeKind::Frame;
  for (const int k : interfaces) kind_[k] = NodeKind::Frame;
  for (int k = 0; k < this->nodes(); ++k) {
    X_.push_back(this->reference[0].inverse() * this->reference[k]);
    A_.push_back(X_[k].AdInv());
    if (k > 0 && kind_[k] == NodeKind::Frame) interfaces_.push_back(k);
  }
  reduce(modes);
  const int n = static_cast<int>(Psi_.cols());
  for (auto* x : {&motion_.e, &motion_.rate, &motion_.acceleration, &q_}) x->setZero(n);
  for (auto* x : {&motion_.u, &motion_.du, &motion_.ddu, &full_, &vel_, &acc_})
    x->setZero(this->size());
  motion_.Y.resize(interfaces_.size(), G::identity());
}

/// Psi, K_e and the constant matrices of the unknowns [v_0; v_i; etadot].
template <FrameGroup G>
void ModalBody<G>::reduce(int modes) {
  std::vector<int> inner, held;  // degrees of freedom; node 0 is the frame
  for (int k = 1; k < this->nodes(); ++k)
    for (int i = 0; i < dim; ++i)
      (kind_[k] == NodeKind::Frame ? held : inner).push_back(dim * k + i);
  const Eigen::MatrixXd K = dense<dim>(beam_->stiffness()), M = dense<dim>(beam_->mass());
  const int ni = interface_size(), most = static_cast<int>(inner.size());
  const int kept = modes < 0 ? most : std::min(modes, most);
  const int slots = (kept + dim - 1) / dim;
  for (int k = 1; k < this->nodes() && static_cast<int>(slots_.size()) < slots; ++k)
    if (kind_[k] == NodeKind::Follower) {
      kind_[k] = NodeKind::Amplitudes;
      slots_.push_back(k);
    }
  const int n = ni + dim * slots;
  Psi_.setZero(this->size(), n);
  K_e_.setZero(n, n);
  for (int j = 0; j < ni; ++j) Psi_(held[j], j) = 1;
  if (most > 0) {
    const Eigen::MatrixXd K_II = select(K, inner, inner);
    if (ni > 0) {
      const Eigen::MatrixXd shapes = -K_II.ldlt().solve(select(K, inner, held));
      for (int i = 0; i < most; ++i) Psi_.row(inner[i]).head(ni) = shapes.row(i);
    }
    if (kept > 0) {
      const auto found =
          constrained_modes(K_II.sparseView(), select(M, inner, inner).sparseView(), kept);
      if (!found.converged) throw std::runtime_error("modes of '" + this->name + "' not found");
      omega2_ = found.lambda.head(kept);
      for (int i = 0; i < most; ++i) Psi_.row(inner[i]).segment(ni, kept) = found.phi.row(i);
    }
  }
  K_e_ = Psi_.transpose() * K * Psi_;
  const int unknown = dim + n;
  Pi_.setZero(this->size(), unknown);
  Pi_.rightCols(n) = Psi_;
  for (int k = 0; k < this->nodes(); ++k) Pi_.template block<dim, dim>(dim * k, 0) = A_[k];
  for (size_t i = 0; i < interfaces_.size(); ++i)
    Pi_.leftCols(dim) -= Psi_.middleCols(dim * static_cast<int>(i), dim) * A_[interfaces_[i]];
  Eigen::MatrixXd M_r = Pi_.transpose() * M * Pi_, K_r = Pi_.transpose() * K * Pi_;
  for (int j = dim + ni + kept; j < unknown; ++j) M_r(j, j) = K_r(j, j) = 1;  // unused amplitudes
  std::vector<int> nodes{0};
  nodes.insert(nodes.end(), interfaces_.begin(), interfaces_.end());
  nodes.insert(nodes.end(), slots_.begin(), slots_.end());
  this->M_.set_dense(nodes, std::move(M_r));
  this->K_.set_dense(std::move(nodes), std::move(K_r));
}

/// e and, from y = v_i - Ad(Y^-1) v_0:  edot = T^-1(u) y,
/// eddot = T^-1(u) (vdot_i - Ad(Y^-1) vdot_0 + ad(y) Ad(Y^-1) v_0) + D_u[T^-1(u) y] edot.
template <FrameGroup G>
void ModalBody<G>::measure(const BodyState<G>& s, bool rates, Motion& m) const {
  using Node = Eigen::Map<const Tangent>;
  const Tangent v0 = Node(s.v), a0 = Node(s.vdot);
  for (size_t i = 0; i < interfaces_.size(); ++i) {
    const int node = interfaces_[i], at = dim * static_cast<int>(i);
    m.Y[i] = s.H[0].inverse() * s.H[node];
    const Tangent u = G::log(X_[node].inverse() * m.Y[i]);
    m.e.template segment<dim>(at) = u;
    if (!rates) continue;
    const typename G::Matrix back = m.Y[i].AdInv(), Ti = G::Tinv(u);
    const Tangent carried = back * v0, y = Node(s.v + dim * node) - carried, rate = Ti * y;
    m.rate.template segment<dim>(at) = rate;
    m.acceleration.template segment<dim>(at) =
        Ti * (Node(s.vdot + dim * node) - back * a0 + G::ad(y) * carried) + G::dTinv(u, y) * rate;
  }
  for (size_t i = 0; i < slots_.size(); ++i) {
    const int at = interface_size() + dim * static_cast<int>(i), node = dim * slots_[i];
    m.e.template segment<dim>(at) = Node(s.w + node);
    if (!rates) continue;
    m.rate.template segment<dim>(at) = Node(s.v + node);
    m.acceleration.template segment<dim>(at) = Node(s.vdot + node);
  }
  if (!rates) return;
  m.u.noalias() = Psi_ * m.e;
  m.du.noalias() = Psi_ * m.rate;
  m.ddu.noalias() = Psi_ * m.acceleration;
}

template <FrameGroup G>
void ModalBody<G>::add_conjugate(const Motion& m, const Eigen::VectorXd& q, double* r,
                                 ForceScale& scale) const {
  using Node = Eigen::Map<Tangent>;
  for (size_t i = 0; i < interfaces_.size(); ++i) {
    const int at = dim * static_cast<int>(i);
    const Tangent u = m.e.template segment<dim>(at);
    const Tangent f = G::Tinv(u).transpose() * q.template segment<dim>(at);
    Node(r + dim * interfaces_[i]) += f;
    Node{r} -= m.Y[i].AdInv().transpose() * f;
    scale.add<G>(f);
  }
  for (size_t i = 0; i < slots_.size(); ++i)
    Node(r + dim * slots_[i]) +=
        q.template segment<dim>(interface_size() + dim * static_cast<int>(i));
}

template <FrameGroup G>
void ModalBody<G>::add_internal(const BodyState<G>& s, double* r, ForceScale& scale) const {
  const double c = damping();
  measure(s, c > 0, motion_);
  if (c > 0) motion_.e += c * motion_.rate;
  q_.noalias() = K_e_ * motion_.e;
  if (c > 0) motion_.e -= c * motion_.rate;
  add_conjugate(motion_, q_, r, scale);
}

template <FrameGroup G>
void ModalBody<G>::add_inertia(const BodyState<G>& s, const Vector& gravity, double* r,
                               ForceScale& scale) const {
  using Node = Eigen::Map<Tangent>;
  using Pair = typename Beam<G>::Pair;
  Motion& m = motion_;
  measure(s, true, m);
  const Tangent v0 = Eigen::Map<const Tangent>(s.v);
  const Tangent a0 = apparent_acceleration<G>(s, 0, gravity);
  for (int k = 0; k < this->nodes(); ++k) {
    const auto u = m.u.template segment<dim>(dim * k), du = m.du.template segment<dim>(dim * k);
    const Tangent carried = A_[k] * v0, a = A_[k] * a0;
    const auto ad_u = G::ad(Tangent(u));
    vel_.template segment<dim>(dim * k) = carried - ad_u * carried + du;
    acc_.template segment<dim>(dim * k) =
        a - ad_u * a - G::ad(Tangent(du)) * carried + m.ddu.template segment<dim>(dim * k);
  }
  full_.setZero();
  Pair g;
  for (int e = 0; e < beam_->elements(); ++e) {
    const Pair acceleration = acc_.template segment<2 * dim>(dim * e);
    beam_->element(e).inertia_force(this->reference[e], this->reference[e + 1],
                                    vel_.data() + dim * e, acceleration, g);
    full_.template segment<2 * dim>(dim * e) += g;
  }
  for (int k = 0; k < this->nodes(); ++k) {
    const Tangent f = full_.template segment<dim>(dim * k);
    const auto ad_u = G::ad(Tangent(m.u.template segment<dim>(dim * k)));
    Node{r} += A_[k].transpose() * (f - ad_u.transpose() * f);
    scale.add<G>(f);
  }
  q_.noalias() = Psi_.transpose() * full_;
  add_conjugate(m, q_, r, scale);
}

template <FrameGroup G>
void ModalBody<G>::exact_tangent(const BodyState<G>&, const Vector&, TangentWeights w,
                                 const Tangent*, Matrices& A) const {
  A.set_sum(w.mass, this->M_, 1 + damping() * w.damping, this->K_);
}

template <FrameGroup G>
void ModalBody<G>::complete(G* H, double* v, double* vdot, const double* w) const {
  using Node = Eigen::Map<Tangent>;
  Motion m = motion_;
  measure({H, v, vdot, w}, true, m);
  const Tangent v0 = Node(v), a0 = Node(vdot);
  for (int k = 1; k < this->nodes(); ++k) {
    if (kind_[k] == NodeKind::Frame) continue;
    const Tangent u = m.u.template segment<dim>(dim * k), du = m.du.template segment<dim>(dim * k);
    const Tangent carried = A_[k] * v0, a = A_[k] * a0;
    H[k] = H[0] * (X_[k] * G::exp(u));
    Node(v + dim * k) = carried - G::ad(u) * carried + du;
    Node(vdot + dim * k) =
        a - G::ad(u) * a - G::ad(du) * carried + m.ddu.template segment<dim>(dim * k);
  }
}

template <FrameGroup G>
Eigen::MatrixXd ModalBody<G>::load_share(bool follower) const {
  const int n = this->nodes();
  Eigen::MatrixXd local(dim * n, dim), shared = Eigen::MatrixXd::Zero(dim * n, dim);
  for (int k = 0; k < n; ++k) {
    auto turn = local.middleRows<dim>(dim * k);
    turn.setIdentity();
    if (follower) continue;
    turn.template topLeftCorner<G::space_dim, G::space_dim>() = X_[k].R.transpose();
    if constexpr (G::rotation_dim == 3)
      turn.template bottomRightCorner<3, 3>() = X_[k].R.transpose();
  }
  const Matrices W = beam_->load_distribution();
  for (int j = 0; j < dim; ++j) W.multiply_add(local.col(j).data(), shared.col(j).data());
  const Eigen::MatrixXd reduced = Pi_.transpose() * shared;
  Eigen::MatrixXd share = Eigen::MatrixXd::Zero(dim * n, dim);
  for (size_t i = 0; i < this->M_.nodes.size(); ++i)
    share.middleRows<dim>(dim * this->M_.nodes[i]) =
        reduced.middleRows<dim>(dim * static_cast<int>(i));
  return share;
}

template <FrameGroup G>
Eigen::VectorXd ModalBody<G>::displacements(const G* H) const {
  Eigen::VectorXd u(this->size());
  for (int k = 0; k < this->nodes(); ++k)
    u.template segment<dim>(dim * k) = G::log(X_[k].inverse() * (H[0].inverse() * H[k]));
  return u;
}

template <FrameGroup G>
auto ModalBody<G>::strain(const BodyState<G>& s, int e) const -> Tangent {
  typename Beam<G>::Pair u;
  for (int i = 0; i < 2; ++i)
    u.template segment<dim>(dim * i) =
        G::log(X_[e + i].inverse() * (s.H[0].inverse() * s.H[e + i]));
  const auto& element = beam_->element(e);
  return BeamElement<G>::P(element.d0()) * u / element.length();
}

template <FrameGroup G>
auto ModalBody<G>::section_force(const BodyState<G>& s, int e) const -> Tangent {
  return beam_->element(e).section_stiffness() * strain(s, e);
}

template <FrameGroup G>
BodyEnergy ModalBody<G>::energy(const BodyState<G>& s, const Vector& gravity) const {
  BodyEnergy energy = beam_->energy(s, gravity);
  energy.elastic = 0;
  for (int e = 0; e < elements(); ++e)
    energy.elastic += 0.5 * beam_->element(e).length() * strain(s, e).dot(section_force(s, e));
  return energy;
}

template class ModalBody<SE2>;
template class ModalBody<SE3>;

}  // namespace liesl
