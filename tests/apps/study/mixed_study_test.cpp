/// @file
/// Sections of beams and outlines of several parts in one study: the shipped four-bar linkage.
#include <gtest/gtest.h>

#include "optim/cycle/derivative_check.hpp"
#include "optim/problems/mass_problem.hpp"
#include "reference/shipped.hpp"
#include "reference/solved.hpp"

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
  const nlohmann::json solved = solved_summary("four_bar_mixed");
  const nlohmann::json& identity = solved.at("identity");
  ASSERT_EQ(identity.size(), 3u);
  for (const auto& [body, error] : identity.items())
    EXPECT_LE(error.at("nonlinear").get<double>(), 1e-8) << body;
  const Mechanism design = load_scene(solved_folder("four_bar_mixed") / "design.toml").mechanism;
  ASSERT_EQ(study.spec.mass_of.size(), 3u);
  for (const int body : study.spec.mass_of) {
    const std::string& part = mechanism.bodies[static_cast<std::size_t>(body)].name;
    EXPECT_LT(mass_of(design, {design.body(part)}), mass_of(mechanism, {body})) << part;
    // What holds each part up, a limit or a wall, has a price.
    bool priced = false;
    for (const auto& [name, price] : solved.at("prices").items())
      priced = priced || (name.starts_with(part) && price.get<double>() > 0);
    EXPECT_TRUE(priced) << part;
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
