/// @file
/// Characteristics of springs: value, slope and energy.

#include "mbs/model/force_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace liesl::test::force_curve_test {
namespace {

using enum TimeFunction::Interpolation;

ForceCurve bump_stop(TimeFunction::Interpolation how) {
  return {{-0.02, -0.01, 0, 0.01, 0.03}, {-500, -100, 0, 100, 900}, how};
}

TEST(ForceCurve, GoesThroughItsPointsAndOnStraight) {
  for (const auto how : {Linear, Cubic}) {
    const ForceCurve f = bump_stop(how);
    for (std::size_t i = 0; i < f.x().size(); ++i) EXPECT_NEAR(f(f.x()[i]), f.f()[i], 1e-10);
    for (const double over : {0.01, 5.}) {
      EXPECT_NEAR(f(0.03 + over), 900 + f.slope(0.03) * over, 1e-9);
      EXPECT_NEAR(f(-0.02 - over), -500 - f.slope(-0.02) * over, 1e-9);
      EXPECT_EQ(f.slope(0.03 + over), f.slope(0.03));
    }
  }
  EXPECT_NEAR(bump_stop(Linear)(0.015), 300, 1e-10);
  EXPECT_NEAR(bump_stop(Linear).slope(0.2), 40000, 1e-6);
}

/// f = dE/dx and slope = df/dx by differences of order 2, also outside of the table.
TEST(ForceCurve, SlopeAndEnergyBelongToTheForce) {
  const double h = 1e-6;
  for (const auto how : {Linear, Cubic}) {
    const ForceCurve f = bump_stop(how);
    for (const double x : {-0.05, -0.0153, -0.004, 0.0061, 0.0173, 0.029, 0.07}) {
      EXPECT_NEAR((f.energy(x + h) - f.energy(x - h)) / (2 * h), f(x), 1e-5 * 900) << x;
      EXPECT_NEAR((f(x + h) - f(x - h)) / (2 * h), f.slope(x), 1e-3 * 40000) << x;
    }
    EXPECT_EQ(f.energy(0), 0);
  }
  EXPECT_NEAR(bump_stop(Linear).energy(0.03), 0.5 * 0.01 * 100 + 0.02 * 500, 1e-12);
  EXPECT_NEAR(bump_stop(Linear).energy(-0.02), 0.5 * 0.01 * 100 + 0.01 * 300, 1e-12);
}

TEST(ForceCurve, RefusesTablesThatAreNone) {
  EXPECT_THROW(ForceCurve({0, 0}, {1, 2}, Linear), std::invalid_argument);
  EXPECT_THROW(ForceCurve({0}, {1}, Linear), std::invalid_argument);
  EXPECT_THROW(bump_stop(Quintic), std::invalid_argument);
}

}  // namespace
}  // namespace liesl::test::force_curve_test
