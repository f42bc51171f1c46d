/// @file
/// Springs and rigid masses as design variables: closed forms.
#include <gtest/gtest.h>

#include "apps/scene/load_scene.hpp"
#include "apps/study/load_study.hpp"
#include "optim/cycle/motion_cycle.hpp"
#include "reference/shipped.hpp"

namespace liesl::test {
namespace {

/// A mass on a spring, pushed by a constant force from rest: v(t) = F/sqrt(k m) sin(sqrt(k/m) t).
constexpr const char* kScene = R"(
[bodies]
block = { rigid = { at = [0, 0, 0], mass = 2, inertia = [1, 1, 1] } }
[joints]
rail = { prismatic = ["ground", "block.origin"], axis = [1, 0, 0] }
[forces]
spring = { on = "rail", stiffness = 50 }
[loads]
push = { at = "block.origin", force = [10, 0, 0] }
[simulation]
duration = 2
step = 2e-3
rho_inf = 1
[responses]
speed = { response = "velocity", at = "block.origin", axis = [1, 0, 0] }
)";

StudySpec lightest_block(const Scene& scene, double limit) {
  StudySpec study;
  study.mass_of = {scene.mechanism.body("block")};
  ConstantSpec mass{.name = "mass",
                    .quantity = ConstantQuantity::Mass,
                    .force = -1,
                    .turns = false,
                    .body = study.mass_of[0],
                    .lower = 0.2,
                    .upper = 10,
                    .start = {}};
  ConstantSpec spring{.name = "spring",
                      .quantity = ConstantQuantity::Stiffness,
                      .force = 0,
                      .turns = false,
                      .body = -1,
                      .lower = 20,
                      .upper = 100,
                      .start = {}};
  study.constants = {mass, spring};
  study.constraints = {{scene.responses[0], limit, false}};
  return study;
}

TEST(Constants, LightestBlockOnASpringIsThatOfTheClosedForm) {
  const Scene scene = read_scene(kScene, "block.toml");
  const double F = 10, k = 100, v = 0.9;
  StudySpec study = lightest_block(scene, v);
  for (const CycleMethod method : {CycleMethod::Esl1, CycleMethod::Full}) {
    study.cycle.method = method;
    const auto r =
        run_cycle<SE3>(scene.mechanism, space_of<SE3>(scene.mechanism), scene.simulation, study);
    ASSERT_EQ(r.status, CycleStatus::Optimal) << r.reason;
    EXPECT_NEAR(r.x[1], k, 1e-3 * k) << "the stiffest spring";
    EXPECT_NEAR(r.mass, F * F / (k * v * v), 1e-3 * r.mass);
    EXPECT_NEAR(r.final[0].limits[0].largest, v, 1e-3 * v);
    // The limit's price: dm/dv v = -2 m.
    ASSERT_EQ(r.optimality->prices.size(), 1u);
    EXPECT_NEAR(r.optimality->prices[0].price, 2 * r.mass, 0.01 * r.mass);
  }
}

TEST(Constants, PlainMethodAndStaticsRefuseThem) {
  const Scene scene = read_scene(kScene, "block.toml");
  StudySpec study = lightest_block(scene, 0.9);
  study.cycle.method = CycleMethod::Esl;
  EXPECT_THROW(
      run_cycle<SE3>(scene.mechanism, space_of<SE3>(scene.mechanism), scene.simulation, study),
      std::invalid_argument);
}

TEST(Constants, AreReadBesideSections) {
  const auto design = [](const std::string& text) {
    return shipped_study("slider_crank_rod",
                         {"design.payload={" + text + "}", "objective.of=[\"rod\", \"slider\"]"});
  };
  const Study study = design("of=\"slider\", property=\"mass\", bounds=[0.1, 0.3]");
  ASSERT_EQ(study.spec.constants.size(), 1u);
  EXPECT_EQ(study.spec.constants[0].body, study.scene.mechanism.body("slider"));
  EXPECT_FALSE(study.spec.constants[0].start);
  EXPECT_THROW(design("of=\"slider\", property=\"mass\", bounds=[0.3, 0.4]"), std::exception);
  EXPECT_THROW(design("of=\"slider\", property=\"mass\", bounds=[-1, 0.4]"), std::exception);
  EXPECT_THROW(design("of=\"slider\", property=\"mas\", bounds=[0.1, 0.4]"), std::exception);
}

}  // namespace
}  // namespace liesl::test
