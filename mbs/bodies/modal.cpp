#include "mbs/bodies/modal.hpp"

#include <stdexcept>

#include "mbs/linalg/constrained_modes.hpp"
#include "mbs/linalg/dense.hpp"

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
    : FloatingBody<G>(beam->name, beam->reference), beam_(std::move(beam)) {
  std::vector<NodeKind> kind(this->nodes(), NodeKind::Follower);
  kind[0] = NodeKind::Frame;
  for (const int k : interfaces) kind[k] = NodeKind::Frame;
  for (const G& X : X_) A_.push_back(X.AdInv());
  reduce(std::move(kind), modes);
  this->set_constant_matrices();
}

template <FrameGroup G>
ModalBody<G>::ModalBody(const ModalBody& body, std::unique_ptr<Beam<G>> beam)
    : FloatingBody<G>(body),
      beam_(std::move(beam)),
      A_(body.A_),
      Psi_(body.Psi_),
      Psi_t_(body.Psi_t_) {
  bool massless = true;
  for (int e = 0; e < beam_->elements(); ++e)
    massless = massless && beam_->element(e).section_inertia().isZero(0);
  this->become_derivative(
      linalg::transposed_product(Psi_, linalg::product(dense<dim>(beam_->stiffness()), Psi_)),
      massless);
  this->set_constant_matrices();
}

template <FrameGroup G>
std::unique_ptr<Body<G>> ModalBody<G>::derivative(const LawDerivative<G>& law) const {
  std::unique_ptr<Body<G>> beam = beam_->derivative(law);
  return std::unique_ptr<Body<G>>(
      new ModalBody(*this, std::unique_ptr<Beam<G>>(static_cast<Beam<G>*>(beam.release()))));
}

/// Psi and K_e.
template <FrameGroup G>
void ModalBody<G>::reduce(std::vector<NodeKind> kind, int modes) {
  std::vector<int> inner, held;  // degrees of freedom; node 0 is the frame
  for (int k = 1; k < this->nodes(); ++k)
    for (int i = 0; i < dim; ++i)
      (kind[k] == NodeKind::Frame ? held : inner).push_back(dim * k + i);
  const Eigen::MatrixXd K = dense<dim>(beam_->stiffness()), M = dense<dim>(beam_->mass());
  const int ni = static_cast<int>(held.size()), most = static_cast<int>(inner.size());
  const int kept = modes < 0 ? most : std::min(modes, most);
  int slots = (kept + dim - 1) / dim;
  const int n = ni + dim * slots;
  for (int k = 1; k < this->nodes() && slots > 0; ++k)
    if (kind[k] == NodeKind::Follower) {
      kind[k] = NodeKind::Amplitudes;
      --slots;
    }
  Psi_.setZero(this->size(), n);
  Eigen::VectorXd omega2(0);
  for (int j = 0; j < ni; ++j) Psi_(held[j], j) = 1;
  if (most > 0) {
    const Eigen::MatrixXd K_II = select(K, inner, inner);
    if (ni > 0) {
      const Eigen::MatrixXd shapes = -linalg::LDLT(K_II).solve(select(K, inner, held));
      for (int i = 0; i < most; ++i) Psi_.row(inner[i]).head(ni) = shapes.row(i);
    }
    if (kept > 0) {
      const auto found =
          constrained_modes(K_II.sparseView(), select(M, inner, inner).sparseView(), kept);
      if (!found.converged) throw std::runtime_error("modes of '" + this->name + "' not found");
      omega2 = found.lambda.head(kept);
      for (int i = 0; i < most; ++i) Psi_.row(inner[i]).segment(ni, kept) = found.phi.row(i);
    }
  }
  Psi_t_ = Psi_.transpose();
  const Eigen::MatrixXd K_e = linalg::transposed_product(Psi_, linalg::product(K, Psi_));
  this->reduce_to(std::move(kind), K_e.topLeftCorner(ni + kept, ni + kept), std::move(omega2));
}

template <FrameGroup G>
std::unique_ptr<BodyWorkspace> ModalBody<G>::make_workspace() const {
  auto room = std::make_unique<Room>();
  this->set_up(*room);
  for (auto* x : {&room->field.u, &room->field.du, &room->field.ddu, &room->full, &room->velocity,
                  &room->acceleration})
    x->setZero(this->size());
  return room;
}

template <FrameGroup G>
void ModalBody<G>::spread(const Motion& m, Field& field) const {
  field.u.noalias() = Psi_ * m.e;
  field.du.noalias() = Psi_ * m.rate;
  field.ddu.noalias() = Psi_ * m.acceleration;
}

template <FrameGroup G>
auto ModalBody<G>::velocity(int k, const Field& field, const Tangent& v0) const -> Tangent {
  const Tangent u = field.u.template segment<dim>(dim * k),
                du = field.du.template segment<dim>(dim * k);
  const Tangent carried = A_[k] * v0;
  return carried + du - G::ad(u) * (carried + 0.5 * du);
}

template <FrameGroup G>
auto ModalBody<G>::acceleration(int k, const Field& field, const Tangent& v0,
                                const Tangent& a0) const -> Tangent {
  const Tangent u = field.u.template segment<dim>(dim * k),
                du = field.du.template segment<dim>(dim * k);
  const Tangent ddu = field.ddu.template segment<dim>(dim * k), a = A_[k] * a0;
  return a + ddu - G::ad(u) * (a + 0.5 * ddu) - G::ad(du) * (A_[k] * v0);
}

template <FrameGroup G>
void ModalBody<G>::nodal_rates(const Field& field, const Tangent& v0, const Tangent& a0,
                               Eigen::VectorXd& v, Eigen::VectorXd& a) const {
  for (int k = 0; k < this->nodes(); ++k) {
    v.template segment<dim>(dim * k) = velocity(k, field, v0);
    a.template segment<dim>(dim * k) = acceleration(k, field, v0, a0);
  }
}

template <FrameGroup G>
void ModalBody<G>::inertia_force(const Motion& m, const Tangent& v_0, const Tangent& a_0,
                                 Tangent& f_0, Eigen::VectorXd& q, ForceScale& scale,
                                 typename FloatingBody<G>::Workspace& work) const {
  using Pair = typename Beam<G>::Pair;
  Room& room = static_cast<Room&>(work);
  spread(m, room.field);
  nodal_rates(room.field, v_0, a_0, room.velocity, room.acceleration);
  room.full.setZero();
  Pair g;
  for (int e = 0; e < beam_->elements(); ++e) {
    const Pair accelerated = room.acceleration.template segment<2 * dim>(dim * e);
    beam_->element(e).inertia_force(this->reference[e], this->reference[e + 1],
                                    room.velocity.data() + dim * e, accelerated, g);
    room.full.template segment<2 * dim>(dim * e) += g;
  }
  for (int k = 0; k < this->nodes(); ++k) {
    const Tangent f = room.full.template segment<dim>(dim * k);
    const auto ad_u = G::ad(Tangent(room.field.u.template segment<dim>(dim * k)));
    const Tangent turned = ad_u.transpose() * f;
    f_0 += A_[k].transpose() * (f - turned);
    room.full.template segment<dim>(dim * k) -= 0.5 * turned;
    scale.add<G>(f);
  }
  q.noalias() += Psi_.transpose() * room.full;
}

template <FrameGroup G>
void ModalBody<G>::complete(G* H, double* v, double* vdot, const double* w) const {
  using Node = Eigen::Map<Tangent>;
  Motion m = this->at_reference();
  this->measure({H, v, vdot, w}, true, m);
  Field field;
  spread(m, field);
  const Tangent v0 = Node(v), a0 = Node(vdot);
  for (int k = 1; k < this->nodes(); ++k) {
    if (this->kind(k) == NodeKind::Frame) continue;
    H[k] = H[0] * (X_[k] * G::exp(Tangent(field.u.template segment<dim>(dim * k))));
    Node(v + dim * k) = velocity(k, field, v0);
    Node(vdot + dim * k) = acceleration(k, field, v0, a0);
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
  Eigen::MatrixXd Pi = linalg::product(Psi_, this->increments(this->at_reference()));
  for (int k = 0; k < n; ++k) Pi.template block<dim, dim>(dim * k, 0) += A_[k];
  const Eigen::MatrixXd reduced = linalg::transposed_product(Pi, shared);
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
void ModalBody<G>::add_elastic_force(const G* H, double* f) const {
  beam_->stiffness().multiply_add(displacements(H).data(), f);
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
auto ModalBody<G>::section_force(const BodyState<G>& s, int e, ElementPlace at) const -> Tangent {
  const auto& element = beam_->element(e);
  const Tangent n = element.section_stiffness() * strain(s, e);
  if (at == ElementPlace::Middle) return n;
  const auto P = BeamElement<G>::P(element.d0());
  if (at == ElementPlace::First) return -P.template leftCols<dim>().transpose() * n;
  return P.template rightCols<dim>().transpose() * n;
}

/// u_k = log(X_k^-1 H_0^-1 H_k): du = T^-1(u) (h_k - Ad((H_0^-1 H_k)^-1) h_0).
template <FrameGroup G>
void ModalBody<G>::add_section_force_gradient(const BodyState<G>& s, int e, ElementPlace at,
                                              const Tangent& f, double* h) const {
  using Node = Eigen::Map<Tangent>;
  const auto& element = beam_->element(e);
  const auto P = BeamElement<G>::P(element.d0());
  Tangent on_n = f;
  if (at == ElementPlace::First) on_n = -(P.template leftCols<dim>() * f);
  if (at == ElementPlace::Last) on_n = P.template rightCols<dim>() * f;
  const typename Beam<G>::Pair on_u =
      P.transpose() * (element.section_stiffness().transpose() * on_n) / element.length();
  for (int i = 0; i < 2; ++i) {
    const int k = e + i;
    const G Y = s.H[0].inverse() * s.H[k];
    const Tangent on_node =
        G::Tinv(G::log(X_[k].inverse() * Y)).transpose() * on_u.template segment<dim>(dim * i);
    Node(h + dim * k) += on_node;
    Node{h} -= Y.AdInv().transpose() * on_node;
  }
}

/// That of the nodes of the beam, and of the linear strains.
template <FrameGroup G>
void ModalBody<G>::add_energy_gradient(const BodyState<G>& s, const Vector& gravity,
                                       const BodyEnergy& weight, double* h, double* v) const {
  const int n = this->nodes(), size = this->size();
  std::vector<G, Eigen::aligned_allocator<G>> H(s.H, s.H + n);
  Eigen::VectorXd all_v = Eigen::Map<const Eigen::VectorXd>(s.v, size), rates = all_v;
  complete(H.data(), all_v.data(), rates.data(), s.w);
  const BodyState<G> completed{H.data(), all_v.data(), rates.data(), s.w};
  Eigen::VectorXd on_h = Eigen::VectorXd::Zero(size), on_v = on_h;
  beam_->add_energy_gradient(completed, gravity, {weight.kinetic, 0, weight.potential}, on_h.data(),
                             on_v.data());
  for (int e = 0; e < elements(); ++e)
    add_section_force_gradient(completed, e, ElementPlace::Middle,
                               weight.elastic * beam_->element(e).length() * strain(completed, e),
                               on_h.data());
  to_unknowns(s, on_h.data(), on_v.data());
  Eigen::Map<Eigen::VectorXd>(h, size) += on_h;
  Eigen::Map<Eigen::VectorXd>(v, size) += on_v;
}

/// H_k = H_0 X_k exp(u): h_k = Ad(exp(-u) X_k^-1) h_0 + T(u) du; v_k as in `velocity`, u = Psi_k e.
template <FrameGroup G>
void ModalBody<G>::to_unknowns(const BodyState<G>& s, double* h, double* v) const {
  using Node = Eigen::Map<Tangent>;
  Motion m = this->at_reference();
  this->measure(s, true, m);
  Field field;
  spread(m, field);
  const Tangent v_0 = Eigen::Map<const Tangent>(s.v);
  Eigen::VectorXd c_e = Eigen::VectorXd::Zero(Psi_.cols()), c_rate = c_e;
  for (int k = 1; k < this->nodes(); ++k) {
    if (this->kind(k) == NodeKind::Frame) continue;
    const Tangent f = Node(h + dim * k), p = Node(v + dim * k);
    Node(h + dim * k).setZero();
    Node(v + dim * k).setZero();
    const Tangent u = field.u.template segment<dim>(dim * k),
                  du = field.du.template segment<dim>(dim * k);
    const auto ad_u = G::ad(u);
    const Tangent carried = A_[k] * v_0, turned = ad_u.transpose() * p;
    Node{h} += (X_[k] * G::exp(u)).AdInv().transpose() * f;
    Node{v} += A_[k].transpose() * (p - turned);
    const Tangent on_u =
        G::T(u).transpose() * f + G::ad(Tangent(carried + 0.5 * du)).transpose() * p;
    const auto psi = Psi_.template middleRows<dim>(dim * k);
    c_e += psi.transpose() * on_u;
    c_rate += psi.transpose() * (p - 0.5 * turned);
  }
  this->add_unknowns(m, s, c_e, c_rate, h, v);
}

/// vdot_k as in `acceleration`; its share of du is -ad(du) c = ad(c) du.
template <FrameGroup G>
void ModalBody<G>::rates_to_unknowns(const BodyState<G>& s, double* h, double* v,
                                     double* vdot) const {
  using Node = Eigen::Map<Tangent>;
  Motion m = this->at_reference();
  this->measure(s, true, m);
  Field field;
  spread(m, field);
  const Tangent v_0 = Eigen::Map<const Tangent>(s.v), a_0 = Eigen::Map<const Tangent>(s.vdot);
  Eigen::VectorXd c_e = Eigen::VectorXd::Zero(Psi_.cols()), c_rate = c_e, c_acceleration = c_e;
  for (int k = 1; k < this->nodes(); ++k) {
    const Tangent p = Node(vdot + dim * k);
    if (this->kind(k) == NodeKind::Frame || p.isZero(0)) continue;
    Node(vdot + dim * k).setZero();
    const Tangent u = field.u.template segment<dim>(dim * k),
                  du = field.du.template segment<dim>(dim * k),
                  ddu = field.ddu.template segment<dim>(dim * k), c = A_[k] * v_0,
                  arm = A_[k] * a_0 + 0.5 * ddu, turned = G::ad(u).transpose() * p;
    Node{vdot} += A_[k].transpose() * (p - turned);
    Node{v} -= A_[k].transpose() * (G::ad(du).transpose() * p);
    const auto psi = Psi_.template middleRows<dim>(dim * k);
    c_e += psi.transpose() * (G::ad(arm).transpose() * p);
    c_rate += psi.transpose() * (G::ad(c).transpose() * p);
    c_acceleration += psi.transpose() * (p - 0.5 * turned);
  }
  if (c_e.isZero(0) && c_rate.isZero(0) && c_acceleration.isZero(0)) return;
  this->add_unknowns(m, s, c_e, c_rate, h, v);
  this->add_unknowns_of_acceleration(m, s, c_acceleration, h, v, vdot);
}

template <FrameGroup G>
BodyEnergy ModalBody<G>::energy(const BodyState<G>& s, const Vector& gravity) const {
  BodyEnergy energy = beam_->energy(s, gravity);
  energy.elastic = 0;
  for (int e = 0; e < elements(); ++e)
    energy.elastic += 0.5 * beam_->element(e).length() *
                      strain(s, e).dot(section_force(s, e, ElementPlace::Middle));
  return energy;
}

/// As of the beam, with du_k/dt = T^-1(u_k) (v_k - Ad(Y_k^-1) v_0), Y_k = H_0^-1 H_k.
template <FrameGroup G>
double ModalBody<G>::dissipation(const BodyState<G>& s) const {
  using Node = Eigen::Map<const Tangent>;
  double power = 0;
  for (int e = 0; e < elements() && damping() > 0; ++e) {
    typename Beam<G>::Pair du;
    for (int i = 0; i < 2; ++i) {
      const int k = e + i;
      const G Y = s.H[0].inverse() * s.H[k];
      du.template segment<dim>(dim * i) =
          G::Tinv(G::log(X_[k].inverse() * Y)) * (Node(s.v + dim * k) - Y.AdInv() * Node(s.v));
    }
    const auto& element = beam_->element(e);
    const Tangent rate = BeamElement<G>::P(element.d0()) * du;
    power += damping() / element.length() * rate.dot(element.section_stiffness() * rate);
  }
  return power;
}

template class ModalBody<SE2>;
template class ModalBody<SE3>;

}  // namespace liesl
