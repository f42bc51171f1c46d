#include "mbs/bodies/averaged_port.hpp"

#include "mbs/linalg/dense.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

}  // namespace

template <FrameGroup G>
AveragedPort<G>::AveragedPort(int port, std::vector<int> nodes, Points places, double stiffness,
                              double mass)
    : port_(port),
      nodes_(std::move(nodes)),
      places_(std::move(places)),
      stiffness_(stiffness),
      mass_(mass) {
  const MatrixXd rigid = rigid_motions(places_);
  Q_ = linalg::times_q(rigid, MatrixXd::Identity(rigid.rows(), dim));
  const Points about = places_.colwise() - places_.rowwise().mean().eval();
  inertia_ = mass_ * about.squaredNorm() / static_cast<double>(places_.cols());
}

template <FrameGroup G>
MatrixXd AveragedPort<G>::rigid_motions(const Points& places) {
  MatrixXd rigid(places.size(), dim);
  for (Eigen::Index i = 0; i < places.cols(); ++i) {
    rigid.block(sd * i, 0, sd, sd).setIdentity();
    rigid.block(sd * i, sd, sd, rd) = turn<G>(places.col(i));
  }
  return rigid;
}

template <FrameGroup G>
std::vector<int> AveragedPort<G>::unknowns() const {
  std::vector<int> out;
  for (int j = 0; j < dim; ++j) out.push_back(dim * port_ + j);
  for (const int k : nodes_)
    for (int j = 0; j < sd; ++j) out.push_back(dim * k + j);
  return out;
}

template <FrameGroup G>
auto AveragedPort<G>::local(const G* H) const -> Points {
  Points y(sd, places_.cols());
  const G& at = H[port_];
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    y.col(static_cast<Eigen::Index>(i)) = at.R.transpose() * (H[nodes_[i]].x - at.x);
  return y;
}

/// dy_i = R^T R_k dx_k - u - w x y_i.
template <FrameGroup G>
MatrixXd AveragedPort<G>::by_unknowns(const G* H, const Points& y) const {
  MatrixXd B = MatrixXd::Zero(y.size(), size());
  for (Eigen::Index i = 0; i < y.cols(); ++i) {
    B.block(sd * i, 0, sd, sd) = -MatrixXd::Identity(sd, sd);
    B.block(sd * i, sd, sd, rd) = -turn<G>(y.col(i));
    B.block(sd * i, dim + sd * i, sd, sd) =
        H[port_].R.transpose() * H[nodes_[static_cast<std::size_t>(i)]].R;
  }
  return B;
}

template <FrameGroup G>
VectorXd AveragedPort<G>::stress(const G* H, const double* delta) const {
  const Points y = local(H), off = y - places_;
  VectorXd moved = off.reshaped();
  if (delta) {
    const auto at = unknowns();
    VectorXd by(size());
    for (int i = 0; i < size(); ++i) by[i] = delta[at[static_cast<std::size_t>(i)]];
    moved += by_unknowns(H, y) * by;
  }
  return stiffness_ * (Q_.transpose() * moved);
}

template <FrameGroup G>
double AveragedPort<G>::elastic_energy(const G* H) const {
  const Points off = local(H) - places_;
  return 0.5 * stiffness_ * (Q_.transpose() * off.reshaped()).squaredNorm();
}

template <FrameGroup G>
double AveragedPort<G>::kinetic_energy(const double* v) const {
  const Eigen::Map<const Tangent> of(v + dim * port_);
  return 0.5 * (mass_ * of.template head<sd>().squaredNorm() +
                inertia_ * of.template tail<rd>().squaredNorm());
}

template <FrameGroup G>
void AveragedPort<G>::add_internal(const G* H, double weight, double* r, ForceScale* scale) const {
  const VectorXd spread = weight * (Q_ * stress(H)),
                 forces = by_unknowns(H, local(H)).transpose() * spread;
  const auto at = unknowns();
  for (int i = 0; i < size(); ++i) r[at[static_cast<std::size_t>(i)]] += forces[i];
  if (scale) scale->force += spread.squaredNorm();
}

template <FrameGroup G>
void AveragedPort<G>::add_weight(const G* H, const Vector& gravity, double factor,
                                 double* r) const {
  Eigen::Map<Vector>(r + dim * port_) -= factor * mass_ * (H[port_].R.transpose() * gravity);
}

/// d(R^T g) = -dtheta x R^T g.
template <FrameGroup G>
auto AveragedPort<G>::weight_stiffness(const G* H, const Vector& gravity) const ->
    typename G::Matrix {
  typename G::Matrix K = G::Matrix::Zero();
  K.template topRightCorner<sd, rd>() = mass_ * turn<G>(Vector(H[port_].R.transpose() * gravity));
  return K;
}

template <FrameGroup G>
void AveragedPort<G>::add_inertia(const BodyState<G>& s, const Vector& gravity, double* r) const {
  add_weight(s.H, gravity, 1, r);
  const Eigen::Map<const Tangent> v(s.v + dim * port_), a(s.vdot + dim * port_);
  Eigen::Map<Tangent> out(r + dim * port_);
  out.template head<sd>() +=
      mass_ * (a.template head<sd>() + turn<G>(v.template head<sd>()) * v.template tail<rd>());
  out.template tail<rd>() += inertia_ * a.template tail<rd>();
}

template <FrameGroup G>
void AveragedPort<G>::add_momentum(const double* v, double weight, double* out) const {
  const Eigen::Map<const Tangent> of(v + dim * port_);
  Eigen::Map<Tangent> to(out + dim * port_);
  to.template head<sd>() += weight * mass_ * of.template head<sd>();
  to.template tail<rd>() += weight * inertia_ * of.template tail<rd>();
}

/// B^T k Q Q^T B, and B^T f at constant f: nodes R_k^T R (w x f_i), the port -dy_i x f_i.
template <FrameGroup G>
MatrixXd AveragedPort<G>::stiffness_at(const G* H, const VectorXd& stress) const {
  const MatrixXd B = by_unknowns(H, local(H)), strain = linalg::transposed_product(Q_, B);
  MatrixXd K = stiffness_ * linalg::transposed_product(strain, strain);
  const VectorXd f = Q_ * stress;
  for (Eigen::Index i = 0; i < places_.cols(); ++i) {
    const auto turns = turn<G>(Eigen::Matrix<double, sd, 1>(f.segment(sd * i, sd)));
    const Eigen::Index node = dim + sd * i;
    const auto dy = B.middleRows(sd * i, sd);
    K.middleRows(sd, rd) += turns.transpose() * dy;
    K.block(node, sd, sd, rd) += dy.middleCols(node, sd).transpose() * turns;
  }
  return K;
}

/// d(w x u).
template <FrameGroup G>
MatrixXd AveragedPort<G>::damping_at(const double* v) const {
  const Eigen::Map<const Tangent> of(v + dim * port_);
  MatrixXd C = MatrixXd::Zero(size(), size());
  for (int j = 0; j < sd; ++j)
    C.block(0, j, sd, 1) =
        mass_ * turn<G>(Eigen::Matrix<double, sd, 1>::Unit(j)) * of.template tail<rd>();
  C.block(0, sd, sd, rd) = mass_ * turn<G>(of.template head<sd>());
  return C;
}

template <FrameGroup G>
MatrixXd AveragedPort<G>::mass() const {
  MatrixXd M = MatrixXd::Zero(size(), size());
  M.diagonal().head(sd).setConstant(mass_);
  M.diagonal().segment(sd, rd).setConstant(inertia_);
  return M;
}

template <FrameGroup G>
auto AveragedPort<G>::variation(
    const std::vector<std::pair<double, const AveragedPort*>>& nearby) const -> Variation {
  Variation by;
  by.places = Points::Zero(sd, places_.cols());
  for (const auto& [weight, port] : nearby) {
    by.places += weight * port->places_;
    by.stiffness += weight * port->stiffness_;
    by.mass += weight * port->mass_;
    by.inertia += weight * port->inertia_;
  }
  const MatrixXd rigid = rigid_motions(places_);
  by.motions = rigid_motions(by.places) - rigid_motions(Points::Zero(sd, places_.cols()));
  by.inverse = linalg::LDLT(linalg::transposed_product(rigid, rigid)).solve(rigid.transpose());
  return by;
}

/// f = k P (y - s), P = Q Q^T; on a node R_k^T R f_i, on the port -[sum f_i; sum y_i x f_i].
template <FrameGroup G>
void AveragedPort<G>::add_variation(const BodyState<G>& s, const StateDirection& d,
                                    const Vector& gravity, const Vector& dgravity,
                                    const Variation& by, double* r) const {
  using Vec = Vector;
  using Rotation = Eigen::Matrix<double, rd, 1>;
  const auto at = unknowns();
  VectorXd eta(size());
  for (int i = 0; i < size(); ++i) eta[i] = d.eta[at[static_cast<std::size_t>(i)]];
  const Points y = local(s.H);
  const VectorXd dy = by_unknowns(s.H, y) * eta, off = (y - places_).reshaped(),
                 doff = dy - by.places.reshaped();
  const auto kept = [this](const VectorXd& x) -> VectorXd { return Q_ * (Q_.transpose() * x); };
  const VectorXd in = kept(off), through = by.motions * (by.inverse * off);
  const VectorXd out_of = by.inverse.transpose() * (by.motions.transpose() * (off - in));
  const VectorXd f = stiffness_ * in,
                 df = by.stiffness * in +
                      stiffness_ * (kept(doff) + through - kept(through) + out_of);
  const Rotation turned = eta.segment(sd, rd);
  Eigen::Map<Tangent> port(r + dim * port_);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const auto k = sd * static_cast<Eigen::Index>(i);
    const Vec f_i = f.segment(k, sd), df_i = df.segment(k, sd), y_i = y.col(k / sd),
              dy_i = dy.segment(k, sd);
    port.template head<sd>() -= df_i;
    port.template tail<rd>() -= turn<G>(dy_i).transpose() * f_i + turn<G>(y_i).transpose() * df_i;
    Eigen::Map<Vec>(r + dim * nodes_[i]) +=
        s.H[nodes_[i]].R.transpose() * (s.H[port_].R * (df_i + turn<G>(f_i) * turned));
  }
  const Eigen::Map<const Tangent> v(s.v + dim * port_), a(s.vdot + dim * port_),
      dv(d.v + dim * port_), da(d.vdot + dim * port_);
  const auto u = [](const auto& of) -> Vec { return of.template head<sd>(); };
  const auto w = [](const auto& of) -> Rotation { return of.template tail<rd>(); };
  const Vec g = s.H[port_].R.transpose() * gravity;
  port.template head<sd>() +=
      mass_ * (turn<G>(g) * turned - s.H[port_].R.transpose() * dgravity) - by.mass * g;
  port.template head<sd>() += by.mass * (u(a) + turn<G>(u(v)) * w(v)) +
                              mass_ * (u(da) + turn<G>(u(dv)) * w(v) + turn<G>(u(v)) * w(dv));
  port.template tail<rd>() += by.inertia * w(a) + inertia_ * w(da);
}

template <FrameGroup G>
void AveragedPort<G>::scale(double stiffness, double mass) {
  stiffness_ *= stiffness;
  mass_ *= mass;
  inertia_ *= mass;
}

template class AveragedPort<SE2>;
template class AveragedPort<SE3>;

}  // namespace liesl
