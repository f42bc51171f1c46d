/// @file
/// The README.md beside a deck: what somebody has to know who opens it in another program.
#include <gtest/gtest.h>

#include "apps/export/solid_deck.hpp"
#include "apps/program.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/tasks/describe_identity.hpp"

namespace liesl::test::deck_readme_test {
namespace {

struct Exported {
  explicit Exported(const char* name, const Words& set)
      : scene(load_scene(kData / "scenes" / name, set)),
        esl(esl_task(scene, choose_space(scene))) {}
  Scene scene;
  EslOutcome esl;
};

const BeamDeck& beam() {
  static const Exported of("slider_crank.toml", {"simulation.duration=0.03"});
  static const BeamDeck deck = beam_deck(of.scene, of.esl, "rod", DeckCases::Peaks);
  return deck;
}

const SolidDeck& plate() {
  static const Exported of("meshed_slider_crank.toml", {"simulation.duration=0.002"});
  static const SolidDeck deck = solid_deck(of.scene, of.esl, "rod", DeckCases::Peaks);
  return deck;
}

/// Lines are broken for readers; here they are not.
template <class Deck>
std::string readme(const Deck& deck, const char* program) {
  std::string text = deck_readme(deck, program);
  for (auto at = text.find("\n  "); at != std::string::npos; at = text.find("\n  ", at))
    text.replace(at, 3, " ");
  return text;
}

void expect_said(const std::string& text, const Words& all) {
  for (const std::string& words : all)
    EXPECT_NE(text.find(words), std::string::npos) << "'" << words << "' in\n" << text;
}

void expect_unsaid(const std::string& text, const Words& all) {
  for (const std::string& words : all)
    EXPECT_EQ(text.find(words), std::string::npos) << "'" << words << "' in\n" << text;
}

/// Rows of the table of cases.
std::size_t cases(const std::string& text) {
  std::size_t n = 0;
  for (auto at = text.find("\n| "); at != std::string::npos; at = text.find("\n| ", at + 1)) ++n;
  return n - 1;  // the heading
}

TEST(DeckReadme, OfABeamSaysUnitsFrameAndWhatItGivesBack) {
  const Identity& identity = beam().identity;
  ASSERT_LT(identity.nonlinear, 1e-9);
  ASSERT_GT(identity.linear, 1e-3) << "two numbers that cannot be mistaken for each other";
  for (const char* program : {"CalculiX", "Nastran"}) {
    const std::string text = readme(beam(), program);
    expect_said(
        text,
        {std::string("# rod of 'slider-crank' for ") + program, "- **Units**: m, N, Pa, kg, s.",
         "- **Frame**: inertial axes; the part where the scene puts it, held at its first node.",
         "turned into the frame of that node",
         "`displacements.csv`, the displacements of the motion",
         "differ from those of the motion, over the largest: " +
             difference_text(identity.nonlinear) + " (linear: " + difference_text(identity.linear) +
             ").",
         "Gravity and inertia are in the loads", "N L^2/(pi^2 EI) of its bending",
         "too much where N pulls and too little where it pushes",
         "- **Deviations go to one side**"});
    EXPECT_EQ(cases(text), beam().cases.size()) << text;
  }
}

/// A scene of statics or modes has no motion.
TEST(DeckReadme, OfAnEquilibriumSpeaksOfNoMotion) {
  for (const char* type : {"static", "modes"}) {
    const Exported of("svanberg_cantilever.toml",
                      {std::string("simulation.type=\"") + type + "\""});
    const BeamDeck deck = beam_deck(of.scene, of.esl, "beam", DeckCases::Peaks);
    const std::string text = readme(deck, "Nastran");
    expect_said(text, {"loads of an equilibrium: the internal forces of the part at 1 load factor,",
                       "the displacements of the equilibrium", "Gravity is in the loads",
                       "| case | load factor [-] |"});
    expect_unsaid(text, {"of a motion", "in the motion", "of the motion", "time [s]"});
    expect_said(nastran_text(deck), {"static loads of its equilibrium. SI",
                                     "LABEL = the equilibrium at load factor 1\n"});
    expect_said(calculix_text(deck), {"static loads of its equilibrium. SI",
                                      "** case 1: the equilibrium at load factor 1\n"});
    EXPECT_TRUE(deck_displacements(deck).starts_with("case,load factor [-],node,"));
  }
  SolidDeck part = plate();
  part.words.equilibrium = true;
  const std::string text = readme(part, "CalculiX");
  expect_said(text, {"loads of an equilibrium: what deforms the part at ",
                     "those of the equilibrium, over the largest", "| case | load factor [-] |"});
  expect_unsaid(text, {"of a motion", "of the motion", "time [s]"});
  expect_said(calculix_text(part), {"static loads of its equilibrium, as unit cases"});
  expect_said(nastran_text(part), {"LABEL = the equilibrium at load factor "});
  EXPECT_TRUE(deck_factors(part).starts_with("case,load factor [-],unit 1"));
}

/// The README of a program names what its deck has.
TEST(DeckReadme, OfABeamSaysHowItsProgramSolvesIt) {
  const std::string calculix = readme(beam(), "CalculiX"), nastran = readme(beam(), "Nastran");
  expect_said(calculix, {"solved with large displacements** (`NLGEOM`)", "is node 2k + 1",
                         "CalculiX 2.20 bends round bars by 0.4 % and tubes by 0.3 % less"});
  expect_said(calculix_text(beam()), {"*STEP, NLGEOM"});
  expect_unsaid(calculix, {"SOL 106", "grid"});
  expect_said(nastran, {"solved with large displacements** (`SOL 106`, `LGDISP`)", "is grid k + 1",
                        "no Nastran was at hand"});
  expect_said(nastran_text(beam()), {"SOL 106", "LGDISP"});
  expect_unsaid(nastran, {"NLGEOM", "CalculiX"});
}

/// CalculiX joins unlike outlines by rigid knots, but for those of bars at their nodes.
TEST(DeckReadme, OfABeamSaysWhereItsSectionsJump) {
  BeamDeck jumps = beam();
  auto& circle = std::get<Circle>(jumps.sections.back().shape);
  circle.diameter *= 1.5;
  const char *words = "sections of this part jump", *knots = "Tubes or boxes of this part";
  expect_said(readme(jumps, "CalculiX"), {words, "NODAL THICKNESS"});
  expect_unsaid(readme(jumps, "CalculiX"), {knots});
  for (const char* both : {words, knots}) {
    expect_unsaid(readme(jumps, "Nastran"), {both});
    expect_unsaid(readme(beam(), "CalculiX"), {both});
  }
  jumps.sections.back().shape = Tube{2 * circle.diameter, 0.001};
  expect_said(readme(jumps, "CalculiX"), {knots});
  expect_unsaid(readme(jumps, "CalculiX"), {words});
}

TEST(DeckReadme, OfAMeshedPartSaysUnitsFrameAndWhatItGivesBack) {
  const Vec3& x = plate().frame.x;
  EXPECT_EQ(x, Vec3(0.06, 0, 0));
  for (const char* program : {"CalculiX", "Nastran"}) {
    const std::string text = readme(plate(), program);
    expect_said(text, {std::string("# rod of 'meshed slider-crank' for ") + program,
                       "- **Units**: m, N, Pa, kg, s. A unit case is that of a coordinate of 1 m "
                       "or 1 rad",
                       "- **Frame**: that of the mesh, whose origin lies at (0.06, 0, 0) m",
                       "the floating frame of the first interface, which is held",
                       "with the factors of `factors.csv`", "`displacements.csv`",
                       "differ from those of the motion, over the largest: " +
                           difference_text(plate().identity.linear) + ".",
                       std::to_string(plate().units.size()) + " unit cases",
                       std::to_string(plate().cells.cols()) + " of " +
                           std::to_string(plate().node_count()) + " nodes"});
    EXPECT_EQ(cases(text), plate().times.size()) << text;
  }
}

/// Its cases are linear, as are its steps.
TEST(DeckReadme, OfAMeshedPartSaysHowItsProgramSolvesIt) {
  const std::string calculix = readme(plate(), "CalculiX"), nastran = readme(plate(), "Nastran");
  expect_said(calculix, {"- **Cases are linear** (no `NLGEOM`)", "one layer of C3D8I",
                         "C3D8I is liesl's cell, so that it does to 1e-6"});
  expect_unsaid(calculix_text(plate()), {"NLGEOM"});
  expect_unsaid(calculix, {"SOL 101", "LGDISP"});
  expect_said(nastran, {"- **Cases are linear** (`SOL 101`)", "CQUAD4, membrane stiffness alone",
                        "no Nastran was at hand"});
  expect_said(nastran_text(plate()), {"SOL 101"});
  expect_unsaid(nastran, {"NLGEOM", "LGDISP", "C3D8I", "CalculiX"});
}

}  // namespace
}  // namespace liesl::test::deck_readme_test
