/// @file
/// Decks of beams: their loads are in equilibrium, in the axes of the held end, and every program
/// is told of every section.
#include "apps/export/beam_deck.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "apps/good_scene.hpp"
#include "apps/output/file.hpp"
#include "apps/program.hpp"
#include "apps/scene/load_scene.hpp"

namespace liesl::test::beam_deck_test {
namespace {

const std::vector<std::string> kShort = {"simulation.duration=0.03"};

struct Exported {
  Scene scene = load_scene(kData / "scenes/slider_crank.toml", kShort);
  EslOutcome esl = esl_task(scene, choose_space(scene));
};

const Exported& exported() {
  static const Exported once;
  return once;
}

BeamDeck rod(DeckCases cases) { return beam_deck(exported().scene, exported().esl, "rod", cases); }

TEST(BeamDeck, LoadsAreInEquilibriumWhereThePartIsDeformed) {
  for (const auto& c : rod(DeckCases::Peaks).cases) {
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    double size = 0;
    const BeamDeck deck = rod(DeckCases::Peaks);
    for (std::size_t k = 0; k < deck.nodes.size(); ++k) {
      force += c.force[k];
      moment += c.moment[k] + (deck.nodes[k].x + c.displacement[k]).cross(c.force[k]);
      size += c.force[k].norm();
    }
    EXPECT_LE(force.norm(), 1e-9 * size);
    EXPECT_LE(moment.norm(), 1e-9 * size);
  }
}

TEST(BeamDeck, FirstNodeStaysWhereItIs) {
  for (const auto& c : rod(DeckCases::All).cases) EXPECT_LE(c.displacement[0].norm(), 1e-15);
}

TEST(BeamDeck, PeaksAreSomeOfAll) {
  const BeamDeck peaks = rod(DeckCases::Peaks), all = rod(DeckCases::All);
  EXPECT_EQ(all.cases.size(), exported().esl.run.results.times.size());
  ASSERT_GE(peaks.cases.size(), 1u);
  EXPECT_LT(peaks.cases.size(), all.cases.size() / 10);
  double largest = 0;
  for (const auto& c : all.cases) largest = std::max(largest, c.deflection);
  for (const auto& c : all.cases) EXPECT_TRUE(std::isfinite(c.deflection));
  EXPECT_EQ(
      largest,
      std::max_element(peaks.cases.begin(), peaks.cases.end(), [](const auto& a, const auto& b) {
        return a.deflection < b.deflection;
      })->deflection);
}

/// Where every seventh step is recorded, a case is that of the same instant of the whole motion.
TEST(BeamDeck, CasesOfFewerRecordsAreThoseOfTheirInstants) {
  const Scene scene =
      load_scene(kData / "scenes/slider_crank.toml", {kShort[0], "simulation.output_every=7"});
  const BeamDeck few =
                     beam_deck(scene, esl_task(scene, choose_space(scene)), "rod", DeckCases::All),
                 all = rod(DeckCases::All);
  ASSERT_GT(few.cases.size(), 40u);
  ASSERT_LT(few.cases.size(), all.cases.size() / 6);
  for (const auto& c : few.cases) {
    const auto same = std::find_if(all.cases.begin(), all.cases.end(), [&](const auto& other) {
      return std::abs(other.time - c.time) < 1e-9;
    });
    ASSERT_NE(same, all.cases.end()) << c.time;
    EXPECT_EQ(c.deflection, same->deflection) << c.time;
    for (std::size_t k = 0; k < few.nodes.size(); ++k) {
      EXPECT_EQ(c.force[k], same->force[k]) << c.time;
      EXPECT_EQ(c.displacement[k], same->displacement[k]) << c.time;
    }
  }
}

/// Results whose bodies went to a file keep a few records, which are not those of the loads.
TEST(BeamDeck, RefusesResultsThatKeepFewerRecordsThanTheLoads) {
  struct Nowhere final : output::BodySink {
    void put(const std::vector<output::BodyResult>&, std::size_t, std::size_t,
             std::size_t) override {}
  } nowhere;
  const Scene& scene = exported().scene;
  const EslOutcome esl = esl_task(scene, choose_space(scene), {}, &nowhere);
  ASSERT_LT(esl.run.results.kept.size(), esl.beams[0].set.t.size());
  EXPECT_THROW(beam_deck(scene, esl, "rod", DeckCases::All), std::invalid_argument);
}

TEST(BeamDeck, TextsHaveEveryNodeElementAndCase) {
  const BeamDeck deck = rod(DeckCases::Peaks);
  const std::string ccx = calculix_text(deck), nastran = nastran_text(deck);
  const auto count = [](const std::string& text, const std::string& word) {
    std::size_t n = 0;
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
    return n;
  };
  EXPECT_EQ(count(ccx, "*STEP, NLGEOM"), deck.cases.size());
  EXPECT_EQ(count(ccx, "SECTION=CIRC\n1.000000000000e-02\n"), 1u);
  EXPECT_EQ(count(nastran, "\nGRID*"), deck.nodes.size());
  EXPECT_EQ(count(nastran, "\nCBAR*"), deck.nodes.size() - 1);
  EXPECT_EQ(count(nastran, "SUBCASE"), deck.cases.size());
  EXPECT_EQ(count(nastran, "\nFORCE*"), deck.cases.size() * (deck.nodes.size() - 1));
  std::istringstream lines(nastran.substr(nastran.find("BEGIN BULK")));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 72u) << line;
}

TEST(BeamDeck, RefusesWhatIsNoDeck) {
  const auto& [scene, esl] = exported();
  EXPECT_THROW(beam_deck(scene, esl, "slider", DeckCases::Peaks), std::invalid_argument);
  EXPECT_THROW(beam_deck(scene, esl, "rood", DeckCases::Peaks), std::invalid_argument);
  BeamDeck deck = rod(DeckCases::Peaks);
  deck.sections.assign(deck.sections.size(), {"i", ISection{0.1, 0.1, 0.01, 0.01}});
  EXPECT_THROW(calculix_text(deck), std::invalid_argument);
  EXPECT_NE(nastran_text(deck).find("PBARL*"), std::string::npos) << "which has I sections";
  FullSection matrices;
  matrices.stiffness.setIdentity();
  matrices.inertia.setIdentity();
  deck.sections.assign(deck.sections.size(), {"full", matrices});
  EXPECT_THROW(nastran_text(deck), std::invalid_argument);
}

class Export : public Program {};

TEST_F(Export, WritesAFolderOrNothing) {
  const std::string scene = (kData / "scenes/slider_crank.toml").string();
  const Words words = {"export", scene,     "--to", "calculix",
                       "--set",  kShort[0], "-o",   (dir_ / "deck").string()};
  Words with = words;
  with.insert(with.end(), {"--part", "rod"});
  EXPECT_EQ(run(with).code, 0);
  for (const char* file : {"rod.inp", "README.md", "displacements.csv"})
    EXPECT_TRUE(fs::exists(dir_ / "deck" / file)) << file;
  EXPECT_EQ(run(with).code, 3);  // it exists
  with.back() = "rood";
  with.push_back("--force");
  const Outcome typo = run(with);
  EXPECT_EQ(typo.code, 2);
  EXPECT_NE(typo.err.find("did you mean 'rod'"), std::string::npos) << typo.err;
  EXPECT_EQ(run(words).code, 2);
  EXPECT_EQ(run({"export", scene, "--part", "rod"}).code, 2);
}

/// The folder of a run says which scene it was, that of an optimisation has its final design.
TEST_F(Export, TakesTheSceneOfAResultsFolder) {
  const fs::path scene = dir_ / "mine.toml";
  fs::copy_file(kData / "scenes/slider_crank.toml", scene);
  const auto deck_of = [&](const fs::path& source, const Words& set) {
    Words words = {
        "export", source.string(),         "--part", "rod", "--to", "calculix", "--force",
        "-o",     (dir_ / "deck").string()};
    words.insert(words.end(), set.begin(), set.end());
    const Outcome o = run(words);
    return o.code == 0 ? text_of(dir_ / "deck/rod.inp") : o.err;
  };
  const Words shorter = {"--set", kShort[0]};
  Words words = {"run", scene.string(), "-o", (dir_ / "results").string()};
  words.insert(words.end(), shorter.begin(), shorter.end());
  ASSERT_EQ(run(words).code, 0);
  const std::string deck = deck_of(dir_ / "results", {});
  EXPECT_EQ(deck.substr(0, 2), "**") << deck;
  EXPECT_EQ(deck, deck_of(scene, shorter));
  std::ofstream(scene, std::ios::app) << "# changed\n";
  EXPECT_NE(deck_of(dir_ / "results", {}).find("is gone or has changed"), std::string::npos);
  fs::copy_file(kData / "scenes/slider_crank.toml", dir_ / "results/design.toml");
  EXPECT_EQ(deck_of(dir_ / "results", shorter), deck);
  fs::copy_file(kData / "scenes/four_bar.toml", dir_ / "results/design.toml",
                fs::copy_options::overwrite_existing);
  EXPECT_NE(deck_of(dir_ / "results", {}).find("there is no beam"), std::string::npos)
      << "no 'rod'";
  const fs::path summary = dir_ / "results/summary.json";
  std::string text = text_of(summary);
  fs::remove(dir_ / "results/design.toml");
  text.replace(text.find("\"command\": \"run\""), 16, "\"command\": \"map\"");
  output::write_file(summary, text);
  EXPECT_NE(deck_of(dir_ / "results", {}).find("is a folder without a scene"), std::string::npos);
  const std::string key = "\"liesl\": \"";
  text.replace(text.find(key) + key.size(), 1, "9");
  output::write_file(summary, text);
  EXPECT_NE(deck_of(dir_ / "results", {}).find("run it again"), std::string::npos);
  EXPECT_EQ(run({"export", (dir_ / "results").string(), "--to", "xdmf"}).code, 3);
  fs::remove(summary);
  EXPECT_NE(deck_of(dir_ / "results", {}).find("no summary.json"), std::string::npos);
}

std::set<std::string> folders_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_directory()) names.insert(entry.path().filename().string());
  return names;
}

/// No scenario is left out, each deck says which it is, and files that only look like a design are
/// no scenario.
TEST_F(Export, HasAFolderForEachScenarioOfTheStudyAndNoOther) {
  const Outcome end = run({"optimize", study("rod_three_speeds"), "-o", results(), "--set",
                           "scene." + kShort[0], "--set", "cycle.max=1", "--set",
                           "cycle.optimality=\"never\"", "--no-verify", "--no-report"});
  ASSERT_TRUE(fs::exists(results() / "design_slow.toml")) << end.err;
  const std::set<std::string> known = {"over", "rated", "slow"};
  EXPECT_EQ(summary()["scenarios"], Json(known));
  for (const char* stray : {"design_old.toml", "design_.toml"})  // as good as any other
    fs::copy_file(results() / "design_slow.toml", results() / stray);
  output::write_file(results() / "design_notes.toml", "of no scene = at all\n");
  const Words words = {"export",  results(), "--part",      "rod",    "--to",
                       "nastran", "-o",      dir_ / "deck", "--force"};
  const Outcome o = run(words);
  ASSERT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(folders_in(dir_ / "deck"), known);
  for (const std::string& name : known) {
    EXPECT_TRUE(fs::exists(dir_ / "deck" / name / "rod.bdf"));
    EXPECT_NE(text_of(dir_ / "deck" / name / "README.md").find(", scenario '" + name + "'"),
              std::string::npos);
    EXPECT_NE(o.out.find("deck/" + name + "/rod.bdf"), std::string::npos) << o.out;
  }
  EXPECT_FALSE(fs::exists(dir_ / "deck/rod.bdf"));
  std::ofstream(results() / "design_slow.toml", std::ios::app) << "# edited\n";
  const Outcome edited = run(words);
  EXPECT_EQ(edited.code, 2);
  EXPECT_NE(edited.err.find("'design_slow.toml' is not the design of these results"),
            std::string::npos)
      << edited.err;
  EXPECT_NE(edited.err.find("liesl export " + (results() / "design_slow.toml").string()),
            std::string::npos)
      << edited.err;
  fs::remove(results() / "design_slow.toml");
  const Outcome half = run(words);
  EXPECT_EQ(half.code, 2);
  EXPECT_NE(half.err.find("'design_slow.toml' of scenario 'slow' is missing"), std::string::npos)
      << half.err;
}

/// A study without scenarios has one design, whatever lies beside it.
TEST_F(Export, TakesNoOtherDesignWhereThereAreNoScenarios) {
  ASSERT_EQ(run({"run", (kData / "scenes/slider_crank.toml").string(), "-o", results().string(),
                 "--set", kShort[0]})
                .code,
            0);
  for (const char* name : {"design.toml", "design_old.toml"})
    fs::copy_file(kData / "scenes/slider_crank.toml", results() / name);
  ASSERT_EQ(run({"export", results(), "--part", "rod", "--to", "nastran", "-o", dir_ / "deck",
                 "--set", kShort[0]})
                .code,
            0);
  EXPECT_TRUE(fs::exists(dir_ / "deck/rod.bdf"));
  EXPECT_EQ(folders_in(dir_ / "deck"), std::set<std::string>());
}

TEST_F(Export, APartThatBendsFarSaysSo) {
  for (const auto& [scene, part, far] :
       {std::tuple("pendulum", "beam", true), {"slider_crank", "rod", false}}) {
    ASSERT_EQ(run({"export", (kData / "scenes" / (std::string(scene) + ".toml")).string(), "--part",
                   part, "--to", "calculix", "-o", (dir_ / scene).string()})
                  .code,
              0);
    EXPECT_EQ(text_of(dir_ / scene / "README.md").find("bends far") != std::string::npos, far);
  }
}

}  // namespace
}  // namespace liesl::test::beam_deck_test
