/// @file
/// Scenes of beams that are chains of segments, and of joints by penalties: what is read, and what
/// is refused by name.
#include <gtest/gtest.h>

#include "apps/good_scene.hpp"
#include "apps/scene/load_scene.hpp"

namespace liesl::test::segments_scene_test {
namespace {

using test::changed;
using test::kGoodScene;

/// The good scene with its load that follows left out.
std::string chain(const std::string& more = "") {
  const std::string dead =
      changed(kGoodScene, "force = [0, 3, 0], follower = true }", "force = [0, 3, 0] }");
  return changed(dead, "[simulation]", "[simulation]\nformalism = \"segments\"\n" + more);
}

void expect_refused(const std::string& text, const std::string& words) {
  try {
    read_scene(text, "scene.toml");
    FAIL() << "not refused: " << words;
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems.size(), 1u) << error.what();
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    EXPECT_GT(error.problems.front().line, 1) << error.what();
  }
}

TEST(SegmentsScene, IsRead) {
  const Mechanism m = read_scene(chain(), "a").mechanism;
  EXPECT_EQ(m.formalism, Formalism::Segments);
  const std::string one =
      changed(kGoodScene, "elements = 4 }",
              "elements = 4, as = \"segments\", potential = \"neo_hookean\", mass = \"lumped\" }");
  const Mechanism lumped = read_scene(one, "a").mechanism;
  const auto& beam = std::get<BeamSpec>(lumped.bodies[0].kind);
  EXPECT_EQ(beam.as, BeamModel::Segments);
  EXPECT_EQ(beam.segment.potential, AxialPotential::NeoHookean);
  EXPECT_TRUE(beam.segment.lumped);
}

TEST(SegmentsScene, WhatTurnsAnInnerNodeIsRefused) {
  expect_refused(changed(chain(), "force = [0, 3, 0] }", "force = [0, 3, 0], follower = true }"),
                 "load 'wind' follows nodes of 'rod'");
  expect_refused(changed(chain(), "wind = { over = \"rod\", force = [0, 3, 0] }",
                         "twist = { at = \"rod.node2\", moment = [0, 0, 1] }"),
                 "load 'twist' turns nodes of 'rod'");
  EXPECT_NO_THROW(read_scene(changed(chain(), "wind = { over = \"rod\", force = [0, 3, 0] }",
                                     "twist = { at = \"rod.end\", moment = [0, 0, 1] }"),
                             "a"));
  const std::string disc =
      changed(chain(), "slider = {",
              "disc = { rigid = { at = [0.1, 0, 0], mass = 1, inertia = [1, 1, 1] } }\nslider = {");
  expect_refused(
      changed(disc, "[forces]", "bolt = { fixed = [\"crank.mid\", \"disc.origin\"] }\n[forces]"),
      "joint 'bolt' turns a node of 'crank'");
  EXPECT_NO_THROW(read_scene(
      changed(disc, "[forces]", "bolt = { revolute = [\"crank.mid\", \"disc.origin\"] }\n[forces]"),
      "a"));
}

TEST(SegmentsScene, InSpaceWhatNeedsTorsionIsRefused) {
  const std::string space = chain("space = \"spatial\"");
  EXPECT_NO_THROW(read_scene(space, "a"));
  EXPECT_NO_THROW(
      read_scene(changed(chain(), "gravity = [0, -9.81, 0]", "gravity = [0, -9.81, 1]"), "a"));
  expect_refused(changed(space, "type = \"circle\", diameter = 0.02",
                         "type = \"rectangle\", width = 0.02, height = 0.01"),
                 "beam 'crank' has no torsion as a chain of segments: in space its section 'round' "
                 "bends more easily in one direction");
  expect_refused(changed(space, "elements = 5", "elements = 5, damping = 1e-5"),
                 "beam 'rod' has no torsion as a chain of segments: in space it has no damping");
  expect_refused(changed(space, "from = [0.2, 0, 0], to = [0.6, 0, 0]",
                         "through = [[0.2, 0, 0], [0.4, 0.05, 0], [0.6, 0, 0]]"),
                 "beam 'rod' has no torsion as a chain of segments: in space it is curved");
  expect_refused(changed(space, "axis = [0, 0, 2]", "axis = [1, 0, 0]"),
                 "joint 'motor' turns about its axis");
  const auto with_load = [&](const char* load) {
    return changed(space, "wind = { over = \"rod\", force = [0, 3, 0] }", load);
  };
  expect_refused(
      with_load("twist = { at = \"rod.end\", moment = [1, 0, 0] }"),
      "beam 'rod' has no torsion as a chain of segments: load 'twist' acts about its axis");
  EXPECT_NO_THROW(read_scene(with_load("turn = { at = \"rod.end\", moment = [0, 1, 0] }"), "a"));
  const auto with_disc = [&](const char* disc, const char* joint) {
    return changed(changed(space, "slider = {", std::string(disc) + "\nslider = {"), "[forces]",
                   std::string(joint) + "\n[forces]");
  };
  const char *const inside =
                        "disc = { rigid = { at = [0.1, 0, 0], mass = 1, inertia = [1, 1, 1] } }",
                    *const outside =
                        "disc = { rigid = { at = [0.2, 0, 0], mass = 1, inertia = [1, 1, 1], "
                        "centre = [0, 0, 0.1] } }";
  expect_refused(with_disc(inside, "bolt = { revolute = [\"crank.mid\", \"disc.origin\"] }"),
                 "joint 'bolt' turns a node of 'crank'");
  EXPECT_NO_THROW(read_scene(
      with_disc(inside, "bolt = { spherical = [\"crank.mid\", \"disc.origin\"] }"), "a"));
  const char* const hub = "disc = { rigid = { at = [0.2, 0, 0], mass = 1, inertia = [1, 1, 1] } }";
  expect_refused(
      with_disc(hub, "bolt = { revolute = [\"crank.end\", \"disc.origin\"], axis = [1, 0, 0] }"),
      "joint 'bolt' turns about its axis");
  EXPECT_NO_THROW(
      read_scene(with_disc(hub, "bolt = { revolute = [\"crank.end\", \"disc.origin\"] }"), "a"));
  expect_refused(with_disc(outside, "bolt = { fixed = [\"crank.end\", \"disc.origin\"] }"),
                 "the weight of 'disc' acts about its axis");
}

/// What a chain leaves out of a stout beam is told: here E/(k G) + 1 = 4.12 (k = 5/6) times
/// pi^2/2 h^2/12/L^2.
TEST(SegmentsScene, AStoutBeamIsToldWhatItLacks) {
  const auto warnings_of = [](const std::string& height) {
    return read_scene(
               "[materials]\nsteel = { E = 210e9, nu = 0.3, rho = 7850 }\n"
               "[sections]\nbar = { type = \"rectangle\", width = 0.01, height = " +
                   height +
                   ", shear_factor = 0.8333333333333334 }\n"
                   "[bodies]\nbar = { beam = { from = [0, 0, 0], to = [1, 0, 0], section = "
                   "\"bar\", material = \"steel\", elements = 4, as = \"segments\" } }\n"
                   "[joints]\nclamp = { fixed = [\"ground\", \"bar.start\"] }\n"
                   "[loads]\npush = { at = \"bar.end\", force = [0, 0, 1] }\n"
                   "[simulation]\nduration = 1\nstep = 1e-3\n",
               "a")
        .warnings;
  };
  const auto told = [](const std::vector<std::string>& warnings) {
    for (const auto& w : warnings)
      if (w.find("beam 'bar' is too stout for a chain of segments") != std::string::npos) return w;
    return std::string();
  };
  EXPECT_NE(told(warnings_of("0.1")).find("by about 1.7 %"), std::string::npos)
      << told(warnings_of("0.1"));
  EXPECT_EQ(told(warnings_of("0.05")), "");
}

TEST(PenaltyScene, IsRead) {
  const std::string text = changed(kGoodScene, "[simulation]",
                                   "[simulation]\nconstraints = \"augmented\"\npenalty = 1e9\n"
                                   "penalty_rotation = 1e7\npenalty_damping = 1e-4");
  const PenaltySpec spec = read_scene(text, "a").mechanism.penalty;
  EXPECT_EQ(spec.form, ConstraintForm::Augmented);
  EXPECT_EQ(spec.displacement, 1e9);
  EXPECT_EQ(spec.rotation, 1e7);
  EXPECT_EQ(spec.damping, 1e-4);
  EXPECT_EQ(spec.step, 1e-3);
  EXPECT_EQ(read_scene(kGoodScene, "a").mechanism.penalty.form, ConstraintForm::Multipliers);
}

/// A drive that jumps would tear its penalty.
TEST(PenaltyScene, ADriveThatJumpsIsRefused) {
  const std::string jumps = changed(kGoodScene, "drive = { rate = 10, ramp = 0.1 }",
                                    "drive = { expression = \"t < 0.2 ? t : t + 1\" }");
  expect_refused(changed(jumps, "[simulation]", "[simulation]\nconstraints = \"penalty\""),
                 "jumps by 1");
}

}  // namespace
}  // namespace liesl::test::segments_scene_test
