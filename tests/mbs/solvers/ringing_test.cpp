/// @file
/// Multipliers that change sign at every step are told from those that follow a motion.

#include "mbs/solvers/ringing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace liesl::test::ringing_test {
namespace {

/// Forces of a smooth motion at step n, a turn in 100 steps, and a part that alternates.
Eigen::VectorXd forces(int n, double alternating) {
  const double t = 2 * std::numbers::pi * n / 100;
  return Eigen::Vector3d(3 * std::cos(t), 3 * std::sin(t), 4) +
         Eigen::Vector3d(0, 0, n % 2 == 0 ? alternating : -alternating);
}

Ringing watch(int steps, double alternating, double rho = 1) {
  Ringing r;
  for (int n = 0; n < steps; ++n) r.step(forces(n, alternating * std::pow(rho, n)), 1e-3);
  return r;
}

TEST(Ringing, ShareIsThatOfTheAlternatingPart) {
  for (const double share : {0.02, 0.1, 0.5}) {  // of |(3, 4)| = 5
    const auto r = watch(200, 5 * share);
    EXPECT_TRUE(r.lasts()) << share;
    // Of the force at either sign.
    const double a = 5 * share, mean = a / std::hypot(3, 4 + a) / 2 + a / std::hypot(3, 4 - a) / 2;
    EXPECT_NEAR(r.share(), mean, 0.005 * share) << share;
  }
}

TEST(Ringing, SmoothForcesAndFaintOnesDoNot) {
  EXPECT_FALSE(watch(200, 0).lasts());
  EXPECT_FALSE(watch(200, 5 * 0.005).lasts());
  EXPECT_EQ(watch(200, 0).share(), 0);
}

TEST(Ringing, WhatDiesOutInLessThanHalfOfTheStepsDoesNotLast) {
  EXPECT_FALSE(watch(200, 2, 0.9).lasts());
  EXPECT_TRUE(watch(200, 2, 0.99).lasts());
}

TEST(Ringing, ForcesThatJumpOnceOrFlipWithTheMotionDoNot) {
  Ringing jump, slow;
  for (int n = 0; n < 200; ++n) {
    jump.step(forces(n, 0) * (n < 100 ? 1 : -3), 1e-3);
    slow.step(forces(n, 0) * std::cos(0.5 * n), 1e-3);  // a turn in 12 steps
  }
  EXPECT_FALSE(jump.lasts());
  EXPECT_FALSE(slow.lasts());
}

TEST(Ringing, StepsOfAnotherSizeAreNotCompared) {
  Ringing r;
  for (int n = 0; n < 200; ++n) r.step(forces(n, 2), n % 3 == 0 ? 1e-3 : 5e-4);
  EXPECT_FALSE(r.lasts());
}

/// The equation behind calm_rho: at its answer the part falls below a hundredth in half of the
/// steps.
TEST(Ringing, CalmRhoIsTheLargestThatCalms) {
  for (const int steps : {50, 200, 1000}) {
    const auto r = watch(steps, 2);
    const double rho = r.calm_rho(), half = 0.5 * steps;
    const auto left = [&](double x) { return r.share() * half * std::pow(x, half); };
    EXPECT_LE(left(rho), 0.01 * (1 + 1e-12)) << steps;
    EXPECT_GT(left(rho + 0.01), 0.01) << steps;
  }
}

}  // namespace
}  // namespace liesl::test::ringing_test
