/// What every driver must do alike: find the optimum, name what cannot be met, hand on exceptions,
/// keep NaN inside, refuse nonsense.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "optim/nlp/problems.hpp"
#include "reference/svanberg_beam.hpp"
#include "reference/ten_bar_truss.hpp"
#include "reference/two_springs.hpp"

namespace liesl::test::drivers_test {
namespace {

class EveryDriver : public testing::TestWithParam<Driver> {
 protected:
  NlpResult solve(Problem& p, const NlpOptions& o = moderate()) { return GetParam().second(p, o); }
};

void expect_finite(const NlpResult& r) {
  EXPECT_TRUE(std::isfinite(r.f) && r.x.allFinite() && r.g.allFinite() &&
              std::isfinite(r.violation) && std::isfinite(r.stationarity));
  for (const auto& [id, value] : r.multipliers) EXPECT_TRUE(std::isfinite(value)) << id;
  EXPECT_FALSE(r.reason.empty());
}

TEST_P(EveryDriver, SvanbergBeam) {
  SvanbergBeam beam;
  const NlpResult r = solve(beam);
  ASSERT_TRUE(r.solved()) << r.brief();
  EXPECT_NEAR(r.f, SvanbergBeam::optimum, 1e-6);
  for (int j = 0; j < 5; ++j) EXPECT_NEAR(r.x[j], SvanbergBeam::solution[j], 2e-3);
}

TEST_P(EveryDriver, TenBarTrussGlobalOrKnownLocalOptimum) {
  TenBarTruss truss(HessianShape::Dense, 20);
  const NlpResult r = solve(truss);
  ASSERT_TRUE(r.solved()) << r.brief();
  const double other = 5076.66926;  // the local optimum, found independently by three drivers
  EXPECT_LT(std::min(std::abs(r.f - TenBarTruss::optimum), std::abs(r.f - other)), 0.02) << r.f;
}

TEST_P(EveryDriver, DynamicTwoSprings) {
  TwoSprings springs = TwoSprings::dynamic();
  const NlpResult r = solve(springs);
  ASSERT_TRUE(r.solved()) << r.brief();
  EXPECT_NEAR(r.f, 1.25, 1e-5);
  EXPECT_NEAR(r.x[0], 0, 1e-5);
}

TEST_P(EveryDriver, InfeasibleNamesTheConflict) {
  Lambda p = contradiction(8, 2);  // x1 + x2 >= 8, x1 <= 2, x2 <= 5: short by 1
  const NlpResult r = solve(p);
  ASSERT_EQ(r.status, NlpStatus::Infeasible) << r.brief();
  ASSERT_EQ(r.conflict.size(), 2u) << r.brief();
  for (const auto& c : r.conflict) EXPECT_NEAR(c.g, 0.5, 1e-5);
  EXPECT_NE(r.reason.find("'strong enough'"), std::string::npos) << r.reason;
  EXPECT_NE(r.reason.find("'slim enough'"), std::string::npos);
  EXPECT_NE(r.reason.find("x2 at its upper bound 5"), std::string::npos);
  expect_finite(r);
}

TEST_P(EveryDriver, InfeasibleSingleConstraint) {
  SvanbergBeam beam(1, HessianShape::Diagonal, 0.01);  // all segments at 10 still give 0.125
  const NlpResult r = solve(beam);
  ASSERT_EQ(r.status, NlpStatus::Infeasible) << r.brief();
  ASSERT_EQ(r.conflict.size(), 1u);
  EXPECT_EQ(r.conflict[0].name, "tip displacement");
  EXPECT_EQ(r.conflict[0].id, 7u);
  EXPECT_NEAR(r.conflict[0].g, 0.125 - 0.01, 1e-6);
}

TEST_P(EveryDriver, ExceptionArrivesUnchanged) {
  struct Failure : std::runtime_error {
    using std::runtime_error::runtime_error;
  };
  for (int when = 1; when <= 4; ++when)
    for (const bool in_gradient : {false, true}) {
      SvanbergBeam good;
      Lambda p;
      p.v = good.variables();
      p.c = good.constraints();
      int calls = 0;
      p.value = [&](const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) {
        if (!in_gradient && ++calls == when) throw Failure("out of paper");
        good.values(x, f, g);
      };
      p.gradient = [&](const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) {
        if (in_gradient && ++calls == when) throw Failure("out of paper");
        good.gradients(x, df, dg);
      };
      EXPECT_THROW(solve(p), Failure) << when;
      EXPECT_EQ(calls, when) << "evaluated after the exception";
    }
}

TEST_P(EveryDriver, NanIsAStatusWithAReason) {
  for (const int when : {1, 2, 3}) {
    SvanbergBeam good;
    Lambda p;
    p.v = good.variables();
    p.c = good.constraints();
    int calls = 0;
    p.value = [&](const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) {
      good.values(x, f, g);
      if (++calls >= when) g[0] = std::numeric_limits<double>::quiet_NaN();
    };
    p.gradient = [&](const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) {
      good.gradients(x, df, dg);
    };
    const NlpResult r = solve(p);
    expect_finite(r);
    EXPECT_EQ(r.status, NlpStatus::Stopped) << r.brief();
    EXPECT_NE(r.reason.find("'tip displacement' is nan"), std::string::npos) << r.reason;
    EXPECT_GE(r.failed_evaluations, 1);
    EXPECT_LE(r.evaluations, 100);
  }
}

TEST_P(EveryDriver, NanInAGradientStops) {
  SvanbergBeam good;
  Lambda p;
  p.v = good.variables();
  p.c = good.constraints();
  int calls = 0;
  p.value = [&](const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) { good.values(x, f, g); };
  p.gradient = [&](const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) {
    good.gradients(x, df, dg);
    if (++calls > 2) df[1] = std::numeric_limits<double>::quiet_NaN();
  };
  const NlpResult r = solve(p);
  expect_finite(r);
  EXPECT_EQ(r.status, NlpStatus::Stopped) << r.brief();
  EXPECT_NE(r.reason.find("gradient of the objective"), std::string::npos) << r.reason;
}

TEST_P(EveryDriver, RefusesInconsistentBoundsByName) {
  Lambda p = contradiction(3, 2);
  p.v[0] = {"diameter", 4, 1, 2};
  p.v[1].start = std::numeric_limits<double>::quiet_NaN();
  p.c[1].id = 11;
  try {
    solve(p);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& e) {
    const std::string text = e.what();
    EXPECT_NE(text.find("'diameter'"), std::string::npos) << text;
    EXPECT_NE(text.find("[4, 1]"), std::string::npos);
    EXPECT_NE(text.find("'x2'"), std::string::npos);
    EXPECT_NE(text.find("'slim enough'"), std::string::npos);
  }
}

TEST_P(EveryDriver, RefusesInvalidOptionsListingAll) {
  SvanbergBeam beam;
  NlpOptions o;
  o.tolerance = -1;
  o.max_iterations = 0;
  EXPECT_EQ(o.errors().size(), 2u);
  EXPECT_THROW(solve(beam, o), std::invalid_argument);
}

TEST_P(EveryDriver, StopsOnRequestAndAtLimits) {
  TenBarTruss truss;
  NlpOptions o = moderate();
  o.progress = [](const NlpProgress& p) { return p.iteration < 3; };
  NlpResult r = solve(truss, o);
  EXPECT_EQ(r.status, NlpStatus::Stopped) << r.brief();
  expect_finite(r);
  o = moderate();
  o.max_iterations = 3;
  r = solve(truss, o);
  EXPECT_EQ(r.status, NlpStatus::IterationLimit) << r.brief();
  o = moderate();
  o.time_limit = 1e-9;
  r = solve(truss, o);
  EXPECT_EQ(r.status, NlpStatus::IterationLimit) << r.brief();
  EXPECT_NE(r.reason.find("time"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(All, EveryDriver, testing::ValuesIn(all_drivers()),
                         [](const auto& driver) {
                           std::string name = driver.param.first;
                           std::erase_if(name, [](char c) { return !std::isalnum(c); });
                           return name;
                         });

TEST(IpoptDriver, NestedCallIsRefusedInsteadOfWaitingForEver) {
  SvanbergBeam inner;
  Lambda outer = contradiction(3, 2);
  const auto value = outer.value;
  int calls = 0;
  outer.value = [&](const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) {
    if (++calls > 1) solve_ipopt(inner);
    value(x, f, g);
  };
  EXPECT_THROW(solve_ipopt(outer), std::logic_error);
}

TEST(IpoptDriver, StepsBackFromPointsWithoutAValue) {
  Lambda p;  // min x, value only for x > 1, start 4: full steps leave the domain
  p.v = {{"x", 0, 10, 4}};
  p.value = [](const Eigen::VectorXd& x, double& f, Eigen::VectorXd&) {
    f = x[0] - std::log(x[0] - 1);
  };
  p.gradient = [](const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix&) {
    df[0] = 1 - 1 / (x[0] - 1);
  };
  const NlpResult r = solve_ipopt(p);
  ASSERT_EQ(r.status, NlpStatus::Converged) << r.brief();
  EXPECT_NEAR(r.x[0], 2, 1e-5);
}

}  // namespace
}  // namespace liesl::test::drivers_test
