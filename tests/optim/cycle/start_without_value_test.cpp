/// @file
/// Subproblems of a cycle start within their bounds, and what has no value there ends with a
/// reason.
#include <gtest/gtest.h>

#include <limits>

#include "optim/cycle/trust_region_rule.hpp"
#include "tests/optim/cycle/bare_model.hpp"

namespace liesl::test::start_without_value_test {
namespace {

using Eigen::VectorXd;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// minimise x subject to x >= 0.2; a look adds x >= 0.6, which has no value below 0.5.
class Holed final : public StaticProblem {
 public:
  explicit Holed(double start, double lower = 0) : variables_{{"x", lower, 1, start}} {
    add("first");
  }
  int add_violated(const VectorXd&, double) override {
    if (constraints_.size() > 1) return 0;
    add("second");
    return 1;
  }
  int load_cases() const override { return 0; }
  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  void values(const VectorXd& x, double& f, VectorXd& g) override {
    f = x[0];
    g[0] = 0.2 - x[0];
    if (g.size() > 1) g[1] = x[0] < 0.5 ? kNone : 0.6 - x[0];
  }
  void gradients(const VectorXd&, VectorXd& df, RowMatrix& dg) override {
    df.setOnes();
    dg.setConstant(-1);
  }

 private:
  void add(const std::string& name) { constraints_.push_back({constraints_.size(), name, 1}); }
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_;
};

ElasticAnswer solved(StaticProblem& problem) {
  NlpWarmStart warm;
  return solve_elastic(problem, {1, 10}, {}, warm, {});
}

TEST(StartWithoutValue, AddedCasesWithoutOneAtTheAnswerAreMetFromTheStart) {
  Holed problem(0.8);
  const ElasticAnswer answer = solved(problem);
  EXPECT_EQ(answer.reason, "");
  EXPECT_NEAR(answer.x[0], 0.6, 1e-5);
  EXPECT_LT(answer.violation, 1e-5);
}

TEST(StartWithoutValue, IsNamed) {
  Holed problem(0.4);
  problem.add_violated({}, 0);
  EXPECT_NE(solved(problem).reason.find("'second' is"), std::string::npos);
}

/// A study whose surrogates have no value.
class Valueless final : public BareModel {
 public:
  Valueless() : BareModel(0.4) {}
  Surrogate surrogate(const DesignAnalysis&, const VectorXd& x, double, double) const override {
    auto inner = std::make_unique<Holed>(x[0]);
    inner->add_violated(x, 0);
    return {std::make_unique<CorrectedProblem>(std::move(inner), MotionGradients(), x, x[0]), {}};
  }
};

TEST(StartWithoutValue, EndsTheCycleWithAReason) {
  Valueless model;
  const CycleOptions options;
  TrustRegionRule rule(options);
  const LoopResult end = run_loop(model, rule, options, {}, {});
  EXPECT_EQ(end.status, CycleStatus::SimulationFailed);
  EXPECT_NE(end.reason.find("'second' is"), std::string::npos) << end.reason;
  EXPECT_EQ(end.history.size(), 1u);
}

/// Only what is within the bounds of a step has a value: moving asymptotes may be beyond them.
TEST(StartWithoutValue, BeyondTheBoundsIsNotAskedFor) {
  Holed problem(0.4, 0.5);
  problem.add_violated({}, 0);
  const ElasticAnswer answer = solved(problem);
  EXPECT_EQ(answer.reason, "");
  EXPECT_NEAR(answer.x[0], 0.6, 1e-5);
}

}  // namespace
}  // namespace liesl::test::start_without_value_test
