/// @file
/// Gradients of a cycle by both forms of the sensitivities.
#include "optim/problems/motion_gradients.hpp"

#include <gtest/gtest.h>

#include "optim/cycle/motion_cycle.hpp"
#include "reference/studies.hpp"

namespace liesl::test::motion_gradients_test {
namespace {

StudyCase many_sections() {
  StudyCase study = slider_crank_rod({duration(0.02), limit(2e-4), groups(24)}, 24);
  study.spec.cycle.method = CycleMethod::Esl1;
  return study;
}

/// Of each maximum and the records beside it the adjoint form has what the direct form has.
TEST(MotionGradients, OfManyVariablesAreThoseOfTheDirectForm) {
  const StudyCase study = many_sections();
  const Space<SE2> space = space_of<SE2>(study.scene.mechanism);
  const DesignSimulator<SE2> simulator(study.scene.mechanism, space, study.scene.simulation,
                                       study.spec);
  Eigen::VectorXd x = simulator.design().start();
  for (int i = 0; i < x.size(); ++i) x[i] *= 1 + 0.01 * i;
  const DesignRun<SE2> run = simulator.run(x);
  ASSERT_TRUE(run.good()) << run.reason();
  LimitedResponse bending{0, study.spec.constraints[0].response};
  const MotionGradients adjoint(simulator.design(), run, x, {bending});
  bending.kept = 0;  // every record: too many for the adjoint form
  const MotionGradients direct(simulator.design(), run, x, {bending});
  ASSERT_TRUE(adjoint.by_adjoint());
  ASSERT_FALSE(direct.by_adjoint());
  int compared = 0, maxima = 0;
  for (int n = 0; n < direct.records(0); ++n) {
    EXPECT_EQ(adjoint.value(0, n), direct.value(0, n));
    const Eigen::VectorXd *a = adjoint.gradient(0, n), *d = direct.gradient(0, n);
    if (n > 0 && n + 1 < direct.records(0) && direct.value(0, n) > direct.value(0, n - 1) &&
        direct.value(0, n) > direct.value(0, n + 1) &&
        direct.value(0, n) > 0.5 * run.limits[0].largest) {
      ++maxima;
      EXPECT_TRUE(a) << "a maximum without gradient";
    }
    if (!a) continue;
    ++compared;
    EXPECT_LT((*a - *d).norm(), 1e-10 * d->norm()) << n;
  }
  EXPECT_GE(maxima, 1);
  EXPECT_GE(compared, 3 * maxima);
  EXPECT_LT(compared, direct.records(0) / 4);
}

/// A cycle of as many sections ends at the optimum that the optimiser of the motion itself finds,
/// whose gradients are of the direct form.
TEST(MotionGradients, ManySectionsEndOptimal) {
  StudyCase study = many_sections();
  const auto optimise = [&](CycleMethod method) {
    study.spec.cycle.method = method;
    return run_cycle<SE2>(study.scene.mechanism, space_of<SE2>(study.scene.mechanism),
                          study.scene.simulation, study.spec);
  };
  const auto r = optimise(CycleMethod::Esl1);
  EXPECT_EQ(r.status, CycleStatus::Optimal) << r.reason;
  EXPECT_LE(r.worst, 1e-4);
  const auto direct = optimise(CycleMethod::Direct);
  EXPECT_EQ(direct.status, CycleStatus::Optimal) << direct.reason;
  EXPECT_NEAR(r.mass, direct.mass, 1e-3 * direct.mass);
}

}  // namespace
}  // namespace liesl::test::motion_gradients_test
