/// @file
/// Notes on motions: a start that strikes, a plane that is left.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "apps/scene/load_scene.hpp"
#include "apps/tasks/run.hpp"
#include "reference/shipped.hpp"

namespace liesl::test::motion_notes_test {
namespace {

/// A cantilever along x with its load, `scale` over time.
std::string cantilever(const std::string& load, const std::string& more) {
  return fmt::format(R"toml(
[materials]
steel = {{ E = 210e9, nu = 0.3, rho = 7850 }}
[sections]
flat = {{ type = "rectangle", width = 0.02, height = 0.005 }}
[bodies]
b = {{ beam = {{ from = [0, 0, 0], to = [1, 0, 0], section = "flat", material = "steel", elements = 12, damping = 1e-5 }} }}
[joints]
clamp = {{ fixed = ["ground", "b.start"] }}
[loads]
f = {{ at = "b.end", {} }}
[responses]
stress = {{ response = "stress", of = "b" }}
tip = {{ response = "position", at = "b.end" }}
[simulation]
duration = 1
step = 1e-3
{}
)toml",
                     load, more);
}

std::string note(const std::string& scene_text, const std::string& words) {
  const Scene scene = read_scene(scene_text, "scene.toml");
  const RunOutcome out = run_task(scene, choose_space(scene));
  EXPECT_EQ(out.status, SolveStatus::Converged) << out.summary.reason;
  for (const std::string& warning : out.summary.warnings)
    if (warning.find(words) != std::string::npos) return warning;
  return "";
}

const char* const kStrikes = "strike the undeformed scene at t = 0";
const char* const kLeaves = "the motion may leave the plane";

/// The load acts at once: the stress swings between 0 and twice its static value.
TEST(StruckStart, IsNamedWithItsShare) {
  for (const char* formalism : {"", "formalism = \"floating\""}) {
    const std::string text = note(cantilever("force = [0, 5, 0]", formalism), kStrikes);
    const auto at = text.find("up to ");  // a half, less what higher modes add to the peak
    ASSERT_NE(at, std::string::npos) << text;
    EXPECT_NEAR(std::stod(text.substr(at + 6)), 47, 6) << text;
    EXPECT_NE(text.find("'stress'"), std::string::npos) << text;
  }
}

TEST(StruckStart, IsNoneFromEquilibriumOrARamp) {
  EXPECT_EQ(note(cantilever("force = [0, 5, 0]", "start = \"equilibrium\""), kStrikes), "");
  EXPECT_EQ(note(cantilever("force = [0, 5, 0], scale = { table = [[0, 0], [0.5, 1]], "
                            "interpolation = \"cubic\" }",
                            ""),
                 kStrikes),
            "");
}

/// Where the later motion is larger, the start carries nothing; nor has a pendulum an equilibrium
/// near its start.
TEST(StruckStart, IsNoneWhereTheMotionCarriesThePeak) {
  EXPECT_EQ(
      note(cantilever("force = [0, 5, 0], scale = { table = [[0, 1], [0.5, 1], [1, 20]] }", ""),
           kStrikes),
      "");
  const Scene pendulum = shipped_scene("pendulum", {"simulation.duration=0.2"});
  for (const std::string& warning : run_task(pendulum, choose_space(pendulum)).summary.warnings)
    EXPECT_EQ(warning.find(kStrikes), std::string::npos) << warning;
}

/// Pressed by a share of the Euler load out of the plane, pi^2 E I / (4 L^2); in the plane it could
/// carry sixteen times that. A little force across singles out the plane.
std::string pressed(double share, const std::string& more = "") {
  const double euler = std::pow(M_PI / 2, 2) * 210e9 * 0.02 * std::pow(0.005, 3) / 12;
  return cantilever(fmt::format("force = [{}, 0.01, 0], scale = {{ table = [[0, 0], [0.2, 1]] }}",
                                -share * euler),
                    more);
}

TEST(LeavingPlane, IsSaidAboveTheEulerLoadOutOfIt) {
  EXPECT_EQ(note(cantilever("force = [0, 5, 0]", ""), kLeaves), "");
  EXPECT_EQ(note(pressed(0.95), kLeaves), "");
  EXPECT_NE(note(pressed(1.05), kLeaves), "");
}

/// Where no linearisation tells, under floating frames and chains of segments, the Euler load out
/// of the plane does: that of a free end is a fourth of the one between hinges.
TEST(LeavingPlane, IsSaidByTheEulerLoadWhereNoLinearisationTells) {
  for (const char* formalism : {"formalism = \"floating\"", "formalism = \"segments\""}) {
    EXPECT_EQ(note(pressed(0.9, formalism), kLeaves), "") << formalism;
    EXPECT_NE(note(pressed(1.1, formalism), kLeaves), "") << formalism;
    EXPECT_EQ(note(pressed(1.1, std::string("space = \"planar\"\n") + formalism), kLeaves), "");
  }
}

/// Who asks for the plane, or for space, has decided.
TEST(LeavingPlane, IsOfAutoOnly) {
  EXPECT_EQ(note(pressed(1.05, "space = \"planar\""), kLeaves), "");
  EXPECT_EQ(note(pressed(1.05, "space = \"spatial\""), kLeaves), "");
}

}  // namespace
}  // namespace liesl::test::motion_notes_test
