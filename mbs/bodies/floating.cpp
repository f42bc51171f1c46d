#include "mbs/bodies/floating.hpp"

#include "mbs/linalg/dense.hpp"

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
  std::vector<int> nodes{0};
  nodes.insert(nodes.end(), interfaces_.begin(), interfaces_.end());
  nodes.insert(nodes.end(), slots_.begin(), slots_.end());
  for (auto* A : {&this->M_, &this->K_})
    A->set_dense(nodes, Eigen::MatrixXd::Zero(dim + n, dim + n));
}

template <FrameGroup G>
void FloatingBody<G>::set_up(Workspace& work) const {
  work.motion = at_reference();
  work.q.setZero(reduced_size());
}

template <FrameGroup G>
std::unique_ptr<BodyWorkspace> FloatingBody<G>::make_workspace() const {
  auto work = std::make_unique<Workspace>();
  set_up(*work);
  return work;
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
void FloatingBody<G>::become_derivative(const Eigen::MatrixXd& dK_e, bool massless) {
  K_e_.setZero();
  K_e_.topLeftCorner(dK_e.rows(), dK_e.cols()) = 0.5 * (dK_e + dK_e.transpose());
  massless_ = massless;
  elastic_ = !K_e_.isZero(0);
  unused_weight_ = 0;
}

/// E is the identity but for the rows of the interfaces.
template <FrameGroup G>
void FloatingBody<G>::add_frames(const Motion& m, const Eigen::MatrixXd& by_frames,
                                 Matrices& A) const {
  const int ni = interface_size();
  const Eigen::MatrixXd E = interface_increments(m);
  A.dense.leftCols(dim + ni) = by_frames + linalg::product(A.dense.middleCols(dim, ni), E);
  const Eigen::MatrixXd carried = linalg::transposed_product(E, A.dense.middleRows(dim, ni));
  A.dense.topRows(dim) += carried.topRows(dim);
  A.dense.middleRows(dim, ni) = carried.bottomRows(ni);
}

/// A = mass L^T M(e) L + stiffness E^T K_e E with [h_0; de] = L [h_0; h_i; deta], L = [I 0; E].
template <FrameGroup G>
void FloatingBody<G>::set_matrix(const Motion& m, double mass, double stiffness,
                                 Matrices& A) const {
  const int n = reduced_size();
  A.dense.setZero(dim + n, dim + n);
  A.dense.bottomRightCorner(n, n) = stiffness * K_e_;
  Eigen::MatrixXd by_frames = Eigen::MatrixXd::Zero(dim + n, dim + interface_size());
  if (mass > 0) {
    const Eigen::MatrixXd M = mass * inertia_matrix(m);
    A.dense.rightCols(n) += M.rightCols(n);
    by_frames.leftCols(dim) = M.leftCols(dim);
  }
  add_frames(m, by_frames, A);
  for (int j = dim + n - unused_; j < dim + n; ++j)
    A.dense(j, j) = unused_weight_ * (mass + stiffness);
}

template <FrameGroup G>
Eigen::MatrixXd FloatingBody<G>::interface_increments(const Motion& m) const {
  const int ni = interface_size();
  Eigen::MatrixXd E = Eigen::MatrixXd::Zero(ni, dim + ni);
  for (size_t i = 0; i < interfaces_.size(); ++i) {
    const int at = dim * static_cast<int>(i);
    const typename G::Matrix Ti = G::Tinv(Tangent(m.e.template segment<dim>(at)));
    E.template block<dim, dim>(at, dim + at) = Ti;
    E.template block<dim, dim>(at, 0) = -Ti * m.Y[i].AdInv();
  }
  return E;
}

template <FrameGroup G>
Eigen::MatrixXd FloatingBody<G>::increments(const Motion& m) const {
  const int n = reduced_size(), ni = interface_size();
  Eigen::MatrixXd E = Eigen::MatrixXd::Zero(n, dim + n);
  E.topLeftCorner(ni, dim + ni) = interface_increments(m);
  E.bottomRightCorner(n - ni, n - ni).setIdentity();
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
  if (!elastic_) return;
  in_workspace(s, [&](Workspace& work) {
    const double c = this->damping();
    Motion& m = work.motion;
    measure(s, c > 0, m);
    if (c > 0) m.e += c * m.rate;
    work.q.noalias() = K_e_ * m.e;
    if (c > 0) m.e -= c * m.rate;
    add_conjugate(m, work.q, r, scale);
  });
}

template <FrameGroup G>
void FloatingBody<G>::add_inertia(const BodyState<G>& s, const Vector& gravity, double* r,
                                  ForceScale& scale) const {
  if (massless_) return;
  in_workspace(s, [&](Workspace& work) {
    measure(s, true, work.motion);
    const Tangent v0 = Eigen::Map<const Tangent>(s.v);
    Tangent f0 = Tangent::Zero();
    work.q.setZero();
    inertia_force(work.motion, v0, apparent_acceleration<G>(s, 0, gravity), f0, work.q, scale,
                  work);
    Eigen::Map<Tangent>{r} += f0;
    add_conjugate(work.motion, work.q, r, scale);
  });
}

template class FloatingBody<SE2>;
template class FloatingBody<SE3>;

}  // namespace liesl
