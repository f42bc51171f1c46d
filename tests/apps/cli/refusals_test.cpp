/// @file
/// Input that was accepted in silence, or refused with poor words: each with its exit code and the
/// words that tell it, with its place.
#include <sys/resource.h>

#include "apps/program.hpp"

namespace liesl::test::refusals_test {
namespace {

struct Refusal {
  const char* name;
  Words words;  ///< SCENE, BATCH, COMPARISON: files of the test; DIR: its folder
  int code;
  const char* said;
};
void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.name; }

/// `check` of a shipped study of an outline with one change.
Words rod(const std::string& change) { return {"check", study("connecting_rod"), "--set", change}; }
/// `check` of the test's scene with one change.
Words scene_with(const std::string& change) { return {"check", "SCENE", "--set", change}; }

const Refusal kRefusals[] = {
    {"WallToItself", rod("walls.big_bore_edge.to=big_bore"), 2,
     "wall 'big_bore_edge' is between 'big_bore' and itself"},
    {"GroupsOfAnOutline", rod("design.height.groups=2"), 2,
     "'height' moves an outline, which has no groups"},
    {"BoundsOutOfOrder", rod("design.height.bounds=[0.5,0.1]"), 2,
     "connecting_rod.toml:11:10: 'height': bounds [0.5, 0.1], expected least < largest"},
    {"GriddedKeyForAllCases",
     {"batch", "BATCH", "-o", "DIR/b", "--set", "joints.motor.drive.rate=3"},
     2,
     "'rate' sets 'joints.motor.drive.rate' in every case"},
    {"TableOfAGriddedKeyForAllCases",
     {"batch", "BATCH", "-o", "DIR/b", "--set", "joints.motor.drive={rate=3}"},
     2,
     "'rate' sets 'joints.motor.drive.rate' in every case"},
    {"StudyOfABatchThatIsNotThere",
     {"batch", "BATCH", "-o", "DIR/b", "--set", "scene=nowhere.toml"},
     2,
     "there is no file"},
    {"EmptyStudyOfABatch", {"check", "EMPTY_BATCH"}, 2, "empty.toml: the file is empty"},
    {"BatchOfBoth",
     {"check", "BOTH_BATCH"},
     2,
     "both.toml:2:9: the file has both 'study' and 'scene'"},
    {"EmptyShard", {"batch", "BATCH", "-o", "DIR/b", "--shard", ""}, 2, "expected i/n"},
    {"PlaceOfAComparison",
     {"compare", study("compare_pendulum"), "-o", "/proc/no/where"},
     3,
     "liesl: cannot use '/proc/no/where': No such file or directory"},
    {"InertiaOfNoSection", scene_with("sections.s.inertia=[1,1,1,1,0.1,0.1]"), 2,
     "'inertia' is of no section: 1 is more than 0.1 + 0.1 kg m"},
    {"InertiaOfNoBody", scene_with("bodies.r.rigid.inertia=[1,1,5]"), 2,
     "the inertia of body 'r' is of no body: 5 is more than 1 + 1"},
    {"OrientationInDegrees", scene_with("bodies.r.rigid.orientation=[0,0,90]"), 2,
     "'orientation' turns by 90 rad, more than a whole turn; expected a rotation vector in rad, of "
     "at most 2 pi; hint: 90 degrees are 1.5708 rad"},
    {"RateInRpm", scene_with("joints.j2.drive={rate=3000}"), 0,
     "joints.j2.drive turns at 3000 rad/s, that is 2.865e+04 rpm: 3000 rpm is 314.2 rad/s"},
    {"CasesWithoutEnd",
     {"check", study("slider_crank_rod"), "--set", "cycle.min_cases=1e18"},
     2,
     "expected an integer >= 1, at most 1e+09"},
    {"RecordsWithoutEnd", scene_with("simulation.output_every=1e12"), 2,
     "expected an integer >= 1, at most 1e+09"},
    {"MaximaForAnOptimiserOfTheMotion",
     {"check", study("slider_crank_rod"), "--set", "cycle.method=\"direct\"", "--set",
      "constraints.bending.treatment=\"maxima\""},
     2,
     "the number of maxima changes with the design, and cycle.method is \"direct\""},
    {"FixedLoadsForAnOptimiserOfTheMotion",
     {"check", study("plate_with_hole"), "--set", "cycle.method=\"direct\""},
     2,
     "fixed loads have no motion, and cycle.method is \"direct\""},
    {"RestartsWithoutEnd",
     {"check", study("slider_crank_rod"), "--set", "cycle.restarts=6"},
     2,
     "'cycle.restarts'"},
    {"ContinuationOfEquilibria",
     {"check", study("svanberg_cantilever"), "--set", "cycle.continuation=4"},
     2,
     "equilibria have no speed"},
    {"ContinuationOfFixedLoads",
     {"check", study("plate_with_hole"), "--set", "cycle.continuation=4"},
     2,
     "fixed loads have no speed"},
    {"ContinuationOfAMotionThatVaries",
     {"check", study("robot_codesign"), "--set", "cycle.continuation=4"},
     2,
     "changes the motion itself"},
    {"ContinuationOfACatalogue",
     {"check", study("rod_catalogue"), "--set", "cycle.continuation=4"},
     2,
     "sizes of catalogues are not followed"},
    {"NegativeThreads",
     {"run", "SCENE", "-o", "DIR/r", "--threads", "-1"},
     2,
     "--threads: Value -1 not in range"},
    {"EmptyDrive", scene_with("joints.j2.drive=[]"), 2, "'joints.j2.drive' is empty"},
    {"SecondAxisOfARevolute", scene_with("joints.j2.axis2=[1,0,0]"), 2,
     "revolute joint 'j2' has no second axis"},
    {"InterpolationBesideARate", scene_with("joints.j2.drive.interpolation=\"linear\""), 2,
     "a drive with 'interpolation' but no 'table'"},
};

class Refusals : public Program, public testing::WithParamInterface<Refusal> {};

TEST_P(Refusals, IsTold) {
  const std::string text = R"toml([sections]
s = { type = "full", stiffness = [1e6, 1e6, 1e6, 1e3, 1e3, 1e3], inertia = [1, 1, 1, 1, 1, 1] }
[bodies]
b = { beam = { from = [0, 0, 0], to = [1, 0, 0], section = "s", elements = 2 } }
r = { rigid = { at = [0, 0, 0], mass = 1, inertia = [1, 1, 1] } }
[joints]
j = { fixed = ["ground", "b.start"] }
j2 = { revolute = ["ground", "r.origin"], drive = { rate = 3, ramp = 1 } }
[simulation]
duration = 0.01
)toml";
  const std::string places[][2] = {
      {"SCENE", write("scene.toml", text)},
      {"BATCH", write("batch.toml", "scene = \"" + scene("slider_crank") +
                                        "\"\n[grid]\nrate = { key = \"joints.motor.drive.rate\", "
                                        "values = [50, 60] }\n")},
      {"EMPTY_BATCH",
       write("of_empty.toml", "study = \"" + write("empty.toml", "").string() +
                                  "\"\n[grid]\na = { key = \"b\", values = [1] }\n")},
      {"BOTH_BATCH", write("both.toml",
                           "study = \"a.toml\"\nscene = \"b.toml\"\n[grid]\na = { "
                           "key = \"b\", values = [1] }\n")},
      {"DIR", dir_.string()}};
  Words words = GetParam().words;
  for (std::string& word : words)
    for (const auto& [name, place] : places)
      if (word.rfind(name, 0) == 0) word.replace(0, name.size(), place);
  const Outcome out = run(words);
  EXPECT_EQ(out.code, GetParam().code) << out.err;
  EXPECT_NE((out.out + out.err).find(GetParam().said), std::string::npos) << out.out << out.err;
  EXPECT_EQ(out.err.find("internal error"), std::string::npos) << out.err;
}

INSTANTIATE_TEST_SUITE_P(Table, Refusals, testing::ValuesIn(kRefusals),
                         [](const auto& of) { return std::string(of.param.name); });

using FileLimit = Program;

/// A disk without room, here a limit on the size of a file: the program ends with code 3 and says
/// which file, whichever library writes it.
TEST_F(FileLimit, EndsWithTheNameOfTheFile) {
  const Words commands[] = {
      {"run", scene("slider_crank"), "-q", "-o", results()},
      {"optimize", study("plate_with_hole"), "-q", "-o", results(), "--set", "cycle.max=1"}};
  for (const Words& words : commands) {
    rlimit before;
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit small = before;
    small.rlim_cur = 40000;
    setrlimit(RLIMIT_FSIZE, &small);
    const Outcome out = run(words);
    setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_EQ(out.code, 3) << words[0] << out.err;
    EXPECT_EQ(out.err.find("liesl: cannot write '"), 0u) << out.err;
    EXPECT_NE(out.err.find("': File too large"), std::string::npos) << out.err;
  }
}

using LeanEnd = Program;

/// A lean model that was not found is not named as a file.
TEST_F(LeanEnd, NamesNoFileThatItDidNotWrite) {
  const Outcome out = run({"lean", scene("pendulum"), "--response", "tip", "-o", results(), "--set",
                           "simulation.step=0.5", "--set", "simulation.max_iterations=3"});
  EXPECT_EQ(out.code, 1) << out.err;
  EXPECT_FALSE(fs::exists(results() / "lean.toml"));
  EXPECT_EQ(out.out.find("lean.toml"), std::string::npos) << out.out;
}

}  // namespace
}  // namespace liesl::test::refusals_test
