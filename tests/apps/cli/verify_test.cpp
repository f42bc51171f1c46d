/// @file
/// `--verify`: errors beside what they are of; what has none is refused before any work.
#include "apps/program.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/study/load_study.hpp"
#include "mbs/solids/solid_model.hpp"
#include "reference/solved.hpp"

namespace liesl::test::verify_test {
namespace {

const Words kOrder2 = {"--set", "bodies.crank.beam.order=2", "--set", "bodies.rod.beam.order=2"};

class VerifyCommand : public Program {
 protected:
  /// The optimised rod, verified as by default.
  Outcome optimise_rod(const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"optimize", study("slider_crank_rod"), "-o", results(),
                                          "--no-report"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  /// Refused before any work.
  void expect_refused(const std::vector<std::string>& arguments, const std::string& why) {
    const Outcome o = run(arguments);
    EXPECT_EQ(o.code, 2);
    EXPECT_NE(o.err.find(why), std::string::npos) << o.err;
    EXPECT_FALSE(fs::exists(results()));
  }
};

/// With 64 elements a link the optimised rod bends 1.8 % more than with 8 of order 2.
TEST_F(VerifyCommand, SaysWhatTheMeshHidesOfALimit) {
  const Outcome o =
      optimise_rod({"--set", "cycle.refine=never", "--set", kOrder2[1], "--set", kOrder2[3]});
  EXPECT_EQ(o.code, 0) << o.err;
  const double error = summary()["worst_constraint_error"];
  EXPECT_GT(error, 0.018 / 3);
  EXPECT_LT(error, 0.018 * 3);
  EXPECT_NE(o.out.find("limit bending is known to"), std::string::npos) << o.out << o.err;
}

TEST_F(VerifyCommand, NamesTheLimitsThatItLeavesOut) {
  const Outcome o =
      optimise_rod({"--set", "constraints.bending.treatment=functional", "--set", "cycle.max=1"});
  EXPECT_NE(o.code, 2) << o.err;
  EXPECT_NE(
      (o.out + o.err).find("not verified, being no largest value of a response: limit bending"),
      std::string::npos)
      << o.out << o.err;
}

/// A response that is made small has an error as one that is limited: the final design on 8 times
/// the elements.
TEST_F(VerifyCommand, TellsTheErrorOfTheObjective) {
  const Outcome o = run({"optimize", study("rod_stiffest"), "-o", results(), "--no-report", "--set",
                         "cycle.max=1", "--set", kOrder2[1], "--set", kOrder2[3]});
  ASSERT_NE(o.code, 2) << o.err;
  const Json s = summary();
  ASSERT_EQ(s["terms"].size(), 1u);
  const auto [name, term] = *s["terms"].items().begin();
  ASSERT_TRUE(term.contains("error")) << term;
  const double mesh = term["error"]["mesh"], weight = term["weight"];
  EXPECT_NEAR(s["objective"]["error"]["mesh"].get<double>(), weight * mesh, 1e-12 * weight * mesh);
  EXPECT_TRUE(s["objective"]["error"].contains("step"));
  EXPECT_NE(o.out.find(" +- "), std::string::npos) << o.out;
  const fs::path finer = results() / "finer";
  ASSERT_EQ(run({"run", results() / "design.toml", "-o", finer, "--no-report", "--set",
                 "bodies.rod.beam.elements=64", "--set", "bodies.crank.beam.elements=32"})
                .code,
            0);
  const double change = std::abs(
      Json::parse(text_of(finer / "summary.json"))["responses"][name]["max_abs"].get<double>() -
      term["final"].get<double>());
  EXPECT_GT(mesh, change / 3);
  EXPECT_LT(mesh, change * 3);
}

TEST_F(VerifyCommand, AFrequencyAsTheObjectiveHasNoErrorAndSaysSo) {
  const Outcome o = run(
      {"optimize", study("rod_frequency"), "-o", results(), "--no-report", "--set", "cycle.max=1"});
  EXPECT_NE(o.code, 2) << o.err;
  EXPECT_NE(
      o.out.find("the error of the objective is not known, as that of lowest frequency is not"),
      std::string::npos)
      << o.out;
}

/// What `VerifySlow` holds against converged runs: errors by mesh and step with their signs.
TEST_F(VerifyCommand, PrintsTheErrorInAll) {
  const Outcome o = run({"run", scene("four_bar"), "--verify", "-o", results(), "--no-report"});
  ASSERT_EQ(o.code, 0) << o.err;
  int compared = 0;
  const Json s = summary();
  for (const auto& [name, r] : s["responses"].items()) {
    const Json& error = r["error"];
    if (!error.contains("total")) continue;
    const std::string largest = fmt::format("largest {:.6g} +- {:.2g} ", r["max_abs"].get<double>(),
                                            error["total"].get<double>());
    EXPECT_NE(o.out.find(largest), std::string::npos) << largest << o.out;
    ++compared;
  }
  EXPECT_GE(compared, 2);
}

TEST_F(VerifyCommand, NamesTheTermsOfTheObjectiveWithoutAnError) {
  const Outcome o =
      run({"optimize", study("rod_goals"), "-o", results(), "--no-report", "--set", "cycle.max=1"});
  ASSERT_NE(o.code, 2) << o.err;
  EXPECT_FALSE(summary()["objective"].contains("error"));
  EXPECT_NE((o.out + o.err).find("the error of the objective is not known"), std::string::npos)
      << o.out << o.err;
}

TEST_F(VerifyCommand, LeavesTheErrorsOutIfAskedTo) {
  EXPECT_EQ(optimise_rod({"--no-verify"}).code, 0);
  EXPECT_FALSE(summary().contains("verification"));
  EXPECT_FALSE(summary().contains("refinement"));
  EXPECT_FALSE(summary()["constraints"]["bending"].contains("error"));
}

/// Each limit in each scenario.
TEST_F(VerifyCommand, VerifiesEveryScenario) {
  const Outcome o = run({"optimize", study("rod_three_speeds"), "-o", results(), "--no-report",
                         "--set", "cycle.max=1", "--set", "simulation.duration=0.02"});
  EXPECT_EQ(o.code, 1) << o.err;
  const Json limits = summary()["constraints"];
  EXPECT_EQ(limits.size(), 3u);
  for (const auto& [name, limit] : limits.items()) {
    ASSERT_TRUE(limit.contains("error")) << name;
    EXPECT_GT(limit["error"]["mesh"].get<double>(), 0) << name;
  }
  EXPECT_EQ(summary()["verification"]["runs"], 15) << "five a scenario";
  for (const char* by : {"mesh", "step"})
    EXPECT_EQ(summary()["verification"][by]["observed"].size(), 3u) << by;
}

/// Limits are found by the names of bodies and joints.
TEST_F(VerifyCommand, FindsTheLimitsOfTheFinalDesign) {
  const Outcome o = run({"optimize", study("robot_codesign"), "-o", results(), "--no-report",
                         "--set", "cycle.max=1"});
  EXPECT_EQ(o.code, 1) << o.err;
  EXPECT_EQ(o.out.find("was not verified"), std::string::npos) << o.out;
  const Json limits = summary()["constraints"];
  EXPECT_EQ(limits.size(), 4u);
  for (const auto& [name, limit] : limits.items()) EXPECT_TRUE(limit.contains("error")) << name;
}

using VerifyCommandSlow = VerifyCommand;

/// design.toml has bodies and the interfaces of a part, which are numbered, in the order of the
/// scene: it is the scene of another design.
TEST_F(VerifyCommandSlow, ReadsTheFinalDesignOfAPart) {
  for (const char* name : {"robot_arm_lattice", "four_bar_mixed"}) {
    SCOPED_TRACE(name);
    const Outcome o = run({"optimize", study(name), "-o", results(), "-f", "--no-report", "--set",
                           "cycle.max=1", "--set", "simulation.duration=0.01"});
    EXPECT_EQ(o.code, 1) << o.err;
    EXPECT_EQ(o.out.find("not verified"), std::string::npos) << o.out;
    EXPECT_EQ(run({"check", results() / "design.toml"}).code, 0);
    const Mechanism given = load_study(study(name)).scene.mechanism,
                    design = load_scene(results() / "design.toml").mechanism;
    ASSERT_EQ(given.bodies.size(), design.bodies.size());
    for (std::size_t b = 0; b < given.bodies.size(); ++b) {
      const auto* part = std::get_if<SolidSpec>(&given.bodies[b].kind);
      if (!part) continue;
      const auto& again =
          std::get<SolidSpec>(design.bodies[std::size_t(design.body(given.bodies[b].name))].kind);
      ASSERT_EQ(part->model->interfaces().size(), again.model->interfaces().size());
      for (std::size_t i = 0; i < part->model->interfaces().size(); ++i)
        EXPECT_EQ(part->model->interfaces()[i].name, again.model->interfaces()[i].name);
    }
  }
}

/// On 80 x 40 cells, twice and half of them.
TEST_F(VerifyCommand, OutlinesUnderFixedLoadsHaveErrors) {
  run({"optimize", study("cantilever"), "-o", results(), "--set", "cycle.max=2"});
  Json s = summary();
  EXPECT_EQ(s["verification"]["runs"], 3);
  EXPECT_EQ(s["verification"]["mesh"]["order"], 1);
  EXPECT_GT(s["constraints"]["sag"]["error"]["mesh"].get<double>(), 0.0);
  EXPECT_GT(s["objective"]["error"]["mesh"].get<double>(), 0.0);
  EXPECT_TRUE(s.contains("refinement"));
}

/// What holds a part and what acts on it: the resultant of a traction of 100 MPa on 1 m by 10 mm;
/// points are material, so none lies in the hole.
TEST_F(VerifyCommand, SupportsAndLoadsOfAPartAreInTheSummary) {
  run({"optimize", study("plate_with_hole"), "-o", results(), "--no-verify", "--set", "cycle.max=1",
       "--set", "scene.bodies.plate.solid.mesh.cells=[40, 40]"});
  const Json s = summary();
  ASSERT_EQ(s["supports"].size(), 2u);
  EXPECT_EQ(s["supports"][0]["place"], "x_min");
  EXPECT_EQ(s["supports"][0]["held"], "x");
  ASSERT_EQ(s["fixed_loads"].size(), 2u);
  const Json load = s["fixed_loads"][0];
  EXPECT_EQ(load["name"], "along_x");
  EXPECT_EQ(load["place"], "x_max");
  EXPECT_NEAR(load["force"][0].get<double>(), 1e6, 1e-3);
  EXPECT_NEAR(load["force"][1].get<double>(), 0, 1e-3);
  ASSERT_EQ(load["points"].size(), 9u);
  for (const Json& point : s["supports"][0]["points"])  // from the middle of the right side
    EXPECT_GE(point[1].get<double>() + 0.5, 0.05);
  EXPECT_NE(text_of(results() / "report.html").find("along_x"), std::string::npos);
}

/// The mesh of the scene, of order 4 by default, is fine enough for the limit.
TEST_F(VerifyCommand, TheShippedRodIsCertainAtOnce) {
  Json s = solved_summary("slider_crank_rod");
  EXPECT_TRUE(s["refinement"]["holds"].get<bool>());
  EXPECT_TRUE(s["refinement"]["steps"].empty()) << s["refinement"];
  EXPECT_LE(s["worst_constraint"].get<double>() + s["worst_constraint_error"].get<double>(), 1e-3);
}

/// The refined rod is a scene of the finer model, with the starts of the first.
TEST_F(VerifyCommand, RefinesUntilTheDesignHolds) {
  ASSERT_EQ(optimise_rod(kOrder2).code, 0);
  Json s = summary();
  Json refinement = s["refinement"];
  EXPECT_TRUE(refinement["holds"].get<bool>()) << refinement;
  ASSERT_EQ(refinement["steps"].size(), 1u);
  EXPECT_EQ(refinement["steps"][0]["because"].get<std::string>().rfind(
                "limit bending is known to 1.7 % only", 0),
            0u)
      << refinement;
  EXPECT_NE(text_of(results() / "design.toml").find("order = 4"), std::string::npos);
  EXPECT_EQ(s["cycles"], s["history"].size());
  EXPECT_EQ(s["history"].back()["cycle"], s["cycles"]);
  EXPECT_EQ(s["design_range"]["rod_diameters[0]"]["initial"], 0.01146);
}

TEST_F(VerifyCommand, PrintsWhyItRefines) {
  const Outcome o =
      optimise_rod({"--set", "simulation.duration=0.02", "--set", "constraints.bending.limit=2e-4",
                    "--set", kOrder2[1], "--set", kOrder2[3]});
  EXPECT_EQ(o.code, 0) << o.err;
  Json steps = summary()["refinement"]["steps"];
  ASSERT_FALSE(steps.empty());
  EXPECT_NE(o.out.find(steps[0]["because"].get<std::string>()), std::string::npos) << o.out;
}

/// The middle of an element is no place of another mesh.
TEST_F(VerifyCommand, SaysThatTheMiddleOfAnElementKeepsItsMesh) {
  std::string text = text_of(scene("slider_crank"));
  const std::string table = "[responses]\n";
  text.insert(text.find(table) + table.size(),
              "moment = { response = \"section_force\", of = \"rod\", at = \"mid\", "
              "component = \"Mz\" }\n");
  const Outcome o = run({"run", write("scene.toml", text), "-o", results(), "--verify"});
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_NE((o.out + o.err).find("leaves out beam rod: the scene names the middle of an element"),
            std::string::npos)
      << o.out << o.err;
}

/// A load and responses at nodes and ends of elements by number have the errors that they have by
/// name, without a word.
TEST_F(VerifyCommand, KnowsNodesByTheirNumbers) {
  const auto verified = [this](const std::string& middle, const std::string& end) {
    std::string text = text_of(scene("pendulum"));
    const std::string table = "[responses]\n";
    text.insert(text.find(table),
                "[loads]\npush = { at = \"beam." + end + "\", force = [0, 0.5, 0] }\n\n");
    text.insert(text.find(table) + table.size(),
                "middle = { response = \"position\", at = \"beam." + middle +
                    "\" }\nbow = { response = \"deflection\", of = \"beam\", at = \"" + middle +
                    "\" }\n");
    const Outcome o = run({"run", write("scene.toml", text), "-o", results(), "--verify", "--force",
                           "--no-report", "--set", "simulation.duration=0.2"});
    EXPECT_EQ(o.code, 0) << o.err;
    EXPECT_EQ((o.out + o.err).find("leaves out"), std::string::npos) << o.out << o.err;
    return summary()["responses"];
  };
  const Json by_name = verified("mid", "end"), by_number = verified("node8", "node16");
  EXPECT_TRUE(by_name["middle"]["error"].contains("mesh"));
  EXPECT_EQ(by_number, by_name);
}

/// A mesh that has no room for twice its elements, and one that just has: 10000 are the most.
TEST_F(VerifyCommand, SaysThatAMeshHasNoRoom) {
  const auto verified = [this](const char* elements) {
    const Outcome o = run({"run", scene("pendulum"), "-o", results(), "--verify", "--force",
                           "--set", std::string("bodies.beam.beam.elements=") + elements, "--set",
                           "simulation.duration=0.002"});
    EXPECT_EQ(o.code, 0) << o.err;
    return o.out + o.err;
  };
  const std::string words = "leaves out beam beam: it has no room for twice its elements";
  EXPECT_NE(verified("5001").find(words), std::string::npos);
  EXPECT_FALSE(summary()["responses"]["tip"]["error"].contains("mesh"));
  EXPECT_EQ(verified("5000").find(words), std::string::npos);
  EXPECT_TRUE(summary()["responses"]["tip"]["error"].contains("mesh"));
}

/// Beside the largest value, the value at the end, and in a report that is there.
TEST_F(VerifyCommand, WritesBothErrorsOfAResponse) {
  const Outcome o = run({"run", scene("bend45"), "-o", results(), "--verify"});
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(o.err, "");
  const Json error = summary()["responses"]["tip"]["error"];
  EXPECT_GT(error["end"]["mesh"].get<double>(), 1e-4);
  EXPECT_FALSE(error["end"].contains("step"));
  EXPECT_EQ(o.out.find("alone"), std::string::npos) << "there is no step: " << o.out;
  EXPECT_TRUE(fs::exists(results() / "report.html"));
}

/// Records as often as the scene asks for them; the limit holds at every step all the same.
TEST_F(VerifyCommand, AStudyRecordsAsOftenAsItsSceneAsks) {
  const auto study_with = [this](const char* every) {
    EXPECT_EQ(optimise_rod({"--no-verify", "--force", "--set",
                            std::string("simulation.output_every=") + every})
                  .code,
              0);
    std::istringstream rows(text_of(results() / "responses.csv"));
    int count = 0;
    for (std::string row; std::getline(rows, row);) ++count;
    return std::pair(count, summary()["constraints"]["bending"]["max_abs_final"].get<double>());
  };
  const auto [all, every_step] = study_with("1");
  const auto [few, same] = study_with("400");
  EXPECT_EQ(all - few, 1201 - 4) << "with the start and the end";
  EXPECT_EQ(every_step, same);
}

/// Not silent where there is nothing to verify.
TEST_F(VerifyCommand, SaysWhyARunIsNotVerified) {
  const Outcome inaccurate =
      run({"run", (kData / "stability/buckling_links.toml").string(), "-o", results(), "--verify"});
  EXPECT_EQ(inaccurate.code, 1);
  EXPECT_NE(inaccurate.out.find("not verified: the run ended with status 'inaccurate'"),
            std::string::npos)
      << inaccurate.out << inaccurate.err;
  std::string text = text_of(scene("slider_crank"));
  text.erase(text.find("[responses]"));
  const Outcome without =
      run({"run", write("scene.toml", text), "-o", results(), "--verify", "--force"});
  EXPECT_EQ(without.code, 0) << without.err;
  EXPECT_NE(without.out.find("not verified: the scene asks for no responses"), std::string::npos)
      << without.out;
}

/// What is no largest value of a response has no error: the design is not certain.
TEST_F(VerifyCommand, AFrequencyIsNotCertain) {
  std::string text = text_of(study("slider_crank_rod"));
  const std::string of_scene = "../scenes/slider_crank.toml";
  text.replace(text.find(of_scene), of_scene.size(), scene("slider_crank"));
  text += "\n[frequencies]\nlow = { of = \"rod\", least = 200 }\n";
  const Outcome o = run({"optimize", write("study.toml", text), "-o", results(), "--no-report"});
  EXPECT_EQ(o.code, 0) << o.err;
  Json refinement = summary()["refinement"];
  EXPECT_FALSE(refinement["holds"].get<bool>());
  EXPECT_EQ(refinement["reason"], "the error of limit low is not known");
}

TEST_F(VerifyCommand, RefusesModesBeforeTheyAreComputed) {
  expect_refused(
      {"run", scene("slider_crank"), "-o", results(), "--verify", "--set", "simulation.type=modes"},
      "natural frequencies have no responses to verify");
}

}  // namespace
}  // namespace liesl::test::verify_test
