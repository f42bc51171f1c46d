#include "optim/nlp/ipopt_driver.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <set>
#include <vector>

#include "optim/nlp/problems.hpp"
#include "reference/many_load_cases.hpp"
#include "reference/svanberg_beam.hpp"
#include "reference/ten_bar_truss.hpp"

namespace liesl::test::ipopt_driver_test {
namespace {

NlpOptions tight() {
  NlpOptions o;
  o.tolerance = o.feasibility = 1e-10;
  return o;
}

TEST(Ipopt, SvanbergBeamToTheDigitsPublished) {
  for (const HessianShape shape :
       {HessianShape::Diagonal, HessianShape::Dense, HessianShape::None}) {
    SvanbergBeam beam(1, shape);
    const NlpResult r = solve_ipopt(beam, tight());
    ASSERT_EQ(r.status, NlpStatus::Converged) << r.brief();
    EXPECT_NEAR(r.f, SvanbergBeam::optimum, 1e-9);
    for (int j = 0; j < 5; ++j) EXPECT_NEAR(r.x[j], SvanbergBeam::solution[j], 2e-7);
    EXPECT_LE(r.violation, 1e-10);
    EXPECT_LE(r.stationarity, 1e-8);
  }
}

TEST(Ipopt, ScalingMakesUnitsIrrelevant) {
  SvanbergBeam plain, thousandths(1e-3);
  const NlpResult a = solve_ipopt(plain), b = solve_ipopt(thousandths);
  EXPECT_EQ(a.iterations, b.iterations);
  EXPECT_NEAR(a.f, b.f, 1e-12);
  EXPECT_NEAR(a.multipliers.at(7), b.multipliers.at(7), 1e-9);
}

TEST(Ipopt, MultiplierIsTheSensitivityOfTheOptimum) {
  // f ~ (limit)^(-1/3) for the beam: df/d(limit) = -f/3 at limit 1, and lambda = f/3.
  SvanbergBeam beam;
  const NlpResult r = solve_ipopt(beam, tight());
  ASSERT_TRUE(r.has_multipliers);
  EXPECT_NEAR(r.multipliers.at(7), r.f / 3, 1e-7);
}

TEST(Ipopt, TenBarTruss) {
  for (const HessianShape shape : {HessianShape::Dense, HessianShape::None})
    for (const double start : {5.0, 20.0}) {
      TenBarTruss truss(shape, start);
      const NlpResult r = solve_ipopt(truss, tight());
      ASSERT_TRUE(r.solved()) << r.brief();
      EXPECT_NEAR(r.f, TenBarTruss::optimum, 1e-4);
    }
}

TEST(Ipopt, WarmStartNeedsFewerIterations) {
  ManyLoadCases cases(20, 300);
  const NlpResult first = solve_ipopt(cases);
  ASSERT_EQ(first.status, NlpStatus::Converged);

  // The same requirements, and a start 2 % off.
  class Changed : public ManyLoadCases {
   public:
    using ManyLoadCases::ManyLoadCases;
    std::vector<NlpVariable> moved;
    const std::vector<NlpVariable>& variables() const override { return moved; }
  } next(20, 300);
  next.moved = cases.variables();
  for (int j = 0; j < 20; ++j) next.moved[j].start = 1.02 * first.x[j];
  const NlpWarmStart warm = first.warm_start();
  const NlpResult cold = solve_ipopt(next), again = solve_ipopt(next, {}, &warm);
  ASSERT_EQ(again.status, NlpStatus::Converged) << again.brief();
  EXPECT_NEAR(again.f, first.f, 1e-6 * first.f);
  EXPECT_LT(again.iterations, cold.iterations);
  RecordProperty("cold", cold.iterations);
  RecordProperty("warm", again.iterations);
}

/// Whether limits can be met at all is a problem of its own, before (18 times the limit: hopeless)
/// or after (9 times) the first run: a request to stop is heard there, too.
TEST(Ipopt, StopsWhileTheLeastViolationIsSought) {
  for (const double low : {20., 11.}) {
    Lambda p = contradiction(low, 2);
    NlpOptions o;
    int asked = 0, most = 1000;
    o.progress = [&](const NlpProgress&) { return ++asked < most; };
    ASSERT_EQ(solve_ipopt(p, o).status, NlpStatus::Infeasible);
    ASSERT_GT(asked, 5);
    most = low > 11 ? 3 : asked - 1;
    asked = 0;
    const NlpResult r = solve_ipopt(p, o);
    EXPECT_EQ(r.status, NlpStatus::Stopped) << low << ": " << r.brief();
    EXPECT_LE(asked, most + 1);
  }
}

TEST(Ipopt, WarmStartGoesById) {
  Lambda p = contradiction(3, 2);
  const NlpResult first = solve_ipopt(p);
  ASSERT_EQ(first.status, NlpStatus::Converged);
  EXPECT_NEAR(first.multipliers.at(11), 1, 1e-6);
  NlpWarmStart unrelated = first.warm_start();
  unrelated.multipliers = {{999, 5.0}};
  EXPECT_EQ(solve_ipopt(p, {}, &unrelated).status, NlpStatus::Converged);
}

TEST(Ipopt, NeverEvaluatesTwiceAtTheSamePoint) {
  class Watching : public TenBarTruss {
   public:
    std::vector<std::vector<double>> valued, differentiated;
    std::vector<double> latest;
    void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override {
      latest.assign(x.begin(), x.end());
      valued.push_back(latest);
      TenBarTruss::values(x, f, g);
    }
    void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override {
      differentiated.emplace_back(x.begin(), x.end());
      EXPECT_EQ(differentiated.back(), latest) << "gradients away from the latest values";
      TenBarTruss::gradients(x, df, dg);
    }
    void hessian(const Eigen::VectorXd& x, double s, const Eigen::VectorXd& l,
                 Eigen::MatrixXd& h) override {
      EXPECT_EQ(std::vector<double>(x.begin(), x.end()), differentiated.back());
      TenBarTruss::hessian(x, s, l, h);
    }
  } truss;
  const NlpResult r = solve_ipopt(truss);
  EXPECT_EQ(static_cast<int>(truss.valued.size()), r.evaluations);
  const std::set<std::vector<double>> once(truss.valued.begin(), truss.valued.end());
  EXPECT_EQ(once.size(), truss.valued.size());
  const std::set<std::vector<double>> slopes(truss.differentiated.begin(),
                                             truss.differentiated.end());
  EXPECT_EQ(slopes.size(), truss.differentiated.size());
}

TEST(Ipopt, FixedVariablesAndNoConstraints) {
  Lambda p;
  p.v = {{"free", -10, 10, 3}, {"fixed", 2, 2, 2}};
  p.value = [](const Eigen::VectorXd& x, double& f, Eigen::VectorXd&) {
    f = (x[0] - x[1]) * (x[0] - x[1]) + 3 * x[1];
  };
  p.gradient = [](const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix&) {
    df << 2 * (x[0] - x[1]), -2 * (x[0] - x[1]) + 3;
  };
  const NlpResult r = solve_ipopt(p);
  ASSERT_EQ(r.status, NlpStatus::Converged) << r.brief();
  EXPECT_NEAR(r.x[0], 2, 1e-6);
  EXPECT_EQ(r.x[1], 2);
  EXPECT_NEAR(r.lower_multipliers[1], 3, 1e-6);
}

TEST(Ipopt, ManyConstraintsInReasonableTime) {
  for (const HessianShape shape :
       {HessianShape::Dense, HessianShape::Diagonal, HessianShape::None}) {
    ManyLoadCases cases(40, 2000, shape);
    const NlpResult r = solve_ipopt(cases);
    ASSERT_EQ(r.status, NlpStatus::Converged) << r.brief();
    EXPECT_NEAR(r.f, 180.837694, 1e-4);
    EXPECT_LE(r.iterations, 40);
    std::printf("2000 x 40, Hessian %d: %s\n", static_cast<int>(shape), r.brief().c_str());
  }
}

TEST(Ipopt, StartFarFromFeasibleStillFindsTheOptimum) {
  // 1000 times too soft at the start: first the least violation, then the optimum.
  SvanbergBeam beam;
  const NlpResult reference = solve_ipopt(beam);
  struct Far final : SvanbergBeam {
    const std::vector<NlpVariable>& variables() const override { return variables_; }
    const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
    std::vector<NlpVariable> variables_ = SvanbergBeam::variables();
    std::vector<NlpConstraint> constraints_ = {{7, "tip displacement", 1}};
    Far() {
      for (auto& v : variables_) v.start = v.lower = 0.5;
    }
  } far;
  Eigen::VectorXd g(1);
  double f = 0;
  far.values(Eigen::VectorXd::Constant(5, 0.5), f, g);
  ASSERT_GT(g[0], 100);
  const NlpResult r = solve_ipopt(far);
  ASSERT_EQ(r.status, NlpStatus::Converged) << r.brief();
  EXPECT_NEAR(r.f, reference.f, 1e-7 * reference.f);
  EXPECT_LT((r.x - reference.x).norm(), 1e-5 * reference.x.norm());
}

}  // namespace
}  // namespace liesl::test::ipopt_driver_test
