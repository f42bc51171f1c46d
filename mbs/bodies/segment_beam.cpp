#include "mbs/bodies/segment_beam.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

#include "mbs/bodies/four_segments.hpp"
#include "mbs/bodies/segment_angle.hpp"

namespace liesl {
namespace {

using Vec2 = Eigen::Vector2d;

/// Axes along and across the direction halfway between two.
Eigen::Matrix2d bisector(const Vec2& before, const Vec2& after) {
  const Vec2 t = (before + after).normalized();
  Eigen::Matrix2d out;
  out << t, turned(t);
  return out;
}

/// The velocity of an end turns with its frame; the axes of positions are held.
Vec2 velocity_by_turn(const BodyState<SE2>& s, int k) {
  return s.H[k].R * turned(Eigen::Map<const Vec2>(s.v + 3 * k));
}

}  // namespace

struct SegmentBeam::Segment {
  double l;
  Vec2 t, n;  ///< along it, and to the left of that

  Vec2 force(const Tangent& stress) const { return stress[0] * t + stress[1] * n; }
};

/// Of a scalar, by the increments of up to three neighbouring nodes.
struct SegmentBeam::Gradient {
  int first = 0, count = 0;
  std::array<Tangent, 3> at = {Tangent::Zero(), Tangent::Zero(), Tangent::Zero()};

  /// g . (increment of x_{e+1} - x_e), g in inertial axes; e = first or first + 1.
  void add(const SE2* H, int e, const Vec2& g) {
    at[e - first].head<2>() -= H[e].R.transpose() * g;
    at[e + 1 - first].head<2>() += H[e + 1].R.transpose() * g;
    count = std::max(count, e + 2 - first);
  }
  void add(const Gradient& other, double factor) {
    for (int k = 0; k < other.count; ++k) at[other.first + k - first] += factor * other.at[k];
    count = std::max(count, other.first + other.count - first);
  }
  void add_to(double* h, double factor) const {
    for (int k = 0; k < count; ++k) Eigen::Map<Tangent>(h + 3 * (first + k)) += factor * at[k];
  }
  double dot(const double* h) const {
    double sum = 0;
    for (int k = 0; k < count; ++k)
      sum += at[k].dot(Eigen::Map<const Tangent>(h + 3 * (first + k)));
    return sum;
  }
};

namespace {

using Matrices = Body<SE2>::Matrices;

template <class Gradient>
void add_product(double factor, const Gradient& p, const Gradient& q, Matrices& A) {
  for (int i = 0; i < p.count; ++i)
    for (int j = 0; j < q.count; ++j)
      block_of<3>(A, p.first + i, q.first + j).noalias() +=
          (factor * p.at[i]) * q.at[j].transpose();
}

}  // namespace

SegmentBeam::SegmentBeam(std::string body_name, std::vector<SE2> nodes_at_rest,
                         const std::vector<ElementSection<SE2>>& sections, double damping,
                         const SegmentSpec& spec)
    : Body<SE2>(std::move(body_name), std::move(nodes_at_rest)),
      potential_(spec.potential),
      lumped_(spec.lumped),
      damping_(damping) {
  const int n = elements();
  L_.resize(n);
  for (int e = 0; e < n; ++e) L_[e] = (reference[e + 1].x - reference[e].x).norm();
  half_.setZero(n + 1);
  half_.head(n) += 0.5 * L_;
  half_.tail(n) += 0.5 * L_;
  require_on_axis<SE2>(name, sections, half_.maxCoeff());
  phi0_.setZero(n + 1);
  for (int i = 0; i <= n; ++i) phi0_[i] = angle(reference.data(), i);
  from_bisector_.assign(n + 1, Matrix2::Identity());
  std::vector<SE2> bisected = reference;
  turn_axes(bisected.data());
  for (int i = 1; i < n; ++i) from_bisector_[i] = bisected[i].R.transpose() * reference[i].R;
  set_sections(sections);
  dead_ = c_;
  dead_mass_ = half_.cwiseProduct(half_) * (m_.sum() / n);
  set_matrices();
}

void SegmentBeam::set_sections(const std::vector<ElementSection<SE2>>& sections) {
  const int n = elements();
  acting_ = acting_range<SE2>(sections);
  k_.resize(n);
  EI_.resize(n);
  m_.resize(n);
  for (int e = 0; e < n; ++e) {
    k_[e] = sections[e].K(0, 0) / L_[e];
    EI_[e] = sections[e].K(2, 2);
    m_[e] = sections[e].M(0, 0) * L_[e];
  }
  c_ = bending_springs(L_, EI_);
  J_ = {0.5 * L_[0] * sections.front().M(2, 2), 0.5 * L_[n - 1] * sections.back().M(2, 2)};
}

void SegmentBeam::set_matrices() {
  for (auto* A : {&M_, &K_}) {
    A->resize(nodes());
    A->widen();
  }
  add_mass(reference.data(), 1, M_);
  add_material(reference.data(), 1, true, K_);
  for (int i = 1; i + 1 < nodes(); ++i) K_.D[i](2, 2) += dead_[i];
}

SegmentBeam::Segment SegmentBeam::segment(const SE2* H, int e) const {
  const Vec2 d = H[e + 1].x - H[e].x;
  const double l = d.norm();
  const Vec2 t = d / l;
  return {l, t, turned(t)};
}

double SegmentBeam::angle(const SE2* H, int i) const {
  const Vec2 before = i > 0 ? segment(H, i - 1).t : Vec2(H[0].R.col(0));
  const Vec2 after = i < elements() ? segment(H, i).t : Vec2(H[i].R.col(0));
  return angle_between(before, after);
}

double SegmentBeam::axial(int e, double l) const {
  return axial_force(potential_, k_[e], L_[e], l);
}

/// dN/dl
double SegmentBeam::axial_slope(int e, double l) const {
  return axial_force_slope(potential_, k_[e], L_[e], l);
}

SegmentBeam::Gradient SegmentBeam::length_gradient(const SE2* H, int e) const {
  Gradient g{e};
  g.add(H, e, segment(H, e).t);
  return g;
}

/// d psi = n . d(d)/l
SegmentBeam::Gradient SegmentBeam::direction_gradient(const SE2* H, int e) const {
  const Segment segment = this->segment(H, e);
  Gradient g{e};
  g.add(H, e, segment.n / segment.l);
  return g;
}

SegmentBeam::Gradient SegmentBeam::angle_gradient(const SE2* H, int i) const {
  const int n = elements();
  Gradient g{std::max(i - 1, 0)};
  if (i > 0) g.add(direction_gradient(H, i - 1), -1);
  if (i < n) g.add(direction_gradient(H, i), 1);
  if (i == 0) g.at[0][2] -= 1;
  if (i == n) g.at[1][2] += 1;
  return g;
}

double SegmentBeam::length_rate(const BodyState<SE2>& s, int e) const {
  return segment(s.H, e).t.dot(node_velocity(s, e + 1) - node_velocity(s, e));
}

double SegmentBeam::direction_rate(const BodyState<SE2>& s, int e) const {
  const Segment segment = this->segment(s.H, e);
  return segment.n.dot(node_velocity(s, e + 1) - node_velocity(s, e)) / segment.l;
}

double SegmentBeam::angle_rate(const BodyState<SE2>& s, int i) const {
  const double before = i > 0 ? direction_rate(s, i - 1) : s.v[2];
  const double after = i < elements() ? direction_rate(s, i) : s.v[3 * i + 2];
  return after - before;
}

/// d(t . d') = psi' n . d(d) + t . d(d')
SegmentBeam::Gradient SegmentBeam::length_rate_gradient(const BodyState<SE2>& s, int e) const {
  const Segment segment = this->segment(s.H, e);
  Gradient g{e};
  g.add(s.H, e, direction_rate(s, e) * segment.n);
  if (e == 0) g.at[0][2] -= segment.t.dot(velocity_by_turn(s, 0));
  if (e + 1 == elements()) g.at[1][2] += segment.t.dot(velocity_by_turn(s, e + 1));
  return g;
}

/// d(n . d'/l) = -(l'/l^2) n . d(d) - (psi'/l) t . d(d) + n . d(d')/l
SegmentBeam::Gradient SegmentBeam::direction_rate_gradient(const BodyState<SE2>& s, int e) const {
  const Segment segment = this->segment(s.H, e);
  const double l = segment.l;
  Gradient g{e};
  g.add(s.H, e,
        -(length_rate(s, e) / (l * l)) * segment.n - (direction_rate(s, e) / l) * segment.t);
  if (e == 0) g.at[0][2] -= segment.n.dot(velocity_by_turn(s, 0)) / l;
  if (e + 1 == elements()) g.at[1][2] += segment.n.dot(velocity_by_turn(s, e + 1)) / l;
  return g;
}

SegmentBeam::Gradient SegmentBeam::angle_rate_gradient(const BodyState<SE2>& s, int i) const {
  Gradient g{std::max(i - 1, 0)};
  if (i > 0) g.add(direction_rate_gradient(s, i - 1), -1);
  if (i < elements()) g.add(direction_rate_gradient(s, i), 1);
  return g;
}

void SegmentBeam::turn_axes(SE2* H) const { turn_segment_axes(from_bisector_, elements(), H); }

void SegmentBeam::follow_frames(const SE2* start, SE2* H) const {
  follow_ends(start, elements(), H);
}

/// With d' and d'' of a segment: psi' = n . d'/l, psi'' = (n . d'' - 2 l' psi')/l.
void SegmentBeam::complete(SE2* H, double* v, double* vdot, const double* w) const {
  const BodyState<SE2> s{H, v, vdot, w};
  struct Point {
    Vec2 velocity, acceleration;
  };
  struct Turn {
    Vec2 t;
    double rate, acceleration;
  };
  const auto point = [&](int k) -> Point {
    return {node_velocity(s, k), H[k].R * node_acceleration(s, k)};
  };
  const auto put = [&](int k, const Point& at, const Turn& before, const Turn& after) {
    H[k].R = bisector(before.t, after.t) * from_bisector_[k];
    Eigen::Map<Tangent> out(v + 3 * k), out_dot(vdot + 3 * k);
    out[2] = 0.5 * (before.rate + after.rate);
    out.head<2>() = H[k].R.transpose() * at.velocity;
    out_dot.head<2>() = H[k].R.transpose() * at.acceleration - out[2] * turned(out.head<2>());
    out_dot[2] = 0.5 * (before.acceleration + after.acceleration);
  };
  Point a = point(0);
  Turn before{};
  for (int e = 0; e < elements(); ++e) {
    const Point b = point(e + 1);
    const Segment g = segment(H, e);
    const Vec2 d1 = b.velocity - a.velocity, d2 = b.acceleration - a.acceleration;
    const double rate = g.n.dot(d1) / g.l;
    const Turn turn{g.t, rate, (g.n.dot(d2) - 2 * g.t.dot(d1) * rate) / g.l};
    if (e > 0) put(e, a, before, turn);
    a = b;
    before = turn;
  }
}

void SegmentBeam::add_inertia(const BodyState<SE2>& s, const Vector& gravity, double* r,
                              ForceScale& scale) const {
  const int n = elements();
  add_point_inertia(s, m_, acting_, lumped_, gravity, r, scale);
  r[2] += J_[0] * s.vdot[2];
  r[3 * n + 2] += J_[1] * s.vdot[3 * n + 2];
}

void SegmentBeam::add_internal(const BodyState<SE2>& s, double* r, ForceScale& scale) const {
  add_segment_forces(
      {potential_, damping_, L_.data(), k_.data(), c_.data(), phi0_.data(), elements()},
      acting_.with_neighbours(elements()), s, r, scale);
}

double SegmentBeam::mass_between(int i, int j) const {
  return liesl::mass_between(m_, lumped_, i, j);
}

void SegmentBeam::add_mass(const SE2* H, double weight, Matrices& A) const {
  const int n = elements();
  for (int i = 0; i <= n; ++i) {
    A.D[i].topLeftCorner<2, 2>().diagonal().array() += weight * mass_between(i, i);
    const bool end = i == 0 || i == n;
    A.D[i](2, 2) += weight * (end ? J_[i == 0 ? 0 : 1] : dead_mass_[i]);
    if (i == n || lumped_) continue;
    const Matrix2 m = weight * mass_between(i, i + 1) * H[i].R.transpose() * H[i + 1].R;
    A.U[i].topLeftCorner<2, 2>() += m;
    A.L[i].topLeftCorner<2, 2>() += m.transpose();
  }
}

/// sum of dN/dl dl dl^T (of damping EA/L) and of c_i d(phi) d(phi)^T.
void SegmentBeam::add_material(const SE2* H, double weight, bool tangent, Matrices& A) const {
  for (int e = 0; e < elements(); ++e) {
    const Gradient g = length_gradient(H, e);
    add_product(weight * (tangent ? axial_slope(e, segment(H, e).l) : k_[e]), g, g, A);
  }
  for (int i = 0; i < nodes(); ++i) {
    const Gradient g = angle_gradient(H, i);
    add_product(weight * c_[i], g, g, A);
  }
}

/// Material and geometric terms, N d^2 l = N (n . d)^2/l and m d^2 psi = -2 m (t . d)(n . d)/l^2
/// with m = V l.
void SegmentBeam::add_stiffness(const BodyState<SE2>& s, const Tangent* stress, Matrices& A) const {
  add_material(s.H, 1, true, A);
  for (int e = 0; e < elements(); ++e) {
    const Segment segment = this->segment(s.H, e);
    Tangent n = stress ? stress[e] : section_force(s, e, ElementPlace::Middle);
    if (damping_ > 0) {
      n[0] += damping_ * k_[e] * length_rate(s, e);
      n[1] += damping_ * (c_[e] * angle_rate(s, e) - c_[e + 1] * angle_rate(s, e + 1)) / segment.l;
    }
    Gradient along = length_gradient(s.H, e), across{e};
    across.add(s.H, e, segment.n);
    add_product(n[0] / segment.l, across, across, A);
    add_product(-n[1] / segment.l, along, across, A);
    add_product(-n[1] / segment.l, across, along, A);
  }
}

void SegmentBeam::add_damping_stiffness(const BodyState<SE2>& s, Matrices& A) const {
  for (int e = 0; e < elements(); ++e)
    add_product(damping_ * k_[e], length_gradient(s.H, e), length_rate_gradient(s, e), A);
  for (int i = 0; i < nodes(); ++i)
    add_product(damping_ * c_[i], angle_gradient(s.H, i), angle_rate_gradient(s, i), A);
}

/// By v: accelerations R (w J du + J u dw).
void SegmentBeam::add_rates(const BodyState<SE2>& s, double weight, Matrices& A) const {
  const int n = elements();
  for (int k = 0; k <= n; ++k) {
    const bool end = k == 0 || k == n;
    const Tangent v = Eigen::Map<const Tangent>(s.v + 3 * k);
    Eigen::Matrix<double, 2, 3> by_v = Eigen::Matrix<double, 2, 3>::Zero();
    by_v(0, 1) = -v[2];
    by_v(1, 0) = v[2];
    if (end) by_v.col(2) = turned(v.head<2>());
    for (int j = std::max(k - 1, 0); j <= std::min(k + 1, n); ++j)
      if (const double m = mass_between(j, k); m > 0)
        block_of<3>(A, j, k).topRows<2>() += weight * m * s.H[j].R.transpose() * s.H[k].R * by_v;
  }
}

/// An end frame turns against the forces on it, and its acceleration turns with it.
void SegmentBeam::add_turning(const BodyState<SE2>& s, const Vector& gravity, const Tangent* stress,
                              Matrices& A) const {
  const int n = elements();
  ForceScale unused;
  Eigen::VectorXd r = Eigen::VectorXd::Zero(size()), elastic = r;
  add_inertia(s, gravity, r.data(), unused);
  add_internal(s, r.data(), unused);
  for (const int k : {0, n}) {
    Vec2 f = r.segment<2>(3 * k);
    if (stress) {
      const int e = k == 0 ? 0 : n - 1;
      const Vec2 change =
          segment(s.H, e).force(stress[e] - section_force(s, e, ElementPlace::Middle));
      f += (k == 0 ? -1 : 1) * s.H[k].R.transpose() * change;
    }
    A.D[k].col(2).head<2>() -= turned(f);
    const Vec2 by_turn = turned(node_acceleration(s, k));
    for (int j = std::max(k - 1, 0); j <= std::min(k + 1, n); ++j)
      if (const double m = mass_between(j, k); m > 0)
        block_of<3>(A, j, k).col(2).head<2>() += m * s.H[j].R.transpose() * s.H[k].R * by_turn;
  }
}

void SegmentBeam::exact_tangent(const BodyState<SE2>& s, const Vector& gravity, TangentWeights w,
                                const Tangent* stress, Matrices& A) const {
  A.set_zero();
  if (w.stiffness != 0) {
    add_stiffness(s, stress, A);
    if (damping_ > 0) add_damping_stiffness(s, A);
    add_turning(s, gravity, stress, A);
    for (int i = 1; i < elements(); ++i) A.D[i](2, 2) += dead_[i];
    if (w.stiffness != 1)
      for (auto* blocks : {&A.D, &A.U, &A.L, &A.U2, &A.L2})
        for (auto& b : *blocks) b *= w.stiffness;
  }
  if (w.damping != 0) {
    add_rates(s, w.damping, A);
    if (damping_ > 0) add_material(s.H, w.damping * damping_, false, A);
  }
  if (w.mass != 0) add_mass(s.H, w.mass, A);
}

SegmentBeam::Matrices SegmentBeam::load_distribution() const {
  Matrices W(nodes());
  for (int i = 0; i < nodes(); ++i) W.D[i].topLeftCorner<2, 2>().diagonal().setConstant(half_[i]);
  return W;
}

SegmentBeam::Tangent SegmentBeam::strain(const BodyState<SE2>& s, int e) const {
  const auto curvature = [&](int i) { return (angle(s.H, i) - phi0_[i]) / half_[i]; };
  return {segment(s.H, e).l / L_[e] - 1, 0, 0.5 * (curvature(e) + curvature(e + 1))};
}

SegmentBeam::Tangent SegmentBeam::section_force(const BodyState<SE2>& s, int e,
                                                ElementPlace at) const {
  const Segment segment = this->segment(s.H, e);
  const double first = moment(s.H, e), last = moment(s.H, e + 1);
  const Tangent n(axial(e, segment.l), (first - last) / segment.l, 0.5 * (first + last));
  if (at == ElementPlace::Middle) return n;
  const int node = at == ElementPlace::First ? e : e + 1;
  Tangent out;
  out << s.H[node].R.transpose() * segment.force(n), at == ElementPlace::First ? first : last;
  return out;
}

void SegmentBeam::extrapolate_stress(const BodyState<SE2>& s, const double* delta,
                                     Tangent* stress) const {
  for (int e = 0; e < elements(); ++e) {
    const Segment segment = this->segment(s.H, e);
    const double first = c_[e] * angle_gradient(s.H, e).dot(delta),
                 last = c_[e + 1] * angle_gradient(s.H, e + 1).dot(delta);
    const auto moved = [&](int k) -> Vec2 {
      return s.H[k].R * Eigen::Map<const Vec2>(delta + 3 * k);
    };
    const double l = (segment.l * segment.t + moved(e + 1) - moved(e)).norm();
    stress[e] = section_force(s, e, ElementPlace::Middle) +
                Tangent(axial_slope(e, segment.l) * length_gradient(s.H, e).dot(delta), 0,
                        0.5 * (first + last));
    stress[e][1] = (moment(s.H, e) + first - moment(s.H, e + 1) - last) / l;
  }
}

BodyEnergy SegmentBeam::energy(const BodyState<SE2>& s, const Vector& gravity) const {
  BodyEnergy energy;
  const int n = elements();
  Vec2 before = s.H[0].R.col(0), a = node_velocity(s, 0);
  const auto add_bending = [&](int i, const Vec2& after) {
    const double phi = angle_between<double>(before, after) - phi0_[i];
    energy.elastic += 0.5 * c_[i] * phi * phi;
    before = after;
  };
  for (int e = 0; e < n; ++e) {
    const Vec2 b = node_velocity(s, e + 1);
    const Segment segment = this->segment(s.H, e);
    energy.kinetic += kinetic_energy(m_[e], lumped_, a, b);
    energy.elastic += axial_energy(potential_, k_[e], L_[e], segment.l);
    energy.potential -= 0.5 * m_[e] * gravity.dot(s.H[e].x + s.H[e + 1].x);
    add_bending(e, segment.t);
    a = b;
  }
  add_bending(n, s.H[n].R.col(0));
  energy.kinetic += 0.5 * (J_[0] * s.v[2] * s.v[2] + J_[1] * s.v[3 * n + 2] * s.v[3 * n + 2]);
  return energy;
}

double SegmentBeam::dissipation(const BodyState<SE2>& s) const {
  if (damping_ == 0) return 0;
  double power = 0;
  for (int e = 0; e < elements(); ++e) power += damping_ * k_[e] * std::pow(length_rate(s, e), 2);
  for (int i = 0; i < nodes(); ++i) power += damping_ * c_[i] * std::pow(angle_rate(s, i), 2);
  return power;
}

/// Forces are linear in EA, in c_i and in the masses; d(c_i) = c_i^2 sum of L/(2 EI^2) d(EI).
std::unique_ptr<Body<SE2>> SegmentBeam::derivative(const LawDerivative<SE2>& law) const {
  const auto* sections = std::get_if<std::vector<ElementSection<SE2>>>(&law);
  if (!sections || static_cast<int>(sections->size()) != elements())
    throw std::invalid_argument("derivative of beam '" + name + "': expected d(K, M_s)/dp of " +
                                std::to_string(elements()) + " segments");
  std::unique_ptr<SegmentBeam> out(new SegmentBeam(*this));
  out->acting_ = acting_range<SE2>(*sections);
  Eigen::VectorXd dEI(elements());
  for (int e = 0; e < elements(); ++e) {
    const auto& section = (*sections)[static_cast<std::size_t>(e)];
    out->k_[e] = section.K(0, 0) / L_[e];
    out->m_[e] = section.M(0, 0) * L_[e];
    dEI[e] = section.K(2, 2);
  }
  out->c_ = bending_springs_by(c_, L_, EI_, dEI);
  const int n = elements();
  out->J_ = {0.5 * L_[0] * sections->front().M(2, 2), 0.5 * L_[n - 1] * sections->back().M(2, 2)};
  out->dead_.setZero();
  out->dead_mass_.setZero();
  out->set_matrices();
  return out;
}

/// At a node the force of the segment is in its axes, which turn.
void SegmentBeam::add_section_force_gradient(const BodyState<SE2>& s, int e, ElementPlace at,
                                             const Tangent& f, double* h) const {
  const Segment segment = this->segment(s.H, e);
  const Tangent n = section_force(s, e, ElementPlace::Middle);
  Tangent on = f;  // on [N, V, M] in the middle
  double first = 0.5, last = 0.5;
  if (at != ElementPlace::Middle) {
    const int node = at == ElementPlace::First ? e : e + 1;
    const Vec2 inertial = s.H[node].R * f.head<2>(), force = segment.force(n);
    on.head<2>() = Vec2(inertial.dot(segment.t), inertial.dot(segment.n));
    direction_gradient(s.H, e).add_to(h, inertial.dot(turned(force)));
    h[3 * node + 2] -= inertial.dot(turned(force));
    first = at == ElementPlace::First ? 1 : 0;
    last = 1 - first;
  }
  length_gradient(s.H, e).add_to(h, on[0] * axial_slope(e, segment.l) - on[1] * n[1] / segment.l);
  angle_gradient(s.H, e).add_to(h, c_[e] * (on[1] / segment.l + on[2] * first));
  angle_gradient(s.H, e + 1).add_to(h, c_[e + 1] * (-on[1] / segment.l + on[2] * last));
}

void SegmentBeam::add_energy_gradient(const BodyState<SE2>& s, const Vector& gravity,
                                      const BodyEnergy& weight, double* h, double* v) const {
  const int n = elements();
  std::vector<Vec2> p(n + 1, Vec2::Zero());  // momenta
  for (int i = 0; i <= n; ++i)
    for (int j = std::max(i - 1, 0); j <= std::min(i + 1, n); ++j)
      p[i] += mass_between(i, j) * node_velocity(s, j);
  for (int i = 0; i <= n; ++i) {
    Eigen::Map<Tangent> on_h(h + 3 * i), on_v(v + 3 * i);
    on_v.head<2>() += weight.kinetic * s.H[i].R.transpose() * p[i];
    const double mass = 0.5 * ((i > 0 ? m_[i - 1] : 0) + (i < n ? m_[i] : 0));
    on_h.head<2>() -= weight.potential * mass * s.H[i].R.transpose() * gravity;
    if (i > 0 && i < n) continue;
    on_h[2] += weight.kinetic * p[i].dot(velocity_by_turn(s, i));
    on_v[2] += weight.kinetic * J_[i == 0 ? 0 : 1] * s.v[3 * i + 2];
  }
  for (int e = 0; e < n; ++e)
    length_gradient(s.H, e).add_to(h, weight.elastic * axial(e, segment(s.H, e).l));
  for (int i = 0; i <= n; ++i) angle_gradient(s.H, i).add_to(h, weight.elastic * moment(s.H, i));
}

/// theta_k = (psi_{k-1} + psi_k)/2; what is in its axes turns with it.
void SegmentBeam::to_unknowns(const BodyState<SE2>& s, double* h, double* v) const {
  const int n = elements();
  std::vector<SE2> H(s.H, s.H + n + 1);
  turn_axes(H.data());
  std::vector<std::array<double, 2>> turns(n + 1, {0, 0});
  for (int k = 1; k < n; ++k) {
    Eigen::Map<Tangent> on_h(h + 3 * k), on_v(v + 3 * k);
    const Matrix2 Q = s.H[k].R.transpose() * H[k].R;
    const Vec2 u = H[k].R.transpose() * node_velocity(s, k);
    turns[k] = {on_h[2] - on_v.head<2>().dot(turned(u)), on_v[2]};
    on_h.head<2>() = (Q * on_h.head<2>()).eval();
    on_v.head<2>() = (Q * on_v.head<2>()).eval();
    on_h[2] = on_v[2] = 0;
  }
  for (int k = 1; k < n; ++k) {
    const auto [turn, rate] = turns[k];
    for (const int e : {k - 1, k}) {
      direction_gradient(s.H, e).add_to(h, 0.5 * turn);
      if (rate == 0) continue;
      direction_rate_gradient(s, e).add_to(h, 0.5 * rate);
      direction_gradient(s.H, e).add_to(v, 0.5 * rate);
    }
  }
}

}  // namespace liesl
