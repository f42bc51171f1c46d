/// @file
/// Energy: kinetic + elastic + potential - work of the drives drifts with the square of the step.

#include "mbs/run.hpp"

namespace liesl {
namespace {

using testing::options;

/// Work of the drive on coordinate 0 of joint 0 until each record: trapezoidal rule on
/// power = -lambda dq/dt.
template <class G>
double drift(const testing::Run<G>& r, const TimeFunction* drive) {
  const auto& c = r.model->couplings[0];
  int driven = -1;
  if (drive)
    for (int i = 0; i < c.constraints; ++i)
      if (c.equations[std::size_t(i)].coordinate == 0) driven = c.first_constraint + i;
  double work = 0, largest = 0, before = 0;
  const double start = testing::total_energy(r, 0);
  for (int i = 0; i < r.trajectory().size(); ++i) {
    const double t = r.trajectory().time(i);
    const double power = driven < 0 ? 0 : -r.trajectory().lambda(i)[driven] * drive->rate(t);
    if (i > 0) work += 0.5 * (power + before) * (t - r.trajectory().time(i - 1));
    before = power;
    largest = std::max(largest, std::abs(testing::total_energy(r, i) - start - work));
  }
  return largest;
}

void expect_second_order(const Mechanism& m, double duration, double step, double scale) {
  const TimeFunction* drive = m.drives.empty() ? nullptr : &m.drives[0].motion;
  std::vector<double> drifts;
  for (const double h : {step, step / 2, step / 4}) {
    const auto r = testing::run_planar(m, options(duration, h, 1.0, 1e-9));
    ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
    drifts.push_back(drift(r, drive));
  }
  EXPECT_NEAR(std::log2(drifts[0] / drifts[1]), 2, 0.25) << drifts[0] << " " << drifts[1];
  EXPECT_NEAR(std::log2(drifts[1] / drifts[2]), 2, 0.25) << drifts[1] << " " << drifts[2];
  EXPECT_LT(drifts[2], scale);
}

TEST(Energy, RigidPendulum) {
  RigidSpec body = reference::block({0, 0, 0}, 3, 0.05);
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
    const auto r = testing::run_planar(reference::pendulum(n), options(1, 1e-3, 1.0, 1e-9));
    ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
    drifts.push_back(drift(r, nullptr));
  }
  EXPECT_GT(std::log2(drifts[0] / drifts[1]), 1.9) << drifts[0] << " " << drifts[1];
  EXPECT_GT(std::log2(drifts[1] / drifts[2]), 1.9) << drifts[1] << " " << drifts[2];
  EXPECT_LT(drifts[2], 2e-4 * 0.78 * 9.81 * 0.5);
}

TEST(Energy, DrivenSpinUp) {
  auto m = reference::spin_up(4);
  m.drives[0].motion = TimeFunction::rate(2, 5);
  expect_second_order(m, 5, 2e-2, 1e-2);
}

TEST(Energy, DissipatesBelowRhoOne) {
  const auto r = testing::run_planar(reference::pendulum(8), options(2, 1e-3, 0.6));
  EXPECT_LE(testing::total_energy(r, r.last()), testing::total_energy(r, 0) + 1e-9);
}

TEST(Energy, StiffnessProportionalDampingDissipates) {
  auto m = reference::flying_beam(8);
  m.loads[0].scale =
      TimeFunction::table({0, 0.25, 0.5}, {0, 200, 0}, TimeFunction::Interpolation::Linear);
  const auto last_energy = [&](double damping) {
    std::get<BeamSpec>(m.bodies[0].kind).damping = damping;
    const auto r = testing::run_spatial(m, options(5, 5e-3, 1, 1e-9));
    EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
    double before = 1e9;
    for (int i = r.at(0.5, 5e-3); i < r.trajectory().size(); i += 10) {  // free flight
      const double e = testing::total_energy(r, i);
      EXPECT_LT(e, before * (1 + 1e-4)) << r.trajectory().time(i);
      before = e;
    }
    return before;
  };
  const double undamped = last_energy(0), damped = last_energy(0.05);
  EXPECT_LT(damped, 0.99 * undamped);
}

}  // namespace
}  // namespace liesl
