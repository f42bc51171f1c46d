/// @file
/// `liesl lean`: its choices against runs of their own, and the program as a user starts it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <set>

#include "apps/input/document.hpp"
#include "apps/input/rewrite.hpp"
#include "apps/lean/setting.hpp"
#include "apps/lean/trial.hpp"
#include "apps/program.hpp"
#include "apps/scene/load_scene.hpp"
#include "mbs/solvers/richardson.hpp"

namespace liesl::test::lean_test {
namespace {

// --- distance ------------------------------------------------------------------------------------

output::Series sampled(int n, double (*f)(double), int rows = 1) {
  output::Series s;
  s.values.setZero(rows, n + 1);
  for (int i = 0; i <= n; ++i) {
    s.t.push_back(static_cast<double>(i) / n);
    s.values(0, i) = f(s.t.back());
  }
  return s;
}
double wave(double t) { return std::sin(7 * t); }
double cubic(double t) { return 1 + t * (2 - t * (3 - 5 * t)); }

TEST(Distance, IsRelativeToTheLargestReference) {
  output::Series reference = sampled(8, cubic), other = reference;
  EXPECT_EQ(relative_distance(other, reference), 0);
  other.values(0, 3) += 0.1;
  EXPECT_NEAR(relative_distance(other, reference), 0.1 / 5, 1e-12);  // cubic(1) = 5
  output::Series in_space = sampled(8, cubic, 2);
  EXPECT_EQ(relative_distance(in_space, reference), 0) << "missing components are zero";
  in_space.values(1, 2) = 0.5;
  EXPECT_NEAR(relative_distance(in_space, reference), 0.1, 1e-12);
}

TEST(Distance, BetweenRecordsIsThatOfACubic) {
  EXPECT_LT(relative_distance(sampled(5, cubic), sampled(60, cubic)), 1e-14);
  const auto off = [](int n) { return relative_distance(sampled(n, wave), sampled(960, wave)); };
  for (int n = 30; n <= 120; n *= 2) EXPECT_NEAR(std::log2(off(n) / off(2 * n)), 4, 0.3) << n;
  EXPECT_GT(off(4), 0.05) << "records that do not show the wave";
}

TEST(Distance, RunThatStopsEarlyIsNoApproximation) {
  output::Series half = sampled(8, cubic);
  half.t.resize(5);
  half.values.conservativeResize(1, 5);
  EXPECT_TRUE(std::isinf(relative_distance(half, sampled(8, cubic))));
  EXPECT_TRUE(std::isinf(relative_distance(output::Series{}, sampled(8, cubic))));
}

TEST(Distance, ThinnedKeepsTheEnds) {
  const output::Series thin = thinned(sampled(10, cubic), 4);
  ASSERT_EQ(thin.t.size(), 4u);  // 0, 4, 8, 10
  EXPECT_DOUBLE_EQ(thin.t[2], 0.8);
  EXPECT_DOUBLE_EQ(thin.t[3], 1.0);
  EXPECT_DOUBLE_EQ(thin.values(0, 3), 5);
}

// --- settings ------------------------------------------------------------------------------------

TEST(LeanSetting, KeepsThePlacesThatASceneNames) {
  const Scene crank = load_scene(scene("slider_crank"));
  const Setting given = setting_of(crank);
  ASSERT_EQ(given.beams.size(), 2u);
  EXPECT_EQ(given.beams[0].multiple, 1) << "crank: only its ends";
  EXPECT_EQ(given.beams[1].multiple, 2) << "rod: its middle, too";
  EXPECT_EQ(given.steps, 1200);
  EXPECT_TRUE(changes(given, given).empty());
  const Setting fine = given.refined(2.5);
  EXPECT_EQ(fine.beams[1].elements, 20);
  EXPECT_EQ(fine.steps, 3000);
  const Scene changed = load_scene(scene("slider_crank"), changes(fine, given));
  EXPECT_EQ(setting_of(changed).steps, 3000);
  EXPECT_EQ(setting_of(changed).beams[0].elements, 20);
  EXPECT_EQ(places(changed, 1), places(crank, 1));
}

TEST(LeanSetting, ChangesAreReadBackAsTheSetting) {
  const Setting given = setting_of(load_scene(scene("slider_crank")));
  Setting wanted = given;
  wanted.space = "planar";
  wanted.beams[0].rigid = true;
  wanted.beams[1].elements = 12;
  wanted.steps = 1600;
  wanted.tangent = "exact";
  const Scene changed = load_scene(scene("slider_crank"), changes(wanted, given));
  const Setting read = setting_of(changed);
  EXPECT_EQ(std::get<BeamSpec>(changed.mechanism.bodies[0].kind).as, BeamModel::Rigid);
  ASSERT_EQ(read.beams.size(), 1u);
  EXPECT_EQ(read.beams[0].elements, 12);
  EXPECT_EQ(read.steps, 1600);
  EXPECT_EQ(read.tangent, "exact");
  EXPECT_EQ(read.space, "planar");
}

// --- rewriting -----------------------------------------------------------------------------------

TEST(Rewrite, ChangesValuesInPlaceAndKeepsComments) {
  const std::string text = text_of(scene("slider_crank"));
  const std::vector<std::string> list = {"bodies.rod.beam.elements=12", "simulation.step=7.5e-05",
                                         "bodies.crank.beam.as=\"rigid\"",
                                         "simulation.space=\"planar\"", "gravity.1=-1.62"};
  const std::string changed = rewrite_scene(text, list);
  const auto second = text.find('\n') + 1;  // the first line names the schema by its place
  EXPECT_EQ(text.substr(second, 200), changed.substr(0, 200));
  EXPECT_NE(changed.find("# Start: cycloidal ramp of 0.04 s."), std::string::npos);
  EXPECT_NE(changed.find("elements = 12 } }"), std::string::npos) << changed;
  EXPECT_NE(changed.find("elements = 8, as = \"rigid\" } }"), std::string::npos) << changed;
  EXPECT_NE(changed.find("\nspace = \"planar\"\n"), std::string::npos) << changed;
  Document wanted = parse_document(text, "x");
  Problems problems("x");
  apply_overrides(wanted.root, FileKind::Scene, list, problems);
  EXPECT_EQ(parse_document(changed, "x").root, wanted.root);
}

TEST(Rewrite, WhatHasNoPlaceIsWrittenAnew) {
  const std::string text =
      "[bodies.b]  # ä\nrigid = { at = [0, 0, 0], mass = 1, inertia = [1, 1, 1] }\n";
  const std::string changed = rewrite_scene(text, {"simulation.step=0.5", "bodies.b.rigid.mass=2"});
  const Document read = parse_document(changed, "x");
  EXPECT_EQ(read.root["simulation"]["step"].value<double>(), 0.5);
  EXPECT_EQ(read.root["bodies"]["b"]["rigid"]["mass"].value<int>(), 2);
  EXPECT_THROW(rewrite_scene(text, {"simulation.stepp=1"}), InputError);
}

// --- the program ---------------------------------------------------------------------------------

class Lean : public Program {
 protected:
  Outcome lean(const std::string& file, const std::string& response, const Words& more = {}) const {
    Words words = {"lean", file, "--response", response, "-o", results(), "-f"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  const Json* decision(const Json& s, const std::string& about) const {
    for (const auto& d : s["decisions"])
      if (d["about"] == about) return &d;
    return nullptr;
  }
  /// Distance of two models, by runs of this test's own.
  static double off(const std::string& file, const std::string& response,
                    const std::vector<std::string>& a, const std::vector<std::string>& b) {
    Trials trials(text_of(file), file, {}, response, {});
    return relative_distance(trials.run(a).series, trials.run(b).series);
  }
};

TEST_F(Lean, SliderCrankWithAFlexibleCrank) {
  const Outcome o = lean(scene("slider_crank"), "bend", {"--tolerance", "1%"});
  ASSERT_EQ(o.code, 0) << o.err << o.out;
  const Json s = summary();
  EXPECT_EQ(s["status"], "done");
  EXPECT_EQ(s["lean"]["space"], "planar");
  EXPECT_FALSE(s["lean"]["beams"]["crank"]["rigid"]);
  EXPECT_GT((*decision(s, "beam crank"))["figure"], 0.01) << "a rigid crank is not within 1 %";
  EXPECT_LE(s["error"], 0.01);
  EXPECT_GT(s["held_out"]["steps"], s["reference"]["steps"].get<int>());
  EXPECT_GT(s["held_out"]["beams"]["rod"]["elements"],
            s["reference"]["beams"]["rod"]["elements"].get<int>());

  // The lean scene is a scene, and it is as near to a fine run as it says.
  ASSERT_EQ(run({"check", results() / "lean.toml"}).code, 0);
  const std::string text = text_of(results() / "lean.toml");
  EXPECT_EQ(text.rfind("# Lean model of slider_crank.toml", 0), 0u);
  EXPECT_NE(text.find("# Start: cycloidal ramp of 0.04 s."), std::string::npos);
  const std::vector<std::string> lean_model = s["changes"];
  const std::vector<std::string> fine = {
      "simulation.step=1.25e-05",      "simulation.output_every=2", "bodies.rod.beam.elements=64",
      "bodies.crank.beam.elements=64", "bodies.rod.beam.order=2",   "bodies.crank.beam.order=2"};
  EXPECT_NEAR(off(scene("slider_crank"), "bend", lean_model, fine), s["error"], 1e-9);
}

/// The estimate of `run --verify` beside the error that was measured: within a factor of 3 of the
/// largest difference over time, of which that of the peak is a part.
TEST_F(Lean, ModelIsVerified) {
  ASSERT_EQ(lean(scene("slider_crank"), "bend").code, 0);
  const Json s = summary(), bend = s["responses"]["bend"];
  const double size = bend["max_abs"], error = bend["error"]["total"].get<double>() / size;
  EXPECT_GT(error, 0);
  EXPECT_LT(error, 3 * s["error"].get<double>());
  EXPECT_LT(error, s["tolerance"].get<double>());
  EXPECT_LE(s["verification"]["runs"], 5);
  const fs::path again = dir_ / "again";
  ASSERT_EQ(run({"run", results() / "lean.toml", "--verify", "-o", again}).code, 0);
  const Json same = Json::parse(text_of(again / "summary.json"));
  EXPECT_EQ(same["responses"]["bend"], bend);

  const Outcome bare = lean(scene("slider_crank"), "bend", {"--no-verify"});
  ASSERT_EQ(bare.code, 0);
  EXPECT_TRUE(summary()["responses"].empty());
  EXPECT_FALSE(summary().contains("verification"));
}

/// Fewer elements of order 4 are as good and faster; the reference knows nothing of them.
TEST_F(Lean, OrderFourIsTakenWhereItIsFaster) {
  ASSERT_EQ(lean(scene("slider_crank"), "bend").code, 0);
  const Json s = summary();
  const Json* order = decision(s, "order");
  ASSERT_NE(order, nullptr);
  EXPECT_EQ((*order)["choice"], "order 4: taken") << *order;
  EXPECT_EQ(s["lean"]["beams"]["rod"]["order"], 4);
  EXPECT_EQ(s["reference"]["beams"]["rod"]["order"], 2);
  EXPECT_EQ(s["given"]["beams"]["rod"]["order"], 4) << "by default";
  EXPECT_LT(s["lean"]["beams"]["rod"]["elements"], 12);
}

/// Of a damped beam segments are as good, at half the time of elements of order 2 as a rule. What
/// is taken is what the two times that stand beside the choice say, also on a busy machine.
TEST_F(Lean, SegmentsAreTakenWhereTheyAreFaster) {
  ASSERT_EQ(lean(scene("pendulum"), "tip",
                 {"--set", "bodies.beam.beam.damping=1e-5", "--set", "simulation.tolerance=1e-8"})
                .code,
            0);
  const Json s = summary();
  const Json* segments = decision(s, "segments");
  ASSERT_NE(segments, nullptr);
  double then = 0, now = 0;
  ASSERT_EQ(std::sscanf((*segments)["evidence"].get<std::string>().c_str(),
                        "%lf s instead of %lf s", &then, &now),
            2)
      << *segments;
  const double share = then / now;
  if (std::abs(share - 0.9) > 0.01) {  // the digits of the evidence
    EXPECT_EQ((*segments)["choice"], share < 0.9 ? "segments: taken" : "segments: no") << *segments;
  }
  const bool chosen = (*segments)["choice"] == "segments: taken";
  EXPECT_EQ(s["lean"]["beams"]["beam"]["segments"], chosen);
  EXPECT_FALSE(s["reference"]["beams"]["beam"]["segments"]);
  EXPECT_LE(s["error"], 0.01);
  const Scene model = load_scene(results() / "lean.toml");
  EXPECT_EQ(std::get<BeamSpec>(model.mechanism.bodies[0].kind).as == BeamModel::Segments, chosen);
}

/// Never where a scene needs torsion, nor where shear counts: of this bar 3 EI/(k G A L^2) = 7 % of
/// its deflection.
TEST_F(Lean, SegmentsAreNotTakenWhereTorsionOrShearCounts) {
  const auto refusal = [this](const fs::path& file, const char* response) {
    EXPECT_EQ(lean(file, response).code, 0);
    const Json s = summary();
    const Json* segments = decision(s, "segments");
    EXPECT_NE(segments, nullptr);
    if (!segments) return std::string();
    EXPECT_EQ((*segments)["choice"], "segments: no") << *segments;
    for (const auto& [name, beam] : s["lean"]["beams"].items()) EXPECT_FALSE(beam["segments"]);
    return (*segments)["evidence"].get<std::string>();
  };
  EXPECT_NE(refusal(scene("bend45"), "tip").find("has no torsion as a chain of segments"),
            std::string::npos);
  std::ofstream(dir_ / "bar.toml") << R"(
[materials]
steel = { E = 210e9, nu = 0.3, rho = 7850 }
[sections]
bar = { type = "rectangle", width = 0.1, height = 0.3, shear_factor = 0.8333333333333334 }
[bodies]
bar = { beam = { from = [0, 0, 0], to = [1, 0, 0], section = "bar", material = "steel", elements = 8 } }
[joints]
clamp = { fixed = ["ground", "bar.start"] }
[loads]
push = { at = "bar.end", force = [0, 0, 1000] }
[simulation]
type = "static"
[responses]
tip = { response = "position", at = "bar.end", axis = [0, 0, 1] }
)";
  EXPECT_EQ(refusal(dir_ / "bar.toml", "tip"), "no mesh and step within the budget");
}

/// One multiple less of anything is beyond the tolerance.
TEST_F(Lean, MeshOfTheSliderCrankIsTheCoarsest) {
  ASSERT_EQ(lean(scene("slider_crank"), "bend").code, 0);
  const Json s = summary();
  const std::vector<std::string> reference = {
      "simulation.step=2.5e-05", "bodies.rod.beam.elements=32", "bodies.crank.beam.elements=32",
      "bodies.rod.beam.order=2", "bodies.crank.beam.order=2"};
  const double budget = 0.01 - s["reference_error"].get<double>();
  const auto order = [&](const std::string& beam) {
    return fmt::format("bodies.{}.beam.order={}", beam,
                       s["lean"]["beams"][beam]["order"].get<int>());
  };
  const auto with = [&](int crank, int rod, double step) {
    return off(scene("slider_crank"), "bend",
               {"simulation.space=planar", order("crank"), order("rod"),
                "bodies.crank.beam.elements=" + std::to_string(crank),
                "bodies.rod.beam.elements=" + std::to_string(rod),
                fmt::format("simulation.step={}", step)},
               reference);
  };
  const int crank = s["lean"]["beams"]["crank"]["elements"];
  const int rod = s["lean"]["beams"]["rod"]["elements"];
  const double step = s["lean"]["step"];
  EXPECT_LE(with(crank, rod, step), budget);
  EXPECT_GT(with(crank, rod - 2, step), budget);
  const auto counts = divisors(4800);  // steps of the reference
  const auto here = std::find(counts.begin(), counts.end(), s["lean"]["steps"].get<long>());
  ASSERT_GT(here - counts.begin(), 0);
  EXPECT_GT(with(crank, rod, 0.12 / static_cast<double>(*(here - 1))), budget);
  if (crank > 1) {
    EXPECT_GT(with(crank - 1, rod, step), budget);
  }
}

TEST_F(Lean, SliderCrankWithARigidCrank) {
  ASSERT_EQ(lean(scene("slider_crank"), "slider_x").code, 0);
  const Json s = summary();
  EXPECT_TRUE(s["lean"]["beams"]["crank"]["rigid"]);
  EXPECT_LT((*decision(s, "beam crank"))["figure"], 0.01);
  EXPECT_LT(s["lean"]["steps"], s["given"]["steps"].get<int>() / 10);
  EXPECT_LE(s["error"], 0.01);
  EXPECT_EQ(load_scene(results() / "lean.toml").mechanism.bodies.size(), 3u);
}

TEST_F(Lean, TighterToleranceCostsMore) {
  const auto size = [&](const char* tolerance) {
    EXPECT_EQ(lean(scene("pendulum"), "tip", {"--tolerance", tolerance}).code, 0);
    const Json s = summary();
    EXPECT_LE(s["error"], s["tolerance"].get<double>());
    return s["lean"]["steps"].get<long>() * s["lean"]["beams"]["beam"]["elements"].get<long>();
  };
  const long loose = size("10%"), middle = size("1%"), tight = size("0.002");
  EXPECT_LT(loose, middle);
  EXPECT_LT(middle, tight);
}

/// What `auto` stands for is a matter of the formalism, and not tried against itself.
TEST_F(Lean, TriesTheTangentsThatTheFormalismDoesNotTake) {
  for (const auto& [formalism, own] : {std::pair("se3", "constant"),
                                       {"r3so3", "adaptive"},
                                       {"classical", "exact"},
                                       {"floating", "adaptive"}}) {
    ASSERT_EQ(
        lean(scene("pendulum"), "tip",
             {"--tolerance", "10%", "--set", std::string("simulation.formalism=") + formalism})
            .code,
        0);
    std::set<std::string> tried;
    const Json s = summary();
    for (const auto& d : s["decisions"])
      if (d["about"] == "tangent") tried.insert(d["choice"].get<std::string>().substr(0, 5));
    std::set<std::string> others = {"const", "adapt", "exact"};
    others.erase(std::string(own).substr(0, 5));
    EXPECT_EQ(tried, others) << formalism;
  }
}

TEST_F(Lean, StaticSceneKeepsItsStepsAndFindsItsMesh) {
  ASSERT_EQ(lean(scene("roll_up"), "tip").code, 0);
  EXPECT_EQ(summary()["lean"]["beams"]["beam"]["elements"], 3)
      << "below 3 the circle does not close";
  EXPECT_EQ(summary()["lean"]["steps"], 0);
}

TEST_F(Lean, MeshWithNumberedNodesIsKept) {
  std::string text = text_of(scene("pendulum"));
  text += "quarter = { response = \"position\", at = \"beam.node4\" }\n";
  ASSERT_EQ(lean(write("numbered.toml", text), "tip").code, 0);
  EXPECT_EQ(summary()["lean"]["beams"]["beam"]["elements"], 16);
  EXPECT_NE(summary()["warnings"].dump().find("keeps its mesh"), std::string::npos);
}

TEST_F(Lean, BadInputIsRefusedWithAHint) {
  const Outcome name = lean(scene("slider_crank"), "bendd");
  EXPECT_EQ(name.code, 2);
  EXPECT_NE(name.err.find("did you mean 'bend'?"), std::string::npos) << name.err;
  for (const char* tolerance : {"0", "51%", "-1%", "one", "1%%", "nan", "inf", "", "%"}) {
    const Outcome o = lean(scene("slider_crank"), "bend", {"--tolerance", tolerance});
    EXPECT_EQ(o.code, 2) << tolerance;
    EXPECT_NE(o.err.find("(0, 0.5]"), std::string::npos) << tolerance << ": " << o.err;
  }
  EXPECT_EQ(run({"lean", scene("slider_crank"), "-o", results()}).code, 2) << "no --response";
  EXPECT_EQ(lean(dir_ / "absent.toml", "bend").code, 2);
  EXPECT_EQ(lean(scene("pendulum"), "tip", {"--set", "simulation.type=modes"}).code, 2);
  EXPECT_EQ(lean(scene("bend45"), "tip", {"--set", "simulation.arc_length=true"}).code, 2);
  EXPECT_FALSE(fs::exists(results()));
}

TEST_F(Lean, SceneThatFailsIsSaid) {
  const Outcome o =
      lean(scene("slider_crank"), "bend",
           {"--set", "joints.motor.drive.rate=1e7", "--set", "simulation.duration=0.01"});
  EXPECT_EQ(o.code, 1);
  EXPECT_EQ(summary()["status"], "simulation failed");
  EXPECT_NE(summary()["reason"].get<std::string>(), "");
  EXPECT_FALSE(fs::exists(results() / "lean.toml"));
}

TEST_F(Lean, SummaryHasTheDocumentedKeys) {
  ASSERT_EQ(lean(scene("roll_up"), "tip").code, 0);
  auto expected = documented("### `run`\n").always;
  const auto more = documented("### `lean`").always;
  ASSERT_GE(more.size(), 10u);
  expected.insert(more.begin(), more.end());
  ASSERT_EQ(documented("### `lean`").sometimes.count("verification"), 1u);
  expected.insert("verification");
  EXPECT_EQ(keys(summary()), expected);
}

using LeanSlow = Lean;

TEST_F(LeanSlow, MeetsItsToleranceInEveryShippedScene) {
  const std::map<std::string, std::string> responses = {{"bend45", "tip"},
                                                        {"connecting_rod", "elongation"},
                                                        {"connecting_rod_3d", "elongation"},
                                                        {"crane_boom", "tip"},
                                                        {"engine_mount", "engine"},
                                                        {"flying_beam", "A"},
                                                        {"four_bar", "bend"},
                                                        {"four_bar_plates", "coupler_bend"},
                                                        {"gear_hoist", "sway"},
                                                        {"heavy_top", "centre"},
                                                        {"meshed_slider_crank", "elongation"},
                                                        {"pendulum", "tip"},
                                                        {"robot_arm_lattice", "arm_tip"},
                                                        {"roll_up", "tip"},
                                                        {"slider_crank", "bend"},
                                                        {"spin_up", "lag"},
                                                        {"svanberg_cantilever", "tip"},
                                                        {"two_link_robot", "tip"},
                                                        {"two_link_robot_path", "tip"}};
  for (const auto& entry : fs::directory_iterator(kData / "scenes")) {
    if (entry.path().extension() != ".toml") continue;
    const auto response = responses.find(entry.path().stem());
    ASSERT_NE(response, responses.end()) << "no response named for " << entry.path();
    Words more = {"-q"};
    if (response->first == "connecting_rod_3d")  // an eighth of the cells: minutes with all
      more.insert(more.end(), {"--set", "bodies.rod.solid.mesh.cells=[30,8,4]"});
    const Outcome o = lean(entry.path(), response->second, more);
    EXPECT_EQ(o.code, 0) << entry.path() << "\n" << o.err;
    const Json s = summary();
    EXPECT_LE(s["error"], 0.01) << entry.path();
    EXPECT_EQ(run({"run", results() / "lean.toml", "-o", dir_ / "again", "-f", "-q"}).code, 0)
        << entry.path();
  }
}

}  // namespace
}  // namespace liesl::test::lean_test
