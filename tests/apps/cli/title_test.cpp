/// @file
/// Scenes and what is made of them without a `name` are called as their files are.
#include "apps/output/hdf5_input.hpp"
#include "apps/program.hpp"
#include "apps/scene/load_scene.hpp"

namespace liesl::test::title_test {
namespace {

const std::string kShort = "simulation.duration=0.01";

class Title : public Program {
 protected:
  /// A shipped file without its name.
  fs::path nameless(const fs::path& shipped, const char* name, const std::string& scene = "") {
    std::string text = text_of(shipped);
    const auto at = text.find("\nname = ");
    EXPECT_NE(at, std::string::npos) << shipped;
    text.erase(at, text.find('\n', at + 1) - at);
    if (const auto of = text.find("\nscene = "); of != std::string::npos && !scene.empty())
      text.replace(of, text.find('\n', of + 1) - of, "\nscene = \"" + scene + "\"");
    return write(name, text);
  }
  Json name_after(Words words) {
    words.insert(words.end(), {"-o", results().string(), "--force", "--no-report"});
    const Outcome out = run(words);
    EXPECT_LE(out.code, 1) << out.err;
    return summary().at("name");
  }

  void SetUp() override {
    Program::SetUp();
    scene_ = nameless(scene("slider_crank"), "my crank.toml");
  }
  fs::path scene_;
};

TEST_F(Title, OfASceneIsThatOfItsFile) {
  EXPECT_EQ(name_after({"run", scene_, "--set", kShort}), "my crank");
  EXPECT_EQ(output::Hdf5Input(results() / "results.h5").attribute("/", "scene"), "my crank");
  EXPECT_EQ(name_after({"run", scene_, "--set", kShort, "--set", "name=\"other\""}), "other");
  EXPECT_EQ(name_after({"run", scene("slider_crank"), "--set", kShort}), "slider-crank");
  EXPECT_EQ(run({"report", results()}).code, 0);
}

TEST_F(Title, IsOnPages) {
  ASSERT_EQ(run({"run", scene_, "--set", kShort, "-o", results()}).code, 0);
  EXPECT_NE(text_of(results() / "report.html").find("\"name\":\"my crank\""), std::string::npos);
}

/// Texts that are no file have none.
TEST_F(Title, OfATextIsTheDefault) {
  EXPECT_EQ(read_scene(text_of(scene_), "Scene").mechanism.name, "scene");
}

TEST_F(Title, OfAStudyIsThatOfItsFileAndDesignsKeepThatOfTheScene) {
  const fs::path rod = nameless(study("slider_crank_rod"), "my_rod.toml", "my crank.toml");
  EXPECT_EQ(name_after({"optimize", rod, "--set", "cycle.max=1", "--no-verify", "--set",
                        "cycle.optimality=\"never\"", "--set", "scene." + kShort}),
            "my_rod");
  const std::string design = text_of(results() / "design.toml");
  EXPECT_NE(design.find("\nname = \"my crank\"\n"), std::string::npos) << design;
}

TEST_F(Title, OfABatchIsThatOfItsFile) {
  const fs::path batch = write("grid.toml", R"(scene = "my crank.toml"
[grid]
rate = { key = "joints.motor.drive.rate", values = [140] }
)");
  EXPECT_EQ(name_after({"batch", batch, "--set", kShort}), "grid");
  EXPECT_EQ(Json::parse(text_of(results() / "cases/1/summary.json")).at("name"), "my crank");
}

TEST_F(Title, OfAComparisonIsThatOfItsFile) {
  const fs::path rows = write("rows.toml", R"(scene = "my crank.toml"
repeats = 1
set = { "simulation.duration" = 0.01 }
[quantity]
response = "bend"
norm = "rms"
[reference]
formalisms = ["se3", "r3so3"]
elements = 8
step = 1e-4
[grid]
formalism = ["se3"]
)");
  EXPECT_EQ(name_after({"compare", rows}), "rows");
}

}  // namespace
}  // namespace liesl::test::title_test
