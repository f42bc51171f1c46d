/// @file
/// Exact tangents and gradients of chains of segments in space.

#include <vector>

#include "mbs/bodies/segment_law.hpp"
#include "mbs/bodies/spatial_segment_beam.hpp"

namespace liesl {
namespace {

constexpr double kReversed = 1e-8;  // 1 + cos of a turn

/// 1 - t t^T
Mat3 projector(const Vec3& t) { return Mat3::Identity() - t * t.transpose(); }

}  // namespace

/// Turn of the bisector of both directions at a node, without one about itself: with s = a + b, s x
/// ds/|s|^2.
NodalGradient SpatialSegmentBeam::turn_gradient(const SE3* H, int i) const {
  const Misalignment bend = this->bend(H, i);
  const Vec3 sum = bend.a + bend.b;
  const Mat3 by = hat(sum) / sum.squaredNorm();
  NodalGradient g{std::max(i - 1, 0)};
  if (i > 0)
    g.add(H, i - 1, by * projector(bend.a) / segment(H, i - 1).l);
  else
    g.add_axis(H, 0, by);
  if (i < elements())
    g.add(H, i, by * projector(bend.b) / segment(H, i).l);
  else
    g.add_axis(H, i, by);
  return g;
}

/// m = c k(z) a x b: dm = c (k' (a x b) (b . da + a . db) + k (da x b + a x db)); about another
/// moment that one turns with the bisector.
NodalGradient SpatialSegmentBeam::moment_gradient(const SE3* H, int i, const Vec3* about) const {
  const Misalignment bend = this->bend(H, i);
  const Mat3 by_a = c_[i] * (bend.slope * bend.cross * bend.b.transpose() - bend.k * hat(bend.b)),
             by_b = c_[i] * (bend.slope * bend.cross * bend.a.transpose() + bend.k * hat(bend.a));
  NodalGradient g{std::max(i - 1, 0)};
  if (i > 0)
    g.add(H, i - 1, by_a * projector(bend.a) / segment(H, i - 1).l);
  else
    g.add_axis(H, 0, by_a);
  if (i < elements())
    g.add(H, i, by_b * projector(bend.b) / segment(H, i).l);
  else
    g.add_axis(H, i, by_b);
  if (about) g.add(turn_gradient(H, i), -hat(Vec3(*about - c_[i] * bend.q())));
  return g;
}

/// f = N t + mu x t/l, mu = m_e - m_{e+1}: df = N' t dl + N dt + dmu x t/l + mu x dt/l - mu x t
/// dl/l^2.
NodalGradient SpatialSegmentBeam::force_gradient(const SE3* H, int e, const Tangent* stress) const {
  const auto [l, t] = segment(H, e);
  const SegmentForces at = forces(H, e, stress);
  const Vec3 mu = at.first - at.last;
  const Mat3 P = projector(t), by_moment = hat(t) / l;
  const Mat3 own = axial_slope(e, l) * t * t.transpose() + at.N / l * P +
                   (hat(mu) * P - mu.cross(t) * t.transpose()) / (l * l);
  NodalGradient g{std::max(e - 1, 0)};
  g.add(H, e, own);
  g.add(moment_gradient(H, e, stress ? &at.first : nullptr), -by_moment);
  g.add(moment_gradient(H, e + 1, stress ? &at.last : nullptr), by_moment);
  return g;
}

/// Forces and moments change in inertial axes; what their axes turn is `add_turning`.
void SpatialSegmentBeam::add_stiffness(const SE3* H, const Tangent* stress, Matrices& A) const {
  const int n = elements();
  for (int e = 0; e < n; ++e) {
    const NodalGradient g = force_gradient(H, e, stress);
    for (int k = 0; k < g.count; ++k) {
      const int j = g.first + k;
      block_of<6>(A, e, j).topRows<3>() -= H[e].R.transpose() * g.at[k];
      block_of<6>(A, e + 1, j).topRows<3>() += H[e + 1].R.transpose() * g.at[k];
    }
  }
  for (const int end : {0, n}) {
    const Vec3 m = stress ? Vec3(stress[end].tail<3>()) : moment(H, end);
    const NodalGradient g = moment_gradient(H, end, stress ? &m : nullptr);
    const double sign = end == 0 ? -1 : 1;
    for (int k = 0; k < g.count; ++k)
      block_of<6>(A, end, g.first + k).bottomRows<3>() += sign * H[end].R.transpose() * g.at[k];
  }
}

/// By v: accelerations R (w x du + dw x u), and J w' + w x J w of the ends.
void SpatialSegmentBeam::add_rates(const BodyState<SE3>& s, double weight, Matrices& A) const {
  const int n = elements();
  for (int k = 0; k <= n; ++k) {
    const Vec3 u = Eigen::Map<const Vec3>(s.v + 6 * k), w = Eigen::Map<const Vec3>(s.v + 6 * k + 3);
    const bool end = k == 0 || k == n;
    Eigen::Matrix<double, 3, 6> by_v = Eigen::Matrix<double, 3, 6>::Zero();
    by_v.leftCols<3>() = hat(w);
    if (end) by_v.rightCols<3>() = -hat(u);
    for (int j = std::max(k - 1, 0); j <= std::min(k + 1, n); ++j)
      if (const double m = nodal_mass(j, k); m > 0)
        block_of<6>(A, j, k).topRows<3>() += weight * m * s.H[j].R.transpose() * s.H[k].R * by_v;
    if (!end) continue;
    const Mat3& J = J_[k == 0 ? 0 : 1];
    const Vec3 momentum = J * w;
    A.D[k].bottomRightCorner<3, 3>() += weight * (hat(w) * J - hat(momentum));
  }
}

/// An end frame turns against the forces and the elastic moment on it, and its acceleration turns
/// with it.
void SpatialSegmentBeam::add_turning(const BodyState<SE3>& s, const Vector& gravity,
                                     const Tangent* stress, Matrices& A) const {
  const int n = elements();
  ForceScale unused;
  Eigen::VectorXd elastic = Eigen::VectorXd::Zero(size());
  add_internal(s, elastic.data(), unused);
  Eigen::VectorXd r = elastic;
  add_inertia(s, gravity, r.data(), unused);
  for (const int k : {0, n}) {
    Vec3 f = r.segment<3>(6 * k), m = elastic.segment<3>(6 * k + 3);
    if (stress) {
      const int e = k == 0 ? 0 : n - 1;
      const double sign = k == 0 ? -1 : 1;
      const Vec3 change = force(s.H, e, stress) - force(s.H, e);
      f += sign * s.H[k].R.transpose() * change;
      m = sign * across_x(s.H[k].R.transpose() * stress[k].tail<3>());
    }
    A.D[k].topRightCorner<3, 3>() += hat(f);
    A.D[k].bottomRightCorner<3, 3>() += hat(m);
    const Mat3 by_turn = hat(node_acceleration(s, k));
    for (int j = std::max(k - 1, 0); j <= std::min(k + 1, n); ++j)
      if (const double mass = nodal_mass(j, k); mass > 0)
        block_of<6>(A, j, k).topRightCorner<3, 3>() -=
            mass * s.H[j].R.transpose() * s.H[k].R * by_turn;
  }
}

void SpatialSegmentBeam::add_tangent(const BodyState<SE3>& s, const Vector& gravity,
                                     TangentWeights w, const Tangent* stress, Matrices& A) const {
  A.set_zero();
  if (w.stiffness != 0) {
    add_stiffness(s.H, stress, A);
    add_turning(s, gravity, stress, A);
    for (int i = 1; i < elements(); ++i)
      A.D[i].bottomRightCorner<3, 3>().diagonal().array() += dead_[i];
    if (w.stiffness != 1)
      for (auto* blocks : {&A.D, &A.U, &A.L, &A.U2, &A.L2})
        for (auto& b : *blocks) b *= w.stiffness;
  }
  if (w.damping != 0) add_rates(s, w.damping, A);
  if (w.mass != 0) add_mass(s.H, w.mass, A);
}

void SpatialSegmentBeam::exact_tangent(const BodyState<SE3>& s, const Vector& gravity,
                                       TangentWeights w, const Tangent* stress, Matrices& A) const {
  add_tangent(s, gravity, w, stress, A);
  if (w.mass != 0 || w.damping != 0) return;
  A.D[0](3, 3) += w.stiffness * spin_[0];
  A.D[elements()](3, 3) += w.stiffness * spin_[1];
}

void SpatialSegmentBeam::exact_tangents(const BodyState<SE3>& s, const Vector& gravity,
                                        const Tangent* stress, Matrices& K, Matrices& C,
                                        Matrices& M) const {
  add_tangent(s, gravity, {0, 0, 1}, stress, K);
  add_tangent(s, gravity, {0, 1, 0}, stress, C);
  add_tangent(s, gravity, {1, 0, 0}, stress, M);
}

/// Moments turn with the bisector of both directions, which moves as positions do: straight.
void SpatialSegmentBeam::extrapolate_stress(const BodyState<SE3>& s, const double* delta,
                                            Tangent* stress) const {
  const int n = elements();
  const auto way = [&](int e) -> Vec3 {
    const auto moved = [&](int k) -> Vec3 {
      return s.H[k].R * Eigen::Map<const Vec3>(delta + 6 * k);
    };
    return moved(e + 1) - moved(e);
  };
  const auto direction = [&](int e) -> Vec3 {
    return (s.H[e + 1].x - s.H[e].x + way(e)).normalized();
  };
  const auto axis = [&](int k) -> Vec3 {
    return s.H[k].R * SO3::exp(Eigen::Map<const Vec3>(delta + 6 * k + 3)).R.col(0);
  };
  for (int i = 0; i <= n; ++i) {
    stress[i].setZero();
    if (i < n) {
      const SpatialSegment g = segment(s.H, i);
      stress[i][0] = axial(i, g.l) + axial_slope(i, g.l) * g.t.dot(way(i));
    }
    const Misalignment bend = this->bend(s.H, i);
    const Vec3 m = c_[i] * bend.q(), turn = turn_gradient(s.H, i).product(delta),
               changed = m + moment_gradient(s.H, i).product(delta) - turn.cross(m),
               before = (bend.a + bend.b).normalized(),
               after = ((i > 0 ? direction(i - 1) : axis(0)) + (i < n ? direction(i) : axis(n)))
                           .normalized();
    const bool turns = 1 + before.dot(after) > kReversed;
    stress[i].tail<3>() = turns ? Vec3(smallest_rotation(before, after) * changed) : changed;
  }
}

/// In axes A of a force f and a moment m: d(A^T f) = A^T (df - turn x f), likewise m.
void SpatialSegmentBeam::add_section_force_gradient(const BodyState<SE3>& s, int e, ElementPlace at,
                                                    const Tangent& f, double* h) const {
  const bool middle = at == ElementPlace::Middle;
  const int node = at == ElementPlace::Last ? e + 1 : e;
  const Mat3 axes = middle ? axes_of(s.H, e) : s.H[node].R;
  const double first = middle ? 0.5 : node == e ? 1 : 0, last = 1 - first;
  const Vec3 on_force = axes * f.head<3>(), on_moment = axes * f.tail<3>();
  const Vec3 m = first * moment(s.H, e) + last * moment(s.H, e + 1);
  const Vec3 on_turn = on_force.cross(force(s.H, e)) + on_moment.cross(m);
  const auto [l, t] = segment(s.H, e);
  force_gradient(s.H, e).add_transposed(on_force, h);
  moment_gradient(s.H, e).add_transposed(first * on_moment, h);
  moment_gradient(s.H, e + 1).add_transposed(last * on_moment, h);
  if (!middle) {
    Eigen::Map<Vec3>(h + 6 * node + 3) += s.H[node].R.transpose() * on_turn;
    return;
  }
  const CarriedBack back(Vec3(s.H[e].R.col(0)), t, on_turn);
  const Vec3 on_d = across(t, back.on_direction.x) / l;
  Eigen::Map<Vec3>(h + 6 * e) -= s.H[e].R.transpose() * on_d;
  Eigen::Map<Vec3>(h + 6 * (e + 1)) += s.H[e + 1].R.transpose() * on_d;
  Eigen::Map<Vec3>(h + 6 * e + 3) += s.H[e].R.transpose() * back.on_turn.x;
}

void SpatialSegmentBeam::add_energy_gradient(const BodyState<SE3>& s, const Vector& gravity,
                                             const BodyEnergy& weight, double* h, double* v) const {
  const int n = elements();
  Eigen::VectorXd elastic = Eigen::VectorXd::Zero(size());
  ForceScale unused;
  add_internal(s, elastic.data(), unused);
  for (int i = 0; i <= n; ++i) {
    Vec3 p = Vec3::Zero();  // momentum
    for (int j = std::max(i - 1, 0); j <= std::min(i + 1, n); ++j)
      p += nodal_mass(i, j) * node_velocity(s, j);
    const Vec3 local = s.H[i].R.transpose() * p;
    Eigen::Map<Tangent> on_h(h + 6 * i), on_v(v + 6 * i);
    on_h += weight.elastic * elastic.segment<6>(6 * i);
    on_v.head<3>() += weight.kinetic * local;
    const double mass = 0.5 * ((i > 0 ? m_[i - 1] : 0) + (i < n ? m_[i] : 0));
    on_h.head<3>() -= weight.potential * mass * s.H[i].R.transpose() * gravity;
    if (i > 0 && i < n) continue;
    const Vec3 u = Eigen::Map<const Vec3>(s.v + 6 * i), w = Eigen::Map<const Vec3>(s.v + 6 * i + 3);
    on_h.tail<3>() += weight.kinetic * u.cross(local);
    on_v.tail<3>() += weight.kinetic * (J_[i == 0 ? 0 : 1] * w);
  }
}

/// Axes are carried along the chain, so what is said of the turn eta of a node goes back along it,
/// onto the directions of segments and the first frame; what is in axes that turn, turns with them.
/// Of angular velocities, dw = deta/dt + w x eta (L. Euler, J.-L. Lagrange; in the axes of the
/// node): with g on w, constant there, g . dw is the rate of g . eta, so that what comes back has
/// the gradient with respect to velocities as its value and that with respect to places as its
/// rate.
void SpatialSegmentBeam::to_unknowns(const BodyState<SE3>& s, double* h, double* v) const {
  const int n = elements();
  std::vector<SE3> H(s.H, s.H + n + 1);
  turn_axes(H.data());
  std::vector<Rated> d, t, on_turn(n + 1), on_t(n);
  for (int e = 0; e < n; ++e) {
    d.emplace_back(s.H[e + 1].x - s.H[e].x, node_velocity(s, e + 1) - node_velocity(s, e));
    t.push_back(d[e] / d[e].norm());
  }
  for (int k = 1; k < n; ++k) {
    Eigen::Map<Tangent> on_h(h + 6 * k), on_v(v + 6 * k);
    const Mat3 to_unknown = s.H[k].R.transpose() * H[k].R;
    const Vec3 u = H[k].R.transpose() * node_velocity(s, k), by_h = on_h.head<3>(),
               by_v = on_v.head<3>(), by_turn = on_h.tail<3>(), by_w = on_v.tail<3>();
    on_turn[k] = Rated(H[k].R * by_w, H[k].R * (by_turn - u.cross(by_v)));
    on_h << to_unknown * by_h, Vec3::Zero();
    on_v << to_unknown * by_v, Vec3::Zero();
  }
  Rated on_axes;  // of the segment behind a node
  for (int k = n - 1; k > 0; --k) {
    const Rated sum = t[k - 1] + t[k], b = sum / sum.norm();
    const CarriedBack to_node(b, t[k], on_axes);
    const CarriedBack to_segment(t[k - 1], b, on_turn[k] + to_node.on_turn);
    const Rated on_sum = across(b, to_segment.on_direction) / sum.norm();
    on_t[k] = on_t[k] + to_node.on_direction + on_sum;
    on_t[k - 1] = on_t[k - 1] + on_sum;
    on_axes = to_segment.on_turn;
  }
  const Vec3 w = Eigen::Map<const Vec3>(s.v + 3), x = s.H[0].R.col(0);
  const CarriedBack to_frame(Rated(x, (s.H[0].R * w).cross(x)), t[0], on_axes);
  on_t[0] = on_t[0] + to_frame.on_direction;
  Eigen::Map<Vec3>(h + 3) += s.H[0].R.transpose() * to_frame.on_turn.d;
  Eigen::Map<Vec3>(v + 3) += s.H[0].R.transpose() * to_frame.on_turn.x;
  for (int e = 0; e < n; ++e) {
    const Rated on_d = across(t[e], on_t[e]) / d[e].norm();
    for (const int k : {e, e + 1}) {
      const Mat3 to_node = (k == e ? -1 : 1) * s.H[k].R.transpose();
      const Vec3 by_v = to_node * on_d.x;
      Eigen::Map<Vec3>(h + 6 * k) += to_node * on_d.d;
      Eigen::Map<Vec3>(v + 6 * k) += by_v;
      if (k == 0 || k == n)  // x' = R u
        Eigen::Map<Vec3>(h + 6 * k + 3) += Eigen::Map<const Vec3>(s.v + 6 * k).cross(by_v);
    }
  }
}

}  // namespace liesl
