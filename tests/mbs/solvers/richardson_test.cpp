/// @file
/// Richardson's estimates against errors that are known, and the plan that they allow.

#include "mbs/solvers/richardson.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace liesl::test::richardson_test {
namespace {

/// Trapezoidal sums of exp on [0, 1] are of order 2 and have a known error.
double trapezoids(int n) {
  double sum = 0.5 * (1 + std::exp(1));
  for (int i = 1; i < n; ++i) sum += std::exp(static_cast<double>(i) / n);
  return sum / n;
}

TEST(Richardson, EstimatesTheErrorOfAKnownLimit) {
  const double exact = std::exp(1) - 1;
  double last = 1;
  for (int n = 4; n <= 64; n *= 2) {
    const double before = trapezoids(n / 2) - trapezoids(n);
    const double difference = trapezoids(n) - trapezoids(2 * n);
    EXPECT_NEAR(observed_order(before, difference), 2, 0.05) << n;
    const double ratio = error_of_finer(difference, before) / (trapezoids(2 * n) - exact);
    EXPECT_LT(std::abs(ratio - 1), 0.02) << n;
    EXPECT_LT(std::abs(ratio - 1), last) << n;
    last = std::abs(ratio - 1) + 1e-6;
  }
}

TEST(Richardson, LowerOrdersCostMoreAndNoneIsNoEstimate) {
  EXPECT_DOUBLE_EQ(error_of_finer(0.03), 0.01);          // order 2: a third
  EXPECT_DOUBLE_EQ(error_of_finer(0.03, 0.06), 0.03);    // order 1: all of it
  EXPECT_DOUBLE_EQ(error_of_finer(0.03, 10.0), 0.01);    // never better than order 2
  EXPECT_TRUE(std::isinf(error_of_finer(0.03, 0.031)));  // nothing converges
  EXPECT_TRUE(std::isinf(error_of_finer(std::numeric_limits<double>::infinity())));
  EXPECT_EQ(error_of_finer(1e-14, 1e-14), 1e-14);  // rounding has no order
}

TEST(Richardson, TheCoarserRunHasTheLargerError) {
  for (const double p : {1.0, 2.0, 4.0})  // R = 1 + h^p, h = 1 and 1/2
    EXPECT_DOUBLE_EQ(error_of_coarser(1 - std::exp2(-p), p), 1.0);
  EXPECT_TRUE(std::isinf(error_of_coarser(std::numeric_limits<double>::infinity(), 2)));
}

/// The plan for two beams of orders p and q against all meshes of a grid.
void expect_cheapest(double p, double q) {
  SCOPED_TRACE(fmt::format("orders {}, {}", p, q));
  const std::vector<MeshError> meshes = {{8, 0.02, 1, 200, p}, {8, 0.001, 1, 200, q}};
  const std::vector<long> counts = divisors(2400);
  const double budget = 0.009, step_error = 0.01;
  const Plan plan = cheapest(counts, 1200, step_error, meshes, 1, budget);
  EXPECT_LE(plan.error, budget);
  const auto cost = [](long steps, int a, int b) {
    return static_cast<double>(steps * (a + b + 1));
  };
  double least = std::numeric_limits<double>::infinity();
  for (const long n : counts)
    for (int a = 1; a <= 60; ++a)
      for (int b = 1; b <= 60; ++b) {
        const double ratio = 1200.0 / static_cast<double>(n);
        if (step_error * ratio * ratio + meshes[0].at(a) + meshes[1].at(b) <= budget)
          least = std::min(least, cost(n, a, b));
      }
  // Elements are rounded up one by one: at most an element a beam too many.
  const double found = cost(plan.steps, plan.elements[0], plan.elements[1]);
  EXPECT_GE(found, least);
  EXPECT_LE(found, least + 2.0 * static_cast<double>(plan.steps));
}

/// Against all meshes of a grid, for beams of orders 2 and 4.
TEST(Richardson, PlanIsTheCheapestWithinTheBudget) {
  const std::vector<std::array<double, 2>> orders = {{2, 2}, {4, 4}, {4, 2}};
  for (const auto& [p, q] : orders) expect_cheapest(p, q);
}

TEST(Richardson, PlanWithAnUnknownErrorIsTheFinest) {
  const double unknown = std::numeric_limits<double>::infinity();
  const Plan plan =
      cheapest({10, 20}, 10, 1e-3, {{4, 1e-3, 1, 32, 4}, {4, unknown, 1, 16}}, 1, 0.1);
  EXPECT_EQ(plan.elements, (std::vector<int>{32, 16}));
}

TEST(Richardson, PlanBeyondReachIsTheFinest) {
  const Plan plan = cheapest({10, 20}, 10, 1.0, {{4, 1.0, 2, 32}}, 1, 1e-9);
  EXPECT_EQ(plan.steps, 20);
  EXPECT_EQ(plan.elements, std::vector<int>{32});
  EXPECT_GT(plan.error, 1e-9);
}

TEST(Richardson, DivisorsAreAscendingAndComplete) {
  EXPECT_EQ(divisors(12), (std::vector<long>{1, 2, 3, 4, 6, 12}));
  EXPECT_EQ(divisors(49), (std::vector<long>{1, 7, 49}));
  EXPECT_EQ(divisors(1), (std::vector<long>{1}));
}

}  // namespace
}  // namespace liesl::test::richardson_test
