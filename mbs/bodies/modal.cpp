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
  set_constant_matrices();
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
  unused_ = dim * slots - kept;
  std::vector<int> nodes{0};
  nodes.insert(nodes.end(), interfaces_.begin(), interfaces_.end());
  nodes.insert(nodes.end(), slots_.begin(), slots_.end());
  for (auto* A : {&this->M_, &this->K_})
    A->set_dense(nodes, Eigen::MatrixXd::Zero(dim + n, dim + n));
}

/// Zero displacement: Ad(Y^-1) = Ad(X^-1), T = I.
template <FrameGroup G>
void ModalBody<G>::set_constant_matrices() {
  for (size_t i = 0; i < interfaces_.size(); ++i) motion_.Y[i] = X_[interfaces_[i]];
  set_matrix(motion_, 1, 0, this->M_);
  set_matrix(motion_, 0, 1, this->K_);
}

/// A = mass Pi^T M Pi + stiffness E^T K_e E with all nodal increments = Pi [h_0; h_i; deta],
/// Pi = [(I - ad(u_k)) Ad(X_k^-1), 0] + Psi E.
template <FrameGroup G>
void ModalBody<G>::set_matrix(const Motion& m, double mass, double stiffness, Matrices& A) const {
  const Eigen::MatrixXd E = increments(m);
  A.dense.noalias() = stiffness * E.transpose() * K_e_ * E;
  if (mass > 0) {
    Eigen::MatrixXd Pi = Psi_ * E, MPi = Eigen::MatrixXd::Zero(Pi.rows(), Pi.cols());
    for (int k = 0; k < this->nodes(); ++k) {
      const auto ad_u = G::ad(Tangent(m.u.template segment<dim>(dim * k)));
      auto rows = Pi.template middleRows<dim>(dim * k);
      rows -= 0.5 * (ad_u * rows).eval();
      rows.template leftCols<dim>() += A_[k] - ad_u * A_[k];
    }
    for (int j = 0; j < Pi.cols(); ++j)
      beam_->mass().multiply_add(Pi.col(j).data(), MPi.col(j).data());
    A.dense.noalias() += mass * Pi.transpose() * MPi;
  }
  for (int j = static_cast<int>(E.cols()) - unused_; j < E.cols(); ++j)
    A.dense(j, j) = mass + stiffness;
}

template <FrameGroup G>
Eigen::MatrixXd ModalBody<G>::increments(const Motion& m) const {
  const int n = static_cast<int>(Psi_.cols()), ni = interface_size();
  Eigen::MatrixXd E = Eigen::MatrixXd::Zero(n, dim + n);
  E.bottomRightCorner(n - ni, n - ni).setIdentity();
  for (size_t i = 0; i < interfaces_.size(); ++i) {
    const int at = dim * static_cast<int>(i);
    const typename G::Matrix Ti = G::Tinv(Tangent(m.e.template segment<dim>(at)));
    E.template block<dim, dim>(at, dim + at) = Ti;
    E.template block<dim, dim>(at, 0) = -Ti * m.Y[i].AdInv();
  }
  return E;
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
  m.u.noalias() = Psi_ * m.e;
  if (!rates) return;
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
auto ModalBody<G>::velocity(const Motion& m, int k, const Tangent& v0) const -> Tangent {
  const Tangent u = m.u.template segment<dim>(dim * k), du = m.du.template segment<dim>(dim * k);
  const Tangent carried = A_[k] * v0;
  return carried + du - G::ad(u) * (carried + 0.5 * du);
}

template <FrameGroup G>
auto ModalBody<G>::acceleration(const Motion& m, int k, const Tangent& v0, const Tangent& a0) const
    -> Tangent {
  const Tangent u = m.u.template segment<dim>(dim * k), du = m.du.template segment<dim>(dim * k);
  const Tangent ddu = m.ddu.template segment<dim>(dim * k), a = A_[k] * a0;
  return a + ddu - G::ad(u) * (a + 0.5 * ddu) - G::ad(du) * (A_[k] * v0);
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
    vel_.template segment<dim>(dim * k) = velocity(m, k, v0);
    acc_.template segment<dim>(dim * k) = acceleration(m, k, v0, a0);
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
    const Tangent turned = ad_u.transpose() * f;
    Node{r} += A_[k].transpose() * (f - turned);
    full_.template segment<dim>(dim * k) -= 0.5 * turned;
    scale.add<G>(f);
  }
  q_.noalias() = Psi_.transpose() * full_;
  add_conjugate(m, q_, r, scale);
}

template <FrameGroup G>
void ModalBody<G>::exact_tangent(const BodyState<G>& s, const Vector&, TangentWeights w,
                                 const Tangent*, Matrices& A) const {
  Motion& m = motion_;
  measure(s, false, m);
  set_matrix(m, w.mass, 1 + damping() * w.damping, A);
}

template <FrameGroup G>
void ModalBody<G>::complete(G* H, double* v, double* vdot, const double* w) const {
  using Node = Eigen::Map<Tangent>;
  Motion m = motion_;
  measure({H, v, vdot, w}, true, m);
  const Tangent v0 = Node(v), a0 = Node(vdot);
  for (int k = 1; k < this->nodes(); ++k) {
    if (kind_[k] == NodeKind::Frame) continue;
    H[k] = H[0] * (X_[k] * G::exp(Tangent(m.u.template segment<dim>(dim * k))));
    Node(v + dim * k) = velocity(m, k, v0);
    Node(vdot + dim * k) = acceleration(m, k, v0, a0);
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
  Motion rest = motion_;
  rest.e.setZero();
  for (size_t i = 0; i < interfaces_.size(); ++i) rest.Y[i] = X_[interfaces_[i]];
  Eigen::MatrixXd Pi = Psi_ * increments(rest);
  for (int k = 0; k < n; ++k) Pi.template block<dim, dim>(dim * k, 0) += A_[k];
  const Eigen::MatrixXd reduced = Pi.transpose() * shared;
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
