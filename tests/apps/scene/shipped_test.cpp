/// @file
/// Every scene and study that is shipped is read, with its named responses and source.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "apps/batch/batch.hpp"
#include "apps/input/document.hpp"
#include "apps/input/rewrite.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/study/load_study.hpp"
#include "mbs/sections/section_law.hpp"
#include "mbs/sections/shape_dimensions.hpp"
#include "reference/places.hpp"

namespace liesl::test::shipped_test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files(const char* folder) {
  std::vector<fs::path> list;
  for (const auto& entry : fs::directory_iterator(fs::path(test::kDataDir) / folder))
    if (entry.path().extension() == ".toml") list.push_back(entry.path());
  std::sort(list.begin(), list.end());
  return list;
}

Scene scene(const char* name) {
  return load_scene(fs::path(test::kDataDir) / "scenes" / (std::string(name) + ".toml"));
}

TEST(Shipped, ScenesAreRead) {
  EXPECT_GE(files("scenes").size(), 10u);
  for (const fs::path& path : files("scenes")) {
    SCOPED_TRACE(path.filename());
    try {
      const Scene read = load_scene(path);
      EXPECT_FALSE(read.responses.empty());
      EXPECT_EQ(without_schema_line(read.input).substr(0, 2), "# ");
      EXPECT_NE(read.input.find("Source:"), std::string::npos);
    } catch (const InputError& error) {
      ADD_FAILURE() << error.what();
    }
  }
}

TEST(Shipped, StudiesAreRead) {
  EXPECT_GE(files("studies").size(), 4u);
  for (const fs::path& path : files("studies")) {
    if (kind_of(load_document(path).root) != FileKind::Study) continue;
    SCOPED_TRACE(path.filename());
    try {
      const Study read = load_study(path);
      EXPECT_FALSE(read.spec.constraints.empty() && read.spec.part_limits.empty() &&
                   read.spec.mass_limits.empty());
      EXPECT_NE(read.input.find("Source:"), std::string::npos);
    } catch (const InputError& error) {
      ADD_FAILURE() << error.what();
    }
  }
}

TEST(Shipped, BatchesAreRead) {
  const fs::path path = fs::path(test::kDataDir) / "studies/batch_rod.toml";
  const Batch rods = load_batch(path);
  EXPECT_EQ(rods.cases.rows.size(), 200u);
  EXPECT_TRUE(rods.optimize);
  EXPECT_NE(load_document(path).text.find("Source:"), std::string::npos);
}

TEST(Shipped, SliderCrankNamesItsResponses) {
  const Scene read = scene("slider_crank");
  ASSERT_EQ(read.responses.size(), 2u);
  EXPECT_EQ(read.responses[0].name, "bend");
  EXPECT_EQ(read.responses[1].name, "slider_x");
  EXPECT_EQ(read.mechanism.gravity, Vec3(0, -9.81, 0));
  EXPECT_EQ(scene("pendulum").responses[0].name, "tip");
}

TEST(Shipped, HeavyTopTurnsAboutItsTip) {
  const Scene read = scene("heavy_top");
  const BodySpec& top = read.mechanism.bodies[0];
  const Vec3 arm = std::get<RigidSpec>(top.kind).frame.x;
  EXPECT_NEAR((top.velocity - top.angular_velocity.cross(arm)).norm(), 0, 1e-12);
}

TEST(Shipped, FourBarCloses) {
  const Mechanism m = scene("four_bar").mechanism;
  for (const JointSpec& joint : m.joints)
    EXPECT_NEAR((m.frame(joint.a).x - m.frame(joint.b).x).norm(), 0, 1e-15) << joint.name;
}

/// Mass and tip deflection by beam theory at Svanberg's optimum are his f and the limit.
TEST(Shipped, SvanbergsCantileverIsScaledToHisNumbers) {
  const Study study = load_study(fs::path(test::kDataDir) / "studies/svanberg_cantilever.toml");
  const double x[] = {6.016015894, 5.309173857, 4.494329573, 3.501474970, 2.152665330};
  const auto& beam = std::get<BeamSpec>(study.scene.mechanism.bodies[0].kind);
  const DesignSpec& design = study.spec.design[0];
  ASSERT_EQ(design.groups, 5);
  EXPECT_EQ(design.properties, (std::vector<std::string>{"width", "height"}));
  const double wall = dimension(beam.sections[0].shape, "thickness");
  const double P = study.scene.mechanism.loads[0].force.norm();
  double mass = 0, tip = 0;
  for (int i = 0; i < 5; ++i) {
    Section section = beam.sections[0];
    for (const auto& property : design.properties)
      section.shape = with_dimension(section.shape, property, 0.01 * x[i] + wall);
    const SectionGeometry g = geometry(section, beam.material.nu);
    mass += beam.material.rho * g.A * 1.0;
    const double far = 5 - i, near = 4 - i;  // m, from the tip
    tip += P * (far * far * far - near * near * near) / (3 * beam.material.E * g.Iz);
  }
  EXPECT_NEAR(mass, 1.3399563606, 1e-9);
  EXPECT_NEAR(tip / study.spec.constraints[0].limit, 1, 3e-6);  // wall against width, squared
}

}  // namespace
}  // namespace liesl::test::shipped_test
