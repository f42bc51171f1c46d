/// @file
/// Optimisers that are given the motion itself, against the cycles that approximate it.
#include "optim/cycle/direct_optimum.hpp"

#include <gtest/gtest.h>

#include "optim/cycle/motion_cycle.hpp"
#include "reference/studies.hpp"

namespace liesl::test::direct_optimum_test {
namespace {

struct DirectRod {
  DirectRod() { study.spec.cycle.method = CycleMethod::Direct; }
  CycleResult<SE2> optimise(const CycleHooks& hooks = {}, const History& resume = {}) const {
    return run_cycle<SE2>(study.scene.mechanism, space_of<SE2>(study.scene.mechanism),
                          study.scene.simulation, study.spec, hooks, resume);
  }
  StudyCase study = slider_crank_rod({duration(0.02), limit(2e-4)});
};

/// One optimum, by trust regions and static images, and by three optimisers on the motion itself.
TEST(DirectOptimum, IsThatOfTheTrustRegion) {
  DirectRod rod;
  rod.study.spec.cycle.method = CycleMethod::Esl1;
  const double mass = rod.optimise().mass;
  rod.study.spec.cycle.method = CycleMethod::Direct;
  for (const Optimizer optimizer : {Optimizer::Ipopt, Optimizer::Mma, Optimizer::Slsqp}) {
    rod.study.spec.cycle.optimizer = optimizer;
    const auto r = rod.optimise();
    EXPECT_EQ(r.status, CycleStatus::Optimal) << static_cast<int>(optimizer) << r.reason;
    EXPECT_NEAR(r.mass, mass, 1e-3 * mass) << static_cast<int>(optimizer);
    EXPECT_LE(r.worst, 1e-4);
    ASSERT_TRUE(r.optimality && r.optimality->residual);
    EXPECT_LE(r.optimality->residual->stationarity, kOptimalResidual);
  }
  rod.study.spec.cycle.optimizer = Optimizer::Ipopt;
  rod.study.spec.cycle.model = NlpModel::Separable;
  const auto by_asymptotes = rod.optimise();
  EXPECT_EQ(by_asymptotes.status, CycleStatus::Optimal) << by_asymptotes.reason;
  EXPECT_NEAR(by_asymptotes.mass, mass, 1e-3 * mass);
}

TEST(DirectOptimum, TreatmentsOfOneConstraint) {
  DirectRod rod;
  const double mass = rod.optimise().mass;
  rod.study.spec.constraints[0].treatment = Treatment::Functional;
  rod.study.spec.cycle.max = 200;  // it has no gradient where the limit holds
  const auto functional = rod.optimise();
  EXPECT_EQ(functional.status, CycleStatus::Optimal) << functional.reason;
  EXPECT_NEAR(functional.mass, mass, 5e-3 * mass) << functional.reason;
  rod.study.spec.constraints[0].treatment = Treatment::PNorm;
  const auto r = rod.optimise();
  EXPECT_EQ(r.status, CycleStatus::Optimal) << r.reason;
  EXPECT_LT(r.mass, mass) << "the root mean square is below the largest";
}

TEST(DirectOptimum, RefusesConstraintsWhoseNumberChanges) {
  for (const Treatment t : {Treatment::Maxima, Treatment::Neighbours, Treatment::Ks}) {
    DirectRod rod;
    rod.study.spec.constraints[0].treatment = t;
    EXPECT_THROW(rod.optimise(), std::invalid_argument);
  }
}

TEST(DirectOptimum, EndsAfterSoManyCycles) {
  DirectRod rod;
  rod.study.spec.cycle.max = 3;
  const auto r = rod.optimise();
  EXPECT_EQ(r.status, CycleStatus::CycleLimit) << r.reason;
  EXPECT_GE(r.history.size(), 3u);
  EXPECT_LE(r.history.size(), 6u) << "a line search may look further";
}

/// Every optimiser ends at the stationary point of the violation that the trust region ends at.
TEST(DirectOptimum, NamesALimitThatCannotBeMet) {
  DirectRod rod;
  rod.study.spec.constraints[0].limit = 1e-5;
  rod.study.spec.cycle.method = CycleMethod::Esl1;
  const auto least = rod.optimise();
  ASSERT_EQ(least.status, CycleStatus::Infeasible) << least.reason;
  rod.study.spec.cycle.method = CycleMethod::Direct;
  for (const Optimizer optimizer : {Optimizer::Ipopt, Optimizer::Mma, Optimizer::Slsqp}) {
    rod.study.spec.cycle.optimizer = optimizer;
    const auto r = rod.optimise();
    EXPECT_EQ(r.status, CycleStatus::Infeasible) << r.reason;
    EXPECT_GT(r.worst, 0.999 * least.worst) << r.reason;
    EXPECT_LT(r.worst, 1.05 * least.worst) << r.reason;
    EXPECT_NE(r.reason.find("'bending' is exceeded by"), std::string::npos) << r.reason;
  }
}

/// From the thinnest rods, where the limit is exceeded several hundred times.
TEST(DirectOptimum, IsReachedFromFarOutsideTheLimits) {
  DirectRod rod;
  const double mass = rod.optimise().mass;
  rod.study.spec.design[0].start = {rod.study.spec.design[0].lower};
  for (const Optimizer optimizer : {Optimizer::Ipopt, Optimizer::Mma, Optimizer::Slsqp}) {
    rod.study.spec.cycle.optimizer = optimizer;
    const auto r = rod.optimise();
    EXPECT_EQ(r.status, CycleStatus::Optimal) << static_cast<int>(optimizer) << r.reason;
    EXPECT_NEAR(r.mass, mass, 1e-3 * mass) << static_cast<int>(optimizer);
  }
}

/// The designs before the interruption are analysed again: the same ones.
TEST(DirectOptimum, ResumedEndsAtTheSameDesign) {
  const DirectRod rod;
  const auto whole = rod.optimise();
  History kept;
  CycleHooks stopping;
  stopping.on_cycle = [&](const History& history) { kept = history; };
  stopping.keep_going = [&] { return kept.size() < 4; };
  const auto part = rod.optimise(stopping);
  EXPECT_EQ(part.status, CycleStatus::Interrupted) << part.reason;
  ASSERT_TRUE(part.model) << "the best design so far";
  ASSERT_TRUE(part.optimality && part.optimality->residual) << "and how far it is from optimal";
  const auto r = rod.optimise({}, kept);
  EXPECT_EQ(r.status, whole.status);
  EXPECT_EQ(r.x, whole.x);
  EXPECT_EQ(r.effort.steps, whole.effort.steps);
}

}  // namespace
}  // namespace liesl::test::direct_optimum_test
