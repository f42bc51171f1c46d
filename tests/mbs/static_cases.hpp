#pragma once
/// @file
/// Scenes of the static tests, built in code.

#include <Eigen/Geometry>

#include "mbs/model/curves.hpp"
#include "mbs/solvers/statics.hpp"

namespace liesl::test {

/// Section by its stiffness [EA, GA_y, GA_z, GJ, EI_y, EI_z] and inertia (unit density by default).
inline Section section(const SE3::Tangent& stiffness,
                       const SE3::Tangent& inertia = SE3::Tangent::Ones()) {
  Section s;
  s.shape = FullSection{stiffness.asDiagonal(), inertia.asDiagonal()};
  return s;
}

inline SE3::Tangent diagonal(double EA, double GA, double GJ, double EI) {
  return (SE3::Tangent() << EA, GA, GA, GJ, EI, EI).finished();
}

inline BeamSpec beam(std::vector<SE3> nodes, const Section& s) {
  BeamSpec b;
  b.sections.assign(nodes.size() - 1, s);
  b.nodes = std::move(nodes);
  return b;
}

/// One beam, clamped at its first node.
inline Mechanism cantilever(BeamSpec b) {
  Mechanism m;
  m.bodies.push_back({"beam", std::move(b)});
  JointSpec clamp;
  clamp.name = "clamp";
  clamp.b = {0, 0};
  m.joints.push_back(clamp);
  return m;
}

inline Port end_of(const Mechanism& m, int body = 0) {
  const auto& nodes = std::get<BeamSpec>(m.bodies[static_cast<size_t>(body)].kind).nodes;
  return {body, static_cast<int>(nodes.size()) - 1};
}

inline LoadSpec tip_load(const Mechanism& m, const Vec3& force, const Vec3& moment = Vec3::Zero()) {
  LoadSpec l;
  l.name = "tip";
  l.port = end_of(m);
  l.force = force;
  l.moment = moment;
  return l;
}

inline SimulationOptions tight() {
  SimulationOptions o;
  o.type = SimulationType::Static;
  o.tolerance = 1e-11;
  o.max_iterations = 20;
  return o;
}

/// Roll-up: L = 10, EI = GJ = 100, EA = GA = 1e4, end moment 2 pi EI/L.
inline Mechanism roll_up(int n) {
  Mechanism m =
      cantilever(beam(straight({0, 0, 0}, {10, 0, 0}, n), section(diagonal(1e4, 1e4, 100, 100))));
  m.loads.push_back(tip_load(m, Vec3::Zero(), {0, 0, 20 * M_PI}));
  return m;
}

/// A straight rod bent by an end moment that follows it into two coils of radius 10 and height 50,
/// of slenderness 1e4 (Harsch).
inline Mechanism helix(int n, int order = 2) {
  const double R = 10, c = 50 / (4 * M_PI), L = 4 * M_PI * std::hypot(R, c);
  const double kappa = R / (R * R + c * c), tau = c / (R * R + c * c);
  const double w = L / 1e4, E = 1, EI = E * w * w * w * w / 12;
  Mechanism m = cantilever(
      beam(straight({0, 0, 0}, {L, 0, 0}, n), section(diagonal(E * w * w, E * w * w / 2, EI, EI))));
  std::get<BeamSpec>(m.bodies[0].kind).order = order;
  m.loads.push_back(tip_load(m, Vec3::Zero(), EI * Vec3(tau, 0, kappa)));
  m.loads.back().follower = true;
  return m;
}
inline Vec3 end_of_helix() { return 50 * Vec3(50 / (4 * M_PI), 0, 10).normalized(); }

/// 45 degree bend (Bathe, Bolourchi 1979): R = 100, unit square section, E = 1e7, nu = 0.
inline Mechanism bend45(int n, double P, double shear_factor = 1, double J = 1. / 6) {
  const Arc quarter = Arc::with_radius({0, 0, 0}, Vec3::UnitX(), Vec3::UnitZ(), 100, M_PI / 4);
  Mechanism m = cantilever(
      beam(arc(quarter, n), section(diagonal(1e7, shear_factor * 5e6, 5e6 * J, 1e7 / 12))));
  m.loads.push_back(tip_load(m, {0, 0, P}));
  return m;
}

template <FrameGroup G>
struct Solved {
  StaticResult<G> result;
  Space<G> space;
  /// Last recorded frame of a node (counted over all bodies) in space.
  SE3 frame(int node) const {
    const auto& t = result.trajectory;
    return space.embed(t.frames(t.size() - 1)[node], SE3::identity());
  }
};

template <FrameGroup G = SE3>
Solved<G> solve(const Mechanism& m, const SimulationOptions& o = tight(),
                const Space<G>& space = {}) {
  auto model = Model<G>::build(m, space);
  return {solve_static(model, o), space};
}

/// Displacement of the last node of body 0.
template <FrameGroup G = SE3>
Vec3 tip_displacement(const Mechanism& m, const SimulationOptions& o = tight(),
                      const Space<G>& space = {}) {
  const int tip = end_of(m).node;
  const auto solved = solve<G>(m, o, space);
  if (solved.result.report.status != SolveStatus::Converged) return Vec3::Constant(NAN);
  return solved.frame(tip).x - std::get<BeamSpec>(m.bodies[0].kind).nodes.back().x;
}

/// Limit of a quantity with error h^2 + h^4 from two meshes, the second twice as fine.
template <class Value>
Value richardson(const Value& coarse, const Value& fine) {
  return fine + (fine - coarse) / 3;
}

}  // namespace liesl::test
