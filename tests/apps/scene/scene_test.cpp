/// @file
/// Scenes: the right numbers, all problems at once, files that are none.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "apps/good_scene.hpp"
#include "apps/input/document.hpp"
#include "apps/scene/load_scene.hpp"

namespace liesl::test::scene_test {
namespace {

using test::changed;
using test::kGoodScene;
namespace fs = std::filesystem;

std::vector<InputProblem> problems_of(const std::string& text) {
  try {
    read_scene(text, "scene.toml");
  } catch (const InputError& error) {
    return error.problems;
  }
  return {};
}

TEST(Scene, HasTheNumbersOfTheFile) {
  const Scene scene = read_scene(kGoodScene, "scene.toml");
  const Mechanism& m = scene.mechanism;
  EXPECT_EQ(m.name, "good");
  EXPECT_EQ(m.gravity, Vec3(0, -9.81, 0));
  ASSERT_EQ(m.bodies.size(), 3u);
  EXPECT_EQ(m.bodies[0].name, "crank");  // the order of the file
  const auto& crank = std::get<BeamSpec>(m.bodies[0].kind);
  ASSERT_EQ(crank.nodes.size(), 5u);
  ASSERT_EQ(crank.sections.size(), 4u);
  EXPECT_NEAR((crank.nodes[2].x - Vec3(0.1, 0, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR((crank.nodes[2].R - Mat3::Identity()).norm(), 0, 1e-15);  // x along, z up
  EXPECT_EQ(crank.material.E, 210e9);
  EXPECT_EQ(std::get<Circle>(crank.sections[0].shape).diameter, 0.02);
  EXPECT_EQ(crank.sections[0].shear_factor[1], 0.9);
  const auto& slider = std::get<RigidSpec>(m.bodies[2].kind);
  EXPECT_EQ(slider.mass, 0.2);
  EXPECT_EQ(slider.inertia, Mat3(1e-4 * Mat3::Identity()));
  EXPECT_EQ(slider.points.at("tip"), Vec3(0.7, 0, 0));
}

TEST(Scene, HasCouplingsAndLoads) {
  const Mechanism m = read_scene(kGoodScene, "scene.toml").mechanism;
  ASSERT_EQ(m.joints.size(), 4u);
  EXPECT_EQ(m.joints[0].axis, Vec3(0, 0, 1));  // normalised
  EXPECT_EQ(m.joints[0].a.body, -1);
  EXPECT_EQ(m.joints[3].type, JointType::Prismatic);
  EXPECT_EQ(m.joints[3].a.offset.x, Vec3(0.6, 0, 0));  // the ground's side is at the body's
  ASSERT_EQ(m.drives.size(), 1u);
  EXPECT_NEAR(m.drives[0].motion(0.3), 10 * (0.3 - 0.05), 1e-12);
  ASSERT_EQ(m.forces.size(), 2u);
  EXPECT_EQ(m.forces[0].joint, 3);
  EXPECT_EQ(m.forces[0].rest, 0.01);
  EXPECT_NEAR(m.forces[1].rest, 0.7, 1e-15);  // relaxed at the start
  EXPECT_NEAR(m.forces[1].force(0.25), 1, 1e-12);
  ASSERT_EQ(m.loads.size(), 2u);
  EXPECT_NEAR(m.loads[0].scale(0.5), 2, 1e-12);
  EXPECT_TRUE(m.loads[1].spread);
  EXPECT_TRUE(m.loads[1].follower);
  EXPECT_EQ(m.loads[1].port.body, 1);
}

TEST(Scene, HasResponsesAndOptions) {
  const Scene scene = read_scene(kGoodScene, "scene.toml");
  EXPECT_EQ(scene.simulation.duration, 0.5);
  ASSERT_EQ(scene.responses.size(), 2u);
  EXPECT_EQ(scene.responses[0].kind, ResponseKind::Position);
  EXPECT_EQ(*scene.responses[0].axis, Vec3(1, 0, 0));
  EXPECT_EQ(scene.responses[1].kind, ResponseKind::Deflection);
  EXPECT_EQ(scene.responses[1].s, 0.5);
}

TEST(Scene, DefaultsOfTheSchemaAreThoseOfTheOptions) {
  const auto text = changed(kGoodScene, "[simulation]\nduration = 0.5\nstep = 1e-3\n", "");
  const SimulationOptions read = read_scene(text, "scene.toml").simulation, fresh;
  EXPECT_EQ(read.type, fresh.type);
  EXPECT_EQ(read.space, fresh.space);
  const auto with = read_scene(kGoodScene, "s", {"simulation.duration=1.0"}).simulation;
  EXPECT_EQ(with.duration, fresh.duration);
  EXPECT_EQ(with.step, fresh.step);
  EXPECT_EQ(with.rho_inf, fresh.rho_inf);
  EXPECT_EQ(with.tolerance, fresh.tolerance);
  EXPECT_EQ(with.max_iterations, fresh.max_iterations);
  EXPECT_EQ(with.adaptive, fresh.adaptive);
  EXPECT_EQ(with.error_tolerance, fresh.error_tolerance);
  EXPECT_EQ(with.step_min, fresh.step_min);
  EXPECT_EQ(with.output_every, fresh.output_every);
  EXPECT_EQ(with.load_steps, fresh.load_steps);
  EXPECT_EQ(with.arc_length, fresh.arc_length);
  EXPECT_EQ(with.max_load, fresh.max_load);
  EXPECT_EQ(with.critical, fresh.critical);
  EXPECT_EQ(with.modes, fresh.modes);
}

TEST(Scene, TellsAllProblemsAtOnceInTheOrderOfTheFile) {
  std::string text = changed(kGoodScene, "-9.81, 0]", "-9.81]");
  text = changed(text, "section = \"wall\"", "section = \"wal\"");
  text = changed(text, "[\"crank.end\", \"rod.start\"]", "[\"crank.end\", \"crank.start\"]");
  text = changed(text, "on = \"guide\"", "on = \"guid\"");
  text = changed(text, "sin(2*pi*t)", "sin(2*pi*t");
  text = changed(text, "step = 1e-3", "step = 7\nstepp = 1");
  const auto problems = problems_of(text);
  ASSERT_EQ(problems.size(), 6u);
  for (std::size_t i = 0; i + 1 < problems.size(); ++i)
    EXPECT_LE(problems[i].line, problems[i + 1].line);
  EXPECT_NE(problems[0].what.find("gravity"), std::string::npos);
  EXPECT_NE(problems[1].what.find("'wal'"), std::string::npos);
  EXPECT_NE(problems[5].what.find("stepp"), std::string::npos);
}

TEST(Scene, SmallGapsAreLeftToTheAssembly) {
  const auto moved = [](const char* y) {
    return changed(kGoodScene, "from = [0.2, 0, 0]", std::string("from = [0.2, ") + y + ", 0]");
  };
  EXPECT_NO_THROW(read_scene(moved("5e-4"), "s"));
  const auto problems = problems_of(moved("5e-3"));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].what.find("0.005 m apart"), std::string::npos);
}

TEST(Scene, NeedsAWayToMove) {
  const std::string still = R"([bodies]
ball = { rigid = { at = [0, 0, 0], mass = 1, inertia = [1, 1, 1] } }
)";
  const auto problems = problems_of(still);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].line, 1);
  EXPECT_NE(problems[0].text().find("no way to move"), std::string::npos);
  EXPECT_NE(problems[0].text().find("gravity"), std::string::npos);
  const auto thrown = changed(still, "ball = {", "ball = { velocity = [1, 0, 0],");
  EXPECT_NO_THROW(read_scene(thrown, "s"));
}

TEST(Scene, NeedsBodies) {
  auto problems = problems_of("gravity = [0, 0, -9.81]\n[bodies]\n");
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].what.find("no bodies"), std::string::npos);
  EXPECT_EQ(problems[0].line, 2);
  problems = problems_of("gravity = [0, 0, -9.81]\n");
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].what.find("missing key 'bodies'"), std::string::npos);
}

TEST(Scene, StaticBeamsNeedNoDensity) {
  const std::string text = R"([materials]
soft = { E = 1e7, nu = 0 }
[sections]
square = { type = "rectangle", width = 1, height = 1 }
[bodies.beam.beam]
arc = { from = [0, 0, 0], centre = [0, 100, 0], angle = 0.7853981633974483 }
section = "square"
material = "soft"
elements = 8
[joints]
clamp = { fixed = ["ground", "beam.start"] }
[loads]
pull = { at = "beam.end", force = [0, 0, 600] }
[simulation]
type = "static"
)";
  const Scene scene = read_scene(text, "s");
  const auto& beam = std::get<BeamSpec>(scene.mechanism.bodies[0].kind);
  const double a = std::sqrt(0.5);
  EXPECT_NEAR((beam.nodes.back().x - Vec3(100 * a, 100 * (1 - a), 0)).norm(), 0, 1e-11);
  EXPECT_NEAR((beam.nodes.back().R.col(0) - Vec3(a, a, 0)).norm(), 0, 1e-13);
  EXPECT_EQ(problems_of(changed(text, "type = \"static\"", "")).size(), 1u);
}

TEST(Scene, TapersByRunsOfElements) {
  const auto text = changed(kGoodScene, "section = \"round\"", "section = [\"round\", \"wall\"]");
  const Scene scene = read_scene(text, "s");
  const auto& beam = std::get<BeamSpec>(scene.mechanism.bodies[0].kind);
  EXPECT_EQ(beam.sections[1].name, "round");
  EXPECT_EQ(beam.sections[2].name, "wall");
}

TEST(Scene, InertiaIsGivenInThreeWays) {
  const char* forms[] = {"[[2, 0.1, 0.2], [0.1, 3, 0.3], [0.2, 0.3, 4]]",
                         "[2, 3, 4, 0.1, 0.2, 0.3]"};
  for (const char* form : forms) {
    const auto text = changed(kGoodScene, "[1e-4, 1e-4, 1e-4]", form);
    const Scene scene = read_scene(text, "s");
    const Mat3 J = std::get<RigidSpec>(scene.mechanism.bodies[2].kind).inertia;
    EXPECT_EQ(J(0, 1), 0.1);
    EXPECT_EQ(J(2, 0), 0.2);
    EXPECT_EQ(J(2, 1), 0.3);
    EXPECT_EQ(J(2, 2), 4);
  }
}

/// Whatever is done to a scene, it is read or refused with a text; nothing else is thrown.
TEST(Scene, DamagedTextIsReadOrRefused) {
  std::mt19937 random(1);
  const auto below = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  int refused = 0;
  for (int i = 0; i < 1500; ++i) {
    std::string text = kGoodScene;
    for (std::size_t k = 0; k <= below(3); ++k) {
      const std::size_t at = below(text.size()), length = 1 + below(12);
      switch (below(3)) {
        case 0:
          text.erase(at, length);
          break;
        case 1:
          text.insert(at, text.substr(below(text.size()), length));
          break;
        default:
          text[at] = "0-{}[]\".,=ax"[below(12)];
      }
    }
    try {
      read_scene(text, "damaged.toml");
    } catch (const InputError& error) {
      ++refused;
      EXPECT_FALSE(error.problems.empty());
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what() << "\n" << text;
    }
  }
  EXPECT_GT(refused, 1000);
}

/// A folder that goes with the test.
class File : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / (std::string("liesl_scene_") + info->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string refusal(const fs::path& path) {
    try {
      load_scene(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  fs::path write(const std::string& text) {
    const fs::path path = folder_ / "scene.toml";
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  fs::path folder_;
};

TEST_F(File, NotThere) {
  const auto text = refusal(folder_ / "none.toml");
  EXPECT_NE(text.find("none.toml: there is no such file"), std::string::npos) << text;
}

TEST_F(File, IsAFolder) { EXPECT_NE(refusal(folder_).find("is a directory"), std::string::npos); }

TEST_F(File, IsEmpty) {
  EXPECT_NE(refusal(write("")).find("empty"), std::string::npos);
  EXPECT_NE(refusal(write("# nothing\n")).find("empty"), std::string::npos);
}

TEST_F(File, IsHuge) {
  const fs::path path = write("a = 1\n");
  fs::resize_file(path, kLargestFile + 1);  // sparse
  EXPECT_NE(refusal(path).find("huge"), std::string::npos);
}

TEST_F(File, IsNotToml) {
  EXPECT_NE(refusal(write("{\"bodies\": 1}")).find("scene.toml:1:"), std::string::npos);
  EXPECT_NE(refusal(write(std::string("\x7f"
                                      "ELF\0\0\0",
                                      7)))
                .find("binary"),
            std::string::npos);
  EXPECT_NE(refusal(write("a = \"\xff\xfe\"\n")).find("not TOML"), std::string::npos);
}

TEST_F(File, IsAStudy) {
  EXPECT_NE(refusal(write("scene = \"x.toml\"\n")).find("a study, not a scene"), std::string::npos);
}

TEST_F(File, IsAScene) {
  const Scene scene = load_scene(write(kGoodScene));
  EXPECT_EQ(scene.file, (folder_ / "scene.toml").string());
  EXPECT_EQ(scene.input, kGoodScene);
}

}  // namespace
}  // namespace liesl::test::scene_test
