/// @file
/// Studies of outlines: the right data, and faults at their places.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "apps/good_scene.hpp"
#include "apps/study/load_study.hpp"
#include "reference/places.hpp"

namespace liesl::test::shape_study_test {
namespace {

using test::changed;

const std::string kPlate = R"(scene = "../parts/plate_with_hole.toml"

[design]
a = { of = "plate", parameters = ["hole.a", "hole.b"], factors = [1, -0.5], bounds = [0.08, 0.2] }

[walls]
right = { of = "plate", feature = "hole", to = "right", least = 0.1 }

[objective]
minimize = "compliance"
of = "plate"

[part_limits]
mass = { of = "plate", quantity = "mass", limit = 77 }
tone = { of = "plate", quantity = "frequency", limit = 100, count = 2 }

[loads]
pull = { on = "plate.x_max", traction = [1e6, 0, 0] }
turn = { at = "plate.right", moment = [0, 0, 3], case = "2" }

[supports]
plate = ["x_min:x", "y_min:y"]
)";

Study read(const std::string& text) {
  return read_study(text, "study.toml", std::filesystem::path(test::kDataDir) / "studies");
}

std::string refusal(const std::string& text) {
  return test::refusal_of([&] { read(text); });
}

TEST(ShapeStudy, HasTheDataOfTheFile) {
  const StudySpec spec = read(kPlate).spec;
  ASSERT_EQ(spec.shapes.size(), 1u);
  const ShapeDesignSpec& shape = spec.shapes.at(0);
  ASSERT_EQ(shape.variables.size(), 1u);
  EXPECT_EQ(shape.variables[0].drives[1].name, "hole.b");
  EXPECT_EQ(shape.variables[0].drives[1].factor, -0.5);
  EXPECT_EQ(shape.walls.at(0).to, "right");
  EXPECT_EQ(spec.objective, SolidResponse::Compliance);
  ASSERT_EQ(spec.part_limits.size(), 2u);
  EXPECT_EQ(spec.part_limits[1].count, 2);
  ASSERT_EQ(spec.loads.size(), 2u);
  EXPECT_EQ(spec.loads[0].nodes.size(), 121u);
  EXPECT_EQ(spec.loads[1].interface, 0);
  EXPECT_EQ(spec.loads[1].load_case, "2");
}

TEST(ShapeStudy, RefusesWithPlaceAndHint) {
  const auto says = [](const std::string& from, const std::string& to, const std::string& words) {
    const std::string text = refusal(changed(kPlate, from, to));
    EXPECT_NE(text.find(words), std::string::npos) << to << '\n' << text;
  };
  says("\"hole.b\"", "\"hole.bb\"", "the outline has no parameter 'hole.bb'");
  says("\"hole.b\"", "\"hole.bb\"", "study.toml:4:");
  says("factors = [1, -0.5]", "factors = [1]", "1 factors for 2 parameters");
  says("bounds = [0.08, 0.2]", "bounds = [0.08, 0.4]", "turns the feature inside out");
  says("bounds = [0.08, 0.2]", "bounds = [0.2, 0.08]", "expected least < largest");
  says("to = \"right\"", "to = \"left\"", "'left' is neither a feature nor an interface");
  says("plate.x_max", "plate.x_maxx", "no set of nodes 'x_maxx'");
  says("plate.right\", moment", "plate.left\", moment", "no interface 'left'");
  says("moment = [0, 0, 3]", "moment = [0, 0, 0]", "load 'turn' is zero");
  says("\"y_min:y\"", "\"y_mid:y\"", "no interface or set 'y_mid'");
  says("of = \"plate\", quantity = \"mass\"", "of = \"plat\", quantity = \"mass\"",
       "no body 'plat'");
}

TEST(ShapeStudy, RefusesLimitsOfWhatDoesNotChange) {
  const std::string study = R"(scene = "../scenes/four_bar_plates.toml"
[design]
height = { of = "rocker", parameters = "plate.height", bounds = [0.025, 0.031] }
[objective]
of = "rocker"
[constraints]
bend = { use = "coupler_bend", limit = 1.0e-5 }
)";
  EXPECT_NE(refusal(study).find("constraint 'bend' is of 'coupler', which no variable changes"),
            std::string::npos)
      << refusal(study);
  EXPECT_EQ(refusal(changed(study, "coupler_bend", "rocker_bend")), "");
}

TEST(ShapeStudy, LoadsThatStayAreOfOnePart) {
  const std::string study = R"(scene = "../scenes/four_bar_plates.toml"
[design]
rocker  = { of = "rocker", parameters = "plate.height", bounds = [0.025, 0.031] }
coupler = { of = "coupler", parameters = "plate.height", bounds = [0.025, 0.031] }
[objective]
of = ["rocker", "coupler"]
[part_limits]
soft = { of = "rocker", quantity = "compliance", limit = 1 }
[loads]
pull = { at = "rocker.C", force = [1, 0, 0] }
)";
  EXPECT_NE(refusal(study).find("fixed loads are for the outline of one meshed part"),
            std::string::npos)
      << refusal(study);
}

TEST(ShapeStudy, FixedLoadsHaveWeightedTermsOfThePart) {
  const std::string terms =
      changed(kPlate, "minimize = \"compliance\"",
              "minimize = \"weighted\"\nlargest = \"shift\"\nweights = { mass = 0.5, largest = "
              "3, compliance = 2, stress = 1e-8, frequency = 0.1 }\ncount = 3");
  EXPECT_NE(refusal(terms).find("there is no response 'shift'"), std::string::npos)
      << refusal(terms);
  const StudySpec spec =
      read(changed(changed(terms, "largest = \"shift\"\n", ""), "largest = 3, ", "")).spec;
  EXPECT_EQ(spec.motion_objective.mass, 0.5);
  ASSERT_EQ(spec.part_limits.size(), 5u);  // three terms, then the limits
  EXPECT_EQ(spec.part_limits[0].quantity, SolidResponse::Frequency);
  EXPECT_EQ(spec.part_limits[0].count, 3);
  EXPECT_EQ(spec.part_limits[0].weight, 0.1);
  EXPECT_EQ(spec.part_limits[1].quantity, SolidResponse::Compliance);
  EXPECT_EQ(spec.part_limits[1].weight, 2);
  EXPECT_EQ(spec.part_limits[2].quantity, SolidResponse::Stress);
  EXPECT_EQ(spec.part_limits[3].weight, 0);
}

TEST(ShapeStudy, SectionsHaveBoundsAboveZero) {
  const std::string study = R"(scene = "../scenes/slider_crank.toml"
[design]
rod = { of = "rod", property = "diameter", bounds = [-0.004, 0.020] }
[objective]
of = "rod"
[constraints]
bending = { response = "deflection", of = "rod", limit = 1.0e-3 }
)";
  EXPECT_NE(refusal(study).find("the least value of 'rod' is out of range: -0.004"),
            std::string::npos)
      << refusal(study);
}

}  // namespace
}  // namespace liesl::test::shape_study_test
