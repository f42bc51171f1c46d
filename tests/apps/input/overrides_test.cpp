/// @file
/// Changes by key path, from the command line and from a study.
#include <gtest/gtest.h>

#include <filesystem>

#include "apps/good_scene.hpp"
#include "apps/input/document.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/study/load_study.hpp"
#include "reference/places.hpp"

namespace liesl::test::overrides_test {
namespace {

using test::kGoodScene;

Scene with(const std::vector<std::string>& overrides) {
  return read_scene(kGoodScene, "scene.toml", overrides);
}

std::string refusal(const std::string& override_text) {
  return test::refusal_of([&] { with({override_text}); });
}

TEST(Overrides, ChangeValues) {
  const Scene scene = with({"simulation.step=5e-4", "simulation.space=planar", "name=other one",
                            "bodies.rod.beam.elements=6", "simulation.adaptive=true"});
  EXPECT_EQ(scene.simulation.step, 5e-4);
  EXPECT_EQ(scene.simulation.space, SpaceChoice::Planar);
  EXPECT_EQ(scene.mechanism.name, "other one");
  EXPECT_TRUE(scene.simulation.adaptive);
  EXPECT_EQ(std::get<BeamSpec>(scene.mechanism.bodies[1].kind).nodes.size(), 7u);
}

TEST(Overrides, ReachEntriesOfListsAndWholeTables) {
  const Scene scene =
      with({"gravity.1=-1.62", "loads.wind.force=[0, 7, 0]", "joints.motor.drive.rate=20",
            "loads.push.scale.table.1.1=8", "responses.energy={ response = \"energy\" }"});
  EXPECT_EQ(scene.mechanism.gravity, Vec3(0, -1.62, 0));
  EXPECT_EQ(scene.mechanism.loads[1].force, Vec3(0, 7, 0));
  EXPECT_NEAR(scene.mechanism.drives[0].motion(1.0), 20 * 0.95, 1e-12);
  EXPECT_NEAR(scene.mechanism.loads[0].scale(1), 8, 1e-12);
  EXPECT_EQ(scene.responses.back().kind, ResponseKind::Energy);
}

TEST(Overrides, MakeMissingTables) {
  const std::string bare =
      test::changed(kGoodScene, "[simulation]\nduration = 0.5\nstep = 1e-3\n", "");
  EXPECT_EQ(read_scene(bare, "s", {"simulation.step=1e-4"}).simulation.step, 1e-4);
}

TEST(Overrides, AreRefusedWithTheirText) {
  auto text = refusal("simulation.stepp=1");
  EXPECT_EQ(text.find("--set simulation.stepp=1: unknown key 'simulation.stepp'"), 0u) << text;
  EXPECT_NE(text.find("did you mean 'step'"), std::string::npos) << text;
  text = refusal("bodies.rot.beam.elements=6");
  EXPECT_NE(text.find("there is no 'rot' in 'bodies'"), std::string::npos) << text;
  EXPECT_NE(text.find("did you mean 'rod'"), std::string::npos) << text;
  text = refusal("simulation.step=-1");
  EXPECT_EQ(text.find("--set simulation.step=-1: 'simulation.step' is out of range"), 0u) << text;
  EXPECT_NE(refusal("gravity.3=1").find("0 to 2"), std::string::npos);
  EXPECT_NE(refusal("simulation").find("key.path=value"), std::string::npos);
  EXPECT_NE(refusal("simulation.step.x=1").find("below a value"), std::string::npos);
  EXPECT_NE(refusal("simulation.step=1e-3x").find("is a string"), std::string::npos);
}

TEST(Overrides, AreSplitBetweenStudyAndScene) {
  const auto parts = split_overrides(
      {"cycle.max=3", "simulation.step=1", "scene.name=x", "name=y", "scene=z.toml", "nonsense=1"});
  EXPECT_EQ(parts.scene, (std::vector<std::string>{"simulation.step=1", "scene.name=x"}));
  EXPECT_EQ(parts.study,
            (std::vector<std::string>{"cycle.max=3", "name=y", "scene=z.toml", "nonsense=1"}));
}

TEST(Overrides, OfAStudyReachItsScene) {
  const auto path = std::filesystem::path(test::kDataDir) / "studies/slider_crank_rod.toml";
  const Study study = load_study(path, {"simulation.step=5e-5", "cycle.max=7", "scene.name=mine",
                                        "design.rod_diameters.bounds.1=0.03"});
  EXPECT_EQ(study.scene.simulation.step, 5e-5);
  EXPECT_EQ(study.scene.mechanism.name, "mine");
  EXPECT_EQ(study.spec.name, "slider-crank, rod");
  EXPECT_EQ(study.spec.cycle.max, 7);
  EXPECT_EQ(study.spec.design[0].upper, 0.03);
  try {
    load_study(path, {"scene.simulation.stp=5e-5"});
    ADD_FAILURE() << "no such key";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("--set scene.simulation.stp=5e-5: "),
              std::string::npos)
        << "as it was given: " << error.what();
  }
}

}  // namespace
}  // namespace liesl::test::overrides_test
