/// @file
/// Error estimates of `liesl run --verify`: orders from three figures, and against converged runs.

#include "apps/tasks/verify.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "apps/input/document.hpp"
#include "apps/input/problem.hpp"
#include "apps/program.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/tasks/run.hpp"

namespace liesl::test {
namespace {

Refinement figures(double order, double C) {
  const auto at = [=](double h) { return 1 + C * std::pow(h, order); };
  return {at(1), at(0.5), at(2)};
}

TEST(ErrorEstimate, TellsTheErrorOfTheGivenFigure) {
  for (const double order : {2.0, 4.0})
    for (const double C : {1e-3, -1e-5}) {
      const ErrorEstimate e = estimate_error(figures(order, C), order, 1e-12);
      EXPECT_NEAR(e.error, std::abs(C), 1e-9 * std::abs(C) + 1e-15);
      EXPECT_NEAR(*e.observed, order, 1e-6);
      EXPECT_TRUE(e.as_expected);
    }
}

TEST(ErrorEstimate, LowerOrderCountsAndIsSaid) {
  const ErrorEstimate e = estimate_error(figures(1, 1e-3), 4, 1e-12);
  EXPECT_NEAR(e.error, 1e-3, 1e-12);
  EXPECT_FALSE(e.as_expected);
  const ErrorEstimate higher = estimate_error(figures(4, 1e-3), 2, 1e-12);
  EXPECT_FALSE(higher.as_expected);
  EXPECT_GE(higher.error, 1e-3) << "a higher order is no promise";
}

TEST(ErrorEstimate, WhatDoesNotConvergeHasTheLargestDifference) {
  const ErrorEstimate e = estimate_error({1, 1.1, 1.08}, 2, 1e-12);
  EXPECT_FALSE(e.as_expected);
  EXPECT_GE(e.error, 0.1);
  EXPECT_FALSE(estimate_error({1, 1.1}, 2, 1e-12).observed);
  EXPECT_FALSE(estimate_error({1, 1 + 1e-13, 1 + 1e-13}, 2, 1e-12).observed) << "rounding";
}

output::RunSummary summary_of(const std::string& file, const std::vector<std::string>& changes,
                              bool verified) {
  const Scene scene = load_scene(file, changes);
  RunOutcome out = run_task(scene, choose_space(scene));
  EXPECT_EQ(out.status, SolveStatus::Converged) << file;
  if (verified) verify({load_document(file).text, file, changes}, scene, out.summary);
  return out.summary;
}

struct Case {
  const char* scene;
  std::vector<std::string> finer;  ///< four times the elements, a quarter of the step
};

/// What is estimated wrongly: the largest position of the slider, 0.45 m at a dead point, is off by
/// 5e-7 m and estimated as 1.3e-8 m.
const std::set<std::string> kWrong = {"slider_crank slider_x"};

/// Against meshes and steps four times as fine: the estimate is right within a factor of 3.
TEST(VerifySlow, TrueErrorIsWithinAFactorOfThree) {
  const std::vector<Case> cases = {
      {"slider_crank",
       {"bodies.crank.beam.elements=32", "bodies.rod.beam.elements=32", "simulation.step=2.5e-5"}},
      {"pendulum", {"bodies.beam.beam.elements=64", "simulation.step=2.5e-4"}},
      {"spin_up", {"bodies.beam.beam.elements=40", "simulation.step=2.5e-3"}},
      {"bend45", {"bodies.beam.beam.elements=32"}}};
  std::set<std::string> wrong;
  int all = 0;
  for (const Case& c : cases) {
    const std::string file = (kData / fmt::format("scenes/{}.toml", c.scene)).string();
    const auto given = summary_of(file, {}, true), fine = summary_of(file, c.finer, false);
    for (size_t i = 0; i < given.responses.size(); ++i) {
      const auto& r = given.responses[i];
      const double error = std::abs(r.max_abs - fine.responses[i].max_abs) * 16 / 15,
                   estimate = r.error_mesh.value_or(0) + r.error_step.value_or(0);
      if (error < 1e-9 * r.max_abs) continue;
      ++all;
      const std::string name = fmt::format("{} {}", c.scene, r.name);
      RecordProperty(fmt::format("{}_{}", c.scene, r.name), fmt::format("{} {}", error, estimate));
      if (error > 3 * estimate || estimate > 3 * error) wrong.insert(name);
      if (kWrong.contains(name)) {
        EXPECT_LT(error, 2e-6 * r.max_abs);
      }
    }
  }
  EXPECT_EQ(wrong, kWrong) << "of " << all;
  EXPECT_GE(all, 6);
}

TEST(Verify, RefusesWhatHasNoResponsesAndNamesWhatItLeavesOut) {
  const std::string file = (kData / "scenes/slider_crank.toml").string();
  const Scene modes = load_scene(file, {"simulation.type=\"modes\""});
  output::RunSummary summary;
  EXPECT_THROW(verify({load_document(file).text, file, {}}, modes, summary), InputError);
}

}  // namespace
}  // namespace liesl::test
