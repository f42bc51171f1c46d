/// @file
/// Sections of beams and outlines of several parts in one study: the shipped four-bar linkage.
#include <gtest/gtest.h>

#include <algorithm>

#include "optim/cycle/derivative_check.hpp"
#include "optim/cycle/motion_cycle.hpp"
#include "optim/problems/mass_problem.hpp"
#include "reference/shipped.hpp"

namespace liesl::test::mixed_study_test {
namespace {

TEST(MixedStudySlow, HasRightDerivatives) {
  const Study study = shipped_study("four_bar_mixed");
  const DerivativeReport report =
      check_study_derivatives<SE2>(study.scene.mechanism, space_of<SE2>(study.scene.mechanism),
                                   study.scene.simulation, study.spec);
  EXPECT_GT(report.checks.size(), 1000u);
  EXPECT_TRUE(report.right) << report.text(5);
}

TEST(MixedStudySlow, MakesBeamAndPlatesLighterTogether) {
  const Study study = shipped_study("four_bar_mixed");
  const Mechanism& mechanism = study.scene.mechanism;
  const Space<SE2> space = space_of<SE2>(mechanism);
  const CycleResult<SE2> r = run_cycle<SE2>(mechanism, space, study.scene.simulation, study.spec);
  EXPECT_EQ(r.status, CycleStatus::Optimal) << r.reason;
  EXPECT_LE(r.worst, 1e-3);
  ASSERT_EQ(r.identity.size(), 3u);
  for (const auto& [body, identity] : r.identity) EXPECT_LE(identity.nonlinear, 1e-8) << body;
  for (const int body : study.spec.mass_of)
    EXPECT_LT(mass_of(r.mechanism, {body}), mass_of(mechanism, {body})) << body;
  // What holds each part up, a limit or a wall, has a price.
  ASSERT_TRUE(r.optimality);
  for (const int body : study.spec.mass_of) {
    const std::string& part = mechanism.bodies[static_cast<std::size_t>(body)].name;
    const auto& prices = r.optimality->prices;
    EXPECT_TRUE(std::any_of(prices.begin(), prices.end(), [&](const LimitPrice& p) {
      return p.name.starts_with(part) && p.price > 0;
    })) << part;
  }
}

/// Without building the parts anew: the mass is that of the mechanism with the design.
TEST(MassLimit, OfBeamAndPlatesFollowsTheDesign) {
  const Study study = shipped_study("four_bar_mixed");
  const Mechanism& mechanism = study.scene.mechanism;
  const Design design(study.spec, mechanism);
  const std::vector<int>& bodies = study.spec.mass_of;
  Eigen::VectorXd x = design.start();
  MassProblem problem(mechanism, design, {{"all", bodies, 0.5}}, x);
  for (int j = 0; j < x.size(); ++j) x[j] += 0.1 * (design.variables()[j].lower - x[j]);
  double f = 1;
  Eigen::VectorXd g(1);
  problem.values(x, f, g);
  EXPECT_EQ(f, 0);
  const double mass = mass_of(design.apply(mechanism, x), bodies);
  EXPECT_LT(mass, 0.99 * mass_of(mechanism, bodies));
  EXPECT_NEAR(g[0], mass / 0.5 - 1, 1e-12);
  const DerivativeReport report = check_derivatives(problem, x, {});  // along all variables
  int checked = 0;
  for (const DerivativeCheck& check : report.checks) {
    if (check.function.starts_with("Hessian")) continue;  // zero: the problem has none
    EXPECT_TRUE(check.right) << report.text();
    ++checked;
  }
  EXPECT_EQ(checked, 2);  // objective and limit
}

}  // namespace
}  // namespace liesl::test::mixed_study_test
