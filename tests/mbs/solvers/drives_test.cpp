/// @file
/// What acts on joint coordinates and between points: drives, springs, dampers, actuators.

#include <functional>

#include "mbs/run.hpp"

namespace liesl::test::drives_test {
namespace {

using test::options;
using test::run_spatial;

/// A block alone singles out no plane: x and y are given.
test::Run<SE2> run_planar(const Mechanism& m, const SimulationOptions& o) {
  return test::run<SE2>(m, {}, o);
}

/// A block on a rail along x, or hinged about z at the origin with its centre 0.4 m away.
Mechanism rail(double mass) {
  Mechanism m;
  m.bodies = {{"block", test::block({0.2, 0, 0}, mass, 0.01)}};
  m.joints = {{"rail", JointType::Prismatic, {}, {0, 0}, Vec3::UnitX()}};
  return m;
}
Mechanism arm() {
  RigidSpec r = test::block({0, 0, 0}, 3, 0.05);
  r.centre = {0.4, 0, 0};
  Mechanism m;
  m.bodies = {{"arm", r}};
  m.joints = {{"hinge", JointType::Revolute, {}, {0, 0}}};
  return m;
}
constexpr double arm_inertia = 0.05 + 3 * 0.16;

using Motion = std::function<double(double)>;

/// Largest deviation of coordinate 0 of joint 0 from a motion.
template <class G>
double deviation(const test::Run<G>& r, const Motion& motion) {
  EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  const int row = test::row_of(*r.model, 0, 0);
  double largest = 0;
  for (int i = 0; i < r.trajectory().size(); ++i)
    largest =
        std::max(largest, std::abs(r.trajectory().rows(i)[row] - motion(r.trajectory().time(i))));
  return largest;
}

/// Both groups give the motion with an error of second order in the step.
void expect_second_order(const Mechanism& m, double duration, double step, const Motion& motion) {
  std::vector<double> planar, spatial;
  for (const double h : {step, step / 2, step / 4}) {
    planar.push_back(deviation(run_planar(m, options(duration, h, 0.8, 1e-9)), motion));
    spatial.push_back(deviation(run_spatial(m, options(duration, h, 0.8, 1e-9)), motion));
  }
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(std::log2(planar[std::size_t(i)] / planar[std::size_t(i) + 1]), 2, 0.1);
    EXPECT_NEAR(std::log2(spatial[std::size_t(i)] / spatial[std::size_t(i) + 1]), 2, 0.1);
  }
  EXPECT_LT(planar[2], 0.01);
}

ForceSpec on_joint(double stiffness, double damping, double rest) {
  ForceSpec f;
  f.name = "spring";
  f.joint = 0;
  f.stiffness = stiffness;
  f.damping = damping;
  f.rest = rest;
  return f;
}

TEST(Drives, AreFollowed) {
  const auto table = TimeFunction::table({0, 0.2, 0.5, 1}, {0, 0.1, -0.05, 0.3},
                                         TimeFunction::Interpolation::Cubic);
  for (const auto& motion :
       {TimeFunction::rate(30, 0.3), table, TimeFunction::expression("0.2*(1-cos(9*t))")}) {
    for (auto m : {rail(2), arm()}) {
      m.drives = {{0, 0, motion}};
      const auto exact = [&](double t) { return motion(t); };
      EXPECT_LT(deviation(run_planar(m, options(1, 1e-3, 0.8, 1e-8)), exact), 1e-10);
      EXPECT_LT(deviation(run_spatial(m, options(1, 1e-3, 0.8, 1e-8)), exact), 1e-10);
    }
  }
}

TEST(Drives, HoldTheAcceleratingForce) {
  auto m = rail(2);
  m.drives = {{0, 0, TimeFunction::expression("1.5*t^2")}};
  const auto r = run_planar(m, options(0.2, 1e-3));
  const auto wrench = test::joint_wrench(*r.model, r.trajectory().frames(r.last()),
                                         r.trajectory().lambda(r.last()), 0);
  EXPECT_NEAR(wrench[0], 2 * 3.0, 1e-4);
}

TEST(Springs, MassOnASpringHasTheExactFrequency) {
  auto m = rail(2);
  m.forces = {on_joint(200, 0, 0.1)};  // omega = 10 rad/s
  expect_second_order(m, 2, 4e-3, [](double t) { return 0.1 * (1 - std::cos(10 * t)); });
}

TEST(Springs, TorsionSpringOnARevolute) {
  auto m = arm();
  m.forces = {on_joint(64 * arm_inertia, 0, 2)};
  expect_second_order(m, 2, 4e-3, [](double t) { return 2 * (1 - std::cos(8 * t)); });
}

TEST(Springs, DampedOscillation) {
  auto m = rail(2);
  m.forces = {on_joint(200, 2 * 2 * 3, 0.1)};  // decay 3 1/s
  const double w = std::sqrt(100 - 9.0);
  expect_second_order(m, 2, 4e-3, [w](double t) {
    return 0.1 - 0.1 * std::exp(-3 * t) * (std::cos(w * t) + 3 / w * std::sin(w * t));
  });
}

TEST(Springs, DamperAlone) {
  auto m = rail(2);
  m.bodies[0].velocity = {1, 0, 0};
  m.forces = {on_joint(0, 10, 0)};
  expect_second_order(m, 1, 1e-2, [](double t) { return (1 - std::exp(-5 * t)) / 5; });
}

TEST(Springs, BetweenTwoPoints) {
  auto m = rail(2);
  ForceSpec f;
  f.name = "spring";
  f.a.offset = SE3(Mat3::Identity(), {-0.1, 0, 0});
  f.b = {0, 0};
  f.stiffness = 200;
  f.rest = 0.35;  // 0.3 long at the start
  m.forces = {f};
  expect_second_order(m, 2, 4e-3, [](double t) { return 0.05 * (1 - std::cos(10 * t)); });
}

TEST(Springs, PointToPointAcrossTheRail) {
  auto m = rail(2);  // spring from (0.2, 0.3) at its rest length: hardening, against Runge-Kutta
  ForceSpec f;
  f.name = "spring";
  f.a.offset = SE3(Mat3::Identity(), {0.2, 0.3, 0});
  f.b = {0, 0};
  f.stiffness = 500;
  f.rest = 0.3;
  m.forces = {f};
  m.bodies[0].velocity = {1.5, 0, 0};
  const auto force = [](double x) {
    const double l = std::hypot(x, 0.3);
    return -500 * (l - 0.3) * x / l / 2;
  };
  std::vector<double> x{0};
  double q = 0, v = 1.5;
  const double h = 1e-4;
  for (int i = 0; i < 10000; ++i) {  // classical fourth order
    const double k1 = force(q), k2 = force(q + h / 2 * v), k3 = force(q + h / 2 * (v + h / 2 * k1)),
                 k4 = force(q + h * (v + h / 2 * k2));
    q += h * v + h * h / 6 * (k1 + k2 + k3);
    v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    x.push_back(q);
  }
  expect_second_order(m, 1, 4e-3, [&](double t) { return x[std::size_t(std::lround(t / h))]; });
}

TEST(Actuators, TorqueOnARevolute) {
  auto m = arm();
  ForceSpec f;
  f.name = "motor";
  f.joint = 0;
  f.force = TimeFunction::constant(2.5);
  m.forces = {f};
  const Motion exact = [](double t) { return 0.5 * 2.5 / arm_inertia * t * t; };
  EXPECT_LT(deviation(run_planar(m, options(1, 1e-2, 0.8, 1e-10)), exact), 1e-7);
  EXPECT_LT(deviation(run_spatial(m, options(1, 1e-2, 0.8, 1e-10)), exact), 1e-7);
}

TEST(Coordinates, CountRotationOverManyTurns) {
  auto m = arm();
  m.bodies[0].angular_velocity = {0, 0, -200};
  const Motion exact = [](double t) { return -200 * t; };
  EXPECT_LT(deviation(run_planar(m, options(2, 5e-3, 0.8, 1e-9)), exact), 1e-6 * 400);
  EXPECT_LT(deviation(run_spatial(m, options(2, 5e-3, 0.8, 1e-9)), exact), 1e-6 * 400);
}

}  // namespace
}  // namespace liesl::test::drives_test
