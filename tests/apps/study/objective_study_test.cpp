/// @file
/// Catalogues, objectives and limits on mass in studies: the right data, and faults at their
/// places.
#include <gtest/gtest.h>

#include <filesystem>

#include "apps/good_scene.hpp"
#include "apps/study/load_study.hpp"
#include "reference/places.hpp"

namespace liesl::test::objective_study_test {
namespace {

using test::changed;

const std::string kStudy = R"(scene = "slider_crank.toml"

[design]
rod = { of = "rod", property = "diameter", groups = 4, bounds = [0.004, 0.020], values = [0.008, 0.01, 0.012] }

[objective]
minimize = "weighted"
of = "rod"
weights = { mass = 2, largest = 300, frequency = 0.01 }
largest = "bend"
count = 2

[constraints]
heavy = { mass = ["rod", "crank"], limit = 1.5 }
)";

Study read(const std::string& text) {
  return read_study(text, "study.toml", std::filesystem::path(test::kDataDir) / "scenes");
}

std::string refusal(const std::string& text) {
  return test::refusal_of([&] { read(text); });
}

TEST(ObjectiveStudy, HasTheDataOfTheFile) {
  const StudySpec spec = read(kStudy).spec;
  EXPECT_EQ(spec.design[0].values, (std::vector<double>{0.008, 0.01, 0.012}));
  EXPECT_TRUE(has_catalogue(spec));
  EXPECT_EQ(spec.motion_objective.mass, 2);
  EXPECT_TRUE(spec.motion_objective.extremes);
  EXPECT_FALSE(spec.motion_objective.only_mass());
  ASSERT_EQ(spec.constraints.size(), 1u);
  EXPECT_EQ(spec.constraints[0].response.name, "bend");
  EXPECT_EQ(spec.constraints[0].weight, 300);
  EXPECT_FALSE(spec.constraints[0].has_image);
  ASSERT_EQ(spec.frequencies.size(), 1u);
  EXPECT_EQ(spec.frequencies[0].weight, 0.01);
  EXPECT_EQ(spec.frequencies[0].count, 2);
  ASSERT_EQ(spec.mass_limits.size(), 1u);
  EXPECT_EQ(spec.mass_limits[0].bodies.size(), 2u);
  EXPECT_EQ(spec.mass_limits[0].limit, 1.5);
}

struct Fault {
  const char *from, *to, *said;
};

TEST(ObjectiveStudy, FaultsAreSaidAtTheirPlaces) {
  const Fault faults[] = {
      {"[0.008, 0.01, 0.012]", "[]", "catalogue of 'rod' is empty"},
      {"[0.008, 0.01, 0.012]", "[0.008, 0.012, 0.01]", "has 0.01 after 0.012"},
      {"[0.008, 0.01, 0.012]", "[0.008, 0.008]", "has 0.008 after 0.008"},
      {"[0.008, 0.01, 0.012]", "[0.002, 0.008]", "outside the bounds [0.004, 0.02]"},
      {"[0.008, 0.01, 0.012]", "[0.008, 0.03]", "has 0.03, outside the bounds"},
      {"largest = 300", "largest = [300, 2]", "1 responses in 'largest' and 2 weights"},
      {"largest = 300, ", "", "1 responses in 'largest' and 0 weights"},
      {"largest = 300", "largest = 0", "the weight of 'bend' is zero"},
      {"largest = \"bend\"", "largest = \"bent\"", "there is no response 'bent'"},
      {"mass = 2, largest = 300, frequency = 0.01", "mass = 2, largest = 300",
       "'count' is of a frequency"},
      {"count = 2", "count = 2\nfrequency_of = \"slider\"", "'slider' is no flexible beam"},
      {"frequency = 0.01", "compliance = 1", "'compliance' is that of a meshed part under fixed"},
      {"[constraints]", "[frequencies]\nf = { of = \"rod\", least = 10, at = 0.1 }\n[constraints]",
       "one beam has none"},
      {"minimize = \"weighted\"", "minimize = \"mass\"", "the objective is not \"weighted\""},
      {"\"crank\"], limit = 1.5", "\"crnk\"], limit = 1.5", "there is no body 'crnk'"},
      {"\"crank\"], limit = 1.5", "\"crank\"], limit = 1.5, side = \"up\"", "a mass has no 'side'"},
  };
  for (const Fault& f : faults) {
    const std::string said = refusal(changed(kStudy, f.from, f.to));
    EXPECT_NE(said.find(f.said), std::string::npos) << f.to << ": " << said;
    EXPECT_NE(said.find("study.toml:"), std::string::npos) << said;
  }
}

TEST(ObjectiveStudy, FrequencyMayBeThatOfOneBeam) {
  const std::string text =
      changed(changed(kStudy, "count = 2", "count = 2\nfrequency_of = \"rod\""), "[constraints]",
              "[frequencies]\nf = { of = \"crank\", least = 10 }\n[constraints]");
  const Study study = read(text);
  ASSERT_EQ(study.spec.frequencies.size(), 2u);
  const Mechanism& mechanism = study.scene.mechanism;
  EXPECT_EQ(study.spec.frequencies[0].body, mechanism.body("rod"));
  EXPECT_EQ(study.spec.frequencies[1].body, mechanism.body("crank"));
  EXPECT_EQ(read(kStudy).spec.frequencies[0].body, -1);
}

/// A static scene has scenarios of equilibria, and nothing that only a motion has.
TEST(ObjectiveStudy, LoadSetsOfAStaticSceneAreScenarios) {
  const Study study = load_study(std::filesystem::path(test::kDataDir) / "studies/truss_25.toml");
  EXPECT_EQ(study.spec.scenarios, (std::vector<std::string>{"side", "twist"}));
  ASSERT_EQ(study.scenarios.size(), 1u);
  EXPECT_EQ(study.spec.mass_of.size(), 25u);
  EXPECT_EQ(study.spec.design.size(), 8u);
  EXPECT_EQ(study.spec.design[1].bodies.size(), 4u);
  int members = 0;
  for (const ConstraintSpec& c : study.spec.constraints)
    members += c.response.kind == ResponseKind::AxialStress;
  EXPECT_EQ(members, 2 * 25);
}

}  // namespace
}  // namespace liesl::test::objective_study_test
