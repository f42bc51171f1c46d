#pragma once
/// @file
/// Published sensitivities and optima of motions.

#include "mbs/model/mechanism.hpp"
#include "reference/mechanisms.hpp"

namespace liesl::test {

/// Slider-crank with a spring-damper between crank and coupler, of SUNDIALS' examples
/// (idasSlCrank_FSA_dns, after R. Serban): crank of 0.5 m with J = 1 kg m^2 about its pivot;
/// coupler of 2 m whose centre slides, 1 kg, 2 kg m^2; force 1 N on its free end; from rest with
/// the crank upright, 10 s, no gravity. The mass of the coupler is shared with a block in the
/// guide, which moves as its centre does.
struct SundialsSliderCrank {
  static constexpr double kDuration = 10;
  // Integral of the kinetic energy over time, and its derivatives by k and c.
  static constexpr double kG = 3.3366067995, kByStiffness = 0.3334481061,
                          kByDamping = -0.3637540340;

  static Mechanism make(double stiffness = 1, double damping = 1) {
    const double x = std::sqrt(0.75);  // crank upright, half a coupler of 1 m
    const Vec3 pin(0, 0.5, 0), centre(x, 0, 0), free_end = 2 * centre - pin;
    RigidSpec crank = block({0, 0, 0}, 1, 1), coupler = block(centre, 0.5, 2);
    crank.points = {{"pin", pin}};
    Mechanism m;
    m.name = "slider-crank of SUNDIALS";
    m.bodies = {{"crank", crank}, {"coupler", coupler}, {"block", block(centre, 0.5, 1)}};
    const auto at = [](int body, const Vec3& point) {
      return Port{body, 0, SE3(Mat3::Identity(), point)};
    };
    m.joints = {{"pivot", JointType::Revolute, {}, {0, 0}},
                {"pin", JointType::Revolute, at(0, pin), at(1, pin - centre)},
                {"centre", JointType::Revolute, {1, 0}, {2, 0}},
                {"guide", JointType::Prismatic, at(-1, centre), {2, 0}, Vec3::UnitX()}};
    ForceSpec spring;
    spring.name = "spring";
    spring.a = at(0, 0.5 * pin);
    spring.b = at(1, 0.5 * (pin - centre));
    spring.stiffness = stiffness;
    spring.damping = damping;
    spring.rest = 1;
    m.forces = {spring};
    LoadSpec push;
    push.name = "push";
    push.port = at(1, free_end - centre);
    push.force = {1, 0, 0};
    m.loads = {push};
    return m;
  }
};

/// Linear absorber: x'' + c x' + k x = 0, x(0) = 0, x'(0) = 1; the least of the largest |x''| with
/// |x| <= 1 (E. J. Haug, J. S. Arora, Applied Optimal Design, Wiley 1979).
struct LinearAbsorber {
  static constexpr double kStiffness = 0.3607, kDamping = 0.4850, kAcceleration = 0.5206;

  static Mechanism make(double stiffness, double damping) {
    Mechanism m;
    m.name = "linear absorber";
    m.bodies = {{"mass", block({0, 0, 0}, 1, 1)}};
    m.bodies[0].velocity = {1, 0, 0};
    m.joints = {{"guide", JointType::Prismatic, {}, {0, 0}, Vec3::UnitX()}};
    ForceSpec spring;
    spring.name = "spring";
    spring.joint = 0;
    spring.stiffness = stiffness;
    spring.damping = damping;
    m.forces = {spring};
    return m;
  }
};

}  // namespace liesl::test
