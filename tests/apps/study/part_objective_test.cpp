/// @file
/// Objectives of a meshed part under fixed loads: largest value, compliance, stress, lowest
/// frequency, several weighted, with the mass as a limit.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "apps/input/problem.hpp"
#include "apps/study/load_study.hpp"
#include "apps/study/scene_file.hpp"
#include "optim/cycle/topology_cycle.hpp"
#include "reference/places.hpp"

namespace liesl::test::part_objective_test {
namespace {

PartEnd optimise(const std::string& text) {
  const Study study = read_study(text, "study.toml", std::filesystem::path(kDataDir) / "studies");
  return optimise_outline(study.spec, study.scene.mechanism, study.spec.shapes.begin()->first);
}

/// A quarter of a plate with a hole under two load cases.
std::string plate(const std::string& objective, double along_x, double along_y,
                  const std::string& second_case) {
  return R"(
scene = "../parts/plate_with_hole.toml"
[set]
"bodies.plate.solid.mesh.cells" = [80, 80]
[design]
a = { of = "plate", parameters = "hole.a", bounds = [0.05, 0.5], start = 0.16 }
b = { of = "plate", parameters = "hole.b", bounds = [0.05, 0.5], start = 0.125 }
[objective]
of = "plate"
)" + objective +
         R"(
[part_limits]
mass = { of = "plate", quantity = "mass", limit = 77.26686 }
[loads]
along_x = { on = "plate.x_max", traction = [)" +
         std::to_string(along_x) + R"(, 0, 0] }
along_y = { on = "plate.y_max", traction = [0, )" +
         std::to_string(along_y) + ", 0], case = \"" + second_case + R"(" }
[supports]
plate = ["x_min:x", "y_min:y"]
[cycle]
move_cells = 3
)";
}

/// Cherepanov's hole: axes as the stresses, 2 : 1; of one case the largest compliance is the mean.
TEST(PartObjective, ComplianceOfOneCaseIsThatOfThePlainObjective) {
  const PartEnd weighted =
      optimise(plate("minimize = \"weighted\"\nweights = { compliance = 1e-3 }", 100e6, 50e6, "1"));
  ASSERT_EQ(weighted.status, CycleStatus::Optimal) << weighted.reason;
  EXPECT_NEAR(weighted.x[0] / weighted.x[1] / 2, 1, 0.05);
  const PartEnd plain = optimise(plate("minimize = \"compliance\"", 100e6, 50e6, "1"));
  ASSERT_EQ(plain.status, CycleStatus::Optimal) << plain.reason;
  EXPECT_NEAR(weighted.final.objective / (1e-3 * plain.final.objective), 1, 1e-5);
}

/// Of two alike cases the largest is least where both are equal: the round hole of the symmetry.
TEST(PartObjective, LargestOfTwoCasesIsLeastWhereBothAreEqual) {
  const PartEnd end =
      optimise(plate("minimize = \"weighted\"\nweights = { compliance = 1e-3 }", 80e6, 80e6, "2"));
  ASSERT_EQ(end.status, CycleStatus::Optimal) << end.reason;
  EXPECT_NEAR(end.x[0] / end.x[1], 1, 1e-3);
  EXPECT_LT(end.optimality->residual->stationarity, 1e-2);
}

/// A cantilever; stiffness in proportion to the fractions of the cells, as that of beams.
class CantileverObjective : public testing::Test {
 protected:
  const SceneFile file_{R"(
[materials]
steel = { E = 210e9, nu = 0.3, rho = 7850 }
[bodies.plate.solid]
mesh = { from = [0, -0.05], to = [0.2, 0.05], cells = [80, 40] }
material = "steel"
thickness = 0.01
ersatz = { exponent = 1 }
[bodies.plate.solid.interfaces]
wall = { set = "x_min" }
tip  = { box = { from = [0.195, -0.005], to = [0.2, 0.005] } }
[bodies.plate.solid.outline]
plate = { type = "rectangle", x = 0.1, width = 0.3, height = 0.09 }
[responses]
sag = { response = "displacement", at = "plate.tip", axis = [0, 1, 0] }
)"};
  std::string cantilever(const std::string& objective, double mass) const;
};

/// Its height, with a limit on the mass.
std::string CantileverObjective::cantilever(const std::string& objective, double mass) const {
  return "scene = \"" + file_.path() + R"("
[design]
height = { of = "plate", parameters = "plate.height", bounds = [0.03, 0.0995], start = 0.0597 }
[objective]
of = "plate"
minimize = "weighted"
)" + objective +
         R"(
[part_limits]
m = { of = "plate", quantity = "mass", limit = )" +
         std::to_string(mass) + R"( }
[loads]
tip = { at = "plate.tip", force = [0, -20e3, 0] }
)";
}

struct Objective1D {
  const char* objective;
  double slope;  ///< d ln(f)/d ln(mass) of a slender bar; this one is a third as high as long
  double within;
};

/// The price of the mass is the objective times its power of the mass, and what another mass
/// changes.
TEST_F(CantileverObjective, PriceOfTheMassIsWhatTheObjectiveGains) {
  for (const Objective1D& tried :
       {Objective1D{"weights = { largest = 1e3 }\nlargest = \"sag\"", -3, 0.3},
        Objective1D{"weights = { stress = 1e-8 }", -2, 2},
        Objective1D{"weights = { frequency = 1e-3 }", 1, 0.45}}) {
    const double mass = 7850 * 0.01 * 0.2 * 0.0587, more = 1.0002;
    const PartEnd end = optimise(cantilever(tried.objective, mass)),
                  heavier = optimise(cantilever(tried.objective, more * mass));
    ASSERT_EQ(end.status, CycleStatus::Optimal) << tried.objective << end.reason;
    ASSERT_EQ(heavier.status, CycleStatus::Optimal) << tried.objective << heavier.reason;
    EXPECT_NEAR(end.final.mass / mass, 1, 1e-3) << tried.objective;
    ASSERT_EQ(end.optimality->prices.size(), 1u) << tried.objective;
    const double f = end.final.objective, gained = heavier.final.objective - f;
    EXPECT_NEAR(-end.optimality->prices[0].price * (more - 1) / gained, 1, 0.03) << tried.objective;
    EXPECT_NEAR(gained / std::abs(f) / (more - 1), std::copysign(1.0, f) * tried.slope,
                tried.within)
        << tried.objective;
  }
}

/// m/m_0 + w u: with u ~ m^-s the optimum has s u = m/m_0 of the weights.
TEST_F(CantileverObjective, MassAndDisplacementWeighted) {
  const PartEnd end =
      optimise(cantilever("weights = { mass = 1, largest = 1000 }\nlargest = \"sag\"", 10));
  ASSERT_EQ(end.status, CycleStatus::Optimal) << end.reason;
  EXPECT_LT(end.optimality->residual->stationarity, 1e-2);
  double sag = 0;
  for (const LimitCheck& l : end.final.limits)
    if (l.name == "sag") sag = l.value;
  EXPECT_NEAR(end.final.objective, end.final.mass + 1000 * sag, 1e-9);
  EXPECT_NEAR(end.final.mass / (1000 * sag), 2.7, 0.3);  // s is 3 less the share of shear
}

TEST_F(CantileverObjective, WhatFixedLoadsDoNotHaveIsRefused) {
  const auto refused = [this](const std::string& objective, const std::string& why) {
    try {
      optimise(cantilever(objective, 1));
      ADD_FAILURE() << "not refused: " << why;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
  };
  refused("weights = { effort = 1 }\neffort = \"sag\"", "fixed loads have no motion");
  refused("weights = { frequency = 1 }\nat = 0.1", "under fixed loads the part is free");
  refused("weights = { mass = 0 }", "all weights are zero");
}

}  // namespace
}  // namespace liesl::test::part_objective_test
