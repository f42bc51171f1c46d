/// @file
/// Gears, cylinders, bushings, tapered beams, points and gravity over time as a scene gives them.
#include <gtest/gtest.h>

#include "apps/good_scene.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/scene/reader.hpp"
#include "mbs/model/beam_ends.hpp"
#include "mbs/sections/shape_dimensions.hpp"

namespace liesl::test::force_elements_scene_test {
namespace {

Mechanism mechanism(const std::string& from, const std::string& to) {
  return read_scene(changed(kGoodScene, from, to), "scene.toml").mechanism;
}

bool warns(const Scene& scene, const std::string& words) {
  for (const std::string& warning : scene.warnings)
    if (warning.find(words) != std::string::npos) return true;
  return false;
}

TEST(ForceElementsScene, CylinderHasItsLawOnItsCoordinate) {
  const Mechanism m = mechanism(
      "[forces]",
      "lift = { cylinder = [\"ground.post\", \"crank.end\"], stiffness = 7, force = \"3*t\" }\n"
      "[ground.points]\npost = [0.1, -0.4, 0]\n[forces]");
  ASSERT_EQ(m.joints.size(), 5u);
  EXPECT_EQ(m.joints[4].type, JointType::Cylinder);
  EXPECT_EQ(m.frame(m.joints[4].a).x, Vec3(0.1, -0.4, 0));
  ASSERT_EQ(m.forces.size(), 3u);
  EXPECT_EQ(m.forces[0].name, "lift");
  EXPECT_EQ(m.forces[0].joint, 4);
  EXPECT_EQ(m.forces[0].stiffness, 7);
  EXPECT_EQ(m.forces[0].force(2), 6);
}

TEST(ForceElementsScene, BushingHasSixLaws) {
  const Mechanism m =
      mechanism("wrist = { revolute = [\"rod.end\", \"slider.origin\"] }",
                "wrist = { bushing = [\"rod.end\", \"slider.origin\"], stiffness = [1, 2, 3, 4, 5, "
                "6], damping = [0, 0, 0, 0, 0, 7] }");
  ASSERT_EQ(m.forces.size(), 8u);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(m.forces[std::size_t(i)].coordinate, i);
    EXPECT_EQ(m.forces[std::size_t(i)].stiffness, i + 1);
  }
  EXPECT_EQ(m.forces[5].damping, 7);
}

/// [[2, -1], [-1, 3]] on the first displacement and the last angle: 2 (q0 - q5/2)^2 + 2.5 q5^2, and
/// a damper that is not the same sum.
TEST(ForceElementsScene, BushingTakesAMatrix) {
  const Mechanism m = mechanism(
      "wrist = { revolute = [\"rod.end\", \"slider.origin\"] }",
      "wrist = { bushing = [\"rod.end\", \"slider.origin\"], stiffness = [[2, 0, 0, 0, 0, -1], "
      "[0, 7, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], "
      "[-1, 0, 0, 0, 0, 3]], damping = [1, 0, 0, 0, 0, 0] }");
  ASSERT_EQ(m.forces.size(), 6u);
  EXPECT_EQ(m.forces[0].name, "wrist.0");
  EXPECT_EQ(m.forces[0].stiffness, 2);
  EXPECT_EQ(m.forces[0].damping, 0);
  ASSERT_EQ(m.forces[0].shares.size(), 1u);
  EXPECT_EQ(m.forces[0].shares[0].coordinate, 5);
  EXPECT_EQ(m.forces[0].shares[0].weight, -0.5);
  EXPECT_EQ(m.forces[1].name, "wrist.0.damping");
  EXPECT_EQ(m.forces[1].damping, 1);
  EXPECT_TRUE(m.forces[1].shares.empty());
  EXPECT_EQ(m.forces[2].stiffness, 7);
  EXPECT_EQ(m.forces[3].coordinate, 5);
  EXPECT_EQ(m.forces[3].stiffness, 2.5);
}

TEST(ForceElementsScene, GearsCoupleCoordinates) {
  const Mechanism m = mechanism(
      "[forces]", "[gears]\nmesh = { of = [\"motor\", \"guide\"], ratio = -0.5 }\n[forces]");
  ASSERT_EQ(m.gears.size(), 1u);
  EXPECT_EQ(m.gears[0].first.joint, 0);
  EXPECT_EQ(m.gears[0].second.joint, 3);
  EXPECT_EQ(m.gears[0].ratio, -0.5);
}

TEST(ForceElementsScene, SpringGoesThroughItsTable) {
  const Mechanism m =
      mechanism("rest = 0.01", "rest = 0.01, spring = { table = [[0, 0], [0.1, 5], [0.2, 20]] }");
  ASSERT_TRUE(m.forces[0].curve);
  EXPECT_DOUBLE_EQ((*m.forces[0].curve)(0.15), 12.5);
}

/// Diameters at the middles and ends of four elements between 20 and 12 mm.
TEST(ForceElementsScene, TaperIsLinear) {
  std::string text = changed(kGoodScene, "round = {",
                             "thin = { type = \"circle\", diameter = 0.012, shear_factor = 0.9 }\n"
                             "round = {");
  text = changed(text, "section = \"round\"", "taper = true, section = [\"round\", \"thin\"]");
  const Scene scene = read_scene(text, "scene.toml");
  const auto& beam = std::get<BeamSpec>(scene.mechanism.bodies[0].kind);
  ASSERT_EQ(beam.sections.size(), 4u);
  const double expected[] = {0.019, 0.017, 0.015, 0.013};
  for (std::size_t e = 0; e < 4; ++e)
    for (const auto place : {ElementPlace::First, ElementPlace::Middle, ElementPlace::Last}) {
      const double off = 0.001 * (static_cast<int>(place) - 1);
      EXPECT_NEAR(dimension(section_at(beam, e, place).shape, "diameter"), expected[e] - off,
                  1e-15);
    }
}

TEST(ForceElementsScene, PointsAreTiedToTheirNode) {
  const Mechanism m = mechanism(
      "elements = 4 }", "elements = 4, points = { lug = { on = \"mid\", at = [0.1, 0.02, 0] } } }");
  const auto port = m.port("crank.lug");
  ASSERT_TRUE(port);
  EXPECT_EQ(port->node, 2);
  EXPECT_LT((m.frame(*port).x - Vec3(0.1, 0.02, 0)).norm(), 1e-15);
}

/// In statics the factor is that of `simulation.at`, in a motion a function of time.
TEST(ForceElementsScene, GravityHasAFactor) {
  const std::string scaled = "gravity = [0, -10, 0]\ngravity_scale = \"t/2\"";
  std::string text = changed(kGoodScene, "gravity = [0, -9.81, 0]", scaled);
  EXPECT_DOUBLE_EQ(read_scene(text, "a").mechanism.gravity_scale(0.5), 0.25);
  text = changed(text, "[simulation]", "[simulation]\ntype = \"static\"\nat = 0.5");
  const Mechanism m = read_scene(text, "a").mechanism;
  EXPECT_EQ(m.gravity, Vec3(0, -2.5, 0));
  EXPECT_TRUE(m.gravity_scale.is_constant());
}

/// A rigid beam has no section forces: said, in the formalism and for one beam.
TEST(ForceElementsScene, SectionForceOfARigidBeamIsWarnedOf) {
  const std::string response =
      "[responses]\nn = { response = \"section_force\", of = \"crank\", "
      "component = \"Mz\" }";
  const std::string text = changed(kGoodScene, "[responses]", response);
  EXPECT_FALSE(warns(read_scene(text, "a"), "'n' is 0 by definition"));
  const std::string words = "'n' is 0 by definition: 'crank' is simulated as a rigid body";
  EXPECT_TRUE(
      warns(read_scene(changed(text, "[simulation]", "[simulation]\nformalism = \"rigid\""), "a"),
            words));
  EXPECT_TRUE(warns(
      read_scene(changed(text, "elements = 4 }", "elements = 4, as = \"rigid\" }"), "a"), words));
}

/// A force over time is no response of statics; springs are.
TEST(ForceElementsScene, JointForceOfACylinder) {
  const auto read = [](const std::string& law, const std::string& type) {
    std::string text =
        changed(kGoodScene, "[forces]",
                "lift = { cylinder = [\"ground\", \"crank.end\"], " + law + " }\n[forces]");
    text = changed(text, "[responses]",
                   "[responses]\nf = { response = \"joint_force\", of = \"lift\" }");
    return read_scene(changed(text, "[simulation]", "[simulation]\ntype = \"" + type + "\""), "a");
  };
  EXPECT_NO_THROW(read("force = \"3*t\"", "dynamic"));
  EXPECT_NO_THROW(read("stiffness = 7", "static"));
  EXPECT_THROW(read("force = 3", "static"), InputError);
}

}  // namespace
}  // namespace liesl::test::force_elements_scene_test
