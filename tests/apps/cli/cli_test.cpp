/// @file
/// The program itself: exit codes, what it prints and leaves behind, also when it is stopped.
#include <algorithm>
#include <cmath>
#include <set>

#include "apps/program.hpp"
#include "apps/scene/load_scene.hpp"
#include "reference/solved.hpp"

namespace liesl::test::cli_test {
namespace {

class Cli : public Program {};

Words short_run(const fs::path& out, const Words& more = {}) {
  Words words = {"run",   scene("slider_crank"),      "-o",    out,
                 "--set", "simulation.duration=0.01", "--set", "simulation.step=1e-3"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST_F(Cli, VersionListsTheLibraries) {
  const Outcome o = run({"--version"});
  EXPECT_EQ(o.code, 0);
  EXPECT_EQ(o.out.substr(0, 6), "liesl ");
  for (const char* library : {"Eigen", "Ipopt", "NLopt", "HDF5", "SuiteSparse"})
    EXPECT_NE(o.out.find(library), std::string::npos) << library << " in\n" << o.out;
  const Outcome by_program = run({"--version", "--version"});  // bin/liesl tells what one asks for
  EXPECT_EQ(by_program.out, o.out);
}

TEST_F(Cli, CommandLineThatIsNoneIsRefused) {
  EXPECT_EQ(run({"run"}).code, 2) << "no file";
  EXPECT_EQ(run({"optimise", "x"}).code, 2);
  EXPECT_EQ(run({"--help"}).code, 0);
  const Outcome misspelt = run({"runn", scene("pendulum"), "-o", results()});
  EXPECT_EQ(misspelt.code, 2);
  EXPECT_NE(misspelt.err.find("there is no command 'runn'; did you mean 'run'?"), std::string::npos)
      << misspelt.err;
  const Outcome strange = run({"zzzzzzzz"});
  EXPECT_EQ(strange.code, 2);
  EXPECT_NE(
      strange.err.find("known: check, run, esl, sensitivity, optimize, map, batch, compare, lean, "
                       "report, plot, export, "),
      std::string::npos)
      << strange.err;
}

TEST_F(Cli, UnknownOptionsComeWithTheNearestOne) {
  const auto refused = [&](const Words& words, const std::string& text) {
    const Outcome o = run(words);
    EXPECT_EQ(o.code, 2) << text;
    EXPECT_NE(o.err.find(text), std::string::npos) << o.err;
  };
  refused({"run", scene("pendulum"), "--no-reprt"},
          "liesl run: there is no option '--no-reprt'; did you mean '--no-report'?");
  refused({"run", "--no-reprt=1"}, "there is no option '--no-reprt'");
  refused({"--vresion"}, "liesl: there is no option '--vresion'; did you mean '--version'?");
  refused({"--foo"}, "liesl: there is no option '--foo'; known: --help, -h, --version");
  refused({"run", scene("pendulum"), "--set"}, "--set");
  refused({"export", "x", "--to", "calculx"},
          "--to: there is no 'calculx'; did you mean 'calculix'?");
  refused({"schema", "scen"}, "KIND: there is no 'scen'; did you mean 'scene'?");
}

TEST_F(Cli, AloneItSaysWhatItIsFor) {
  const Outcome o = run({});
  EXPECT_EQ(o.code, 0);
  for (const char* text : {"liesl new study --like", "optimize", "report", "completion"})
    EXPECT_NE(o.out.find(text), std::string::npos) << text;
}

/// In a folder of its own, as a user works.
class CliHere : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    before_ = fs::current_path();
    fs::current_path(dir_);
  }
  void TearDown() override {
    fs::current_path(before_);
    Program::TearDown();
  }
  fs::path before_;
};

TEST_F(CliHere, NewFilesRunAndResultsAreNamedAfterThem) {
  const Outcome made = run({"new", "study", "--like", "slider_crank_rod"});
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_NE(text_of("slider_crank_rod.toml").find("scene = \"slider_crank.toml\""),
            std::string::npos);
  EXPECT_EQ(run({"check", "slider_crank_rod.toml"}).code, 0);
  EXPECT_EQ(run({"run", "slider_crank.toml", "--set", "simulation.duration=0.001"}).code, 0);
  EXPECT_TRUE(fs::exists("slider_crank/summary.json"));
  const Words map = {"map",      "slider_crank_rod.toml",
                     "--over",   "rod_diameters[1],rod_diameters[2]",
                     "--points", "2",
                     "--set",    "simulation.duration=0.001"};
  EXPECT_EQ(run(map).code, 0);
  EXPECT_TRUE(fs::exists("slider_crank_rod/map.csv"));
  const Outcome again = run({"new", "study", "--like", "slider_crank_rod"});
  EXPECT_EQ(again.code, 3);
  EXPECT_NE(again.err.find("it exists"), std::string::npos) << again.err;
}

/// What is said to do next can be copied to a shell.
TEST_F(CliHere, NextCommandsAreQuotedWhereTheyHaveTo) {
  const auto next = [this](const char* file) {
    const std::string text = run({"new", "scene", "--like", "pendulum", "-o", file}).out;
    return text.substr(text.find("next: "));
  };
  EXPECT_EQ(next("it's one.toml"), "next: liesl run 'it'\\''s one.toml'\n");
  EXPECT_EQ(next("p_2.toml"), "next: liesl run p_2.toml\n");
  const Outcome ran = run({"run", "p_2.toml", "-o", "my run", "--set", "simulation.duration=0.01"});
  EXPECT_NE(ran.out.find("look at my run/report.html, or: liesl plot 'my run'\n"), ran.out.npos)
      << ran.out;
}

TEST_F(CliHere, NewFilesNameTheSchemaOfTheProgram) {
  EXPECT_EQ(run({"new", "study", "--like", "slider_crank_rod"}).code, 0);
  for (const char* name : {"slider_crank_rod", "slider_crank"}) {
    const std::string text = text_of(std::string(name) + ".toml"), word = "#:schema ";
    ASSERT_TRUE(text.starts_with(word)) << text.substr(0, 80);
    const fs::path schema = text.substr(word.size(), text.find('\n') - word.size());
    EXPECT_TRUE(schema.is_absolute()) << schema;
    const char* kind = name == std::string("slider_crank") ? "scene" : "study";
    EXPECT_EQ(text_of(schema), run({"schema", kind}).out) << schema;
    EXPECT_EQ(text.find(word, word.size()), std::string::npos) << "once";
  }
}

TEST_F(CliHere, EveryShippedFileCanBeBegunFrom) {
  for (const char* kind : {"scene", "study"}) {
    const Outcome o = run({"new", kind});
    EXPECT_EQ(o.code, 2);
    const std::string known = "known: ";
    std::istringstream names(o.err.substr(o.err.find(known) + known.size()));
    for (std::string name; std::getline(names >> std::ws, name, ',');) {
      name.erase(name.find_last_not_of(" \n") + 1);
      EXPECT_EQ(run({"new", kind, "--like", name, "--force", "--quiet"}).code, 0) << name;
      const Outcome checked = run({"check", name + ".toml", "--quiet"});
      EXPECT_EQ(checked.code, 0) << checked.err;
    }
  }
  EXPECT_NE(run({"new", "scene", "--like", "four_bra"}).err.find("did you mean 'four_bar'"),
            std::string::npos);
  const Outcome begins = run({"new", "study", "--like", "four_bar", "--force"});
  EXPECT_EQ(begins.code, 0) << begins.err;
  EXPECT_NE(begins.out.find("optimize four_bar_mixed.toml"), std::string::npos) << begins.out;
  EXPECT_EQ(run({"new", "mesh"}).code, 2);
}

TEST_F(CliHere, CompletionKnowsEveryCommandAndOption) {
  const Outcome o = run({"completion", "bash"});
  EXPECT_EQ(o.code, 0);
  std::ofstream("complete.sh") << o.out << R"(
COMP_WORDS=(liesl opt); COMP_CWORD=1; _liesl; echo "${COMPREPLY[@]}"
COMP_WORDS=(liesl optimize --no); COMP_CWORD=2; _liesl; echo "${COMPREPLY[@]}"
COMP_WORDS=(liesl optimize x.toml --method es); COMP_CWORD=4; _liesl; echo "${COMPREPLY[@]}"
COMP_WORDS=(liesl export x --to = cal); COMP_CWORD=5; _liesl; echo "${COMPREPLY[@]}"
COMP_WORDS=(liesl export x --to =); COMP_CWORD=4; _liesl; echo "${COMPREPLY[@]}"
COMP_WORDS=(liesl export x --cases ""); COMP_CWORD=4; _liesl; echo "${COMPREPLY[@]}"
COMP_WORDS=(liesl schema s); COMP_CWORD=2; _liesl; echo "${COMPREPLY[@]}"
COMP_WORDS=(liesl new ""); COMP_CWORD=2; _liesl; echo "${COMPREPLY[@]}"
COMP_WORDS=(liesl new study --like four_bar_m); COMP_CWORD=4; _liesl; echo "${COMPREPLY[@]}"
COMP_WORDS=(liesl new scene --like pendul); COMP_CWORD=4; _liesl; echo "${COMPREPLY[@]}"
COMP_WORDS=(liesl run comp); COMP_CWORD=2; _liesl; echo "${COMPREPLY[@]}"
)";
  EXPECT_EQ(std::system("bash complete.sh > words"), 0);
  EXPECT_EQ(text_of("words"),
            "optimize\n--no-verify --no-report\nesl esl1\ncalculix\nxdmf calculix nastran "
            "matrices\npeaks all\nscene study sensitivity\nscene study\nfour_bar_mixed\n"
            "pendulum\ncomplete.sh\n");
  EXPECT_EQ(run({"completion", "csh"}).code, 2);
}

TEST_F(CliHere, ManualPageHasEveryCommandAndOption) {
  const Outcome o = run({"man"});
  EXPECT_EQ(o.code, 0);
  for (const char* text : {".TH LIESL 1", "\\fBliesl optimize\\fR \\fISTUDY",
                           "\\fB\\-\\-no\\-report\\fR", "\\fBliesl man\\fR", ".SH EXIT STATUS"})
    EXPECT_NE(o.out.find(text), std::string::npos) << text;
}

TEST_F(Cli, RunAnswersWithFiguresAndNoProgressInAPipe) {
  const Outcome o = run(short_run(results()));
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(o.err, "");
  EXPECT_NE(o.out, "");
  EXPECT_EQ(o.out.find_first_of("\r\033"), std::string::npos) << o.out;
  EXPECT_EQ(summary()["status"], "done");
  EXPECT_EQ(summary()["steps"], 10) << "--set of a scene";
  for (const char* file :
       {"results.h5", "results.xdmf", "responses.csv", "energies.csv", "joints.csv"})
    EXPECT_TRUE(fs::exists(results() / file)) << file;
}

TEST_F(Cli, QuietPrintsNothing) {
  const Outcome o = run(short_run(results(), {"--quiet"}));
  EXPECT_EQ(o.code, 0);
  EXPECT_EQ(o.out + o.err, "");
}

TEST_F(Cli, BadInputIsRefusedWithAllProblemsAtTheirPlaces) {
  const fs::path file = write("bad.toml",
                              "name = \"bad\"\n"
                              "gravety = [0, 0, 0]\n"
                              "[materials]\n"
                              "steel = { E = -1, nu = 0.3, rho = 7850 }\n"
                              "[simulation]\n"
                              "step = \"small\"\n");
  const Outcome o = run({"run", file, "-o", results()});
  EXPECT_EQ(o.code, 2);
  for (const char* place : {":2:1: ", ":4:15: ", ":6:8: "})
    EXPECT_NE(o.err.find(file.string() + place), std::string::npos) << place << " in\n" << o.err;
  EXPECT_NE(o.err.find("'gravity'"), std::string::npos) << o.err;
  EXPECT_FALSE(fs::exists(results()));
  EXPECT_EQ(run({"check", dir_ / "absent.toml"}).code, 2);
  EXPECT_EQ(run(short_run(results(), {"--set", "simulation.stepp=1"})).code, 2);
}

TEST_F(Cli, FolderThatCannotBeWrittenIsAnError) {
  write("file", "");
  const Outcome o = run(short_run(dir_ / "file" / "results"));
  EXPECT_EQ(o.code, 3);
  EXPECT_NE(o.err.find((dir_ / "file").string()), std::string::npos) << o.err;
  EXPECT_EQ(run(short_run(dir_)).code, 3) << "a folder that holds something else";
  EXPECT_EQ(run(short_run(results())).code, 0);
  EXPECT_EQ(run(short_run(results())).code, 3) << "an earlier result, no --force";
  EXPECT_EQ(run(short_run(results(), {"--force"})).code, 0);
}

TEST_F(Cli, FilesOfTheUserStay) {
  const Words more = {"--quiet"};
  ASSERT_EQ(run(short_run(results(), more)).code, 0);
  fs::copy(scene("slider_crank"), results() / "scene.toml");
  fs::create_directory(results() / "photos");
  std::ofstream(results() / "photos" / "1.jpg") << "picture";
  Words again = short_run(results(), {"--force"});
  again[1] = results() / "scene.toml";
  const Outcome o = run(again);
  EXPECT_EQ(o.code, 3);
  EXPECT_NE(o.err.find("it holds 'photos/1.jpg' (and 1 more), which liesl did not write"),
            std::string::npos)
      << o.err;
  EXPECT_EQ(text_of(results() / "scene.toml"), text_of(scene("slider_crank")));
  EXPECT_EQ(text_of(results() / "photos" / "1.jpg"), "picture");
}

TEST_F(Cli, ResumeOfAFinishedRunKeepsFilesOfTheUser) {
  const Words words = {"optimize", study("slider_crank_rod"), "-o", results(), "--quiet"};
  fs::copy(solved_folder("slider_crank_rod"), results(), fs::copy_options::recursive);
  std::ofstream(results() / "notes.txt") << "mine";
  Words resume = words;
  resume.push_back("--resume");
  const Outcome o = run(resume);
  EXPECT_NE(o.code, 0);
  EXPECT_EQ(text_of(results() / "notes.txt"), "mine") << o.err;
  resume.back() = "--force";
  const Outcome forced = run(resume);
  EXPECT_EQ(forced.code, 3);
  EXPECT_NE(forced.err.find("'notes.txt'"), std::string::npos) << forced.err;
  EXPECT_EQ(text_of(results() / "notes.txt"), "mine");
}

TEST_F(Cli, NumberOfThreadsOutOfRangeIsSaidShortly) {
  const Outcome o = run(short_run(results(), {"--threads", "-1"}));
  EXPECT_EQ(o.code, 2);
  EXPECT_NE(o.err.find("1024"), std::string::npos) << o.err;
  EXPECT_LT(o.err.size(), 200u) << o.err;
}

TEST_F(Cli, OptimizeSaysHowItEnded) {
  const auto optimize = [&](const Words& changes) {
    Words words = {"optimize", study("slider_crank_rod"), "-o", results(), "--force"};
    for (const auto& change : changes) words.insert(words.end(), {"--set", change});
    return run(words);
  };
  EXPECT_EQ(optimize({"cycle.method=esl"}).code, 0);
  EXPECT_EQ(summary()["status"], "converged");
  EXPECT_EQ(optimize({"cycle.max=1"}).code, 1);
  EXPECT_EQ(summary()["status"], "cycle limit");
  EXPECT_EQ(optimize({"constraints.bending.limit=1e-5", "simulation.duration=0.03"}).code, 1);
  EXPECT_EQ(summary()["status"], "infeasible");
  EXPECT_NE(summary()["reason"].get<std::string>().find("'bending'"), std::string::npos);
  EXPECT_TRUE(summary()["prices"].empty()) << "what a limit saves is said of designs that meet it";
  EXPECT_NE(summary()["kkt"].get<std::string>().find("limits are exceeded"), std::string::npos);
  const Outcome failed = optimize({"joints.motor.drive.rate=1e7"});
  EXPECT_EQ(failed.code, 1);
  EXPECT_EQ(summary()["status"], "simulation failed");
  EXPECT_EQ(failed.out.find("nan"), std::string::npos) << failed.out;
}

const char* const kSwing = R"toml(
[materials]
steel = { E = 2.1e11, nu = 0.3, rho = 7800 }
[sections]
square = { type = "rectangle", width = 0.02, height = 0.02 }
[bodies.arm]
beam = { from = [0, 0, 0], to = [1, 0, 0], section = "square", material = "steel", elements = 4 }
[joints.hinge]
revolute = ["ground", "arm.start"]
axis = [0, 0, 1]
drive = { interpolation = "quintic", table = [[0, 0], [0.1, 0.1], [0.2, 0]] }
[simulation]
duration = 0.2
step = 2e-3
rho_inf = 0.8
[responses]
torque = { response = "drive_force", of = "hinge" }
)toml";

const char* const kSwingLess = R"toml(
scene = "scene.toml"
[design]
way = { of = "hinge", property = "drive.table.1", bounds = [0, 0.3] }
[objective]
minimize = "weighted"
of = "arm"
weights = { largest = 1 }
largest = "torque"
[constraints]
torque = { use = "torque", limit = 100 }
)toml";

/// A torque that is to be as small as possible is none in the end, and no cycle goes on from there.
TEST_F(Cli, StudiesThatLoseTheirSensitivitiesSayHowTheyEnded) {
  write("scene.toml", kSwing);
  const auto optimize = [&](const char* start) {
    return run({"optimize", write("study.toml", kSwingLess), "-o", results(), "--set",
                std::string("design.way.start=") + start});
  };
  const Outcome none = optimize("0");
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.err.find("cycle.method needs sensitivities"), std::string::npos) << none.err;
  EXPECT_FALSE(fs::exists(results())) << "nothing ran";
  const Outcome lost = optimize("0.1");
  EXPECT_EQ(lost.code, 1) << lost.err;
  EXPECT_EQ(summary()["status"], "simulation failed");
  const std::string reason = summary()["reason"];
  EXPECT_NE(reason.find("after cycle 2: 'torque' of the objective is 0 all the time; bounds"),
            reason.npos)
      << reason;
  EXPECT_EQ(summary()["design"]["way"], 0);
  EXPECT_TRUE(fs::exists(results() / "report.html"));
}

TEST_F(Cli, SummaryHasTheDocumentedKeys) {
  const auto common = documented("### `run`\n").always;
  ASSERT_GE(common.size(), 17u);
  auto expected = common;
  for (const auto& key : documented("### `run` and `esl`").always) expected.insert(key);
  ASSERT_EQ(
      run({"esl", scene("pendulum"), "-o", results(), "--set", "simulation.duration=0.01"}).code,
      0);
  expected.insert({"identity", "input"});
  EXPECT_EQ(keys(summary()), expected);

  ASSERT_EQ(run(short_run(results(), {"-f"})).code, 0);
  expected.erase("identity");
  for (const char* key : {"mobility", "redundant_if_rigid", "input"}) {
    EXPECT_TRUE(documented("### `run` and `esl`").sometimes.count(key)) << key;
    expected.insert(key);
  }
  EXPECT_EQ(keys(summary()), expected);

  Json solved = solved_summary("slider_crank_rod");
  expected = common;
  for (const auto& key : documented("### `optimize`").always) expected.insert(key);
  expected.insert("input");
  for (const char* key : {"verification", "worst_constraint_error", "refinement", "design_files"}) {
    EXPECT_TRUE(documented("### `optimize`").sometimes.count(key)) << key;
    expected.insert(key);
  }
  EXPECT_EQ(keys(solved), expected);
  EXPECT_EQ(solved["cycles"], solved["history"].size());
}

TEST_F(Cli, EslWritesTheLoads) {
  Words words = short_run(results());
  words[0] = "esl";
  EXPECT_EQ(run(words).code, 0);
  const std::string table = text_of(results() / "loads.csv");
  EXPECT_EQ(table.substr(0, table.find('\n')),
            "time [s],body,node,Fx [N],Fy [N],Fz [N],Mx [N m],My [N m],Mz [N m]");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 11 * 2 * 9);
  EXPECT_TRUE(fs::exists(results() / "loads.h5"));
  EXPECT_LT(summary()["identity"]["rod"]["nonlinear"], 1e-10);
}

/// How far static problems are off, in percent; what an equilibrium runs over.
TEST_F(Cli, EslSaysHowWellTheLoadsGiveTheStrainsBack) {
  const Outcome o = run({"esl", scene("bend45"), "-o", results()});
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_NE(o.out.find("2 load cases; difference of the strains under them, of the largest: 0 %, "
                       "of a linear static problem 38 %\n"),
            std::string::npos)
      << o.out;
  EXPECT_NE(o.out.find("(an axial force changes the bending of a slender part"), std::string::npos);
  EXPECT_TRUE(text_of(results() / "loads.csv").starts_with("load_factor [-],body,node,"));
}

TEST_F(Cli, MethodThatTheMotionCannotServeIsRefused) {
  std::string twice = text_of(scene("slider_crank")), rod = text_of(study("slider_crank_rod"));
  const auto guide = twice.find("\nguide"), end = twice.find('\n', guide + 1);
  twice.insert(end, "\nagain" + twice.substr(guide + 6, end - guide - 6));
  write("twice.toml", twice);
  const std::string path = "../scenes/slider_crank.toml";
  const Outcome o =
      run({"optimize", write("study.toml", rod.replace(rod.find(path), path.size(), "twice.toml")),
           "-o", results(), "--method", "esl1", "--set", "simulation.constraints=augmented"});
  EXPECT_EQ(o.code, 2) << o.err;
  EXPECT_NE(o.err.find("cycle.method needs sensitivities"), std::string::npos) << o.err;
  EXPECT_EQ(run({"optimize", study("slider_crank_rod"), "-o", results(), "--method", "esl2"}).code,
            2);
}

/// Arms without drives have sensitivities, so nothing is said of them, but no static problem.
TEST_F(Cli, StaticsOfAMechanismThatMovesAreRefused) {
  std::string arms = text_of(scene("two_link_robot"));
  for (auto at = arms.find("\ndrive = "); at != std::string::npos; at = arms.find("\ndrive = "))
    arms.erase(at, arms.find('\n', at + 1) - at);
  write("scene.toml", arms);
  const Outcome o = run({"optimize", write("study.toml", R"toml(
scene = "scene.toml"
[design]
walls = { of = "arm1", property = "thickness", bounds = [0.0005, 0.005] }
[objective]
minimize = "mass"
of = ["arm1"]
[constraints]
tip = { use = "arm1_tip", limit = 2e-3, surrogate = "mechanism" }
)toml"),
                         "-o", results()});
  EXPECT_EQ(o.code, 2) << o.err;
  EXPECT_NE(o.err.find("study.toml: the mechanism can move at t = "), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("surrogate = \"auto\""), std::string::npos) << o.err;
  EXPECT_EQ(o.err.find("sensitivities"), std::string::npos) << o.err;
}

Words rod_study(const fs::path& out) {
  return {"optimize", study("slider_crank_rod"),          "-o",    out,
          "--set",    "design.rod_diameters.start=0.006", "--set", "simulation.step=5e-5"};
}

TEST_F(Cli, KilledRunLeavesAStateToResumeFrom) {
  ASSERT_EQ(run(rod_study(dir_ / "whole")).code, 0);
  const Json whole = Json::parse(text_of(dir_ / "whole" / "summary.json"));

  const pid_t child = start(rod_study(results()));
  ASSERT_TRUE(wait_for_results());
  kill(child, SIGKILL);
  ASSERT_EQ(wait_for(child).code, -SIGKILL) << "it was done before";
  EXPECT_EQ(summary()["status"], "running");
  EXPECT_GE(summary()["history"].size(), 1u);

  Words words = rod_study(results());
  words.push_back("--resume");
  const Outcome o = run(words);
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(summary()["status"], "optimal");
  EXPECT_EQ(summary()["cycles"], whole["cycles"]);
  for (const auto& [name, value] : whole["design"].items())
    EXPECT_NEAR(summary()["design"][name].get<double>(), value, 1e-5 * value.get<double>()) << name;
  for (const auto& entry : fs::directory_iterator(dir_))
    EXPECT_EQ(entry.path().filename().string().find(".partial"), std::string::npos) << entry.path();
}

TEST_F(Cli, InterruptedRunEndsWithAReadableState) {
  const pid_t child = start(rod_study(results()));
  ASSERT_TRUE(wait_for_results());
  kill(child, SIGINT);
  const Outcome o = wait_for(child);
  EXPECT_EQ(o.code, 1) << o.err;
  EXPECT_EQ(summary()["status"], "interrupted") << summary()["reason"];
  EXPECT_TRUE(fs::exists(results() / "checkpoint.json"));
  EXPECT_TRUE(std::isfinite(summary()["mass_final"].get<double>()));
  Words words = rod_study(results());
  words.push_back("--resume");
  EXPECT_EQ(run(words).code, 0);
}

TEST_F(Cli, ResumeOfNothingSaysWhatIsNext) {
  const Outcome o = run({"optimize", study("slider_crank_rod"), "-o", results(), "--resume"});
  EXPECT_EQ(o.code, 2);
  EXPECT_NE(o.err.find("there is no interrupted run in this folder"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("run without --resume"), std::string::npos) << o.err;
  EXPECT_FALSE(fs::exists(results()));
}

TEST_F(Cli, CheckCountsInWords) {
  const auto said = [&](const char* name) { return run({"check", scene(name)}).out; };
  EXPECT_NE(said("pendulum").find("a good scene of 1 body and 1 joint;"), std::string::npos);
  EXPECT_NE(said("slider_crank").find("a good scene of 3 bodies and 4 joints;"), std::string::npos);
}

TEST_F(Cli, LikelyMistakesInUnitsAreNoted) {
  const Outcome check = run({"check", scene("slider_crank"), "--set", "materials.steel.E=210"});
  EXPECT_EQ(check.code, 0);
  EXPECT_NE(check.out.find("materials.steel.E = 210 Pa"), std::string::npos) << check.out;
  ASSERT_EQ(run(short_run(results(), {"--set", "gravity=[0,-9810,0]"})).code, 0);
  ASSERT_FALSE(summary()["warnings"].empty());
  EXPECT_NE(summary()["warnings"][0].get<std::string>().find("9.81 m/s^2"), std::string::npos);
}

TEST_F(Cli, NonOptimalEndIsSaidWithItsResidual) {
  const Outcome o =
      run({"optimize", kData / "stability/studies/esl_non_optimal.toml", "-o", results()});
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_NEAR(summary()["kkt_residual"].get<double>(), 0.706, 0.02);
  EXPECT_NE(o.out.find("the dynamic optimality conditions do not hold"), std::string::npos)
      << o.out;
}

TEST_F(Cli, CheckpointOfAnotherStudyIsRefused) {
  const Words first = {"optimize",   study("slider_crank_rod"), "-o", results(), "--set",
                       "cycle.max=1"};
  ASSERT_EQ(run(first).code, 1);
  const Outcome o = run({"optimize", study("slider_crank_rod"), "-o", results(), "--resume",
                         "--set", "constraints.bending.limit=2e-3"});
  EXPECT_EQ(o.code, 2);
  EXPECT_NE(o.err.find("another input"), std::string::npos) << o.err;
}

/// More cycles and other tolerances go on, and end where a run without a break does.
TEST_F(Cli, ResumesWithMoreCyclesAndOtherTolerances) {
  for (const char* method : {"esl1", "esl"}) {
    const auto words = [&](const fs::path& out, const Words& more) {
      Words all = {"optimize", study("slider_crank_rod"),  "-o",       out,
                   "--set",    "simulation.duration=0.02", "--method", method};
      all.insert(all.end(), more.begin(), more.end());
      return all;
    };
    ASSERT_EQ(run(words(dir_ / "whole", {"--force"})).code, 0);
    ASSERT_EQ(run(words(results(), {"--force", "--set", "cycle.max=2"})).code, 1);
    EXPECT_EQ(summary()["status"], "cycle limit");
    const Outcome o = run(
        words(results(), {"--resume", "--set", "cycle.max=40", "--set", "cycle.tolerance=1e-3"}));
    EXPECT_EQ(o.code, 0) << o.err;
    const Json whole = Json::parse(text_of(dir_ / "whole" / "summary.json"));
    for (const char* key : {"status", "design", "cycles", "steps", "newton_iterations"})
      EXPECT_EQ(summary()[key], whole[key]) << method << key;
  }
}

/// A design asks for the tolerance of the motions it was found with.
TEST_F(Cli, FinalDesignIsConvergedAsTheOptimisationWas) {
  const auto tolerance = [&](const std::string& method, const std::string& of_scene) {
    run({"optimize", study("slider_crank_rod"), "-o", results(), "--force", "--no-verify",
         "--no-report", "--set", "cycle.max=1", "--set", "simulation.duration=0.02", "--set",
         "simulation.tolerance=" + of_scene, "--method", method});
    return read_scene(text_of(results() / "design.toml"), "design.toml").simulation.tolerance;
  };
  EXPECT_DOUBLE_EQ(tolerance("auto", "1e-5"), 1e-8);
  EXPECT_DOUBLE_EQ(tolerance("auto", "1e-9"), 1e-9);
  EXPECT_DOUBLE_EQ(tolerance("esl", "1e-5"), 1e-5);
}

/// The final design is a scene that runs at once, with the figures of the optimisation.
TEST_F(Cli, FinalDesignIsAScene) {
  const Words shorter = {"--set", "simulation.duration=0.02"};
  for (const char* name : {"slider_crank_rod", "connecting_rod"}) {
    Words words = {"optimize", study(name), "-o", results(), "--force", "--set", "cycle.max=1"};
    words.insert(words.end(), shorter.begin(), shorter.end());
    run(words);
    const Json optimised = summary();
    const Outcome o = run({"run", results() / "design.toml", "-o", dir_ / "again", "--force"});
    ASSERT_EQ(o.code, 0) << o.err;
    const Json again = Json::parse(text_of(dir_ / "again" / "summary.json"));
    for (const auto& [response, figures] : optimised["responses"].items()) {
      const double value = figures["max_abs"];
      EXPECT_NEAR(again["responses"][response]["max_abs"].get<double>(), value, 1e-6 * value)
          << name << response;
    }
  }
  // Of scenarios each has its own, the first one's is design.toml, too.
  Words speeds = {
      "optimize",   study("rod_three_speeds"), "-o", results(), "--force", "--set", "cycle.max=1",
      "--no-verify"};
  speeds.insert(speeds.end(), shorter.begin(), shorter.end());
  run(speeds);
  EXPECT_EQ(text_of(results() / "design.toml"), text_of(results() / "design_over.toml"));
  for (const std::string name : {"over", "rated", "slow"}) {
    const fs::path design = results() / ("design_" + name + ".toml");
    ASSERT_EQ(run({"run", design, "-o", dir_ / "again", "--force"}).code, 0);
    const Json bend = Json::parse(text_of(dir_ / "again/summary.json"))["responses"]["bend"];
    const double value = summary()["constraints"]["bending (" + name + ")"]["max_abs_final"];
    EXPECT_NEAR(bend["max_abs"].get<double>(), value, 1e-6 * value) << name;
  }
  // A truss: its bars have sections of their own, its nodes are ports of them.
  const char* tip = R"(responses.tip={response="translation",at="truss.n2",axis=[0,1,0]})";
  ASSERT_EQ(run({"optimize", study("truss_10"), "-o", results(), "--force", "--set", tip}).code, 0);
  const Outcome truss = run({"run", results() / "design.toml", "-o", dir_ / "again", "--force"});
  ASSERT_EQ(truss.code, 0) << truss.err;
  const Json tip_again = Json::parse(text_of(dir_ / "again" / "summary.json"));
  const double sag = summary()["responses"]["tip"]["max_abs"];
  EXPECT_GT(sag, 0);
  EXPECT_NEAR(tip_again["responses"]["tip"]["max_abs"].get<double>(), sag, 1e-6 * sag);
  const Words taper = {"sections.root={type=\"tube\",diameter=0.01,thickness=0.002}",
                       "sections.tip={type=\"tube\",diameter=0.01,thickness=0.001}",
                       "bodies.rod.beam.section=[\"root\",\"tip\"]",
                       "bodies.rod.beam.taper=true",
                       "design.rod_diameters.groups=1",
                       "design.rod_diameters.bounds=[0.006,0.020]",
                       "responses.stress={response=\"stress\",of=\"rod\"}"};
  const std::string mass =
      "design.slider={of=\"slider\", property=\"mass\", bounds=[0.05, 0.15], start=0.1}";
  for (const Words& changes : {Words{}, Words{mass}, taper}) {
    Words words = {"optimize", study("slider_crank_rod"), "-o", results(), "--force"};
    words.insert(words.end(), shorter.begin(), shorter.end());
    for (const auto& change : changes) words.insert(words.end(), {"--set", change});
    ASSERT_EQ(run(words).code, 0);
    const Json end = summary();
    run({"run", results() / "design.toml", "-o", dir_ / "again", "--force"});
    const Json again = Json::parse(text_of(dir_ / "again" / "summary.json"));
    ASSERT_FALSE(end["responses"].empty());
    for (const auto& [response, figures] : end["responses"].items()) {
      const double value = figures["max_abs"];
      EXPECT_NEAR(again["responses"][response]["max_abs"].get<double>(), value, 1e-6 * value);
    }
  }
}

/// Shipped files of a folder.
std::vector<fs::path> shipped(const char* folder) {
  std::vector<fs::path> list;
  for (const auto& entry : fs::directory_iterator(kData / folder))
    if (entry.path().extension() == ".toml") list.push_back(entry.path());
  std::sort(list.begin(), list.end());
  return list;
}

TEST_F(Cli, ChecksEveryShippedFile) {
  for (const char* folder : {"scenes", "studies", "stability", "stability/studies"}) {
    ASSERT_FALSE(shipped(folder).empty()) << folder;
    for (const auto& file : shipped(folder)) EXPECT_EQ(run({"check", file}).code, 0) << file;
  }
}

TEST_F(Cli, RunsEveryShippedScene) {
  ASSERT_GE(shipped("scenes").size(), 15u);
  for (const auto& file : shipped("scenes")) {
    const Outcome o = run({"run", file, "-o", results(), "-f", "-q"});
    EXPECT_EQ(o.code, 0) << file << "\n" << o.err;
    EXPECT_EQ(summary()["status"], "done") << file << ": " << summary()["reason"];
    if (file.stem() == "bend45")
      EXPECT_EQ(summary()["reason"], "in equilibrium under the whole load");
  }
}

}  // namespace
}  // namespace liesl::test::cli_test
