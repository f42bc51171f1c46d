/// @file
/// Gears: closed forms of wheels, racks and planets; statics, modes, energy; what contradicts them.

#include "mbs/run.hpp"
#include "mbs/solvers/modes.hpp"
#include "mbs/static_cases.hpp"
#include "mbs/step_tangent.hpp"

namespace liesl::test::gear_test {
namespace {

constexpr double kJ1 = 0.03, kJ2 = 0.2, kTorque = 1.5;

ForceSpec torque_on(int joint, double value) {
  ForceSpec f;
  f.name = "torque";
  f.joint = joint;
  f.force = TimeFunction::constant(value);
  return f;
}

/// Two wheels on the ground, side by side.
Mechanism wheels(double ratio) {
  Mechanism m;
  m.name = "wheels";
  m.bodies = {{"small", block({0, 0, 0}, 1, kJ1)}, {"large", block({0.3, 0, 0}, 4, kJ2)}};
  m.joints = {{"in", JointType::Revolute, {}, {0, 0}}, {"out", JointType::Revolute, {}, {1, 0}}};
  m.gears = {{"mesh", {0, 0}, {1, 0}, ratio}};
  m.forces = {torque_on(0, kTorque)};
  return m;
}

template <class G>
void expect_constant_acceleration(double ratio) {
  const Mechanism m = wheels(ratio);
  const auto r = run<G>(m, space_of<G>(m), options(4, 0.01, 0.8, 1e-10));
  ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  const double rate = kTorque / (kJ1 + ratio * ratio * kJ2);
  const int first = row_of(*r.model, 0, 0), second = row_of(*r.model, 1, 0);
  for (int i = 0; i < r.trajectory().size(); ++i) {
    const double t = r.trajectory().time(i), angle = 0.5 * rate * t * t;
    ASSERT_NEAR(r.trajectory().rows(i)[first], angle, 1e-8 * (1 + angle)) << t;
    ASSERT_NEAR(r.trajectory().rows(i)[second], ratio * angle, 1e-8 * (1 + angle)) << t;
  }
  EXPECT_GT(std::abs(r.trajectory().rows(r.last())[second]), 2 * M_PI) << "whole turns";
  EXPECT_LT(r.report().max_constraint_residual, 1e-9);
}

/// alpha = T / (J1 + r^2 J2), over several turns, either way, in the plane and in space.
TEST(Gear, WheelsTurnTogether) {
  for (const double ratio : {-0.4, 0.4, 2.5, -1.}) {
    SCOPED_TRACE(ratio);
    expect_constant_acceleration<SE2>(ratio);
    expect_constant_acceleration<SE3>(ratio);
  }
}

/// A rack that falls and turns its pinion: a = g / (1 + J / (m R^2)).
TEST(Gear, RackTurnsItsPinion) {
  const double R = 0.05, mass = 2, g = 9.81;
  Mechanism m;
  m.gravity = {0, -g, 0};
  m.bodies = {{"pinion", block({0, 0, 0}, 1, kJ1)}, {"rack", block({R, 0, 0}, mass, 1)}};
  m.joints = {{"axle", JointType::Revolute, {}, {0, 0}},
              {"guide", JointType::Prismatic, {}, {1, 0}, Vec3::UnitY()}};
  m.gears = {{"teeth", {0, 0}, {1, 0}, R}};
  const auto r = run_planar(m, options(1, 0.01, 0.8, 1e-10));
  ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  const double a = g / (1 + kJ1 / (mass * R * R));
  EXPECT_NEAR(r.trajectory().frames(r.last())[1].x.y(), -0.5 * a, 1e-8);
  EXPECT_NEAR(r.trajectory().rows(r.last())[row_of(*r.model, 0, 0)], -0.5 * a / R, 1e-7);
}

/// A planet rolls on a fixed sun: on its carrier it turns by z_s/z_p of the carrier's angle, so the
/// inertia about the axis is J_c + m d^2 + J_p (1 + z_s/z_p)^2. The gear acts on three bodies.
Mechanism planet(double ratio) {
  Mechanism m;
  m.name = "planet";
  const double d = 0.3;
  RigidSpec carrier = block({0, 0, 0}, 1, 0.1);
  carrier.points["pin"] = {d, 0, 0};
  m.bodies = {{"carrier", carrier}, {"planet", block({d, 0, 0}, 2, 0.05)}};
  m.joints = {{"axis", JointType::Revolute, {}, {0, 0}},
              {"pin", JointType::Revolute, *m.port("carrier.pin"), {1, 0}}};
  m.gears = {{"sun", {0, 0}, {1, 0}, ratio}};
  m.forces = {torque_on(0, kTorque)};
  return m;
}

/// Angle of the carrier after a second, relative to the closed form; checks the planet's own turn.
double planet_error(double ratio, Formalism formalism, double step) {
  Mechanism m = planet(ratio);
  m.formalism = formalism;
  const auto r = run_spatial(m, options(1, step, 0.8, 1e-10));
  EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  const double inertia = 0.1 + 2 * 0.3 * 0.3 + 0.05 * (1 + ratio) * (1 + ratio);
  const double carrier = r.trajectory().rows(r.last())[row_of(*r.model, 0, 0)];
  const auto& R = r.trajectory().frames(r.last())[1].R;
  const double off = std::atan2(R(1, 0), R(0, 0)) - (1 + ratio) * carrier;
  EXPECT_NEAR(std::remainder(off, 2 * M_PI), 0, 1e-7);
  return std::abs(carrier / (0.5 * kTorque / inertia) - 1);
}

TEST(Gear, PlanetRollsOnItsSun) {
  for (const double ratio : {1.7, -0.6})
    for (const auto formalism : {Formalism::SE3, Formalism::R3SO3, Formalism::Classical}) {
      const double coarse = planet_error(ratio, formalism, 4e-3),
                   fine = planet_error(ratio, formalism, 2e-3);
      EXPECT_LT(fine, 2e-5) << to_string(formalism);
      EXPECT_NEAR(std::log2(coarse / fine), 2, 0.3) << to_string(formalism);
    }
}

/// Teeth do no work: the energy of a spinning set drifts with the square of the step.
TEST(Gear, KeepsTheEnergy) {
  std::vector<double> drifts;
  for (const double step : {4e-3, 2e-3, 1e-3}) {
    Mechanism m = planet(1.7);
    m.gravity = {0, -9.81, 0};
    m.forces.clear();
    m.bodies[0].angular_velocity = {0, 0, 3};
    m.bodies[1].velocity = {0, 0.9, 0};
    m.bodies[1].angular_velocity = {0, 0, 3 * 2.7};
    const auto r = run_planar(m, options(2, step, 1, 1e-10));
    ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
    double largest = 0;
    for (int i = 0; i < r.trajectory().size(); ++i)
      largest = std::max(largest, std::abs(total_energy(r, i) - total_energy(r, 0)));
    drifts.push_back(largest);
  }
  EXPECT_NEAR(std::log2(drifts[0] / drifts[1]), 2, 0.01);
  EXPECT_NEAR(std::log2(drifts[1] / drifts[2]), 2, 0.01);
}

/// k r^2 q = T; omega^2 = k r^2 / (J1 + r^2 J2).
TEST(Gear, SpringBehindTheGear) {
  const double ratio = -0.4, k = 30;
  Mechanism m = wheels(ratio);
  ForceSpec spring;
  spring.name = "spring";
  spring.joint = 1;
  spring.stiffness = k;
  m.forces.push_back(spring);
  const auto solved = solve(m, tight());
  ASSERT_EQ(solved.result.report.status, SolveStatus::Converged) << solved.result.report.reason;
  const SE3 H = solved.frame(0);
  EXPECT_NEAR(std::atan2(H.R(1, 0), H.R(0, 0)), kTorque / (k * ratio * ratio), 1e-9);
  m.forces = {spring};
  SimulationOptions o = tight();
  o.type = SimulationType::Modes;
  o.modes = 3;
  const auto model = Model<SE3>::build(m, {});
  const auto modes = solve_modes(model, o);
  ASSERT_EQ(modes.omega.size(), 1u);
  EXPECT_NEAR(modes.omega[0], std::sqrt(k * ratio * ratio / (kJ1 + ratio * ratio * kJ2)), 1e-9);
}

/// The derivative of the residual of a step, the force of the gear on three bodies in it.
TEST(Gear, IterationMatrixIsExact) {
  const Mechanism m = planet(1.7);
  const auto o = options(1, 0.01, 0.8, 1e-10);
  const auto plane = Model<SE2>::build(m, space_of<SE2>(m));
  StepTangent<SE2> step(plane, o, 50);
  step.expect_exact("planet", kAllColumns);
  step.expect_transposed("planet");
  const auto model = Model<SE3>::build(m, {});
  StepTangent<SE3> in_space(model, o, 50);
  in_space.expect_exact("planet in space", kAllColumns);
}

/// Both wheels driven: the gear repeats the drives, and is broken by them where they differ.
TEST(Gear, RepeatsDrivesOrIsContradicted) {
  Mechanism m = wheels(-0.5);
  m.forces.clear();
  m.drives = {{0, 0, TimeFunction::rate(2, 0.1)}, {1, 0, TimeFunction::rate(-1, 0.1)}};
  const auto kept = run_planar(m, options(0.5, 0.01));
  EXPECT_EQ(kept.report().status, SolveStatus::Converged) << kept.report().reason;
  ASSERT_FALSE(kept.model->redundant.empty());
  EXPECT_NE(kept.model->redundant[0].find("'mesh'"), std::string::npos);
  m.drives[1].motion = TimeFunction::rate(-1.5, 0.1);
  const auto broken = run_planar(m, options(0.5, 0.01));
  EXPECT_EQ(broken.report().status, SolveStatus::Inconsistent);
  EXPECT_NE(broken.report().reason.find("contradicts"), std::string::npos)
      << broken.report().reason;
}

TEST(Gear, RefusesWhatIsNone) {
  EXPECT_THROW(Model<SE3>::build(wheels(0), {}), std::invalid_argument);
  EXPECT_THROW(Model<SE3>::build(wheels(NAN), {}), std::invalid_argument);
  Mechanism m = wheels(1);
  m.gears[0].second.coordinate = 3;
  EXPECT_THROW(Model<SE3>::build(m, {}), std::invalid_argument);
  m = wheels(1);
  m.joints[1].axis = Vec3::UnitX();  // turns out of the plane of the other
  EXPECT_FALSE(find_plane(m).plane);
}

}  // namespace
}  // namespace liesl::test::gear_test
