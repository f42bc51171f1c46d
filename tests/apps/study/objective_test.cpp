/// @file
/// Objectives with the mass as a limit: highest first frequency, least largest deflection, several
/// weighted; closed forms and published optima.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "apps/scene/space.hpp"
#include "apps/study/load_study.hpp"
#include "apps/study/scene_file.hpp"
#include "optim/cycle/motion_cycle.hpp"
#include "reference/places.hpp"
#include "reference/shipped.hpp"
#include "reference/svanberg_beam.hpp"

namespace liesl::test::objective_test {
namespace {

struct End {
  CycleStatus status;
  std::string reason;
  Eigen::VectorXd x;
  double mass, worst, objective;
  DynamicOptimality optimality;
  MotionLimits final;
};

template <FrameGroup G>
End optimise_on(const Study& study, const Space<G>& space) {
  const auto r = run_cycle<G>(study.scene.mechanism, space, study.scene.simulation, study.spec);
  return {r.status, r.reason,          r.x,           r.mass,
          r.worst,  r.best->objective, *r.optimality, r.final.front()};
}

End optimise(const std::string& text) {
  const Study study = read_study(text, "study.toml", std::filesystem::path(kDataDir) / "studies");
  const ChosenSpace space = choose_space(study.scene);
  return std::visit([&](const auto& s) { return optimise_on(study, s); }, space.space);
}

/// Widths of Svanberg's cantilever for the least deflection of its tip at his optimal mass.
std::string least_deflection(const std::string& objective) {
  return R"(
scene = "../scenes/svanberg_cantilever.toml"
[design]
widths = { of = "beam", property = ["width", "height"], groups = 5, bounds = [0.01, 0.10] }
[objective]
minimize = "weighted"
of = "beam"
)" + objective +
         "\n[constraints]\nm = { mass = \"beam\", limit = 1.3399563 }\n";
}

/// The dual of the published problem: the lightest beam with 5 mm is the stiffest of its mass.
TEST(Objective, LeastDeflectionOfAMassIsThePublishedOptimum) {
  const End end = optimise(least_deflection("weights = { largest = 200 }\nlargest = \"tip\""));
  ASSERT_EQ(end.status, CycleStatus::Optimal) << end.reason;
  EXPECT_LT(std::abs(end.worst), 1e-5);
  EXPECT_NEAR(end.objective, 1, 2e-4);  // 200/m x 5 mm
  EXPECT_LT(end.optimality.residual->stationarity, kOptimalResidual);
  for (int i = 0; i < 5; ++i)
    EXPECT_NEAR((end.x[i] - 2e-5) / 0.01, SvanbergBeam::solution[i],
                1e-2 * SvanbergBeam::solution[i]);
  // tip ~ mass^-3 for this box: 1 % more mass is 3 % less deflection.
  ASSERT_EQ(end.optimality.prices.size(), 1u);
  EXPECT_NEAR(end.optimality.prices[0].price, 3, 0.1);
}

/// mass/m_1 + tip/5 mm: of sizes s x the optimum s + s^-3 is least at s = 3^(1/4).
TEST(Objective, MassAndDeflectionWeighted) {
  const End end = optimise(least_deflection(
      "weights = { mass = 0.74629299, largest = 200 }\nlargest = \"tip\""));  // 1/1.3399563
  ASSERT_EQ(end.status, CycleStatus::Optimal) << end.reason;
  // The limit on the mass holds s at 1: the optimum without it is heavier.
  EXPECT_LT(std::abs(end.worst), 1e-5);
  EXPECT_NEAR(end.objective, 2, 5e-4);
  ASSERT_EQ(end.optimality.prices.size(), 1u);
  EXPECT_NEAR(end.optimality.prices[0].price, 3 - 1, 0.1);
}

constexpr const char* kBar = R"(
scene = "SCENE"
[design]
h = { of = "b", property = "height", bounds = [0.004, 0.08] }
w = { of = "b", property = "width", bounds = [0.004, 0.08] }
[objective]
minimize = "weighted"
of = "b"
weights = { frequency = 1 }
count = 2
[constraints]
m = { mass = "b", limit = 7.065 }
)";

class HighestFrequency : public testing::Test {
 protected:
  const SceneFile file_{R"(
[materials]
steel = { E = 210e9, nu = 0.3, rho = 7850 }
[sections]
flat = { type = "rectangle", width = 0.04, height = 0.02 }
[bodies]
b = { beam = { from = [0, 0, 0], to = [1, 0, 0], section = "flat", material = "steel", elements = 10, damping = 1e-3 } }
[joints]
clamp = { fixed = ["ground", "b.start"] }
[loads]
f = { at = "b.end", force = [0, 1, 0], scale = { table = [[0, 0], [0.01, 1]] } }
[simulation]
duration = 0.02
step = 1e-3
)"};
  std::string study() const {
    std::string text = kBar;
    return text.replace(text.find("SCENE"), 5, file_.path());
  }
};

/// A cantilever of given mass vibrates fastest with a square section, where the frequencies across
/// both sides are alike: f = 1.8751^2/(2 pi) sqrt(E/(12 rho)) h, h^2 = 7.065 kg/(rho 1 m).
TEST_F(HighestFrequency, OfAMassIsThatOfTheSquareBar) {
  const End end = optimise(study());
  ASSERT_EQ(end.status, CycleStatus::Optimal) << end.reason;
  EXPECT_NEAR(end.x[0], 0.03, 1e-5);
  EXPECT_NEAR(end.x[1], 0.03, 1e-5);
  const double f = std::pow(1.8751041, 2) / (2 * M_PI) * std::sqrt(210e9 / 7850 / 12) * 0.03;
  EXPECT_NEAR(-end.objective / f, 1, 3e-3);  // of ten elements
  EXPECT_NEAR(end.final.frequencies.at(0).value, -end.objective, 1e-9 * f);
  EXPECT_LT(end.optimality.residual->stationarity, 1e-6);  // a kink, and a vertex
  // f ~ sqrt(mass)
  ASSERT_EQ(end.optimality.prices.size(), 1u);
  EXPECT_NEAR(end.optimality.prices[0].price / f, 0.5, 5e-3);
}

}  // namespace
}  // namespace liesl::test::objective_test
