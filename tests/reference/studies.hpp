#pragma once
/// @file
/// Shipped studies built by the API of the libraries, for tests that read no files. Equality with
/// the files: tests/apps/study/shipped_study_test.cpp.

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "mbs/motion.hpp"
#include "optim/study/study.hpp"

namespace liesl::test {

/// A mechanism, how it moves, and what to change and to limit of it.
struct StudyCase {
  struct {
    Mechanism mechanism;
    SimulationOptions simulation;
  } scene;
  StudySpec spec;
};

using Change = std::function<void(StudyCase&)>;

/// Stiffness of the first spring as a variable.
inline ConstantSpec spring_stiffness(const std::string& name, double lower, double upper) {
  ConstantSpec spring;
  spring.name = name;
  spring.force = 0;
  spring.lower = lower;
  spring.upper = upper;
  return spring;
}

// Changes that several tests make.
inline Change start(std::vector<double> values) {
  return [values](StudyCase& s) { s.spec.design[0].start = values; };
}
inline Change start(double value) { return start(std::vector<double>{value}); }
inline Change limit(double value) {
  return [value](StudyCase& s) { s.spec.constraints[0].limit = value; };
}
inline Change duration(double seconds) {
  return [seconds](StudyCase& s) { s.scene.simulation.duration = seconds; };
}
inline Change tolerance(double relative) {
  return [relative](StudyCase& s) { s.scene.simulation.tolerance = relative; };
}
inline Change groups(int n) {
  return [n](StudyCase& s) { s.spec.design[0].groups = n; };
}
/// Of the motor of the slider-crank, rad/s.
inline Change motor(double rate) {
  return
      [rate](StudyCase& s) { s.scene.mechanism.drives[0].motion = TimeFunction::rate(rate, 0.04); };
}
inline Change slider_mass(double kg) {
  return [kg](StudyCase& s) { std::get<RigidSpec>(s.scene.mechanism.bodies[2].kind).mass = kg; };
}

inline StudyCase changed(StudyCase study, const std::vector<Change>& changes) {
  for (const Change& change : changes) change(study);
  return study;
}

/// data/studies/slider_crank_rod.toml
inline StudyCase slider_crank_rod(const std::vector<Change>& changes = {}, int elements = 8) {
  StudyCase s;
  s.scene.mechanism = slider_crank({.elements = elements});
  if (elements != 8)
    std::get<BeamSpec>(s.scene.mechanism.bodies[0].kind) =
        std::get<BeamSpec>(slider_crank().bodies[0].kind);
  s.scene.mechanism.joints[1].a.node = 8;
  s.scene.mechanism.gravity = {0, -9.81, 0};
  s.scene.simulation.duration = 0.12;
  s.scene.simulation.step = 1e-4;
  s.spec.name = "slider-crank, rod";
  s.spec.design = {{"rod_diameters", {1}, {"diameter"}, 4, 0.004, 0.020, {0.01138}}};
  s.spec.mass_of = {1};
  ResponseSpec bending;
  bending.name = "bending";
  bending.kind = ResponseKind::Deflection;
  bending.body = 1;
  s.spec.constraints = {{bending, 1e-3}};
  s.spec.supports[1] = {"start:xyz,rx", "end:yz"};
  s.spec.cycle.max = 60;
  return changed(std::move(s), changes);
}

/// data/scenes/svanberg_cantilever.toml
inline Mechanism svanberg_cantilever_beam() {
  Section wall;
  wall.shape = Box{0.05002, 0.05002, 2e-5};
  wall.shear_factor = {20, 20};
  Mechanism m;
  m.bodies = {
      {"beam", straight_beam({0, 0, 0}, {5, 0, 0}, 100, wall, {"scaled", 210e9, 0.3, 78000})}};
  m.joints = {{"clamp", JointType::Fixed, {}, {0, 0}}};
  LoadSpec tip;
  tip.name = "tip_force";
  tip.port = {0, 100};
  tip.force = {0, -0.042, 0};
  m.loads = {tip};
  return m;
}

/// data/studies/svanberg_cantilever.toml
inline StudyCase svanberg_cantilever(const std::vector<Change>& changes = {}) {
  StudyCase s;
  s.scene.mechanism = svanberg_cantilever_beam();
  s.scene.simulation.type = SimulationType::Static;
  s.spec.design = {{"widths", {0}, {"width", "height"}, 5, 0.01, 0.10, {}}};
  s.spec.mass_of = {0};
  ResponseSpec tip;
  tip.name = "tip";
  tip.kind = ResponseKind::Displacement;
  tip.at = {0, 100};
  tip.axis = Vec3::UnitY();
  s.spec.constraints = {{tip, 5e-3}};
  s.spec.supports[0] = {"start"};
  s.spec.cycle.tolerance = 1e-5;
  s.spec.cycle.objective_tolerance = 1e-8;
  s.spec.cycle.feasibility = 1e-6;
  return changed(std::move(s), changes);
}

/// A cantilever of 1 m along x, wider than high, with a small load across; and what its tip does.
inline StudyCase flat_cantilever() {
  Section flat;
  flat.shape = Rectangle{0.04, 0.02};
  StudyCase s;
  Mechanism& m = s.scene.mechanism;
  BeamSpec beam = straight_beam({0, 0, 0}, {1, 0, 0}, 10, flat, steel());
  beam.damping = 1e-3;
  m.bodies = {{"b", beam}};
  m.joints = {{"clamp", JointType::Fixed, {}, {0, 0}}};
  LoadSpec load;
  load.name = "f";
  load.port = {0, 10};
  load.force = {0, 1, 0};
  load.scale = TimeFunction::table({0, 0.01}, {0, 1}, TimeFunction::Interpolation::Linear);
  m.loads = {load};
  s.scene.simulation.duration = 0.02;
  s.scene.simulation.step = 1e-3;
  ResponseSpec tip;
  tip.name = "tip";
  tip.kind = ResponseKind::Displacement;
  tip.at = {0, 10};
  tip.axis = Vec3::UnitY();
  s.spec.constraints = {{tip, 1}};
  return s;
}

namespace detail {

/// Springs between walls and a slider that is driven at 1000 rad/s, after a ramp.
struct DrivenSlider {
  Mechanism mechanism;

  DrivenSlider(const RigidSpec& slider, const std::string& ramp) {
    mechanism.gravity = {0, -9.81, 0};
    mechanism.bodies = {{"slider", slider}};
    mechanism.joints = {{"guide", JointType::Prismatic, {}, {0, 0}, Vec3::UnitX()}};
    LoadSpec drive;
    drive.name = "drive";
    drive.port = {0, 0};
    drive.force = {10, 0, 0};
    drive.scale = TimeFunction::expression("cos(1000*t) * ((t < " + ramp + ") ? t/" + ramp +
                                           " - sin(2*pi*t/" + ramp + ")/(2*pi) : 1)");
    mechanism.loads = {drive};
  }
  /// One element of width 4 mm.
  int bar(const std::string& name, const Vec3& from, const Vec3& to, double height,
          const Material& material) {
    Section section;
    section.shape = Rectangle{0.004, height};
    mechanism.bodies.push_back({name, straight_beam(from, to, 1, section, material)});
    return static_cast<int>(mechanism.bodies.size()) - 1;
  }
  void fix(const Port& a, const Port& b) {
    mechanism.joints.push_back(
        {"fixed" + std::to_string(mechanism.joints.size()), JointType::Fixed, a, b});
  }
  StudyCase study(int spring, double seconds) const {
    StudyCase s;
    s.scene.mechanism = mechanism;
    s.scene.simulation.duration = seconds;
    s.scene.simulation.step = 4e-5;
    ResponseSpec travel;
    travel.name = "travel";
    travel.kind = ResponseKind::Elongation;
    travel.body = spring;
    travel.at = {spring, 0};
    travel.to = {spring, 1};
    s.spec.constraints = {{travel, 1e-5}};
    s.spec.cycle.method = CycleMethod::Esl;
    return s;
  }
};

}  // namespace detail

/// data/stability/studies/esl_oscillates.toml: a mass on a spring.
inline StudyCase esl_oscillates() {
  detail::DrivenSlider slider(block({1, 0, 0}, 1.5, 1e-3), "0.2");
  const int spring = slider.bar("spring", {0, 0, 0}, {1, 0, 0}, 0.010, {"stiff", 100e9, 0.3, 4500});
  slider.fix({}, {spring, 0});
  slider.fix({0, 0}, {spring, 1});
  StudyCase s = slider.study(spring, 0.24);
  s.spec.design = {{"x", {spring}, {"width"}, 1, 0.001, 0.010, {}}};
  s.spec.mass_of = {spring};
  s.spec.cycle.max = 100;
  return s;
}

/// data/stability/studies/esl_non_optimal.toml: the example of Stolpe.
inline StudyCase esl_non_optimal() {
  const Vec3 at(1, 0, 0), left(0.9, 0, 0), right(1.1, 0, 0);
  detail::DrivenSlider slider(block(at, 1e-4, 1e-7), "0.4");
  const int first = slider.bar("spring1", {0, 0, 0}, at, 0.010, {"stiff", 100e9, 0.3, 4500}),
            second = slider.bar("spring2", {2, 0, 0}, at, 0.010, {"soft", 90e9, 0.3, 4500}),
            ballast1 = slider.bar("ballast1", left, right, 0.500, steel()),
            ballast2 = slider.bar("ballast2", left, right, 0.05414, steel());
  const Port on_left{0, 0, SE3(Mat3::Identity(), left - at)},
      on_right{0, 0, SE3(Mat3::Identity(), right - at)};
  slider.fix({}, {first, 0});
  slider.fix({}, {second, 0});
  slider.fix({0, 0}, {first, 1});
  slider.fix({0, 0}, {second, 1});
  for (const int ballast : {ballast1, ballast2}) {
    slider.fix(on_left, {ballast, 0});
    slider.fix(on_right, {ballast, 1});
  }
  StudyCase s = slider.study(first, 0.43);
  s.spec.design = {{"x1", {first, ballast1}, {"width"}, 1, 1e-6, 0.010, {}},
                   {"x2", {second, ballast2}, {"width"}, 1, 1e-6, 0.010, {}}};
  s.spec.mass_of = {first, second};
  s.spec.cycle.move_limit = 0.9;
  return s;
}

}  // namespace liesl::test
