/// @file
/// Input that was accepted in silence, or refused with poor words: each with its exit code and the
/// words that tell it, with its place.
#include <hdf5.h>
#include <sys/resource.h>

#include <algorithm>
#include <functional>
#include <set>

#include "apps/program.hpp"
#include "mbs/linalg/sanitized.hpp"

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
     "'rate' sets 'joints.motor.drive.rate' in each of its cases"},
    {"TableOfAGriddedKeyForAllCases",
     {"batch", "BATCH", "-o", "DIR/b", "--set", "joints.motor.drive={rate=3}"},
     2,
     "'rate' sets 'joints.motor.drive.rate' in each of its cases"},
    {"GriddedKeyOfTheSceneForAllCases",
     {"batch", "STUDY_BATCH", "-o", "DIR/b", "--set", "scene.joints.motor.drive.rate=3"},
     2,
     "--set scene.joints.motor.drive.rate=3: 'rate' sets 'joints.motor.drive.rate' in each of its "
     "cases; expected a key that no axis and no column sets; hint: change its values, or leave "
     "'rate' out"},
    {"GriddedKeyTwice", {"check", "TWICE_BATCH"}, 2, "is there twice"},
    {"GriddedKeyForAllRows",
     {"check", study("compare_heavy_top"), "--set", "simulation.step=2e-3"},
     2,
     "--set simulation.step=2e-3: 'step' sets 'simulation.step' in each of its cases; expected a "
     "key that no axis and no column sets"},
    {"KeyOfAModelForAllRows",
     {"check", study("compare_pendulum"), "--set", "simulation.constraints=\"penalty\""},
     2,
     "'penalty' sets 'simulation.constraints' in each of its cases"},
    {"GriddedMethodForAllRows",
     {"check", study("compare_methods_rod"), "--set", "cycle.method=full"},
     2,
     "'method' sets 'cycle.method' in each of its cases"},
    {"GriddedKeyInTheFileOfAComparison",
     {"check", "COMPARISON"},
     2,
     "comparison.toml:7:21: 'step' sets 'simulation.step' in each of its cases; expected a key "
     "that no axis sets; hint: leave 'simulation.step' out of 'set'"},
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
    {"StartInRpm", scene_with("bodies.r.angular_velocity=[0,0,3000]"), 0,
     "note: bodies.r.angular_velocity turns at 3000 rad/s, that is 2.865e+04 rpm: 3000 rpm is "
     "314.2 rad/s"},
    {"StressOfABeamInMPa",
     {"check", study("slider_crank_both"), "--set", "constraints.rod_stress.limit=200"},
     0,
     "note: constraints.rod_stress.limit = 200 Pa is far below what materials bear, 9.5e-10 of E: "
     "200 MPa is 2e+08 Pa"},
    {"StressOfATrussInMPa",
     {"check", study("truss_10"), "--set", "constraints.stress.limit=172"},
     0,
     "note: constraints.stress.limit = 172 Pa is far below what materials bear"},
    {"StressOfAPartInMPa",
     {"check", study("cantilever"), "--set",
      "part_limits.peak={of=\"plate\",quantity=\"stress\",limit=100}"},
     0,
     "note: part_limits.peak.limit = 100 Pa is far below what materials bear"},
    {"CasesWithoutEnd",
     {"check", study("slider_crank_rod"), "--set", "cycle.min_cases=1e18"},
     2,
     "expected an integer >= 1, at most 1e+09"},
    {"OrderThree",
     {"check", scene("pendulum"), "--set", "bodies.beam.beam.order=3"},
     2,
     "--set bodies.beam.beam.order=3: beam 'beam' has order 3; expected 2 or 4"},
    {"MoreElementsThanThereMayBe",
     {"check", scene("pendulum"), "--set", "bodies.beam.beam.elements=10001"},
     2,
     "--set bodies.beam.beam.elements=10001: 'bodies.beam.beam.elements' is out of range: 10001; "
     "expected an integer in [1, 10000]"},
    {"NoDuration", scene_with("simulation.duration=0"), 2,
     "simulation.duration=0: 'simulation.duration' is out of range: 0; expected a number > 0 (s)"},
    {"ScenarioWithFewerVariables",
     {"check", study("rod_three_speeds"), "--set",
      "scenarios.rated.set={\"bodies.rod.beam.elements\"=2}"},
     2,
     "rod_three_speeds.toml:10:9: scenario 'rated' has other bodies than 'over'"},
    {"RecordsWithoutEnd", scene_with("simulation.output_every=1e12"), 2,
     "expected an integer >= 1, at most 1e+09"},
    {"MaximaForAnOptimiserOfTheMotion",
     {"check", study("slider_crank_rod"), "--set", "cycle.method=\"direct\"", "--set",
      "constraints.bending.treatment=\"maxima\""},
     2,
     "the number of maxima changes with the design, and cycle.method is \"direct\""},
    {"TreatmentUnderFixedLoads",
     {"check", study("cantilever"), "--set", "constraints.sag.treatment=\"maxima\""},
     2,
     "'sag' has a treatment over time, and fixed loads have no motion; expected \"auto\""},
    {"AggregateOfThePlainCycle",
     {"check", study("slider_crank_rod"), "--set", "cycle.method=\"esl\"", "--set",
      "constraints.bending.treatment=\"ks\""},
     2,
     "is told by the motion's own gradients, and the method \"esl\" uses static problems only; "
     "expected \"auto\""},
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
    {"InterpolationWithARate", scene_with("joints.j2.drive.interpolation=\"linear\""), 2,
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
      {"STUDY_BATCH",
       write("study_batch.toml", "study = \"" + study("slider_crank_rod") +
                                     "\"\n[grid]\nrate = { key = \"joints.motor.drive.rate\", "
                                     "values = [100, 150] }\n")},
      {"TWICE_BATCH",
       write("twice_batch.toml", "study = \"" + study("slider_crank_rod") +
                                     "\"\n[grid]\nrate = { key = \"joints.motor.drive.rate\", "
                                     "values = [100, 150] }\nagain = { key = "
                                     "\"scene.joints.motor.drive.rate\", values = [1] }\n")},
      {"COMPARISON",
       write("comparison.toml",
             "scene = \"" + scene("heavy_top") +
                 "\"\nquantity = { response = \"centre\", norm = \"final\" }\n[grid]\n"
                 "formalism = [\"se3\"]\nstep = [1e-3]\n[set]\n\"simulation.step\" = 2e-3\n")},
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

class Drawing : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    ASSERT_EQ(run(short_run()).code, 0);
  }
  void TearDown() override {
    unsetenv("LIESL_PYTHON");
    Program::TearDown();
  }
  Words short_run(const Words& more = {}) const {
    Words words = {"run",     scene("slider_crank"), "-q",    "-o",
                   results(), "--no-report",         "--set", "simulation.duration=0.005"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  /// `plot` with a script in the place of Python: $4 is the folder for its pictures.
  Outcome plot_by(const std::string& script) const {
    const fs::path python = write("python", "#!/bin/sh\n" + script + "\n");
    fs::permissions(python, fs::perms::owner_all);
    setenv("LIESL_PYTHON", python.c_str(), 1);
    return run({"plot", results()});
  }
};

/// A drawing that is killed among its pictures leaves nothing that keeps --force from its folder.
TEST_F(Drawing, KilledIsReplaced) {
  const Outcome killed = plot_by("mkdir -p \"$4\"; echo half > \"$4/motion.png\"; kill -9 $PPID");
  EXPECT_EQ(killed.code, -SIGKILL);
  const Outcome again = run(short_run({"--force"}));
  EXPECT_EQ(again.code, 0) << again.err;
  fs::create_directory(results() / "plots");  // as earlier versions left it
  const Outcome once_more = run(short_run({"--force"}));
  EXPECT_EQ(once_more.code, 0) << once_more.err;
}

/// Half a drawing leaves no pictures, a whole one is known as liesl's.
TEST_F(Drawing, IsWholeOrNotThere) {
  const std::string picture =
      "mkdir -p \"$4\"; echo whole > \"$4/motion.png\"; echo \"$4/motion.png\"";
  const Outcome failed = plot_by(picture + "; echo 'plot: no room' >&2; exit 1");
  EXPECT_EQ(failed.code, 3);
  EXPECT_NE(failed.err.find("cannot draw '" + results().string() + "': plot: no room"),
            std::string::npos)
      << failed.err;
  EXPECT_FALSE(fs::exists(results() / "plots"));
  const Outcome whole = plot_by(picture);
  EXPECT_EQ(whole.code, 0) << whole.err;
  EXPECT_EQ(whole.out, (results() / "plots/motion.png").string() + "\n");
  EXPECT_EQ(text_of(results() / "plots/motion.png"), "whole\n");
  for (const auto& entry : fs::directory_iterator(results()))
    EXPECT_EQ(entry.path().filename().string().find(".plots"), std::string::npos) << entry.path();
  const Outcome again = run(short_run({"--force"}));
  EXPECT_EQ(again.code, 0) << again.err;
}

/// What `report` refuses, `plot` refuses: another version, a wrong type, half a file. It writes
/// nothing, and names file and key.
TEST_F(Drawing, RefusesWhatIsNoSummaryOfThisVersion) {
  const fs::path path = results() / "summary.json";
  const std::string whole = text_of(path);
  Json other = Json::parse(whole), typed = other, inner = other, last = other;
  other["versions"]["liesl"] = "0.0.1";
  typed["steps"] = "many";
  inner["responses"] = 3;
  last["responses"]["bend"]["unit"] = 1;
  const std::pair<std::string, const char*> cases[] = {
      {other.dump(), "it is of liesl \"0.0.1\""},
      {typed.dump(), "its 'steps' is string"},
      {inner.dump(), "its 'responses' is number"},
      {last.dump(), "its 'responses.bend.unit' is number"},
      {whole.substr(0, whole.size() / 2), "it is not of liesl, or not whole"}};
  for (const auto& [text, reason] : cases) {
    std::ofstream(path) << text;
    const Outcome out = run({"plot", results()});
    EXPECT_EQ(out.code, 3) << reason;
    EXPECT_NE(out.err.find("cannot plot '" + path.string() + "': " + reason), std::string::npos)
        << out.err;
    EXPECT_EQ(run({"report", results()}).code, 3) << reason;
    EXPECT_FALSE(fs::exists(results() / "plots"));
  }
}

/// Half a folder is refused by what is missing, by every reader, which writes nothing.
TEST_F(Drawing, RefusesHalfAResult) {
  const fs::path deck = results().parent_path() / "deck";
  for (const char* name : {"responses.csv", "results.h5", ".liesl"}) {
    const fs::path aside = results().parent_path() / "aside";
    fs::rename(results() / name, aside);
    const std::string reason =
        " '" + results().string() + "': its " + name + " is not there; copy the whole folder";
    for (const Outcome& out :
         {run({"plot", results()}), run({"report", results()}),
          run({"export", results(), "--part", "rod", "--to", "calculix", "-o", deck}),
          run({"export", results(), "--to", "xdmf"})}) {
      EXPECT_EQ(out.code, 3) << name;
      EXPECT_NE(out.err.find(reason), std::string::npos) << out.err;
    }
    EXPECT_FALSE(fs::exists(results() / "plots") || fs::exists(deck)) << name;
    fs::rename(aside, results() / name);
  }
}

/// A results.h5 that was cut off, is something else or lacks a data set is refused by its name.
TEST_F(Drawing, RefusesResultsThatAreNotWhole) {
  const fs::path path = results() / "results.h5", deck = results().parent_path() / "deck";
  const std::string whole = text_of(path);
  const auto lose = [&](const char* set) {
    std::ofstream(path, std::ios::binary) << whole;
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    EXPECT_GE(H5Ldelete(file, set, H5P_DEFAULT), 0) << set;
    H5Fclose(file);
  };
  const auto put = [&](const std::string& text) { std::ofstream(path, std::ios::binary) << text; };
  const std::pair<std::function<void()>, const char*> cases[] = {
      {[&] { put(whole.substr(0, whole.size() / 2)); }, "it is no HDF5 file, or not a whole one"},
      {[&] { put("no numbers\n"); }, "it is no HDF5 file, or not a whole one"},
      {[&] { put(""); }, "it is no HDF5 file, or not a whole one"},
      {[&] { lose("/time"); }, "it has no 'time'"},
      {[&] { lose("/responses/bend"); }, "it has no 'responses/bend'"},
      {[&] { lose("/bodies/rod/position"); }, "it has no 'bodies/rod/position'"}};
  std::set<fs::path> before;
  for (const auto& entry : fs::directory_iterator(results())) before.insert(entry.path());
  for (const auto& [spoil, reason] : cases) {
    spoil();
    for (const Outcome& out :
         {run({"plot", results()}), run({"report", results()}),
          run({"export", results(), "--part", "rod", "--to", "calculix", "-o", deck}),
          run({"export", results(), "--to", "xdmf"})}) {
      EXPECT_EQ(out.code, 3) << reason;
      EXPECT_NE(out.err.find("'" + path.string() + "': " + reason +
                             "; copy the whole folder, or run it again"),
                std::string::npos)
          << out.err;
    }
    std::set<fs::path> after;
    for (const auto& entry : fs::directory_iterator(results())) after.insert(entry.path());
    EXPECT_EQ(after, before) << reason;
    EXPECT_FALSE(fs::exists(deck)) << reason;
  }
  put(whole);
  EXPECT_EQ(run({"report", results()}).code, 0);
}

/// A NUL ended the message.
TEST_F(Drawing, MessagesAreWholeWhereATableHasANul) {
  const fs::path table = results() / "responses.csv";
  std::string text = text_of(table);
  const auto cell = text.find(',', text.find('\n')) + 1;
  text.insert(cell, std::string("1\0"
                                "2\x1b",
                                4));
  std::ofstream(table, std::ios::binary) << text;
  for (const char* command : {"report", "plot"}) {
    const Outcome out = run({command, results()});
    EXPECT_EQ(out.code, 3);
    EXPECT_NE(out.err.find("responses.csv"), std::string::npos) << out.err;
    EXPECT_NE(out.err.find("'1\\x002\\x1b"), std::string::npos) << out.err;
    EXPECT_NE(out.err.find("in line 2 is no "), std::string::npos) << out.err;
    EXPECT_NE(out.err.find("run it again\n"), std::string::npos) << out.err;
  }
}

/// The command line is in the summary as it was given.
TEST_F(Drawing, SummaryHoldsTheArguments) {
  const Words words = short_run({"--verify", "--force"});
  ASSERT_EQ(run(words).code, 0);
  EXPECT_EQ(summary()["arguments"].get<Words>(), words);
}

#ifndef LIESL_SANITIZED  // its shadow memory alone is more than any limit
/// Under a limit of the address space, what a library without memory says, or a timer ends because
/// it asks for ever, is told as that.
TEST_F(Drawing, WithoutMemoryIsToldAsThat) {
  const char* scripts[] = {"kill -PROF $$",
                           "echo 'ImportError: _image.so: failed to map segment'; exit 1",
                           "echo MemoryError; exit 1"};
  EXPECT_NE(plot_by(scripts[0]).err.find("it was ended by signal"), std::string::npos);
  rlimit before;
  getrlimit(RLIMIT_AS, &before);
  rlimit much = before;
  much.rlim_cur = rlim_t{1} << 38;
  setrlimit(RLIMIT_AS, &much);
  for (const char* script : scripts) {
    const Outcome out = plot_by(script);
    EXPECT_EQ(out.code, 3) << script;
    EXPECT_NE(out.err.find("': out of memory"), std::string::npos) << out.err;
  }
  setrlimit(RLIMIT_AS, &before);
}
#endif

using Misspelt = Program;

/// A table that is misspelt is one problem: what follows from it is not told.
TEST_F(Misspelt, TableIsOneProblem) {
  std::string text = text_of(scene("slider_crank"));
  text.replace(text.find("[bodies]"), 8, "[bodie]");
  const Outcome out = run({"check", write("misspelt.toml", text).string()});
  EXPECT_EQ(out.code, 2);
  EXPECT_NE(out.err.find("did you mean 'bodies'?"), std::string::npos) << out.err;
  EXPECT_EQ(std::count(out.err.begin(), out.err.end(), '\n'), 1) << out.err;
}

using LeanEnd = Program;

/// A lean model that was not found is not named as a file.
TEST_F(LeanEnd, NamesNoFileThatItDidNotWrite) {
  const Outcome out = run({"lean", scene("pendulum"), "--response", "tip", "-o", results(), "--set",
                           "simulation.step=0.5", "--set", "simulation.max_iterations=3", "--set",
                           "simulation.tolerance=1e-6", "--set", "bodies.beam.beam.order=2"});
  EXPECT_EQ(out.code, 1) << out.err;
  EXPECT_FALSE(fs::exists(results() / "lean.toml"));
  EXPECT_EQ(out.out.find("lean.toml"), std::string::npos) << out.out;
}

}  // namespace
}  // namespace liesl::test::refusals_test
