/// @file
/// Stepping under difficulty: refreshed tangents, halved and adaptive steps, reasons, no NaN.

#include "mbs/run.hpp"

namespace liesl::test::recovery_test {
namespace {

using test::options;

template <class G>
void expect_finite(const test::Run<G>& r) {
  for (int i = 0; i < r.trajectory().size(); ++i) {
    ASSERT_TRUE(r.trajectory().v(i).allFinite()) << i;
    ASSERT_TRUE(r.trajectory().vdot(i).allFinite()) << i;
    ASSERT_TRUE(r.trajectory().lambda(i).allFinite()) << i;
    for (int k = 0; k < r.model->nodes(); ++k)
      ASSERT_TRUE(r.trajectory().frames(i)[k].x.allFinite() &&
                  r.trajectory().frames(i)[k].R.allFinite());
  }
}

/// 6 mm links, slider 0.5 kg, thrown at 150 rad/s: driven past their buckling load.
Mechanism buckling() {
  test::SliderCrank p;
  p.crank = p.rod = 0.006;
  p.slider = 0.5;
  p.ramp = 0;
  return test::slider_crank(p);
}

TEST(Recovery, BucklingLinksAreReported) {
  for (const double h : {1e-4, 2.5e-5}) {
    const auto r = test::run_planar(buckling(), options(0.12, h));
    expect_finite(r);
    EXPECT_GT(r.report().tangent_refreshes, 0);
    if (r.report().status == SolveStatus::Converged) {
      EXPECT_NEAR(r.trajectory().time(r.last()), 0.12, 1e-12);
      if (r.report().rejected_steps > 0) {
        EXPECT_FALSE(r.report().warnings.empty());
      }
    } else {
      EXPECT_EQ(r.report().status, SolveStatus::NotConverged);
      EXPECT_NE(r.report().reason.find("t = "), std::string::npos) << r.report().reason;
    }
  }
}

TEST(Recovery, BucklingLinksInSpace) {
  const auto r = test::run_spatial(buckling(), options(0.06, 1e-4));
  expect_finite(r);
  EXPECT_GT(r.report().tangent_refreshes, 0);
}

/// A soft pendulum in steps that are long for it: the same motion with fewer corrections. What is
/// said to be out of its range are tangents whose corrections stalled, not those renewed.
TEST(Recovery, TangentsAreRenewedWhereStepsTakeManyCorrections) {
  SimulationOptions o = options(1, 5e-3);
  const auto renewed = test::run_spatial(test::pendulum(8), o);
  o.tangent = TangentStrategy::Constant;
  const auto constant = test::run_spatial(test::pendulum(8), o);
  ASSERT_EQ(renewed.report().status, SolveStatus::Converged);
  EXPECT_GT(renewed.report().tangent_renewals, 0);
  EXPECT_EQ(constant.report().tangent_renewals, 0);
  EXPECT_LT(renewed.report().newton_iterations, 0.9 * constant.report().newton_iterations);
  const auto tip = [](const auto& r) {
    return r.trajectory().frames(r.last())[r.model->nodes() - 1].x;
  };
  EXPECT_LT((tip(renewed) - tip(constant)).norm(), 1e-4);
  const std::string stalled =
      std::to_string(renewed.report().tangent_refreshes - renewed.report().tangent_renewals);
  for (const auto& w : renewed.report().warnings)
    if (w.find("constant tangent") != std::string::npos) {
      EXPECT_NE(w.find(" " + stalled + " times"), std::string::npos) << w;
    }
}

TEST(Recovery, FailedStepsAreHalvedAndTheRestOfTheGridIsKept) {
  auto m = test::slider_crank();
  m.drives = {{0, 0, TimeFunction::rate(150, 1e-3)}};  // a jerk that long steps do not follow
  SimulationOptions o = options(0.02, 1e-3);
  o.max_iterations = 5;
  const auto r = test::run_planar(m, o);
  ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  EXPECT_GT(r.report().rejected_steps, 0);
  EXPECT_LT(r.report().smallest_step, 1e-3);
  EXPECT_FALSE(r.report().warnings.empty());
  ASSERT_EQ(r.trajectory().size(), 21);
  for (int i = 0; i < 21; ++i) EXPECT_NEAR(r.trajectory().time(i), 1e-3 * i, 1e-12);
  expect_finite(r);
}

TEST(Recovery, SmallestStepEndsTheRunWithTimeAndReason) {
  SimulationOptions o = options(0.12, 1e-3);
  o.max_iterations = 3;
  o.tolerance = 1e-13;
  o.step_min = 5e-4;
  auto m = test::slider_crank();
  m.drives = {{0, 0, TimeFunction::rate(150, 1e-3)}};
  const auto r = test::run_planar(m, o);
  EXPECT_EQ(r.report().status, SolveStatus::NotConverged);
  EXPECT_NE(r.report().reason.find("smallest step 0.0005 s"), std::string::npos)
      << r.report().reason;
  EXPECT_GE(r.trajectory().size(), 1);
  expect_finite(r);
}

TEST(Recovery, InterruptKeepsTheRecords) {
  auto model = Model<SE2>::build(test::pendulum(4), {});
  const auto r = simulate(model, options(1, 1e-3), [](double t) { return t < 0.1 - 1e-9; });
  EXPECT_EQ(r.report.status, SolveStatus::Interrupted);
  EXPECT_EQ(r.trajectory.size(), 101);
}

TEST(Adaptive, ErrorFollowsTheTolerance) {
  const auto fine = test::run_planar(test::pendulum(8), options(1, 1e-5));
  const auto tip = [](const test::Run<SE2>& r) {
    return Eigen::Vector2d(r.trajectory().frames(r.last())[8].x);
  };
  double before = 1;
  for (const double tolerance : {1e-5, 1e-6, 1e-7}) {
    SimulationOptions o = options(1, 1e-2);
    o.adaptive = true;
    o.error_tolerance = tolerance;
    const auto r = test::run_planar(test::pendulum(8), o);
    ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
    const double error = (tip(r) - tip(fine)).norm();
    EXPECT_LT(error, tolerance * double(r.report().steps));  // local errors add up
    EXPECT_LT(error, before);
    EXPECT_NEAR(r.trajectory().time(r.last()), 1, 1e-12);
    EXPECT_EQ(r.trajectory().size(), 101);
    before = error;
  }
}

/// A pendulum whose weight grows smoothly, hit by a half sine of 5 ms.
Mechanism struck_pendulum() {
  Mechanism m = test::pendulum(8);
  std::get<BeamSpec>(m.bodies[0].kind).damping = 2e-3;
  m.gravity_scale = TimeFunction::table({0, 0.2}, {0, 1}, TimeFunction::Interpolation::Cubic);
  LoadSpec hit;
  hit.name = "hit";
  hit.port = {0, 8};
  hit.force = {0, -20, 0};
  hit.scale = TimeFunction::expression("t > 0.5 && t < 0.505 ? sin(pi*(t - 0.5)/0.005) : 0");
  m.loads = {hit};
  return m;
}

/// Records every 10 ms, steps of at most 2 ms, which see the blow.
test::Run<SE2> struck(double tolerance, double step_min = 0) {
  SimulationOptions o = options(1, 2e-3, 0.8, 1e-8);
  o.output_every = 5;
  o.adaptive = true;
  o.error_tolerance = tolerance;
  o.step_min = step_min;
  return test::run_planar(struck_pendulum(), o);
}

/// Of the second order in the step, whose local error is of the third: tolerance^(2/3).
TEST(Adaptive, ErrorOfAStruckPendulumIsOfTheOrderOfTheTolerance) {
  SimulationOptions o = options(1, 1.25e-5, 0.8, 1e-9);
  o.output_every = 800;
  const auto fine = test::run_planar(struck_pendulum(), o);
  std::vector<double> errors;
  for (const double tolerance : {1e-7, 1e-8, 1e-9, 1e-10}) {
    const auto r = struck(tolerance);
    ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
    double square = 0;
    for (int i = 0; i <= r.last(); ++i)
      square += (r.trajectory().frames(i)[8].x - fine.trajectory().frames(i)[8].x).squaredNorm();
    errors.push_back(std::sqrt(square / (r.last() + 1)));
  }
  const double order = std::log10(errors.front() / errors.back()) / 3;
  EXPECT_NEAR(order, 2. / 3, 0.12);
  RecordProperty("order", std::to_string(order));
}

/// The same of what a rod bends by in a slider-crank, where joints hold: each decade of the
/// tolerance takes its share of the error.
TEST(Adaptive, ErrorOfASliderCranksRodFallsWithTheTolerance) {
  const Mechanism m = test::slider_crank({.elements = 4, .ramp = 0.02});
  const auto bend = [&m](const SimulationOptions& o) {
    const auto r = test::run_planar(m, o);
    EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
    EXPECT_EQ(r.trajectory().size(), 61);
    Eigen::Matrix2Xd out(2, r.trajectory().size());
    for (int i = 0; i < out.cols(); ++i) {
      const SE2* H = r.trajectory().frames(i) + 5;
      out.col(i) = H[2].x - (H[0].x + H[4].x) / 2;
    }
    return out;
  };
  SimulationOptions o = options(0.06, 2e-6, 0.8, 1e-9);
  o.output_every = 500;
  const Eigen::Matrix2Xd fine = bend(o);
  o.step = 1e-3;
  o.output_every = 1;
  o.adaptive = true;
  std::vector<double> errors;
  for (const double tolerance : {1e-6, 1e-7, 1e-8, 1e-9}) {
    o.error_tolerance = tolerance;
    errors.push_back((bend(o) - fine).norm() / fine.norm());
  }
  for (std::size_t i = 1; i < errors.size(); ++i) EXPECT_LT(errors[i], errors[i - 1] / 2) << i;
  const double order = std::log10(errors.front() / errors.back()) / 3;
  EXPECT_NEAR(order, 2. / 3, 0.12);
  RecordProperty("order", std::to_string(order));
}

TEST(Adaptive, StepsThatAreTooLongForABlowAreRefused) {
  const auto r = struck(1e-8);
  ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  EXPECT_GT(r.report().refused_steps, 2);
  EXPECT_LT(r.report().refused_steps, r.report().steps / 10);
  EXPECT_EQ(r.report().rejected_steps, 0);
  EXPECT_EQ(r.report().inexact_steps, 0);
  EXPECT_LT(r.report().smallest_step, 5e-4);
  for (const auto& warning : r.report().warnings)
    EXPECT_EQ(warning.find("tried again"), std::string::npos) << warning;
  ASSERT_EQ(r.trajectory().size(), 101);
  for (int i = 0; i <= r.last(); ++i) EXPECT_EQ(r.trajectory().time(i), 1. / 500 * (5 * i));
  expect_finite(r);
}

TEST(Adaptive, ErrorsThatTheSmallestStepLeavesAreSaid) {
  const auto r = struck(1e-8, 1e-3);
  ASSERT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  EXPECT_GT(r.report().inexact_steps, 0);
  EXPECT_GE(r.report().smallest_step, 1e-3 * (1 - 1e-12));
  const auto& all = r.report().warnings;
  EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const std::string& text) {
    return text.find("simulation.error_tolerance") != std::string::npos;
  }));
}

TEST(Records, OutputEveryKeepsEveryNthStep) {
  SimulationOptions o = options(0.1, 1e-3);
  const auto all = test::run_planar(test::pendulum(4), o);
  o.output_every = 7;
  const auto some = test::run_planar(test::pendulum(4), o);
  ASSERT_EQ(some.trajectory().size(), 2 + 100 / 7);
  EXPECT_NEAR(some.trajectory().time(some.last()), 0.1, 1e-13) << "the end is always kept";
  for (int i = 0; i < some.last(); ++i) {
    EXPECT_NEAR(some.trajectory().time(i), 7e-3 * i, 1e-13);
    EXPECT_EQ(some.trajectory().v(i), all.trajectory().v(7 * i));
  }
}

}  // namespace
}  // namespace liesl::test::recovery_test
