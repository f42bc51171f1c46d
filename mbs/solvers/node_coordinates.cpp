#include "mbs/solvers/node_coordinates.hpp"

#include <cmath>

#include "mbs/system/retract.hpp"

namespace liesl {
namespace {

bool uses_local(NodeUpdate update) { return update == NodeUpdate::Screw; }

}  // namespace

template <FrameGroup G>
NodeCoordinates<G>::NodeCoordinates(const Model<G>& model, bool rescale)
    : model_(model), rescale_(rescale) {}

template <FrameGroup G>
void NodeCoordinates<G>::start(State<G>& s) const {
  if (model_.update != NodeUpdate::RotationVector) return;
  for (const int k : model_.frames()) s.w.template segment<rd>(dim * k + sd) = Rot::log(s.H[k].R);
}

template <FrameGroup G>
void NodeCoordinates<G>::rates(const State<G>& s, Eigen::VectorXd& u, Eigen::VectorXd& udot) const {
  u = s.v;
  udot = s.vdot;
  if (uses_local(model_.update)) return;
  for (const int k : model_.frames()) {
    const auto v = s.v.template segment<sd>(dim * k);
    const Angular w = s.v.template segment<rd>(dim * k + sd);
    u.template segment<sd>(dim * k) = s.H[k].R * v;
    udot.template segment<sd>(dim * k) =
        s.H[k].R * (s.vdot.template segment<sd>(dim * k) - Rot::cross(v) * w);
    if (model_.update != NodeUpdate::RotationVector) continue;
    const Angular p = psi(s, k);
    const auto Tinv = Rot::Tinv(p);
    const Angular rate = Tinv * w;
    u.template segment<rd>(dim * k + sd) = rate;
    udot.template segment<rd>(dim * k + sd) =
        Tinv * (s.vdot.template segment<rd>(dim * k + sd) - Rot::dT(p, rate) * rate);
  }
}

template <FrameGroup G>
void NodeCoordinates<G>::local_rates(const Eigen::VectorXd& u, const Eigen::VectorXd& udot,
                                     State<G>& s) const {
  s.v = u;
  s.vdot = udot;
  if (uses_local(model_.update)) return;
  for (const int k : model_.frames()) {
    if (model_.update == NodeUpdate::RotationVector) {
      const Angular p = psi(s, k), rate = u.template segment<rd>(dim * k + sd);
      const auto T = Rot::T(p);
      s.v.template segment<rd>(dim * k + sd) = T * rate;
      s.vdot.template segment<rd>(dim * k + sd) =
          T * udot.template segment<rd>(dim * k + sd) + Rot::dT(p, rate) * rate;
    }
    const Angular w = s.v.template segment<rd>(dim * k + sd);
    const Eigen::Matrix<double, sd, 1> v = s.H[k].R.transpose() * u.template segment<sd>(dim * k);
    s.v.template segment<sd>(dim * k) = v;
    s.vdot.template segment<sd>(dim * k) =
        s.H[k].R.transpose() * udot.template segment<sd>(dim * k) + Rot::cross(v) * w;
  }
}

template <FrameGroup G>
void NodeCoordinates<G>::place(const State<G>& old, const Eigen::VectorXd& dq,
                               const Eigen::VectorXd& u, const Eigen::VectorXd& udot,
                               State<G>& s) const {
  retract(old, dq, model_.update, {model_.frames(), model_.positions(), model_.amplitudes()}, s);
  local_rates(u, udot, s);
}

template <FrameGroup G>
void NodeCoordinates<G>::increment(const State<G>& s, const Eigen::VectorXd& dq,
                                   const Eigen::VectorXd& delta, Eigen::VectorXd& e) const {
  for (const auto* vectors : {&model_.amplitudes(), &model_.positions()})
    for (const int k : *vectors)
      e.template segment<dim>(dim * k) = delta.template segment<dim>(dim * k);
  for (const int k : model_.frames()) {
    const auto d = delta.template segment<dim>(dim * k);
    auto out = e.template segment<dim>(dim * k);
    if (uses_local(model_.update)) {
      out.noalias() = G::Tinv(dq.template segment<dim>(dim * k)) * d;
      continue;
    }
    const Angular at = model_.update == NodeUpdate::RotationVector
                           ? psi(s, k)
                           : Angular(dq.template segment<rd>(dim * k + sd));
    out.template head<sd>() = s.H[k].R * d.template head<sd>();
    out.template tail<rd>() = Rot::Tinv(at) * d.template tail<rd>();
  }
}

template <FrameGroup G>
void NodeCoordinates<G>::increments(const State<G>& s, const Eigen::VectorXd& dq,
                                    typename RateTangents<G>::Blocks& E) const {
  E.assign(s.H.size(), G::Matrix::Zero());
  for (const auto* vectors : {&model_.amplitudes(), &model_.positions()})
    for (const int k : *vectors) E[k].setIdentity();
  for (const int k : model_.frames()) {
    if (uses_local(model_.update)) {
      E[k] = G::Tinv(dq.template segment<dim>(dim * k));
      continue;
    }
    const Angular at = model_.update == NodeUpdate::RotationVector
                           ? psi(s, k)
                           : Angular(dq.template segment<rd>(dim * k + sd));
    E[k].template topLeftCorner<sd, sd>() = s.H[k].R;
    E[k].template bottomRightCorner<rd, rd>() = Rot::Tinv(at);
  }
}

/// With v = R^T u, its rate R^T udot + v x w, and in the classical formalism w = T(psi) psidot.
template <FrameGroup G>
void NodeCoordinates<G>::rate_tangents(const State<G>& s, const Eigen::VectorXd& dq,
                                       const Eigen::VectorXd& u, const Eigen::VectorXd& udot,
                                       TangentWeights weights, RateTangents<G>& out) const {
  using Matrix = typename G::Matrix;
  using Vector = Eigen::Matrix<double, sd, 1>;
  const double first = weights.damping, second = weights.mass;
  out.v.assign(s.H.size(), Matrix::Zero());
  out.vdot.assign(s.H.size(), Matrix::Zero());
  for (const auto* vectors : {&model_.amplitudes(), &model_.positions()})
    for (const int k : *vectors) {
      out.v[k] = first * Matrix::Identity();
      out.vdot[k] = second * Matrix::Identity();
    }
  for (const int k : model_.frames()) {
    Matrix &V = out.v[k], &W = out.vdot[k];
    if (uses_local(model_.update)) {
      const Matrix Ti = G::Tinv(dq.template segment<dim>(dim * k));
      V = first * Ti;
      W = second * Ti;
      continue;
    }
    auto V_w = V.template bottomRightCorner<rd, rd>(), W_w = W.template bottomRightCorner<rd, rd>();
    if (model_.update == NodeUpdate::RotationVector) {
      const Angular p = psi(s, k), rate = u.template segment<rd>(dim * k + sd),
                    acceleration = udot.template segment<rd>(dim * k + sd);
      const auto Ti = Rot::Tinv(p), dT = Rot::dT(p, rate);
      V_w = (first * Rot::T(p) + dT) * Ti;
      W_w = (second * Rot::T(p) + Rot::dT(p, acceleration) + Rot::d2T(p, rate, rate) +
             first * (dT + Rot::DT(p, rate))) *
            Ti;
    } else {
      const auto Ti = Rot::Tinv(Angular(dq.template segment<rd>(dim * k + sd)));
      V_w = first * Ti;
      W_w = second * Ti;
    }
    const Vector v = s.v.template segment<sd>(dim * k);
    const Vector a = s.H[k].R.transpose() * udot.template segment<sd>(dim * k);
    const Angular w = s.v.template segment<rd>(dim * k + sd);
    Eigen::Matrix<double, sd, sd> turns;  // v x w by v
    for (int j = 0; j < sd; ++j) turns.col(j) = Rot::cross(Vector::Unit(j)) * w;
    V.template topLeftCorner<sd, sd>().diagonal().setConstant(first);
    V.template topRightCorner<sd, rd>() = Rot::cross(v);
    W.template topLeftCorner<sd, sd>() = first * turns;
    W.template topLeftCorner<sd, sd>().diagonal().array() += second;
    W.template topRightCorner<sd, rd>() =
        Rot::cross(a) + Rot::cross(v) * V_w + turns * Rot::cross(v);
  }
}

template <FrameGroup G>
void NodeCoordinates<G>::difference(const State<G>& old, const State<G>& s,
                                    Eigen::VectorXd& dq) const {
  dq.setZero(model_.size());
  for (const int k : model_.amplitudes())
    dq.template segment<dim>(dim * k) =
        s.w.template segment<dim>(dim * k) - old.w.template segment<dim>(dim * k);
  for (const int k : model_.positions())
    dq.template segment<sd>(dim * k) = old.H[k].R.transpose() * (s.H[k].x - old.H[k].x);
  for (const int k : model_.frames()) {
    auto d = dq.template segment<dim>(dim * k);
    if (uses_local(model_.update)) {
      d = G::log(old.H[k].inverse() * s.H[k]);
      continue;
    }
    d.template head<sd>() = s.H[k].x - old.H[k].x;
    if (model_.update == NodeUpdate::RotationVector)
      d.template tail<rd>() = psi(s, k) - psi(old, k);
    else
      d.template tail<rd>() = Rot::log(old.H[k].R.transpose() * s.H[k].R);
  }
}

template <FrameGroup G>
void NodeCoordinates<G>::turn_positions(State<G>& s,
                                        std::initializer_list<Eigen::VectorXd*> further) const {
  if (model_.positions().empty()) return;
  turned_ = s.H;
  for (size_t b = 0; b < model_.bodies.size(); ++b)
    model_.bodies[b]->turn_axes(turned_.data() + model_.first_node(static_cast<int>(b)));
  for (const int k : model_.positions()) {
    const auto Q = (turned_[k].R.transpose() * s.H[k].R).eval();
    const auto turn = [&](Eigen::VectorXd& x) {
      x.template segment<sd>(dim * k) = (Q * x.template segment<sd>(dim * k)).eval();
    };
    for (auto* x : {&s.v, &s.vdot, &s.a}) turn(*x);
    for (auto* x : further) turn(*x);
    s.H[k].R = turned_[k].R;
  }
}

template <FrameGroup G>
bool NodeCoordinates<G>::passes_full_turn(const State<G>& old, const State<G>& s) const {
  constexpr double kInverseBound = 30;  // |T^-1|, across the vector
  if (model_.update != NodeUpdate::RotationVector || rescale_ || rd == 1) return false;
  for (const int k : model_.frames()) {
    const double before = psi(old, k).norm() / 2, now = psi(s, k).norm() / 2;
    if (std::floor(before / M_PI) != std::floor(now / M_PI)) return true;
    if (now > M_PI / 2 && now > kInverseBound * std::abs(std::sin(now))) return true;
  }
  return false;
}

template <FrameGroup G>
bool NodeCoordinates<G>::finish(State<G>& s) const {
  if (model_.update != NodeUpdate::RotationVector) {
    for (const int k : model_.frames()) s.H[k].orthonormalize();
    return false;
  }
  bool changed = false;
  if (!rescale_ || rd == 1) return false;
  for (const int k : model_.frames()) {
    const Angular p = psi(s, k);
    const double angle = p.norm();
    if (angle <= M_PI) continue;
    // The acceleration-like variable turns with the coordinates, as the acceleration does.
    const Angular w = s.v.template segment<rd>(dim * k + sd), rate = Rot::Tinv(p) * w;
    auto a = s.a.template segment<rd>(dim * k + sd);
    const Angular local = Rot::T(p) * a + Rot::dT(p, rate) * rate;
    const Angular q = (1 - 2 * M_PI / angle) * p, new_rate = Rot::Tinv(q) * w;
    a = Rot::Tinv(q) * (local - Rot::dT(q, new_rate) * new_rate);
    s.w.template segment<rd>(dim * k + sd) = q;
    changed = true;
  }
  return changed;
}

template class NodeCoordinates<SE2>;
template class NodeCoordinates<SE3>;

}  // namespace liesl
