#include "mbs/bodies/spatial_segment_beam.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mbs/bodies/segment_law.hpp"

namespace liesl {
namespace {

constexpr double kStraight = 1e-9;  // rad
constexpr double kRound = 1e-9;     // of the bending stiffness
constexpr double kHeld = 1e-4;      // of the spring beside an end
constexpr double kFolded = 1e-8;    // 1 + cos phi

/// Is the bending stiffness, or a change of it, the same about y and z?
bool bends_alike(const SE3::Matrix& K, double size) {
  return std::abs(K(4, 4) - K(5, 5)) <= kRound * size;
}

}  // namespace

SpatialSegmentBeam::SpatialSegmentBeam(std::string body_name, std::vector<SE3> nodes_at_rest,
                                       const std::vector<ElementSection<SE3>>& sections,
                                       double damping, const SegmentSpec& spec)
    : Body<SE3>(std::move(body_name), std::move(nodes_at_rest)),
      potential_(spec.potential),
      lumped_(spec.lumped) {
  if (damping != 0)
    throw std::invalid_argument(
        "beam '" + name +
        "' has no torsion as a chain of segments, nor damping in space: expected damping = 0; "
        "formalism se3 has both");
  const int n = elements();
  L_.resize(n);
  for (int e = 0; e < n; ++e) L_[e] = (reference[e + 1].x - reference[e].x).norm();
  half_.setZero(n + 1);
  half_.head(n) += 0.5 * L_;
  half_.tail(n) += 0.5 * L_;
  require_straight();
  require_on_axis<SE3>(name, sections, half_.maxCoeff());
  for (const auto& section : sections)
    if (!bends_alike(section.K, section.K(5, 5)))
      throw std::invalid_argument(
          "beam '" + name +
          "' has no torsion as a chain of segments: expected sections of one bending stiffness in "
          "space (circle, tube, square); formalism se3 has the others");
  set_sections(sections);
  dead_ = c_;
  dead_mass_ = half_.cwiseProduct(half_) * (m_.sum() / n);
  spin_ = kHeld * Eigen::Vector2d(c_[0], c_[n]);
  set_matrices();
}

void SpatialSegmentBeam::require_straight() const {
  const Mat3& R = reference[0].R;
  bool straight = true;
  for (int e = 0; e < elements(); ++e)
    straight = straight && (segment(reference.data(), e).t - R.col(0)).norm() <= kStraight &&
               (reference[e + 1].R - R).norm() <= kStraight;
  if (!straight)
    throw std::invalid_argument("beam '" + name +
                                "' has no torsion as a chain of segments: expected a beam that is "
                                "straight and not twisted at rest; formalism se3 has the others");
}

void SpatialSegmentBeam::set_sections(const std::vector<ElementSection<SE3>>& sections) {
  const int n = elements();
  acting_ = acting_range<SE3>(sections);
  k_.resize(n);
  EI_.resize(n);
  m_.resize(n);
  for (int e = 0; e < n; ++e) {
    k_[e] = sections[e].K(0, 0) / L_[e];
    EI_[e] = 0.5 * (sections[e].K(4, 4) + sections[e].K(5, 5));
    m_[e] = sections[e].M(0, 0) * L_[e];
  }
  c_ = bending_springs(L_, EI_);
  J_[0] = 0.5 * L_[0] * sections.front().M.bottomRightCorner<3, 3>();
  J_[1] = 0.5 * L_[n - 1] * sections.back().M.bottomRightCorner<3, 3>();
}

void SpatialSegmentBeam::set_matrices() {
  for (auto* A : {&M_, &K_}) {
    A->resize(nodes());
    A->widen();
  }
  const int n = elements();
  add_mass(reference.data(), 1, M_);
  add_stiffness(reference.data(), nullptr, K_);
  for (int i = 1; i < n; ++i) K_.D[i].bottomRightCorner<3, 3>().diagonal().array() += dead_[i];
  K_.D[0](3, 3) += spin_[0];
  K_.D[n](3, 3) += spin_[1];
}

SpatialSegment SpatialSegmentBeam::segment(const SE3* H, int e) const {
  const Vec3 d = H[e + 1].x - H[e].x;
  const double l = d.norm();
  return {l, d / l};
}

Misalignment SpatialSegmentBeam::bend(const SE3* H, int i) const {
  const Vec3 before = i > 0 ? segment(H, i - 1).t : Vec3(H[0].R.col(0));
  const Vec3 after = i < elements() ? segment(H, i).t : Vec3(H[i].R.col(0));
  return Misalignment(before, after);
}

Vec3 SpatialSegmentBeam::moment(const SE3* H, int i) const { return c_[i] * bend(H, i).q(); }

auto SpatialSegmentBeam::forces(const SE3* H, int e, const Tangent* stress) const -> SegmentForces {
  if (stress) return {stress[e][0], stress[e].tail<3>(), stress[e + 1].tail<3>()};
  return {axial(e, segment(H, e).l), moment(H, e), moment(H, e + 1)};
}

Vec3 SpatialSegmentBeam::force(const SE3* H, int e, const Tangent* stress) const {
  const SpatialSegment g = segment(H, e);
  const SegmentForces at = forces(H, e, stress);
  return at.N * g.t + (at.first - at.last).cross(g.t) / g.l;
}

Mat3 SpatialSegmentBeam::axes_of(const SE3* H, int e) const {
  return smallest_rotation(H[e].R.col(0), segment(H, e).t) * H[e].R;
}

double SpatialSegmentBeam::axial(int e, double l) const {
  return axial_force(potential_, k_[e], L_[e], l);
}

/// dN/dl
double SpatialSegmentBeam::axial_slope(int e, double l) const {
  return axial_force_slope(potential_, k_[e], L_[e], l);
}

double SpatialSegmentBeam::nodal_mass(int i, int j) const {
  return mass_between(m_, lumped_, i, j);
}

void SpatialSegmentBeam::turn_axes(SE3* H) const {
  Vec3 before = segment(H, 0).t;
  Mat3 axes = axes_of(H, 0);
  for (int i = 1; i < elements(); ++i) {
    const Vec3 after = segment(H, i).t, bisector = (before + after).normalized();
    H[i].R = smallest_rotation(before, bisector) * axes;
    axes = smallest_rotation(bisector, after) * H[i].R;
    before = after;
  }
}

void SpatialSegmentBeam::settle_spin(SE3* H) const {
  const int last = elements() - 1;
  H[last + 1].R = smallest_rotation(segment(H, last).t, H[last + 1].R.col(0)) * axes_of(H, last);
}

void SpatialSegmentBeam::follow_frames(const SE3* start, SE3* H) const {
  follow_ends(start, elements(), H);
}

std::optional<ShapeFault> SpatialSegmentBeam::fault(const SE3* H) const {
  for (int i = 0; i < nodes(); ++i)
    if (1 + bend(H, i).z < kFolded)
      return ShapeFault{"a segment of '" + name + "' folds back on the one before",
                        "use more elements"};
  return {};
}

/// With d' of a segment: t' = (d' - (t . d') t)/l.
void SpatialSegmentBeam::complete(SE3* H, double* v, double* vdot, const double* w) const {
  const BodyState<SE3> s{H, v, vdot, w};
  const int n = elements();
  std::vector<Vec3> t(n), rate(n), x1(n + 1), x2(n + 1);
  for (int k = 0; k <= n; ++k) {
    x1[k] = node_velocity(s, k);
    x2[k] = H[k].R * node_acceleration(s, k);
  }
  for (int e = 0; e < n; ++e) {
    const SpatialSegment g = segment(H, e);
    t[e] = g.t;
    rate[e] = across(g.t, x1[e + 1] - x1[e]) / g.l;
  }
  turn_axes(H);
  Vec3 spin = H[0].R * Eigen::Map<const Vec3>(v + 3);  // of the axes, inertial
  spin = carried_turn(H[0].R.col(0), spin, t[0], rate[0]);
  for (int k = 1; k < n; ++k) {
    const Vec3 sum = t[k - 1] + t[k], b = sum.normalized();
    const Vec3 b_rate = across(b, rate[k - 1] + rate[k]) / sum.norm();
    spin = carried_turn(t[k - 1], spin, b, b_rate);
    Eigen::Map<Tangent> out(v + 6 * k), out_dot(vdot + 6 * k);
    out << H[k].R.transpose() * x1[k], H[k].R.transpose() * spin;
    const Vec3 u = out.head<3>(), turn = out.tail<3>();
    out_dot << H[k].R.transpose() * x2[k] - turn.cross(u), Vec3::Zero();
    spin = carried_turn(b, spin, t[k], rate[k]);
  }
}

void SpatialSegmentBeam::add_inertia(const BodyState<SE3>& s, const Vector& gravity, double* r,
                                     ForceScale& scale) const {
  const int n = elements();
  add_point_inertia(s, m_, acting_, lumped_, gravity, r, scale);
  for (const int k : {0, n}) {
    const Mat3& J = J_[k == 0 ? 0 : 1];
    const Vec3 w = Eigen::Map<const Vec3>(s.v + 6 * k + 3), momentum = J * w;
    Eigen::Map<Vec3>(r + 6 * k + 3) +=
        J * Eigen::Map<const Vec3>(s.vdot + 6 * k + 3) + w.cross(momentum);
  }
}

void SpatialSegmentBeam::add_internal(const BodyState<SE3>& s, double* r, ForceScale& scale) const {
  const int n = elements();
  const auto [first, end] = acting_.with_neighbours(n);
  SpatialSegment now = segment(s.H, first), next = now;
  const Vec3 before = first > 0 ? segment(s.H, first - 1).t : Vec3(s.H[0].R.col(0));
  Vec3 m = c_[first] * Misalignment(before, now.t).q();
  if (first == 0) Eigen::Map<Vec3>(r + 3) -= across_x(s.H[0].R.transpose() * m);
  for (int e = first; e < end; ++e) {
    if (e + 1 < n) next = segment(s.H, e + 1);
    const Vec3 after = e + 1 < n ? next.t : Vec3(s.H[n].R.col(0));
    const Vec3 m_next = c_[e + 1] * Misalignment(now.t, after).q();
    const Vec3 f = axial(e, now.l) * now.t + (m - m_next).cross(now.t) / now.l;
    Eigen::Map<Vec3>(r + 6 * e) -= s.H[e].R.transpose() * f;
    Eigen::Map<Vec3>(r + 6 * (e + 1)) += s.H[e + 1].R.transpose() * f;
    Tangent size;
    size << f, m_next;
    scale.add<SE3>(size);
    m = m_next;
    now = next;
  }
  if (end == n) Eigen::Map<Vec3>(r + 6 * n + 3) += across_x(s.H[n].R.transpose() * m);
}

void SpatialSegmentBeam::add_mass(const SE3* H, double weight, Matrices& A) const {
  const int n = elements();
  for (int i = 0; i <= n; ++i) {
    A.D[i].topLeftCorner<3, 3>().diagonal().array() += weight * nodal_mass(i, i);
    if (i == 0 || i == n)
      A.D[i].bottomRightCorner<3, 3>() += weight * J_[i == 0 ? 0 : 1];
    else
      A.D[i].bottomRightCorner<3, 3>().diagonal().array() += weight * dead_mass_[i];
    if (i == n || lumped_) continue;
    const Mat3 m = weight * nodal_mass(i, i + 1) * H[i].R.transpose() * H[i + 1].R;
    A.U[i].topLeftCorner<3, 3>() += m;
    A.L[i].topLeftCorner<3, 3>() += m.transpose();
  }
}

SpatialSegmentBeam::Matrices SpatialSegmentBeam::load_distribution() const {
  Matrices W(nodes());
  for (int i = 0; i < nodes(); ++i) W.D[i].topLeftCorner<3, 3>().diagonal().setConstant(half_[i]);
  return W;
}

SpatialSegmentBeam::Tangent SpatialSegmentBeam::strain(const BodyState<SE3>& s, int e) const {
  const auto curvature = [&](int i) -> Vec3 { return bend(s.H, i).q() / half_[i]; };
  Tangent out = Tangent::Zero();
  out[0] = segment(s.H, e).l / L_[e] - 1;
  out.tail<3>() = across_x(axes_of(s.H, e).transpose() * (0.5 * (curvature(e) + curvature(e + 1))));
  return out;
}

SpatialSegmentBeam::Tangent SpatialSegmentBeam::section_force(const BodyState<SE3>& s, int e,
                                                              ElementPlace at) const {
  const Vec3 f = force(s.H, e);
  Tangent out;
  if (at == ElementPlace::Middle) {
    const Mat3 axes = axes_of(s.H, e);
    const Vec3 mean = 0.5 * (moment(s.H, e) + moment(s.H, e + 1));
    out << axes.transpose() * f, across_x(axes.transpose() * mean);
    return out;
  }
  const int node = at == ElementPlace::First ? e : e + 1;
  const Mat3& R = s.H[node].R;
  out << R.transpose() * f, R.transpose() * moment(s.H, node);
  return out;
}

BodyEnergy SpatialSegmentBeam::energy(const BodyState<SE3>& s, const Vector& gravity) const {
  BodyEnergy energy;
  const int n = elements();
  for (int e = 0; e < n; ++e) {
    const Vec3 a = node_velocity(s, e), b = node_velocity(s, e + 1);
    energy.kinetic += kinetic_energy(m_[e], lumped_, a, b);
    energy.elastic += axial_energy(potential_, k_[e], L_[e], segment(s.H, e).l);
    energy.potential -= 0.5 * m_[e] * gravity.dot(s.H[e].x + s.H[e + 1].x);
  }
  for (int i = 0; i <= n; ++i) energy.elastic += 0.5 * c_[i] * bend(s.H, i).q().squaredNorm();
  for (const int k : {0, n}) {
    const Eigen::Map<const Vec3> w(s.v + 6 * k + 3);
    energy.kinetic += 0.5 * w.dot(J_[k == 0 ? 0 : 1] * w);
  }
  return energy;
}

/// Forces are linear in EA, in c_i and in the masses.
std::unique_ptr<Body<SE3>> SpatialSegmentBeam::derivative(const LawDerivative<SE3>& law) const {
  const auto* sections = std::get_if<std::vector<ElementSection<SE3>>>(&law);
  if (!sections || static_cast<int>(sections->size()) != elements())
    throw std::invalid_argument("derivative of beam '" + name + "': expected d(K, M_s)/dp of " +
                                std::to_string(elements()) + " segments");
  std::unique_ptr<SpatialSegmentBeam> out(new SpatialSegmentBeam(*this));
  out->acting_ = acting_range<SE3>(*sections);
  Eigen::VectorXd dEI(elements());
  for (int e = 0; e < elements(); ++e) {
    const auto& section = (*sections)[static_cast<std::size_t>(e)];
    if (!bends_alike(section.K, std::max(std::abs(section.K(4, 4)), std::abs(section.K(5, 5)))))
      throw std::invalid_argument(
          "derivative of beam '" + name +
          "': a parameter bends it more easily in one direction, which a chain of segments in "
          "space has not; expected one that keeps both bending stiffnesses equal");
    out->k_[e] = section.K(0, 0) / L_[e];
    out->m_[e] = section.M(0, 0) * L_[e];
    dEI[e] = 0.5 * (section.K(4, 4) + section.K(5, 5));
  }
  out->c_ = bending_springs_by(c_, L_, EI_, dEI);
  const int n = elements();
  out->J_[0] = 0.5 * L_[0] * sections->front().M.bottomRightCorner<3, 3>();
  out->J_[1] = 0.5 * L_[n - 1] * sections->back().M.bottomRightCorner<3, 3>();
  out->dead_.setZero();
  out->dead_mass_.setZero();
  out->spin_.setZero();
  out->set_matrices();
  return out;
}

}  // namespace liesl
