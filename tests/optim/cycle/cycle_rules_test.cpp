/// @file
/// The rules of the cycle on histories made by hand: secant steps, oscillation, ends.
#include "optim/cycle/cycle_rules.hpp"

#include <gtest/gtest.h>

namespace liesl::test::cycle_rules_test {
namespace {

const std::vector<NlpVariable> kVariable{{"x", 0.1, 10, 1}};

Cycle cycle(double x, double answer, double move = 0.5) {
  Cycle c;
  c.x = Eigen::VectorXd::Constant(1, x);
  c.mass = c.objective = x;
  c.answer = Eigen::VectorXd::Constant(1, answer);
  c.next = c.answer;
  c.move = move;
  c.lower = c.x * (1 - move);
  c.upper = c.x * (1 + move);
  return c;
}

TEST(SecantStep, SolvesALinearMapInOneStep) {
  for (const double slope : {-0.9, -0.3, 0.3, 0.6}) {
    const auto answer = [&](double x) { return 2 + slope * (x - 2); };
    const double first = 2.2, second = answer(first);
    const auto next =
        next_design({cycle(first, answer(first)), cycle(second, answer(second))}, kVariable);
    EXPECT_NEAR(next[0], 2, 1e-12) << slope;
  }
}

TEST(SecantStep, IsNotTakenFromTheFirstCycleNorFromAnswersOnAMoveLimit) {
  EXPECT_EQ(next_design({cycle(2, 2.2)}, kVariable)[0], 2.2);
  const Cycle free = cycle(2, 2.2), cut = cycle(2.2, 3.3), at_bound = cycle(9, 10);
  EXPECT_FALSE(on_move_limit(free, kVariable));
  EXPECT_TRUE(on_move_limit(cut, kVariable));
  EXPECT_FALSE(on_move_limit(at_bound, kVariable)) << "its own bound, not the move's";
  EXPECT_EQ(next_design({free, cut}, kVariable)[0], 3.3);
  EXPECT_EQ(next_design({cycle(1, 1.5), cycle(1.5, 1.7)}, kVariable)[0], 1.7);
  EXPECT_NE(next_design({free, cycle(2.2, 2.25)}, kVariable)[0], 2.25);
}

TEST(SecantStep, StaysWithinTheBounds) {
  const double next = next_design({cycle(6, 8.5), cycle(8.5, 9.9)}, kVariable)[0];
  EXPECT_EQ(next, 10);
}

History masses(const std::vector<double>& values) {
  History h;
  for (const double m : values) h.push_back(cycle(m, m));
  return h;
}

TEST(Oscillation, IsChangesThatAlternateAndDoNotShrink) {
  const CycleOptions o;
  EXPECT_TRUE(oscillates(masses({1, 2, 1, 2}), o));
  EXPECT_TRUE(oscillates(masses({5, 1, 2, 1, 2}), o));
  EXPECT_FALSE(oscillates(masses({1, 2, 1}), o)) << "too short";
  EXPECT_FALSE(oscillates(masses({1, 2, 3, 2}), o));
  EXPECT_FALSE(oscillates(masses({1, 2, 1.4, 1.7}), o)) << "shrinks";
  EXPECT_FALSE(oscillates(masses({1, 1.0002, 1, 1.0002}), o)) << "below the tolerance";
}

TEST(Ends, FixedPointAndStuckDifferByTheLimits) {
  const CycleOptions o;
  Cycle c = cycle(2, 2 * (1 + 0.5e-4));
  c.worst = 0.5e-3;
  ASSERT_TRUE(fixed_point(c, o));
  EXPECT_EQ(fixed_point(c, o)->status, CycleStatus::Converged);
  EXPECT_FALSE(stuck(c, o));
  c.worst = 2e-3;
  EXPECT_FALSE(fixed_point(c, o));
  EXPECT_FALSE(stuck(c, o)) << "it still moves";
  c.next = c.x;
  c.worst_constraint = "bend";
  ASSERT_TRUE(stuck(c, o));
  EXPECT_NE(
      stuck(c, o)->reason.find("'bend' cannot be met within the bounds: it stays 0.2 % above"),
      std::string::npos);
  c.worst = 1e9;
  EXPECT_NE(stuck(c, o)->reason.find("at 1e+09 times its limit"), std::string::npos);
}

TEST(Ends, AgreementNeedsLoadsMassAndLimits) {
  const CycleOptions o;
  History h = masses({1, 1.0005});
  EXPECT_FALSE(agreement(h, o)) << "loads unknown";
  h.back().load_change = 0.5e-3;
  EXPECT_TRUE(agreement(h, o));
  h.back().worst = 2e-3;
  EXPECT_FALSE(agreement(h, o));
  h.back().worst = 0;
  h.back().load_change = 2e-3;
  EXPECT_FALSE(agreement(h, o));
  h.back().load_change = 0.5e-3;
  h.front().objective = 0.99;
  EXPECT_FALSE(agreement(h, o));
}

}  // namespace
}  // namespace liesl::test::cycle_rules_test
