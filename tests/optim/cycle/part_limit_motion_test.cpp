/// @file
/// Limits of a meshed part itself in studies of its motion: natural frequency, mass, stress.
#include <gtest/gtest.h>

#include "apps/input/problem.hpp"
#include "apps/scene/space.hpp"
#include "apps/study/load_study.hpp"
#include "optim/cycle/motion_cycle.hpp"
#include "reference/places.hpp"

namespace liesl::test {
namespace {

/// The height of a connecting rod of few cells, in a short motion.
Study rod(const std::string& limit, const std::string& method) {
  const std::string text = R"(
scene = "connecting_rod.toml"
[set]
"bodies.rod.solid.mesh.cells" = [40, 8]
"simulation.duration" = 0.034
"simulation.step" = 5e-5
[design]
height = { of = "rod", parameters = ["plate.height", "plate.fillet"], factors = [1, 0.5], bounds = [0.032, 0.044] }
[objective]
of = "rod"
[constraints]
elongation = { response = "elongation", between = ["rod.big_end", "rod.small_end"], limit = 1e-3 }
[part_limits]
own = { of = "rod", )" + limit +
                           R"( }
[cycle]
method = ")" + method + "\"\n";
  return read_study(text, "study.toml", std::filesystem::path(kDataDir) / "scenes");
}

CycleResult<SE2> optimise(const Study& study) {
  const ChosenSpace space = choose_space(study.scene);
  return run_cycle<SE2>(study.scene.mechanism, std::get<Space<SE2>>(space.space),
                        study.scene.simulation, study.spec);
}

TEST(PartLimitOfAMotion, FrequencyHoldsTheHeightUp) {
  const auto end = optimise(rod(R"(quantity = "frequency", limit = 3000)", "auto"));
  ASSERT_EQ(end.status, CycleStatus::Optimal) << end.reason;
  ASSERT_EQ(end.final.front().parts.size(), 1u);
  EXPECT_NEAR(end.final.front().parts[0].value.value, 3000, 0.01);
  EXPECT_LT(end.optimality->residual->stationarity, 1e-6);  // a vertex
  ASSERT_EQ(end.optimality->prices.size(), 1u);
  EXPECT_GT(end.optimality->prices[0].price, 0);
  // The frequency of the mesh at the final design, and that it is the limit that decides.
  const Study study = rod(R"(quantity = "frequency", limit = 2900)", "auto");
  const auto lower = optimise(study);
  EXPECT_LT(lower.mass, end.mass);
  const double gain = end.optimality->prices[0].price;  // -dm/d ln f, 1/30 less: linear to 10 %
  EXPECT_NEAR((end.mass - lower.mass) / (gain / 30), 1, 0.1);
}

TEST(PartLimitOfAMotion, MassIsThatOfTheObjective) {
  Study study = rod(R"(quantity = "mass", limit = 1)", "auto");
  study.spec.cycle.max = 1;
  const auto end = optimise(study);
  ASSERT_EQ(end.final.front().parts.size(), 1u);
  EXPECT_NEAR(end.final.front().parts[0].value.value, end.mass, 1e-12);
}

TEST(PartLimitOfAMotion, StressIsReachedByThePlainCycleAndSaidToBeWithoutCertificate) {
  const auto end = optimise(rod(R"(quantity = "stress", limit = 50e6)", "esl"));
  ASSERT_EQ(end.status, CycleStatus::Converged) << end.reason;
  EXPECT_NEAR(end.final.front().parts[0].value.value / 50e6, 1, 1e-3);
  ASSERT_TRUE(end.optimality);
  EXPECT_FALSE(end.optimality->residual);
  EXPECT_NE(end.optimality->reason.find("no gradient by the motion"), std::string::npos);
}

TEST(PartLimitOfAMotion, StressIsRefusedWhereGradientsOfTheMotionAreNeeded) {
  try {
    rod(R"(quantity = "stress", limit = 50e6)", "esl1");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("part limit 'own' has no gradient by the motion"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace liesl::test
