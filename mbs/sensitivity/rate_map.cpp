#include "mbs/sensitivity/rate_map.hpp"

#include <algorithm>
#include <cmath>

namespace liesl {

using Eigen::MatrixXd;

namespace {

/// In all that the matrices depend on.
template <FrameGroup G>
bool same(const State<G>& s, const State<G>& other) {
  return s.v == other.v && s.vdot == other.vdot && s.a == other.a && s.w == other.w &&
         std::ranges::equal(s.H, other.H,
                            [](const G& H, const G& K) { return H.R == K.R && H.x == K.x; });
}

}  // namespace

/// The one of psi and psi (1 - 2 pi/|psi|) that is nearer to that before. What is in local frames
/// stays, the acceleration-like variable among it.
template <FrameGroup G>
void undo_rescale(const Model<G>& model, const NodeCoordinates<G>& coordinates, const State<G>& old,
                  State<G>& s) {
  constexpr int rd = G::rotation_dim;
  if (model.update != NodeUpdate::RotationVector || rd == 1) return;
  Eigen::VectorXd u, a;
  coordinates.rates(s, u, a);
  State<G> local = s;  // vdot: s.a in local frames
  coordinates.place(s, Eigen::VectorXd::Zero(model.size()), u, s.a, local);
  for (const int k : model.frames()) {
    const auto at = G::dim * k + G::space_dim;
    const auto before = old.w.template segment<rd>(at);
    const auto psi = s.w.template segment<rd>(at);
    const double angle = psi.norm();
    if (angle == 0) continue;
    const typename RotationOf<G>::Vector other = (1 - 2 * M_PI / angle) * psi;
    if ((other - before).norm() < (psi - before).norm()) local.w.template segment<rd>(at) = other;
  }
  coordinates.rates(local, u, a);
  s.w = local.w;
  s.a = a;
}

template <FrameGroup G>
RateMap<G>::RateMap(const Model<G>& model) : model_(&model) {}

/// Rates of coordinates that change by e, and frames by delta: `rate_tangents` with weights 0 has
/// V and W, with a weight of u it adds D, which multiplies B u' there, as e = B^-1 delta.
template <FrameGroup G>
void RateMap<G>::take(const NodeCoordinates<G>& coordinates, const State<G>& s) {
  if (model_->update == NodeUpdate::Screw || (at_ && same(*at_, s))) return;
  at_ = s;
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(model_->size());
  Eigen::VectorXd u, udot;
  coordinates.rates(s, u, udot);
  const TangentWeights none{0, 0}, first{0, 1};
  RateTangents<G> at;
  coordinates.rate_tangents(s, still, u, s.a, none, at);
  A_ = at.vdot;
  coordinates.rate_tangents(s, still, u, udot, first, at);
  D_ = at.vdot;
  coordinates.rate_tangents(s, still, u, udot, none, at);
  V_ = at.v;
  W_ = at.vdot;
  coordinates.increments(s, still, inverse_);
  B_ = inverse_;
  for (const int k : model_->frames()) {
    D_[k] -= W_[k];
    B_[k] = inverse_[k].inverse().eval();
  }
}

template <FrameGroup G>
template <class Each>
void RateMap<G>::each_frame(Each each) const {
  if (model_->update == NodeUpdate::Screw) return;
  for (const int k : model_->frames()) each(k, dim * static_cast<Eigen::Index>(k));
}

template <FrameGroup G>
void RateMap<G>::to_local(StateSensitivity& x) const {
  each_frame([&](int k, Eigen::Index at) {
    const auto eta = x.eta.middleRows<dim>(at);
    auto v = x.v.middleRows<dim>(at), w = x.w.middleRows<dim>(at), a = x.a.middleRows<dim>(at);
    v = (B_[k] * v).eval();
    w = (B_[k] * w + D_[k] * v + W_[k] * eta).eval();
    a = (B_[k] * a + D_[k] * v + A_[k] * eta).eval();
    v += V_[k] * eta;
  });
}

template <FrameGroup G>
void RateMap<G>::to_coordinates(StateSensitivity& x) const {
  each_frame([&](int k, Eigen::Index at) {
    const auto eta = x.eta.middleRows<dim>(at);
    auto v = x.v.middleRows<dim>(at), w = x.w.middleRows<dim>(at), a = x.a.middleRows<dim>(at);
    v -= V_[k] * eta;
    w = (inverse_[k] * (w - D_[k] * v - W_[k] * eta)).eval();
    a = (inverse_[k] * (a - D_[k] * v - A_[k] * eta)).eval();
    v = (inverse_[k] * v).eval();
  });
}

template <FrameGroup G>
void RateMap<G>::to_local_transposed(StateSensitivity& bars) const {
  each_frame([&](int k, Eigen::Index at) {
    auto eta = bars.eta.middleRows<dim>(at), v = bars.v.middleRows<dim>(at),
         w = bars.w.middleRows<dim>(at), a = bars.a.middleRows<dim>(at);
    eta += V_[k].transpose() * v + W_[k].transpose() * w + A_[k].transpose() * a;
    v = (B_[k].transpose() * (v + D_[k].transpose() * (w + a))).eval();
    w = (B_[k].transpose() * w).eval();
    a = (B_[k].transpose() * a).eval();
  });
}

template <FrameGroup G>
void RateMap<G>::to_coordinates_transposed(StateSensitivity& bars) const {
  each_frame([&](int k, Eigen::Index at) {
    auto eta = bars.eta.middleRows<dim>(at), v = bars.v.middleRows<dim>(at),
         w = bars.w.middleRows<dim>(at), a = bars.a.middleRows<dim>(at);
    w = (inverse_[k].transpose() * w).eval();
    a = (inverse_[k].transpose() * a).eval();
    v = (inverse_[k].transpose() * v - D_[k].transpose() * (w + a)).eval();
    eta -= V_[k].transpose() * v + W_[k].transpose() * w + A_[k].transpose() * a;
  });
}

template <FrameGroup G>
void RateMap<G>::at_held_frames(MatrixXd& v, MatrixXd& w) const {
  each_frame([&](int k, Eigen::Index at) {
    auto of_v = v.middleRows<dim>(at), of_w = w.middleRows<dim>(at);
    of_v = (B_[k] * of_v).eval();
    of_w = (B_[k] * of_w + D_[k] * of_v).eval();
  });
}

template <FrameGroup G>
void RateMap<G>::at_held_frames_transposed(MatrixXd& v, MatrixXd& w) const {
  each_frame([&](int k, Eigen::Index at) {
    auto of_v = v.middleRows<dim>(at), of_w = w.middleRows<dim>(at);
    of_v = (B_[k].transpose() * (of_v + D_[k].transpose() * of_w)).eval();
    of_w = (B_[k].transpose() * of_w).eval();
  });
}

template void undo_rescale(const Model<SE2>&, const NodeCoordinates<SE2>&, const State<SE2>&,
                           State<SE2>&);
template void undo_rescale(const Model<SE3>&, const NodeCoordinates<SE3>&, const State<SE3>&,
                           State<SE3>&);
template class RateMap<SE2>;
template class RateMap<SE3>;

}  // namespace liesl
