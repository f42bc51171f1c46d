/// @file
/// `liesl optimize --nucleate`: what it prints, writes and refuses.
#include "apps/program.hpp"
#include "apps/study/load_study.hpp"

namespace liesl::test::nucleation_test {
namespace {

class Nucleation : public Program {
 protected:
  Outcome optimize(const Words& more) const {
    Words words = {"optimize", study("cantilever"),
                   "-o",       results(),
                   "--set",    "bodies.plate.solid.mesh.cells=[60, 30]"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
};

TEST_F(Nucleation, WithoutTheOptionAHoleIsOnlyProposed) {
  const Outcome o = optimize({});
  ASSERT_EQ(o.code, 0) << o.err;
  EXPECT_NE(o.out.find("--nucleate inserts it"), std::string::npos) << o.out;
  const Json nucleation = summary()["nucleation"];
  EXPECT_EQ(keys(nucleation), (std::set<std::string>{"next", "reason", "gain_unit", "tried"}));
  EXPECT_EQ(nucleation["gain_unit"], "kg/m^3");
  EXPECT_TRUE(nucleation["tried"].empty());
  const double gain = nucleation["next"]["gain"];
  EXPECT_GT(gain, 0);
  EXPECT_LT(gain, 7850) << "more than the density";
  EXPECT_NE(text_of(results() / "plate_cells.csv").find(",hole_gain [kg/m^3]\n"),
            std::string::npos);
}

TEST_F(Nucleation, InsertsAHoleAndWritesTheOutlineForTheNextScene) {
  const Outcome o = optimize({"--nucleate=1"});
  ASSERT_EQ(o.code, 0) << o.err;
  const Json s = summary(), tried = s["nucleation"]["tried"];
  ASSERT_EQ(tried.size(), 1u);
  EXPECT_EQ(tried[0]["feature"], "new_hole1");
  EXPECT_GT(tried[0]["cycles"], 0);
  EXPECT_EQ(tried[0]["steps"], tried[0]["cycles"]) << "its name of before";
  EXPECT_TRUE(tried[0]["kept"]);
  EXPECT_EQ(tried[0]["objective"], s["mass_final"]);
  EXPECT_LT(s["mass_final"].get<double>(), tried[0]["objective_before"].get<double>());
  EXPECT_TRUE(s["design"].contains("new_hole1.a"));
  EXPECT_EQ(s["design_range"]["height"]["initial"], 0.09);

  // The scene with the outline that was written has the part of the final design.
  std::string scene = text_of(kData / "parts" / "cantilever.toml");
  scene.erase(scene.find("[bodies.plate.solid.outline]"));
  write("scene.toml", scene + text_of(results() / "plate_outline.toml"));
  std::string text = text_of(study("cantilever"));
  text.replace(text.find("../parts/cantilever.toml"), 24, "scene.toml");
  text.replace(text.find("parameters = \"plate.height\""), 27, "parameters = \"new_hole1.a\"");
  const auto bounds = text.find("bounds = [");
  text.replace(bounds, text.find(']', bounds) + 1 - bounds, "bounds = [0.001, 0.1]");
  const liesl::Study again = liesl::load_study(write("study.toml", text));
  const auto& outline = std::get<liesl::SolidSpec>(again.scene.mechanism.bodies[0].kind).outline;
  const auto shape = make_shape(outline);
  int checked = 0;
  for (const auto& p : shape->parameters())
    if (s["design"].contains(p.name)) {
      EXPECT_NEAR(p.value, s["design"][p.name].get<double>(), 1e-14) << p.name;
      ++checked;
    }
  EXPECT_EQ(checked, 4);
}

TEST_F(Nucleation, RefusesWhatItCannotDo) {
  EXPECT_EQ(optimize({"--nucleate=0"}).code, 2);
  EXPECT_EQ(optimize({"--nucleate=many"}).code, 2);
  EXPECT_FALSE(fs::exists(results()));
  const Outcome motion =
      run({"optimize", study("slider_crank_rod"), "-o", results(), "--nucleate"});
  EXPECT_EQ(motion.code, 2);
  EXPECT_NE(motion.err.find("changes no outline"), std::string::npos) << motion.err;
  EXPECT_FALSE(fs::exists(results()));
  const Outcome resumed =
      run({"optimize", study("connecting_rod"), "-o", results(), "--nucleate", "--resume"});
  EXPECT_EQ(resumed.code, 2);
  EXPECT_NE(resumed.err.find("no interrupted run"), std::string::npos) << resumed.err;
}

}  // namespace
}  // namespace liesl::test::nucleation_test
