#include "optim/nlp/kkt.hpp"

#include <gtest/gtest.h>

#include <random>

#include "optim/nlp/ipopt_driver.hpp"
#include "reference/svanberg_beam.hpp"
#include "reference/ten_bar_truss.hpp"
#include "reference/two_springs.hpp"

namespace liesl::test::kkt_test {
namespace {

TEST(Kkt, FixedPointOfTheCycleIsNotOptimalForTheDynamicProblem) {
  const Eigen::Vector2d fixed_point(5, 0), optimum(0, 1.25);
  TwoSprings dynamic = TwoSprings::dynamic(), equivalent = TwoSprings::equivalent_static();

  const KktResidual stands = kkt_residual(equivalent, fixed_point);
  EXPECT_TRUE(stands.holds(1e-12)) << stands.brief();

  const KktResidual wrong = kkt_residual(dynamic, fixed_point);
  EXPECT_FALSE(wrong.holds(0.1));
  // least squares of 1 - 0.2 l, 1 - 0.8 l: l = 1/0.68, residual (0.7059, -0.1765), both rescaled
  // by the same range: no bound helps, x1 should shrink.
  EXPECT_NEAR(wrong.stationarity, 1 - 0.2 / 0.68, 1e-12);
  EXPECT_EQ(wrong.worst_variable, "x1");
  EXPECT_GT(wrong.worst_slope, 0);
  EXPECT_EQ(wrong.feasibility, 0);
  EXPECT_NE(wrong.brief().find("'x1' should shrink"), std::string::npos);

  const KktResidual right = kkt_residual(dynamic, optimum);
  EXPECT_TRUE(right.holds(1e-12)) << right.brief();
  EXPECT_NEAR(right.multipliers.at(1), 1.25, 1e-12);
  EXPECT_NEAR(right.lower_multipliers[0], 0.75, 1e-12);
}

TEST(Kkt, FeasibilityAndInactiveConstraints) {
  TwoSprings dynamic = TwoSprings::dynamic();
  const KktResidual soft = kkt_residual(dynamic, Eigen::Vector2d(1, 0.5));
  // k - m = 0.6; the violation over the largest change of g with a variable over its range of 10.
  EXPECT_NEAR(soft.feasibility, (1 / 0.6 - 1) / (10 * 0.8 / (0.6 * 0.6)), 1e-12);
  EXPECT_EQ(soft.worst_constraint, "displacement");
  const KktResidual stiff = kkt_residual(dynamic, Eigen::Vector2d(5, 5));
  EXPECT_EQ(stiff.active, 0);
  EXPECT_DOUBLE_EQ(stiff.stationarity, 1);  // nothing holds the objective up
}

TEST(Kkt, AgreesWithTheMultipliersOfTheOptimiser) {
  TenBarTruss truss;
  NlpOptions o;
  o.tolerance = 1e-10;
  const NlpResult r = solve_ipopt(truss, o);
  const KktResidual k = kkt_residual(truss, r.x);
  EXPECT_TRUE(k.holds(1e-6)) << k.brief();
  double largest = 0;
  for (const auto& [id, value] : r.multipliers) largest = std::max(largest, value);
  ASSERT_GT(largest, 100) << "lb per unit of a limit: no limit holds the truss up";
  int compared = 0;
  for (const auto& [id, value] : r.multipliers) {
    if (value < 1e-4 * largest) continue;
    ASSERT_TRUE(k.multipliers.count(id)) << id;
    EXPECT_NEAR(k.multipliers.at(id), value, 1e-4 * largest);
    ++compared;
  }
  EXPECT_GE(compared, 2);
}

TEST(Kkt, ResidualDoesNotDependOnUnits) {
  SvanbergBeam plain, thousandths(1e-3);
  const Eigen::VectorXd x = Eigen::VectorXd::Constant(5, 4.6);
  EXPECT_NEAR(kkt_residual(plain, x).stationarity, kkt_residual(thousandths, 1e3 * x).stationarity,
              1e-12);
}

TEST(Kkt, RefusesWrongSize) {
  TwoSprings p = TwoSprings::dynamic();
  EXPECT_THROW(kkt_residual(p, Eigen::Vector3d::Ones()), std::invalid_argument);
  EXPECT_THROW(kkt_residual(p, Eigen::Vector2d::Zero()), std::runtime_error);  // no stiffness
}

TEST(NonnegativeLeastSquares, OptimalityConditionsHoldForRandomProblems) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 50; ++trial) {
    const int rows = 1 + trial % 12, columns = 1 + (7 * trial) % 40;
    const Eigen::MatrixXd a =
        Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
    const Eigen::VectorXd b = Eigen::VectorXd::NullaryExpr(rows, [&] { return normal(random); });
    const Eigen::VectorXd z = nonnegative_least_squares(a, b);
    const Eigen::VectorXd w = a.transpose() * (b - a * z);
    EXPECT_GE(z.minCoeff(), 0);
    EXPECT_LE(w.maxCoeff(), 1e-9);
    EXPECT_LE(z.cwiseProduct(w).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(NonnegativeLeastSquares, RepeatedAndEmptyColumns) {
  Eigen::MatrixXd a(2, 4);
  a << 1, 1, 0, -1, 0, 0, 0, 0;
  const Eigen::VectorXd z = nonnegative_least_squares(a, Eigen::Vector2d(3, 4));
  EXPECT_NEAR((a * z)[0], 3, 1e-12);
  EXPECT_EQ(nonnegative_least_squares(Eigen::MatrixXd(2, 0), Eigen::Vector2d(1, 1)).size(), 0);
}

}  // namespace
}  // namespace liesl::test::kkt_test
