/// @file
/// Energy: kinetic + elastic + potential - work of the drives drifts with the square of the step.

#include "mbs/run.hpp"
#include "mbs/system/response_value.hpp"

namespace liesl::test::energy_test {
namespace {

using test::options;

/// Work of the drive on coordinate 0 of joint 0 until each record: trapezoidal rule on
/// power = -lambda dq/dt.
template <class G>
double drift(const test::Run<G>& r, const TimeFunction* drive) {
  const auto& c = r.model->couplings[0];
  int driven = -1;
  if (drive)
    for (int i = 0; i < c.constraints; ++i)
      if (c.rows[std::size_t(i)].coordinate == 0) driven = c.first_constraint + i;
  double work = 0, largest = 0, before = 0;
  const double start = test::total_energy(r, 0);
  for (int i = 0; i < r.trajectory().size(); ++i) {
    const double t = r.trajectory().time(i);
    const double power = driven < 0 ? 0 : -r.trajectory().lambda(i)[driven] * drive->rate(t);
    if (i > 0) work += 0.5 * (power + before) * (t - r.trajectory().time(i - 1));
    before = power;
    largest = std::max(largest, std::abs(test::total_energy(r, i) - start - work));
  }
  return largest;
}

void expect_second_order(const Mechanism& m, double duration, double step, double scale) {
  const TimeFunction* drive = m.drives.empty() ? nullptr : &m.drives[0].motion;
  std::vector<double> drifts;
  for (const double h : {step, step / 2, step / 4}) {
    const auto r = test::run_planar(m, options(duration, h, 1.0, 1e-9));
    ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
    drifts.push_back(drift(r, drive));
  }
  EXPECT_NEAR(std::log2(drifts[0] / drifts[1]), 2, 0.01) << drifts[0] << " " << drifts[1];
  EXPECT_NEAR(std::log2(drifts[1] / drifts[2]), 2, 0.01) << drifts[1] << " " << drifts[2];
  EXPECT_LT(drifts[2], scale);
}

TEST(Energy, RigidPendulum) {
  RigidSpec body = test::block({0, 0, 0}, 3, 0.05);
  body.centre = {0.4, 0, 0};
  Mechanism m;
  m.gravity = {0, -9.81, 0};
  m.bodies = {{"arm", body}};
  m.joints = {{"hinge", JointType::Revolute, {}, {0, 0}}};
  expect_second_order(m, 3, 1e-2, 1e-2);
}

/// The weight of a bent element is integrated to second order in its rotation.
TEST(Energy, FlexiblePendulumDriftsWithTheSquareOfTheElementLength) {
  std::vector<double> drifts;
  for (const int n : {4, 8, 16}) {
    const auto r = test::run_planar(test::pendulum(n), options(1, 1e-3, 1.0, 1e-9));
    ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
    drifts.push_back(drift(r, nullptr));
  }
  EXPECT_GT(std::log2(drifts[0] / drifts[1]), 1.9) << drifts[0] << " " << drifts[1];
  EXPECT_GT(std::log2(drifts[1] / drifts[2]), 1.9) << drifts[1] << " " << drifts[2];
  EXPECT_LT(drifts[2], 2e-4 * 0.78 * 9.81 * 0.5);
}

TEST(Energy, DrivenSpinUp) {
  auto m = test::spin_up(4);
  m.drives[0].motion = TimeFunction::rate(2, 5);
  expect_second_order(m, 5, 2e-2, 1e-2);
}

TEST(Energy, DissipatesBelowRhoOne) {
  const auto r = test::run_planar(test::pendulum(8), options(2, 1e-3, 0.6));
  EXPECT_LE(test::total_energy(r, r.last()), test::total_energy(r, 0) + 1e-9);
}

TEST(Energy, StiffnessProportionalDampingDissipates) {
  auto m = test::flying_beam(8);
  m.loads[0].scale =
      TimeFunction::table({0, 0.25, 0.5}, {0, 200, 0}, TimeFunction::Interpolation::Linear);
  const auto last_energy = [&](double damping) {
    std::get<BeamSpec>(m.bodies[0].kind).damping = damping;
    const auto r = test::run_spatial(m, options(5, 5e-3, 1, 1e-9));
    EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
    double before = 1e9;
    for (int i = r.at(0.5, 5e-3); i < r.trajectory().size(); i += 10) {  // free flight
      const double e = test::total_energy(r, i);
      EXPECT_LT(e, before * (1 + 1e-4)) << r.trajectory().time(i);
      before = e;
    }
    return before;
  };
  const double undamped = last_energy(0), damped = last_energy(0.05);
  EXPECT_LT(damped, 0.99 * undamped);
}

/// A mass on a spring, released `stretch` from rest: E = k stretch^2 / 2.
Mechanism oscillator(double m, double k, double c, double stretch) {
  Mechanism oscillator;
  oscillator.bodies = {{"mass", test::block({0, 0, 0}, m, 1)}};
  oscillator.joints = {{"slide", JointType::Prismatic, {}, {0, 0}, Vec3::UnitX()}};
  ForceSpec spring;
  spring.joint = 0;
  spring.stiffness = k;
  spring.damping = c;
  spring.rest = -stretch;
  oscillator.forces = {spring};
  return oscillator;
}

template <class G>
double energy_response(const test::Run<G>& r, const Mechanism& m, int record) {
  ResponseSpec energy;
  energy.kind = ResponseKind::Energy;
  State<G> s = r.model->initial_state();
  r.trajectory().read(record, s);
  return ResponseValues<G>(m, *r.model)(energy, s)[0];
}

/// The whole energy of an oscillator is at times in its spring, and it is a response like others.
TEST(Energy, OfAnOscillatorIsThatOfItsStretchedSpring) {
  const double k = 50, stretch = 0.1, E = 0.5 * k * stretch * stretch;
  const Mechanism m = oscillator(2, k, 0, stretch);
  const auto expect_constant = [&](const auto& r) {
    ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
    double swing = 0;
    for (int i = 0; i <= r.last(); ++i) {
      EXPECT_NEAR(energy_response(r, m, i), E, 1e-9 * E) << r.trajectory().time(i);
      swing = std::max(swing, std::abs(r.trajectory().v(i)[0]));
    }
    EXPECT_NEAR(swing, stretch * std::sqrt(k / 2), 1e-3 * swing) << "all of it was kinetic once";
  };
  expect_constant(test::run<SE2>(m, {}, options(2, 1e-3, 1, 1e-10)));
  expect_constant(test::run_spatial(m, options(2, 1e-3, 1, 1e-10)));
}

/// Closed form of y'' + 2 d y' + w^2 y = 0.
TEST(Energy, OfADampedOscillatorFollowsTheClosedForm) {
  const double mass = 2, k = 50, c = 1.5, y0 = 0.1, end = 1;
  const double d = c / (2 * mass), w = std::sqrt(k / mass - d * d);
  const double y = y0 * std::exp(-d * end) * (std::cos(w * end) + d / w * std::sin(w * end)),
               v = -y0 * std::exp(-d * end) * k / mass / w * std::sin(w * end);
  const Mechanism m = oscillator(mass, k, c, y0);
  std::vector<double> errors;
  for (const double h : {8e-3, 4e-3, 2e-3}) {
    const auto r = test::run<SE2>(m, {}, options(end, h, 1, 1e-11));
    errors.push_back(std::abs(energy_response(r, m, r.last()) - 0.5 * (k * y * y + mass * v * v)));
  }
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.1) << errors[0] << " " << errors[1];
  EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2, 0.1) << errors[1] << " " << errors[2];
}

/// Two masses in a row, one driven, with a spring and a damper between them, an actuator, a load
/// and weight: what goes in is what is there in the end.
Mechanism driven_pair() {
  Mechanism m = oscillator(2, 50, 1.5, 0.1);
  m.gravity = {-9.81, 0, 0};
  m.bodies.push_back({"driven", test::block({0.5, 0.1, 0}, 1, 1)});
  m.joints.push_back({"rail", JointType::Prismatic, {}, {1, 0}, Vec3::UnitX()});
  m.drives = {{1, 0,
               TimeFunction::table({0, 0.5, 1, 2}, {0, 0.02, -0.03, 0.05},
                                   TimeFunction::Interpolation::Cubic)}};
  ForceSpec between, actuator;
  between.a = {0, 0};
  between.b = {1, 0};
  between.stiffness = 80;
  between.damping = 2;
  between.rest = 0.4;
  actuator.joint = 0;
  actuator.force = TimeFunction::table({0, 0.7, 2}, {3, -4, 2}, TimeFunction::Interpolation::Cubic);
  m.forces.push_back(between);
  m.forces.push_back(actuator);
  LoadSpec load;
  load.port = {0, 0};
  load.force = {4, 0, 0};
  load.scale = TimeFunction::table({0, 0.5, 2}, {0, 1, -1}, TimeFunction::Interpolation::Cubic);
  m.loads = {load};
  return m;
}

template <class G>
double imbalance(const test::Run<G>& r) {
  Equations<G> eq(*r.model);
  State<G> s = r.model->initial_state();
  double work = 0, before = 0, start = 0, largest = 0;
  for (int i = 0; i <= r.last(); ++i) {
    r.trajectory().read(i, s);
    const double p = power(*r.model, eq, s), E = total(mechanical_energy(*r.model, s));
    if (i == 0) start = E;
    if (i > 0) work += 0.5 * (p + before) * (s.t - r.trajectory().time(i - 1));
    before = p;
    largest = std::max(largest, std::abs(E - start - work));
  }
  return largest;
}

TEST(Energy, BalancesThePowerOfDrivesLoadsActuatorsAndDampers) {
  const auto expect_balance = [](const auto& run) {
    std::vector<double> errors;
    for (const double h : {4e-3, 2e-3, 1e-3}) {
      const auto r = run(driven_pair(), options(1.5, h, 0.8, 1e-10));
      ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
      errors.push_back(imbalance(r));
    }
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.2) << errors[0] << " " << errors[1];
    EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2, 0.2) << errors[1] << " " << errors[2];
  };
  expect_balance(test::run_planar);
  expect_balance(test::run_spatial);
}

}  // namespace
}  // namespace liesl::test::energy_test
