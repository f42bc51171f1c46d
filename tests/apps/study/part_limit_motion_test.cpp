/// @file
/// Limits of a meshed part itself in studies of its motion: natural frequency, mass, stress.
#include <gtest/gtest.h>

#include "apps/study/rod_study.hpp"

namespace liesl::test::part_limit_motion_test {
namespace {

/// @param limit of the part itself, beside that of the elongation
Study rod(const std::string& limit, const std::string& method) {
  return read_rod(rod_text(R"([constraints]
elongation = { response = "elongation", between = ["rod.big_end", "rod.small_end"], limit = 1e-3 }
[part_limits]
own = { of = "rod", )" + limit +
                           R"( }
[cycle]
method = ")" + method + "\"\n"));
}

TEST(PartLimitOfAMotion, FrequencyHoldsTheHeightUp) {
  const auto end = optimise(rod(R"(quantity = "frequency", limit = 3000)", "auto"));
  ASSERT_EQ(end.status, CycleStatus::Optimal) << end.reason;
  ASSERT_EQ(end.final.front().parts.size(), 1u);
  EXPECT_NEAR(end.final.front().parts[0].value.value, 3000, 0.01);
  EXPECT_LT(end.optimality->residual->stationarity, 1e-6);  // a vertex
  ASSERT_EQ(end.optimality->prices.size(), 1u);
  EXPECT_GT(end.optimality->prices[0].price, 0);
  // The frequency of the mesh at the final design, and that it is the limit that decides.
  const Study study = rod(R"(quantity = "frequency", limit = 2900)", "auto");
  const auto lower = optimise(study);
  EXPECT_LT(lower.mass, end.mass);
  const double gain = end.optimality->prices[0].price;  // -dm/d ln f, 1/30 less: linear to 10 %
  EXPECT_NEAR((end.mass - lower.mass) / (gain / 30), 1, 0.1);
}

TEST(PartLimitOfAMotion, MassIsThatOfTheObjective) {
  Study study = rod(R"(quantity = "mass", limit = 1)", "auto");
  study.spec.cycle.max = 1;
  const auto end = optimise(study);
  ASSERT_EQ(end.final.front().parts.size(), 1u);
  EXPECT_NEAR(end.final.front().parts[0].value.value, end.mass, 1e-12);
}

/// The largest value over the motion of the one limit of the part, and its gradient by the height
/// as the surrogate of a trust region has it.
struct Peak {
  double value = 0, slope = 0;
};

Peak peak_at(MotionModel<SE2>& model, double height, bool with_slope) {
  const Eigen::VectorXd x = Eigen::VectorXd::Constant(1, height);
  const auto analysis = model.analyse(x, {});
  EXPECT_TRUE(analysis->good()) << analysis->reason;
  const auto& motion = dynamic_cast<const MotionAnalysis<SE2>&>(*analysis);
  const LimitCheck& found = motion.limits.front().parts.at(0).value;
  Peak out{found.value, 0};
  if (!with_slope) return out;
  const Surrogate surrogate = model.surrogate(*analysis, x, 0.5, 1e-2);
  CorrectedProblem& problem = *surrogate.problem;
  const auto rows = static_cast<Eigen::Index>(problem.constraints().size());
  double f = 0;
  Eigen::VectorXd g(rows), df(1);
  RowMatrix dg(rows, 1);
  problem.values(x, f, g);
  problem.gradients(x, df, dg);
  for (Eigen::Index i = 0; i < rows; ++i)
    if (problem.constraints()[static_cast<std::size_t>(i)].name == "own at " + found.at) {
      EXPECT_NEAR(found.limit * (1 + g[i]) / found.value, 1, 1e-9);
      out.slope = found.limit * dg(i, 0);
    }
  return out;
}

/// Error of the gradient against central differences of whole simulations, relative to v/x.
double slope_error(const std::string& limit, int modes) {
  Study study = rod(limit, "esl1");
  std::get<SolidSpec>(study.scene.mechanism.bodies[2].kind).modes = modes;
  const ChosenSpace space = choose_space(study.scene);
  const std::vector<Scenario<SE2>> motion{
      {study.scene.mechanism, std::get<Space<SE2>>(space.space), study.scene.simulation}};
  MotionModel<SE2> model(motion, study.spec);
  const double height = 0.0412, h = 2e-5;  // away from the lines of the grid
  const Peak peak = peak_at(model, height, true);
  const double by_difference =
      (peak_at(model, height + h, false).value - peak_at(model, height - h, false).value) / (2 * h);
  EXPECT_NE(peak.slope, 0) << limit;
  return std::abs(peak.slope - by_difference) * height / peak.value;
}

TEST(PartLimitOfAMotion, GradientOfTheStressIsThatOfDifferences) {
  EXPECT_LT(slope_error(R"(quantity = "stress", limit = 50e6)", 8), 1e-5);
}

TEST(PartLimitOfAMotion, GradientOfTheComplianceIsThatOfDifferences) {
  EXPECT_LT(slope_error(R"(quantity = "compliance", limit = 1)", 8), 1e-5);
}

TEST(PartLimitOfAMotion, StressEndsAtTheOptimumOfTheMotion) {
  const auto end = optimise(rod(R"(quantity = "stress", limit = 50e6)", "auto"));
  ASSERT_EQ(end.status, CycleStatus::Optimal) << end.reason;
  EXPECT_NEAR(end.final.front().parts[0].value.value / 50e6, 1, 1e-3);
  ASSERT_EQ(end.optimality->prices.size(), 1u);
  EXPECT_EQ(end.optimality->prices[0].name, "own");
  // What the price says, against optima of other limits.
  const auto less = optimise(rod(R"(quantity = "stress", limit = 49.5e6)", "auto")),
             more = optimise(rod(R"(quantity = "stress", limit = 50.5e6)", "auto"));
  EXPECT_NEAR((less.mass - more.mass) / (0.02 * end.optimality->prices[0].price), 1, 0.03);
}

TEST(PartLimitOfAMotion, ThePlainCycleReachesTheSameStressAndItsCertificateSeesIt) {
  const auto end = optimise(rod(R"(quantity = "stress", limit = 50e6)", "esl"));
  ASSERT_EQ(end.status, CycleStatus::Optimal) << end.reason;
  EXPECT_NEAR(end.final.front().parts[0].value.value / 50e6, 1, 1e-3);
  ASSERT_TRUE(end.optimality && end.optimality->residual);
  EXPECT_LT(end.optimality->residual->stationarity, 1e-6);  // one variable, one limit: a vertex
}

TEST(PartLimitOfAMotion, WithoutSensitivitiesThereIsNoCertificate) {
  Study study = rod(R"(quantity = "stress", limit = 50e6)", "esl");
  study.scene.mechanism.penalty.form = ConstraintForm::Augmented;
  auto& joints = study.scene.mechanism.joints;
  joints.push_back(joints.back());  // rows that share their forces
  joints.back().name = "again";
  study.spec.cycle.max = 1;
  const auto end = optimise(study);
  ASSERT_TRUE(end.optimality);
  EXPECT_FALSE(end.optimality->residual);
  EXPECT_FALSE(end.optimality->reason.empty());
}

}  // namespace
}  // namespace liesl::test::part_limit_motion_test
