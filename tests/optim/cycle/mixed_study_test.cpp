/// @file
/// Sections of beams and outlines of several parts in one study: the shipped four-bar linkage.
#include <gtest/gtest.h>

#include <algorithm>

#include "optim/cycle/derivative_check.hpp"
#include "optim/cycle/motion_cycle.hpp"
#include "reference/shipped.hpp"

namespace liesl {
namespace {

TEST(MixedStudySlow, HasRightDerivatives) {
  const Study study = test::shipped_study("four_bar_mixed");
  const DerivativeReport report = check_study_derivatives<SE2>(
      study.scene.mechanism, test::space_of<SE2>(study.scene.mechanism), study.scene.simulation,
      study.spec);
  EXPECT_GT(report.checks.size(), 1000u);
  EXPECT_TRUE(report.right) << report.text(5);
}

TEST(MixedStudySlow, MakesBeamAndPlatesLighterTogether) {
  const Study study = test::shipped_study("four_bar_mixed");
  const Mechanism& mechanism = study.scene.mechanism;
  const Space<SE2> space = test::space_of<SE2>(mechanism);
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

}  // namespace
}  // namespace liesl
