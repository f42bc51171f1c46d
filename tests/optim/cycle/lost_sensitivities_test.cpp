/// @file
/// A study whose sensitivities are lost at a later design ends with a status and the reason; one
/// that has none at its first design is refused.
#include <gtest/gtest.h>

#include "optim/cycle/direct_optimum.hpp"
#include "optim/cycle/trust_region_rule.hpp"
#include "tests/optim/cycle/bare_model.hpp"

namespace liesl::test::lost_sensitivities_test {
namespace {

using Eigen::VectorXd;

/// minimise x subject to x >= 0.2
class Line final : public StaticProblem {
 public:
  explicit Line(double start) : variables_{{"x", 0, 1, start}} {}
  int add_violated(const VectorXd&, double) override { return 0; }
  int load_cases() const override { return 0; }
  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  void values(const VectorXd& x, double& f, VectorXd& g) override {
    f = x[0];
    g[0] = 0.2 - x[0];
  }
  void gradients(const VectorXd&, VectorXd& df, RowMatrix& dg) override {
    df.setOnes();
    dg.setConstant(-1);
  }

 private:
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_{{0, "least", 1}};
};

/// That study, with sensitivities where x > 0.5.
class Losing final : public BareModel {
 public:
  explicit Losing(double start) : BareModel(start) {}
  Surrogate surrogate(const DesignAnalysis&, const VectorXd& x, double, double) const override {
    if (x[0] <= 0.5) throw NoSensitivities("nothing moves");
    return {std::make_unique<CorrectedProblem>(std::make_unique<Line>(x[0]), MotionGradients(), x,
                                               x[0]),
            {}};
  }
};

LoopResult by_trust_region(double start, const std::vector<Cycle>& resume = {}) {
  Losing model(start);
  const CycleOptions options;
  TrustRegionRule rule(options);
  return run_loop(model, rule, options, {}, resume);
}

TEST(LostSensitivities, EndTheLoopWithAReason) {
  const LoopResult end = by_trust_region(0.9);
  EXPECT_EQ(end.status, CycleStatus::SimulationFailed);
  EXPECT_NE(end.reason.find("no sensitivities any more after cycle 2: nothing moves; bounds"),
            std::string::npos)
      << end.reason;
  EXPECT_EQ(end.lost, "nothing moves");
  ASSERT_EQ(end.history.size(), 2u);
  EXPECT_EQ(end.history.back().end, CycleStatus::SimulationFailed);
  EXPECT_NEAR(end.x[0], 0.2, 1e-4) << "the design is the best of all";
}

TEST(LostSensitivities, EndAResumedLoopAlike) {
  const LoopResult end = by_trust_region(0.9), again = by_trust_region(0.9, end.history);
  EXPECT_EQ(again.status, CycleStatus::SimulationFailed);
  EXPECT_EQ(again.reason, end.reason);
  EXPECT_EQ(again.x, end.x);
}

TEST(LostSensitivities, OfTheFirstDesignAreARefusal) {
  EXPECT_THROW(by_trust_region(0.4), NoSensitivities);
  Losing model(0.4);
  EXPECT_THROW(optimise_directly(model, {}, {}, {}), NoSensitivities);
}

/// The optimiser itself asks for designs: one without sensitivities has no value to it.
TEST(LostSensitivities, KeepTheOptimiserNearDesignsThatHaveThem) {
  Losing model(0.9);
  const LoopResult end = optimise_directly(model, {}, {}, {});
  EXPECT_GT(end.history.size(), 1u);
  EXPECT_FALSE(closed(end.status));
  EXPECT_FALSE(end.reason.empty());
}

}  // namespace
}  // namespace liesl::test::lost_sensitivities_test
