#pragma once
/// @file
/// Mechanisms that the tests share, as functions of what they vary. SI units.

#include <Eigen/Geometry>

#include "mbs/model/curves.hpp"
#include "mbs/model/mechanism.hpp"

namespace liesl::test {

inline Material steel() { return {"steel", 210e9, 0.3, 7850}; }

inline Section round_section(double diameter, double shear_factor) {
  Section s;
  s.shape = Circle{diameter};
  s.shear_factor = {shear_factor, shear_factor};
  return s;
}

/// Section given by diag(K) and diag(M).
inline Section full(const SE3::Tangent& stiffness, const SE3::Tangent& inertia) {
  Section s;
  s.shape = FullSection{stiffness.asDiagonal(), inertia.asDiagonal()};
  return s;
}

inline BeamSpec straight_beam(const Vec3& from, const Vec3& to, int n, const Section& section,
                              const Material& material) {
  BeamSpec b;
  b.nodes = straight(from, to, n);
  b.sections.assign(std::size_t(n), section);
  b.material = material;
  return b;
}

inline RigidSpec block(const Vec3& at, double mass, double inertia) {
  RigidSpec r;
  r.frame.x = at;
  r.mass = mass;
  r.inertia = inertia * Mat3::Identity();
  return r;
}

/// Slider-crank of data/scenes/slider_crank.toml, without gravity: crank 20 mm, from the dead
/// point.
struct SliderCrank {
  int elements = 8;
  double crank = 0.020, rod = 0.010;
  double slider = 0.2;
  double ramp = 0.04;
};
inline Mechanism slider_crank(const SliderCrank& p = {}) {
  Mechanism m;
  m.name = "slider-crank";
  const int n = p.elements;
  m.bodies = {
      {"crank", straight_beam({0, 0, 0}, {0.15, 0, 0}, n, round_section(p.crank, 0.9), steel())},
      {"rod", straight_beam({0.15, 0, 0}, {0.45, 0, 0}, n, round_section(p.rod, 0.9), steel())},
      {"slider", block({0.45, 0, 0}, p.slider, 1e-4)}};
  m.joints = {{"motor", JointType::Revolute, {}, {0, 0}},
              {"pin", JointType::Revolute, {0, n}, {1, 0}},
              {"wrist", JointType::Revolute, {1, n}, {2, 0}},
              {"guide", JointType::Prismatic, {}, {2, 0}, Vec3::UnitX()}};
  m.drives = {{0, 0, TimeFunction::rate(150, p.ramp)}};
  return m;
}

/// Flexible pendulum of data/scenes/pendulum.toml.
inline Mechanism pendulum(int n) {
  Section s;
  s.shape = Rectangle{0.01, 0.01};
  s.shear_factor = {5. / 6, 5. / 6};
  s.torsion_constant = 0.1406e-8;
  Mechanism m;
  m.name = "pendulum";
  m.gravity = {0, -9.81, 0};
  m.bodies = {{"beam", straight_beam({0, 0, 0}, {1, 0, 0}, n, s, {"soft", 5e8, 0.3, 7800})}};
  m.joints = {{"hinge", JointType::Revolute, {}, {0, 0}}};
  return m;
}

/// Heavy top of Bruels, Cardona, Arnold 2012; its frame is at the centre of
/// mass.
inline Mechanism heavy_top() {
  RigidSpec r;
  r.frame.x = Vec3(0, 1, 0);
  r.mass = 15;
  r.inertia = Vec3(0.234375, 0.46875, 0.234375).asDiagonal();
  const Vec3 w(0, 150, -4.61538);
  Mechanism m;
  m.name = "heavy top";
  m.gravity = {0, 0, -9.81};
  m.bodies = {{"top", r, w.cross(Vec3(0, 1, 0)), w}};
  m.joints = {{"tip", JointType::Spherical, {}, {0, 0, SE3(Mat3::Identity(), {0, -1, 0})}}};
  return m;
}

/// Free-flying beam in 3-D of Simo & Vu-Quoc 1988; A = node 0 is loaded.
inline Mechanism flying_beam(int n) {
  SE3::Tangent K, M;
  K << 1e4, 1e4, 1e4, 500, 500, 500;
  M << 1, 1, 1, 10, 10, 10;
  Mechanism m;
  m.name = "flying beam";
  m.bodies = {{"beam", straight_beam({6, 0, 0}, {0, 8, 0}, n, full(K, M), {})}};
  LoadSpec l;
  l.name = "push";
  l.port = {0, 0};
  l.force = {0.1, 0, 0};
  l.moment = {0, -0.5, -1};
  l.scale = TimeFunction::table({0, 2.5, 5}, {0, 200, 0}, TimeFunction::Interpolation::Linear);
  m.loads = {l};
  return m;
}

/// Spin-up of Kane, Ryan, Banerjee 1987.
inline Mechanism spin_up(int n) {
  SE3::Tangent K, M;
  K << 2.8e7, 1e7, 1e7, 1e4, 1.4e4, 1.4e4;
  M << 1.2, 1.2, 1.2, 1.2e-3, 6e-4, 6e-4;
  Mechanism m;
  m.name = "spin-up";
  m.bodies = {{"beam", straight_beam({0, 0, 0}, {10, 0, 0}, n, full(K, M), {})}};
  m.joints = {{"motor", JointType::Revolute, {}, {0, 0}}};
  m.drives = {{0, 0, TimeFunction::rate(6, 15)}};
  return m;
}

/// Driven four-bar in the plane of x and y: crank 0.1, coupler 0.3, rocker 0.2, ground 0.3 m;
/// closed at a crank angle of 90 degrees.
inline Mechanism four_bar(int n) {
  const Vec3 A(0, 0, 0), D(0.3, 0, 0), B(0, 0.1, 0);
  const Vec3 along = D - B;  // C = intersection of the circles |C - B| = 0.3, |C - D| = 0.2
  const double l = along.norm(), a = (0.09 - 0.04 + l * l) / (2 * l);
  const Vec3 up = Vec3::UnitZ().cross(along / l);
  const Vec3 C = B + a * along / l + std::sqrt(0.09 - a * a) * up;
  Mechanism m;
  m.name = "four-bar";
  m.gravity = {0, -9.81, 0};
  m.bodies = {{"crank", straight_beam(A, B, n, round_section(0.008, 0.9), steel())},
              {"coupler", straight_beam(B, C, n, round_section(0.006, 0.9), steel())},
              {"rocker", straight_beam(D, C, n, round_section(0.006, 0.9), steel())}};
  m.joints = {{"motor", JointType::Revolute, {}, {0, 0}},
              {"pin", JointType::Revolute, {0, n}, {1, 0}},
              {"elbow", JointType::Revolute, {1, n}, {2, n}},
              {"pivot", JointType::Revolute, {}, {2, 0}}};
  m.drives = {{0, 0, TimeFunction::rate(20, 0.05)}};
  return m;
}

/// The same scene, turned and moved by H as a whole.
inline Mechanism moved(Mechanism m, const SE3& H) {
  m.gravity = H.R * m.gravity;
  for (auto& body : m.bodies) {
    body.velocity = H.R * body.velocity;
    body.angular_velocity = H.R * body.angular_velocity;
    if (auto* beam = std::get_if<BeamSpec>(&body.kind))
      for (auto& node : beam->nodes) node = H * node;
    if (auto* rigid = std::get_if<RigidSpec>(&body.kind)) {
      rigid->frame = H * rigid->frame;
      for (auto& [name, point] : rigid->points) point = H * point;
    }
  }
  const auto move_port = [&](Port& p) {
    if (p.body < 0) p.offset = H * p.offset;
  };
  for (auto& j : m.joints) {
    move_port(j.a);
    move_port(j.b);
    j.axis = H.R * j.axis;
    j.axis2 = H.R * j.axis2;
  }
  for (auto& f : m.forces) {
    move_port(f.a);
    move_port(f.b);
  }
  for (auto& l : m.loads)
    if (!l.follower) l.force = H.R * l.force, l.moment = H.R * l.moment;
  return m;
}

/// A frame far from the axes.
inline SE3 oblique() {
  SE3::Tangent h;
  h << 0.7, -1.3, 0.4, 0.9, -0.6, 1.1;
  return SE3::exp(h);
}

}  // namespace liesl::test
