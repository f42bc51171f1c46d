#include "mbs/bodies/floating.hpp"

namespace liesl {

template <FrameGroup G>
FloatingBody<G>::FloatingBody(std::string body_name, std::vector<G> nodes_at_rest)
    : Body<G>(std::move(body_name), std::move(nodes_at_rest)) {
  for (const G& H : this->reference) X_.push_back(this->reference[0].inverse() * H);
}

template <FrameGroup G>
void FloatingBody<G>::reduce_to(std::vector<NodeKind> kind, const Eigen::MatrixXd& K_e,
                                Eigen::VectorXd omega2) {
  kind_ = std::move(kind);
  omega2_ = std::move(omega2);
  for (int k = 1; k < this->nodes(); ++k) {
    if (kind_[k] == NodeKind::Frame) interfaces_.push_back(k);
    if (kind_[k] == NodeKind::Amplitudes) slots_.push_back(k);
  }
  const int n = interface_size() + dim * static_cast<int>(slots_.size());
  unused_ = n - static_cast<int>(K_e.cols());
  K_e_ = Eigen::MatrixXd::Zero(n, n);
  K_e_.topLeftCorner(K_e.rows(), K_e.cols()) = K_e;
  q_.setZero(n);
  motion_ = at_reference();
  std::vector<int> nodes{0};
  nodes.insert(nodes.end(), interfaces_.begin(), interfaces_.end());
  nodes.insert(nodes.end(), slots_.begin(), slots_.end());
  for (auto* A : {&this->M_, &this->K_})
    A->set_dense(nodes, Eigen::MatrixXd::Zero(dim + n, dim + n));
}

template <FrameGroup G>
auto FloatingBody<G>::at_reference() const -> Motion {
  Motion m;
  for (auto* x : {&m.e, &m.rate, &m.acceleration}) x->setZero(reduced_size());
  for (const int k : interfaces_) m.Y.push_back(X_[k]);
  return m;
}

template <FrameGroup G>
void FloatingBody<G>::set_constant_matrices() {
  const Motion rest = at_reference();
  set_matrix(rest, 1, 0, this->M_);
  set_matrix(rest, 0, 1, this->K_);
}

template <FrameGroup G>
void FloatingBody<G>::become_derivative(const Eigen::MatrixXd& dK_e) {
  K_e_.setZero();
  K_e_.topLeftCorner(dK_e.rows(), dK_e.cols()) = 0.5 * (dK_e + dK_e.transpose());
  unused_weight_ = 0;
}

/// A = mass L^T M(e) L + stiffness E^T K_e E with [h_0; de] = L [h_0; h_i; deta], L = [I 0; E].
template <FrameGroup G>
void FloatingBody<G>::set_matrix(const Motion& m, double mass, double stiffness,
                                 Matrices& A) const {
  const Eigen::MatrixXd E = increments(m);
  A.dense.noalias() = stiffness * E.transpose() * K_e_ * E;
  if (mass > 0) {
    Eigen::MatrixXd L(dim + E.rows(), E.cols());
    L.topRows(dim).setIdentity();
    L.bottomRows(E.rows()) = E;
    A.dense.noalias() += mass * L.transpose() * inertia_matrix(m) * L;
  }
  for (int j = static_cast<int>(E.cols()) - unused_; j < E.cols(); ++j)
    A.dense(j, j) = unused_weight_ * (mass + stiffness);
}

template <FrameGroup G>
Eigen::MatrixXd FloatingBody<G>::increments(const Motion& m) const {
  const int n = reduced_size(), ni = interface_size();
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
void FloatingBody<G>::measure(const BodyState<G>& s, bool rates, Motion& m) const {
  using Node = Eigen::Map<const Tangent>;
  Tangent v0 = Tangent::Zero(), a0 = v0;
  if (rates) {
    v0 = Node(s.v);
    a0 = Node(s.vdot);
  }
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
}

template <FrameGroup G>
void FloatingBody<G>::add_conjugate(const Motion& m, const Eigen::VectorXd& q, double* r,
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

/// With z = h_i - Ad(Y^-1) h_0 and c = Ad(Y^-1) v_0: du = T^-1(u) z, and
/// d(udot) = T^-1(u) (dv_i - Ad(Y^-1) dv_0) + (D_u[T^-1(u) y] T^-1(u) - T^-1(u) ad(c)) z.
template <FrameGroup G>
void FloatingBody<G>::add_unknowns(const Motion& m, const BodyState<G>& s,
                                   const Eigen::VectorXd& c_e, const Eigen::VectorXd& c_rate,
                                   double* h, double* v) const {
  using Node = Eigen::Map<Tangent>;
  for (size_t i = 0; i < interfaces_.size(); ++i) {
    const int node = dim * interfaces_[i], at = dim * static_cast<int>(i);
    const Tangent u = m.e.template segment<dim>(at), q = c_e.template segment<dim>(at),
                  p = c_rate.template segment<dim>(at);
    const typename G::Matrix Ti = G::Tinv(u), back = m.Y[i].AdInv();
    const Tangent c = back * Eigen::Map<const Tangent>(s.v),
                  y = Eigen::Map<const Tangent>(s.v + node) - c;
    const typename G::Matrix turns = G::dTinv(u, y) * Ti - Ti * G::ad(c);
    const Tangent on_z = Ti.transpose() * q + turns.transpose() * p, on_v = Ti.transpose() * p;
    Node(h + node) += on_z;
    Node{h} -= back.transpose() * on_z;
    Node(v + node) += on_v;
    Node{v} -= back.transpose() * on_v;
  }
  for (size_t i = 0; i < slots_.size(); ++i) {
    const int at = interface_size() + dim * static_cast<int>(i), node = dim * slots_[i];
    Node(h + node) += c_e.template segment<dim>(at);
    Node(v + node) += c_rate.template segment<dim>(at);
  }
}

template <FrameGroup G>
void FloatingBody<G>::add_internal(const BodyState<G>& s, double* r, ForceScale& scale) const {
  const double c = this->damping();
  measure(s, c > 0, motion_);
  if (c > 0) motion_.e += c * motion_.rate;
  q_.noalias() = K_e_ * motion_.e;
  if (c > 0) motion_.e -= c * motion_.rate;
  add_conjugate(motion_, q_, r, scale);
}

template <FrameGroup G>
void FloatingBody<G>::add_inertia(const BodyState<G>& s, const Vector& gravity, double* r,
                                  ForceScale& scale) const {
  measure(s, true, motion_);
  const Tangent v0 = Eigen::Map<const Tangent>(s.v);
  Tangent f0 = Tangent::Zero();
  q_.setZero();
  inertia_force(motion_, v0, apparent_acceleration<G>(s, 0, gravity), f0, q_, scale);
  Eigen::Map<Tangent>{r} += f0;
  add_conjugate(motion_, q_, r, scale);
}

/// At rest the inertia force is M(e) [a; 0] with a = -R_0^T gravity: a turns with H_0, the centre
/// of mass moves with e. Of f = T^-T(u) q on node i and -Ad(Y^-1)^T f on the frame, with y = h_i -
/// Ad(Y^-1) h_0: df = D_u[T^-T(u) q] T^-1(u) y, d(Ad(Y^-1)^T f) = -Ad(Y^-1)^T ad(y)^T f.
template <FrameGroup G>
void FloatingBody<G>::add_turning(const Motion& m, const G& H_0, const Vector& gravity,
                                  Matrices& A) const {
  constexpr int sd = G::space_dim;
  const int n = reduced_size();
  const Eigen::MatrixXd M = inertia_matrix(m), E = increments(m);
  Tangent a = Tangent::Zero();
  a.template head<sd>() = -H_0.R.transpose() * gravity;
  const Eigen::MatrixXd falls = M.leftCols(dim) * weight_tangent<G>(H_0, gravity);
  A.dense.topLeftCorner(dim, dim) += falls.topRows(dim);
  A.dense.leftCols(dim) += E.transpose() * falls.bottomRows(n);
  // The moment S x a = -ad(a)^T [m a; ...] of a mass that moves: dS = N de.
  const Eigen::MatrixXd N = M.block(0, dim, sd, n) * E;
  Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(dim, N.cols());
  moved.topRows(sd) = N;
  for (Eigen::Index k = 0; k < N.cols(); ++k)
    A.dense.col(k).template segment<G::rotation_dim>(sd) -=
        (G::ad(Tangent(moved.col(k))).transpose() * a).template tail<G::rotation_dim>();
  const Eigen::VectorXd q = K_e_ * m.e + M.bottomLeftCorner(n, dim) * a;
  for (size_t i = 0; i < interfaces_.size(); ++i) {
    const int at = dim * static_cast<int>(i);
    const Tangent u = m.e.template segment<dim>(at), q_i = q.template segment<dim>(at);
    const typename G::Matrix Ti = G::Tinv(u), back = m.Y[i].AdInv();
    const typename G::Matrix bends = G::dTinvT(u, q_i) * Ti;  // df = bends y
    const Tangent f = Ti.transpose() * q_i;
    typename G::Matrix turns = -bends;  // d(force on the frame) = Ad(Y^-1)^T turns y
    for (int j = 0; j < dim; ++j) turns.col(j) += G::ad(Tangent::Unit(j)).transpose() * f;
    const typename G::Matrix on_frame = back.transpose() * turns;
    A.dense.template block<dim, dim>(dim + at, dim + at) += bends;
    A.dense.template block<dim, dim>(dim + at, 0) -= bends * back;
    A.dense.template block<dim, dim>(0, dim + at) += on_frame;
    A.dense.template block<dim, dim>(0, 0) -= on_frame * back;
  }
}

template <FrameGroup G>
void FloatingBody<G>::exact_tangent(const BodyState<G>& s, const Vector& gravity, TangentWeights w,
                                    const Tangent*, Matrices& A) const {
  measure(s, false, motion_);
  set_matrix(motion_, w.mass, 1 + this->damping() * w.damping, A);
  if (w.mass == 0) add_turning(motion_, s.H[0], gravity, A);
}

template class FloatingBody<SE2>;
template class FloatingBody<SE3>;

}  // namespace liesl
