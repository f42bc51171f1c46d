/// @file
/// Sizes of steps: whole steps are met exactly, errors kept, few sizes occur.

#include "mbs/solvers/step_control.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace liesl::test::step_control_test {
namespace {

constexpr double kStep = 1e-2, kLimit = 1e-6;

SimulationOptions options(bool adaptive) {
  SimulationOptions o;
  o.step = kStep;
  o.adaptive = adaptive;
  return o;
}

StepResult failed() { return {}; }
StepResult off_by(double error) {
  StepResult attempt;
  attempt.converged = true;
  attempt.error = error;
  return attempt;
}

/// What steps of a local error c(t) h^3 came to.
struct Walk {
  int steps = 0, refused = 0;
  double largest = 0;  ///< error of an accepted step
  std::set<double> sizes;
};

template <class C>
Walk walk(StepControl& control, long whole_steps, C c) {
  Walk out;
  long last = 0;
  while (control.whole() < whole_steps) {
    const double h = control.h(), error = c(control.time()) * h * h * h;
    if (error > control.error_limit()) {
      ++out.refused;
      EXPECT_TRUE(control.retry(off_by(error)));
      EXPECT_LT(control.h(), h);
      continue;
    }
    ++out.steps;
    out.largest = std::max(out.largest, error);
    out.sizes.insert(h);
    control.advance(error);
    if (const long whole = control.whole(); whole >= 0) {
      EXPECT_EQ(whole, last + 1) << "a whole step was missed";
      EXPECT_EQ(control.time(), kStep * double(whole));
      last = whole;
    }
  }
  return out;
}

TEST(StepControl, KeepsTheErrorWhereItIsSteady) {
  for (const double wanted : {9e-3, 3e-3, 1e-3, 2e-4}) {
    StepControl control(options(true), kLimit);
    const double c = kLimit / std::pow(wanted, 3);
    const Walk w = walk(control, 100, [&](double) { return c; });
    EXPECT_LE(w.largest, kLimit);
    EXPECT_LT(w.steps, 100 * 2 * kStep / wanted) << wanted;  // 0.9 and what sizes there are
    EXPECT_GE(w.steps, 100 * kStep / wanted);
    EXPECT_LE(w.refused, 6);
  }
}

TEST(StepControl, FollowsAnErrorThatVaries) {
  StepControl control(options(true), kLimit);
  const Walk w = walk(control, 100, [](double t) {
    const double wanted = 2e-3 * std::exp(1.5 * std::sin(12 * t));
    return kLimit / std::pow(wanted, 3);
  });
  EXPECT_LE(w.largest, kLimit);
  EXPECT_LT(w.steps, 2 * 823);  // the integral of dt/wanted over 1 s
  EXPECT_LE(w.sizes.size(), 12u);
  EXPECT_LT(w.refused, 40);
}

/// A jump of the error by 10^6 is met by few attempts, and left again.
TEST(StepControl, MeetsAJumpOfTheError) {
  StepControl control(options(true), kLimit);
  const Walk w = walk(control, 20, [](double t) { return t < 0.1 || t > 0.11 ? 0.1 : 1e5; });
  EXPECT_GT(w.refused, 0);
  EXPECT_LE(w.refused, 6);
  EXPECT_LE(w.largest, kLimit);
  EXPECT_EQ(control.h(), kStep);
}

TEST(StepControl, TakesTheSmallestStepWhateverItsError) {
  auto o = options(true);
  o.step_min = kStep / 4;
  StepControl control(o, kLimit);
  while (std::isfinite(control.error_limit())) EXPECT_TRUE(control.retry(off_by(1)));
  EXPECT_FALSE(control.retry(off_by(1)));
  EXPECT_GE(control.h(), o.step_min);
  EXPECT_EQ(control.error_limit(), std::numeric_limits<double>::infinity());
}

TEST(StepControl, StepsThatDoNotConvergeAreHalvedAndDoubleAfterFour) {
  StepControl control(options(false), kLimit);
  EXPECT_EQ(control.error_limit(), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(control.retry(failed()));
  EXPECT_TRUE(control.retry(failed()));
  EXPECT_EQ(control.h(), kStep / 4);
  std::vector<double> sizes;
  for (int i = 0; i < 12; ++i) {
    sizes.push_back(control.h() / kStep);
    control.advance(1);  // errors do not count
  }
  const std::vector<double> expected{0.25, 0.25, 0.25, 0.25, 0.5, 0.5, 0.5, 0.5, 1, 1, 1, 1};
  EXPECT_EQ(sizes, expected);
  int halved = 0;
  while (control.retry(failed())) ++halved;
  EXPECT_EQ(halved, 10);  // down to 1/1024
}

TEST(StepControl, AnAdaptiveStepThatFailedGrowsAfterFour) {
  StepControl control(options(true), kLimit);
  EXPECT_TRUE(control.retry(failed()));
  for (int i = 0; i < 3; ++i) {
    control.advance(0);
    EXPECT_EQ(control.h(), kStep / 2);
  }
  control.advance(0);
  EXPECT_EQ(control.h(), kStep);
}

}  // namespace
}  // namespace liesl::test::step_control_test
