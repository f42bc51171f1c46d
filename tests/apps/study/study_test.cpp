/// @file
/// Studies: the right numbers, and faults at their places.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "apps/good_scene.hpp"
#include "apps/study/load_study.hpp"
#include "reference/places.hpp"

namespace liesl::test::study_test {
namespace {

using test::changed;

const std::string kGoodStudy = R"(scene = "slider_crank.toml"

[design]
rod = { of = "rod", property = "diameter", groups = 4, bounds = [0.004, 0.020] }
crank = { of = ["crank"], property = "diameter", bounds = [0.010, 0.030], start = 0.015 }

[objective]
minimize = "mass"
of = ["rod", "crank"]

[constraints]
bending = { response = "deflection", of = "rod", at = "mid", limit = 1.0e-3 }
again = { use = "bend", limit = 2.0e-3 }

[supports]
rod = ["start:xyz,rx", "end:yz"]
crank = "inertia_relief"

[cycle]
max = 12
optimizer = "mma"
method = "esl"
)";

const std::filesystem::path kScenes = std::filesystem::path(test::kDataDir) / "scenes";

Study read(const std::string& text) { return read_study(text, "study.toml", kScenes); }

TEST(Study, HasTheNumbersOfTheFile) {
  const Study study = read(kGoodStudy);
  const StudySpec& spec = study.spec;
  ASSERT_EQ(spec.design.size(), 2u);
  EXPECT_EQ(spec.design[0].bodies, std::vector<int>{1});
  EXPECT_EQ(spec.design[0].properties, std::vector<std::string>{"diameter"});
  EXPECT_EQ(spec.design[0].groups, 4);
  EXPECT_EQ(spec.design[0].upper, 0.020);
  EXPECT_TRUE(spec.design[0].start.empty());
  EXPECT_EQ(spec.design[1].start, std::vector<double>{0.015});
  EXPECT_EQ(spec.mass_of, (std::vector<int>{1, 0}));
  ASSERT_EQ(spec.constraints.size(), 2u);
  EXPECT_EQ(spec.constraints[0].response.kind, ResponseKind::Deflection);
  EXPECT_EQ(spec.constraints[0].limit, 1e-3);
  EXPECT_EQ(spec.constraints[1].response.name, "again");
  EXPECT_EQ(spec.constraints[1].response.body, 1);
  EXPECT_EQ(spec.supports.at(1), (Support{"start:xyz,rx", "end:yz"}));
  EXPECT_EQ(spec.supports.at(0), Support{"inertia_relief"});
  EXPECT_EQ(spec.cycle.max, 12);
  EXPECT_EQ(spec.cycle.optimizer, Optimizer::Mma);
}

TEST(Study, DefaultsOfTheSchemaAreThoseOfTheOptions) {
  const CycleOptions fresh;
  const auto read_cycle =
      read(changed(kGoodStudy, "max = 12\noptimizer = \"mma\"", "max = 30")).spec.cycle;
  EXPECT_EQ(read_cycle.max, fresh.max);
  EXPECT_EQ(read_cycle.tolerance, fresh.tolerance);
  EXPECT_EQ(read_cycle.objective_tolerance, fresh.objective_tolerance);
  EXPECT_EQ(read_cycle.feasibility, fresh.feasibility);
  EXPECT_EQ(read_cycle.move_limit, fresh.move_limit);
  EXPECT_EQ(read_cycle.screening, fresh.screening);
  EXPECT_EQ(read_cycle.min_cases, fresh.min_cases);
  EXPECT_EQ(read_cycle.optimizer, fresh.optimizer);
  EXPECT_EQ(read_cycle.model, fresh.model);
}

TEST(Study, ChangesItsScene) {
  const auto text =
      changed(kGoodStudy, "[design]",
              "[set]\n\"simulation.step\" = 2e-4\nsimulation.duration = 0.06\n\n[design]");
  const Study study = read(text);
  EXPECT_EQ(study.scene.simulation.step, 2e-4);
  EXPECT_EQ(study.scene.simulation.duration, 0.06);
  const auto bad =
      changed(kGoodStudy, "[design]", "[set]\n\"simulation.stepp\" = 2e-4\n\n[design]");
  try {
    read(bad);
    FAIL();
  } catch (const InputError& error) {
    ASSERT_EQ(error.problems.size(), 1u) << error.what();
    EXPECT_EQ(error.problems[0].file, "study.toml");
    EXPECT_EQ(error.problems[0].line, 4);
    EXPECT_NE(error.problems[0].hint.find("'step'"), std::string::npos);
  }
}

TEST(Study, TellsProblemsOfItsSceneToo) {
  try {
    read_study(changed(kGoodStudy, "groups = 4", "groups = 9"), "study.toml", kScenes,
               {"bodies.rod.beam.section=rodd"});
    FAIL();
  } catch (const InputError& error) {
    // The rod cannot be read, hence nothing is said of what refers to it.
    ASSERT_EQ(error.problems.size(), 1u) << error.what();
    EXPECT_EQ(error.problems[0].file, "--set bodies.rod.beam.section=rodd");
  }
}

/// As in the tests of scenes: '@' marks where the problem is expected.
struct BadStudy {
  const char* name;
  const char* from;
  const char* to;
  std::vector<const char*> words;
};

void PrintTo(const BadStudy& study, std::ostream* out) { *out << study.name; }

class Refused : public testing::TestWithParam<BadStudy> {};

TEST_P(Refused, AtItsPlace) {
  const BadStudy& c = GetParam();
  const test::MarkedText marked(changed(kGoodStudy, c.from, c.to));
  const auto refused = [](const auto& text, const auto& file) { read_study(text, file, kScenes); };
  test::expect_refused(marked, "study.toml", refused, c.words);
}

// clang-format off
const BadStudy kStudies[] = {
    {"NoScene", "scene = \"slider_crank.toml\"", "scene = @\"slider_krank.toml\"", {"no such file", "slider_krank.toml"}},
    {"SceneMissing", "scene = \"slider_crank.toml\"", "@", {"missing key 'scene'"}},
    {"UnknownKey", "max = 12", "@maxx = 12", {"cycle.maxx", "'max'"}},
    {"NoBody", "of = \"rod\", property", "of = @\"rodd\", property", {"no body 'rodd'", "'rod'"}},
    {"RigidBody", "of = \"rod\", property", "of = @\"slider\", property", {"'slider' is rigid"}},
    {"NoProperty", "property = \"diameter\", groups", "property = @\"diamter\", groups", {"no dimension 'diamter'", "'diameter'"}},
    {"PropertyOfOtherShape", "property = \"diameter\", groups", "property = @\"height\", groups", {"section 'rod'", "known: diameter"}},
    {"TooManyGroups", "groups = 4", "groups = @9", {"9 groups for the 8 elements"}},
    {"StepsOnATaper", "[design]\nrod = { of = \"rod\", property = \"diameter\", groups = 4",
     "[set]\n\"sections.rod\" = { type = \"tube\", diameter = 0.01, thickness = 0.0015 }\n\"sections.crank\" = { type = \"tube\", diameter = 0.02, thickness = 0.001 }\n"
     "\"bodies.rod.beam.section\" = [\"rod\", \"crank\"]\n\"bodies.rod.beam.taper\" = true\n[design]\nrod = { of = \"rod\", property = \"diameter\", groups = @4",
     {"'rod' has 4 groups on beam 'rod', whose 'thickness' tapers", "groups = 1"}},
    {"NoGroups", "groups = 4", "groups = @0", {"out of range: 0"}},
    {"BoundsSwapped", "bounds = [0.004, 0.020]", "bounds = @[0.020, 0.004]", {"[0.02, 0.004]", "least < largest"}},
    {"BoundBelowZero", "bounds = [0.004, 0.020]", "bounds = [@-0.004, 0.020]", {"out of range", "> 0"}},
    {"SideOfASize", "[constraints]", "[constraints]\nhigh = { response = \"stress\", of = \"rod\", limit = 1e8, side = @\"down\" }", {"never below zero", "\"up\""}},
    {"StartOutside", "start = 0.015", "start = @0.05", {"0.05 is outside the bounds"}},
    {"SceneOutside", "bounds = [0.004, 0.020]", "bounds = @[0.012, 0.020]", {"0.01", "in the scene", "start"}},
    {"StartCount", "start = 0.015", "start = @[0.015, 0.016]", {"2 values for 1 groups"}},
    {"VariedTwice", "of = [\"crank\"], property = \"diameter\"", "of = [\"rod\"], property = @\"diameter\"", {"already varied by 'rod'"}},
    {"NoLimit", "at = \"mid\", limit = 1.0e-3", "at = \"mid\", limit = @0", {"out of range: 0", "> 0"}},
    {"NegativeLimit", "at = \"mid\", limit = 1.0e-3", "at = \"mid\", limit = @-1e-3", {"out of range", "absolute value"}},
    {"LimitMissing", "bending = { response = \"deflection\", of = \"rod\", at = \"mid\", limit = 1.0e-3 }", "bending = @{ response = \"deflection\", of = \"rod\" }", {"missing key 'constraints.bending.limit'"}},
    {"LimitOfARigidBeam",
     "[constraints]\nbending = { response = \"deflection\", of = \"rod\", at = \"mid\", limit = 1.0e-3 }\nagain = {",
     "[set]\n\"bodies.rod.beam.as\" = \"rigid\"\n[constraints]\nagain = @{",
     {"limit 'again' is always 0: 'rod' is rigid", "a response that does not need deformation"}},
    {"NoResponse", "use = \"bend\"", "use = @\"bent\"", {"no response 'bent'", "'bend'"}},
    {"NotOfAPart", "use = \"bend\"", "use = @\"slider_x\"", {"'again' is not on the deformation of a part"}},
    {"NothingToUse", "again = { use = \"bend\", ", "again = @{ ", {"missing key", "use, mass, response"}},
    {"NoNode", "at = \"mid\", limit", "at = @\"node12\", limit", {"no node 'node12'"}},
    {"ObjectiveUnvaried", "of = [\"rod\", \"crank\"]", "of = @[\"slider\"]", {"no design variable changes the objective"}},
    {"MassUnvaried", "again = { use = \"bend\", limit = 2.0e-3 }", "again = { mass = @\"slider\", limit = 1 }", {"no design variable changes the mass of limit 'again'"}},
    {"PropertyOfAJoint", "of = [\"crank\"], property = \"diameter\"", "of = [\"motor\"], property = @\"rate\"", {"joint 'motor' has no drive with a table"}},
    {"NoSupportNode", "[\"start:xyz,rx\", \"end:yz\"]", "[\"start:xyz,rx\", @\"ent:yz\"]", {"no node 'ent'", "'end'"}},
    {"NoDirection", "[\"start:xyz,rx\", \"end:yz\"]", "[\"start:xyz,rx\", @\"end:yw\"]", {"'end:yw' is no support"}},
    {"Indeterminate", "[\"start:xyz,rx\", \"end:yz\"]", "@[\"start\", \"end:yz\"]", {"hold 8 directions", "6"}},
    {"NoSupportBody", "crank = \"inertia_relief\"", "krank = @\"inertia_relief\"", {"no body 'krank'", "'crank'"}},
    {"NoOptimizer", "\"mma\"", "@\"gradient\"", {"ipopt", "slsqp"}},
    {"NoTolerance", "max = 12", "tolerance = @0", {"in (0, 1]"}},
};
// clang-format on

INSTANTIATE_TEST_SUITE_P(Study, Refused, testing::ValuesIn(kStudies),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// An objective of it is refused as a limit is, and what is 0 in one scenario only, too.
TEST(Study, NothingOfARigidBeamIsMinimised) {
  const auto refusal = [](const std::string& text) -> std::string {
    try {
      read(text);
      return "";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  const std::string rigid = "set]\n\"bodies.rod.beam.as\" = \"rigid\"\n";
  const auto weighted = [](const std::string& terms) {
    const std::string text = changed(
        kGoodStudy,
        "bending = { response = \"deflection\", of = \"rod\", at = \"mid\", limit = 1.0e-3 }",
        "heavy = { mass = [\"rod\"], limit = 1 }");
    const std::string free = changed(text, "again = { use = \"bend\", limit = 2.0e-3 }\n", "");
    return changed(changed(free, "method = \"esl\"", "method = \"esl1\""), "minimize = \"mass\"",
                   "minimize = \"weighted\"\n" + terms);
  };
  const std::string always = "response 'bend' is always 0: 'rod' is rigid";
  for (const char* const terms : {"weights = { mass = 1, largest = 1 }\nlargest = [\"bend\"]",
                                  "weights = { mass = 1, effort = 1 }\neffort = [\"bend\"]"}) {
    EXPECT_EQ(refusal(weighted(terms)).find("always 0"), std::string::npos);
    const std::string said = refusal(weighted(terms) + "[" + rigid);
    EXPECT_NE(said.find(always), std::string::npos) << said;
  }
  const std::string said = refusal(kGoodStudy + "[scenarios.a]\n[scenarios.b." + rigid);
  EXPECT_NE(said.find("limit 'bending' is always 0 in scenario 'b': 'rod' is rigid"),
            std::string::npos)
      << said;
}

TEST(Study, WallsMayNotMeetWithinTheBounds) {
  const auto path = std::filesystem::path(test::kDataDir) / "studies/robot_arms.toml";
  try {
    load_study(path, {"design.arm1_walls.bounds=[0.0005, 0.03]"});
    FAIL();
  } catch (const InputError& error) {
    ASSERT_EQ(error.problems.size(), 1u) << error.what();
    EXPECT_NE(error.problems[0].what.find("thickness = 0.03"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace liesl::test::study_test
