/// @file
/// How far bodies in floating frames go beyond what they can describe.
#include "apps/tasks/part_range.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "apps/scene/load_scene.hpp"
#include "apps/tasks/run.hpp"
#include "apps/tasks/sensitivity.hpp"

namespace liesl::test::part_range_test {
namespace {

constexpr double kE = 210e9, kRho = 7850, kSide = 0.02, kLength = 1;
const double kEI = kE * std::pow(kSide, 4) / 12;
const double kEuler = M_PI * M_PI * kEI / (kLength * kLength);

/// A square bar along x, meshed or a beam, between `first` and `second` or held at `first` alone.
std::string bar(bool meshed, bool two, const std::string& rest) {
  const std::string mesh = fmt::format(
      R"toml(bar = {{ solid = {{ mesh = {{ from = [0, -0.01], to = [1, 0.01], cells = [100, 4] }}, material = "steel", thickness = 0.02, modes = 4, interfaces = {{ first = {{ set = "x_min" }}{} }} }} }})toml",
      two ? ", second = { set = \"x_max\" }" : "");
  const std::string beam =
      R"toml(bar = { beam = { from = [0, 0, 0], to = [1, 0, 0], section = "square", material = "steel", elements = 16, as = "modal", points = { first = { on = "start", at = [0, 0, 0] }, second = { on = "end", at = [1, 0, 0] } } } })toml";
  return fmt::format(R"toml(
[materials]
steel = {{ E = 210e9, nu = 0.3, rho = 7850 }}
[sections]
square = {{ type = "rectangle", width = 0.02, height = 0.02 }}
[bodies]
{}
{})toml",
                     meshed ? mesh : beam, rest);
}

/// The same bar, meshed in space.
std::string shaft(bool two, const std::string& rest) {
  return fmt::format(R"toml(
[materials]
steel = {{ E = 210e9, nu = 0.3, rho = 7850 }}
[bodies]
bar = {{ solid = {{ mesh = {{ from = [0, -0.01, -0.01], to = [1, 0.01, 0.01], cells = [60, 2, 2] }}, material = "steel", modes = 4, interfaces = {{ first = {{ set = "x_min" }}{} }} }} }}
{})toml",
                     two ? ", second = { set = \"x_max\" }" : "", rest);
}

std::string pulled(const std::string& force) {
  return "[joints]\nclamp = { fixed = [\"ground\", \"bar.first\"] }\n[loads]\nf = { at = "
         "\"bar.second\", force = " +
         force +
         ", scale = { table = [[0, 0], [0.2, 1]], interpolation = \"quintic\" } }\n"
         "[simulation]\nduration = 0.25\nstep = 1e-3\n";
}

std::string spun(double rate, const std::string& axis = "[0, 0, 1]") {
  return fmt::format(
      "[joints]\nhub = {{ revolute = [\"ground\", \"bar.first\"], axis = {}, drive = {{ rate = {}, "
      "ramp = 0.2 }} }}\n[simulation]\nduration = 0.25\nstep = 1e-3\n",
      axis, rate);
}

/// The figure after `words` in the warnings of a motion, 0 if there is none.
double said(const std::string& text, const std::string& words,
            SolveStatus status = SolveStatus::Converged) {
  const Scene scene = read_scene(text, "scene.toml");
  const RunOutcome out = run_task(scene, choose_space(scene));
  EXPECT_EQ(out.status, status) << out.summary.reason;
  for (const std::string& warning : out.summary.warnings)
    if (const auto at = warning.find(words); at != std::string::npos)
      return std::stod(warning.substr(at + words.size()));
  return 0;
}

const char* const kPulled = "is pulled by up to ";
const char* const kCarries = "carries up to ";
const char* const kBends = "bends by up to ";
const char* const kTurns = "turns at up to ";

/// Both kinds name the same share of pi^2 EI/L^2.
TEST(PartRange, TensionOverTheEulerLoad) {
  const double share = 10e3 / kEuler;
  for (const bool meshed : {true, false}) {
    EXPECT_NEAR(said(bar(meshed, true, pulled("[10e3, 0, 0]")), kPulled), share, 0.05 * share);
    EXPECT_EQ(said(bar(meshed, true, pulled("[10e3, 0, 0]")), kCarries), 0);
    EXPECT_EQ(said(bar(meshed, true, pulled("[2e3, 0, 0]")), kPulled), 0) << "within the bound";
  }
}

TEST(PartRange, CompressionOfABeamInAFloatingFrame) {
  const double share = 5e3 / kEuler;
  EXPECT_NEAR(said(bar(false, true, pulled("[-5e3, 0, 0]")), kCarries), share, 0.05 * share);
  EXPECT_EQ(said(bar(false, true, pulled("[-5e3, 0, 0]")), kPulled), 0);
}

/// The end of a cantilever turns by F L^2/(2 EI).
TEST(PartRange, TurnOfABeamInAFloatingFrame) {
  const double turn = 1.5e3 * kLength * kLength / (2 * kEI),
               bound = said(bar(false, true, pulled("[0, 100, 0]")), kBends);
  EXPECT_NEAR(said(bar(false, true, pulled("[0, 1500, 0]")), kBends), turn, 0.1 * turn);
  EXPECT_EQ(bound, 0) << "within the bound";
}

/// omega_1 = 3.516 sqrt(EI/(rho A L^4)).
TEST(PartRange, SpinOverTheLowestFrequencyOfABlade) {
  const double omega = 3.516 * std::sqrt(kEI / (kRho * kSide * kSide));
  EXPECT_NEAR(said(bar(true, false, spun(60)), kTurns), 60 / omega, 0.05 * 60 / omega);
  EXPECT_EQ(said(bar(true, false, spun(20)), kTurns), 0) << "within the bound";
}

/// With a free interface at its tip it is the tension at the root that is named, m Omega^2 L/2.
TEST(PartRange, CentrifugalForceOfAPartOfTwoInterfaces) {
  const double share = kRho * kSide * kSide * 60 * 60 / 2 / kEuler;
  EXPECT_NEAR(said(bar(true, true, spun(60)), kPulled), share, 0.1 * share);
}

/// About its own length nothing is pulled.
TEST(PartRange, SpinAboutTheOwnAxis) {
  for (const bool two : {true, false}) {
    const char* const words = two ? kPulled : kTurns;
    EXPECT_EQ(said(shaft(two, spun(80, "[1, 0, 0]")), words), 0) << two;
    EXPECT_GT(said(shaft(two, spun(80)), words), 0) << two;
  }
}

/// Above its lowest frequency a blade bends for ever, a bar between guides that is pressed above
/// its Euler load buckles between hinges, and one that is bent by half a turn is as far off its
/// line as it is long: none of them ends done. Tension has no such end.
TEST(PartRange, FarBeyondIsInaccurate) {
  constexpr auto doubted = SolveStatus::Inaccurate;
  const std::string guide =
      "guide = { prismatic = [\"ground\", \"bar.second\"], axis = [1, 0, 0] }\n[loads]";
  EXPECT_GT(said(bar(true, false, spun(120)), kTurns, doubted), 1);
  for (const bool meshed : {true, false}) {
    std::string pressed = pulled("[-30e3, 0, 0]");
    pressed.replace(pressed.find("[loads]"), 7, guide);
    EXPECT_NEAR(said(bar(meshed, true, pressed), kCarries, doubted), 30e3 / kEuler, 0.1);
    std::string bent = pulled("[0, 0, 0]");
    bent.replace(bent.find("force = [0, 0, 0]"), 17, "moment = [0, 0, 5040]");
    EXPECT_NEAR(said(bar(meshed, true, bent), kBends, doubted), 5040 * kLength / kEI, 0.2);
    EXPECT_GT(said(bar(meshed, true, pulled("[60e3, 0, 0]")), kPulled), 2);
  }
}

/// Ranges are those of every step, whatever is recorded: a push that is over between two records.
TEST(PartRange, IsOfEveryStep) {
  for (const bool meshed : {true, false}) {
    const std::string push =
        "[joints]\nclamp = { fixed = [\"ground\", \"bar.first\"] }\n[loads]\nf = { at = "
        "\"bar.second\", force = [10e3, 0, 0], scale = { table = [[0, 0], [0.1, 1], [0.2, 0]] } "
        "}\n[simulation]\nduration = 0.2\nstep = 1e-3\n";
    const double all = said(bar(meshed, true, push), kPulled);
    EXPECT_GT(all, 0.1);
    EXPECT_EQ(said(bar(meshed, true, push + "output_every = 200\n"), kPulled), all);
  }
}

/// Modes about an equilibrium, too.
TEST(PartRange, OfTheEquilibriumOfModes) {
  const std::string pressed =
      "[joints]\nclamp = { fixed = [\"ground\", \"bar.first\"] }\n[loads]\nf = { at = "
      "\"bar.second\", force = [-5e3, 0, 0] }\n[simulation]\ntype = \"modes\"\n";
  EXPECT_NEAR(said(bar(true, true, pressed), kCarries), 5e3 / kEuler, 0.01);
}

/// In space nothing but torsion holds the turn of an end that a chain of segments leaves free: a
/// load that turns it is no part of the model, one that bends in a plane is.
TEST(PartRange, AFreeEndThatSpinsIsNotReliedOn) {
  const auto end_of = [](const std::string& rest) {
    const Scene scene = read_scene(R"toml(
[materials]
plastic = { E = 2e9, nu = 0.3, rho = 1000 }
[sections]
round = { type = "circle", diameter = 0.01 }
[bodies.bar]
)toml" + rest + R"toml(
[bodies.bar.beam]
from = [0, 0, 0]
to = [1, 0, 0]
section = "round"
material = "plastic"
elements = 8
as = "segments"
points = { ear = { on = "end", at = [1, 0.3, 0] } }
[joints]
clamp = { fixed = ["ground", "bar.start"] }
[simulation]
duration = 0.2
step = 5e-4
space = "spatial"
)toml",
                                   "chain.toml");
    return run_task(scene, choose_space(scene));
  };
  const std::string twisted = "would be twisted";
  for (const char* rest : {"[loads]\nf = { at = \"bar.ear\", force = [0.3, 0, 0] }\ng = { at = "
                           "\"bar.end\", force = [0, "
                           "0, 0.1] }",
                           "angular_velocity = [5, 0, 0]"}) {
    const RunOutcome out = end_of(rest);
    EXPECT_EQ(out.status, SolveStatus::Inaccurate) << rest;
    EXPECT_NE(out.summary.reason.find(twisted), std::string::npos) << out.summary.reason;
  }
  const RunOutcome failed = end_of(
      "[loads]\nf = { at = \"bar.ear\", force = [30, 0, 0] }\ng = { at = \"bar.end\", force = [0, "
      "0, "
      "500] }");
  EXPECT_EQ(failed.status, SolveStatus::NotConverged);
  EXPECT_NE(failed.summary.reason.find(twisted), std::string::npos) << failed.summary.reason;
  for (const char* rest : {"[loads]\nf = { at = \"bar.end\", moment = [0, 0, 0.05] }",
                           "[loads]\nf = { at = \"bar.ear\", force = [0.3, 0, 0] }"}) {
    const RunOutcome out = end_of(rest);
    EXPECT_EQ(out.status, SolveStatus::Converged) << rest << out.summary.reason;
  }
}

/// A rod that falls from a ball joint while it spins about its axis is turned out of the plane by
/// the gyroscopic moment, which a chain has at its ends alone.
TEST(PartRange, AChainThatSpinsIsNotReliedOn) {
  const auto falls = [](double spin) {
    const Scene scene = read_scene(fmt::format(R"toml(
gravity = [0, -9.81, 0]
[materials]
steel = {{ E = 210e9, nu = 0.3, rho = 7850 }}
[sections]
round = {{ type = "circle", diameter = 0.02 }}
[bodies.bar]
angular_velocity = [{}, 0, 0]
beam = {{ from = [0, 0, 0], to = [0.8, 0, 0], section = "round", material = "steel", elements = 8, as = "segments" }}
[joints]
ball = {{ spherical = ["ground", "bar.start"] }}
[simulation]
duration = 0.1
step = 5e-4
space = "spatial"
)toml",
                                               spin),
                                   "spin.toml");
    return run_task(scene, choose_space(scene));
  };
  EXPECT_EQ(falls(3000).status, SolveStatus::Inaccurate);
  EXPECT_NE(falls(3000).summary.reason.find("nothing spins"), std::string::npos);
  const RunOutcome slow = falls(300), none = falls(0);
  EXPECT_EQ(slow.status, SolveStatus::Converged);
  const auto told = [](const std::string& w) { return w.find("nothing spins") != w.npos; };
  EXPECT_TRUE(std::ranges::any_of(slow.summary.warnings, told));
  EXPECT_FALSE(std::ranges::any_of(none.summary.warnings, told));
}

/// What sensitivities are of is no better than the motion.
TEST(PartRange, OfSensitivitiesToo) {
  const std::string scene =
      bar(true, false, spun(120)) + "[responses]\nenergy = { response = \"energy\" }\n";
  const SensitivityProblem problem =
      scene_problem(SceneText{scene, "blade.toml", {}}, {"materials.steel.E"});
  const SensitivityOutcome end =
      sensitivity_task(problem, choose_space(problem.scene), {{FunctionalSpec{}}});
  EXPECT_EQ(end.status, SolveStatus::Inaccurate) << end.summary.reason;
  EXPECT_NE(end.summary.reason.find(kBends), std::string::npos) << end.summary.reason;
  EXPECT_FALSE(end.result.gradients.empty());
}

/// Two beams, an L with an arm of this length, under its weight along z.
std::string corner(double arm, const std::string& formalism) {
  return fmt::format(R"toml(
gravity = [0, 0, -9.81]
[materials]
m = {{ E = 1e8, nu = 0.3, rho = 1000 }}
[sections]
s = {{ type = "circle", diameter = 0.02 }}
[bodies]
b = {{ beam = {{ from = [0, 0, 0], to = [1, 0, 0], section = "s", material = "m", elements = 8 }} }}
d = {{ beam = {{ from = [1, 0, 0], to = [{}, {}, 0], section = "s", material = "m", elements = 4 }} }}
[joints]
clamp = {{ fixed = ["ground", "b.start"] }}
corner = {{ fixed = ["b.end", "d.start"] }}
[simulation]
duration = 0.2
space = "spatial"
formalism = "{}"
)toml",
                     arm > 0 ? 1 : 1.5, arm, formalism);
}

/// What hangs beside a chain twists it, and the chain does not resist.
TEST(PartRange, TorsionThatAChainHasNot) {
  const char* const kTwisted = "would be twisted by ";
  EXPECT_GT(said(corner(0.5, "segments"), kTwisted, SolveStatus::Inaccurate), 0.05);
  EXPECT_EQ(said(corner(0, "segments"), kTwisted), 0) << "in one line";
  EXPECT_EQ(said(corner(0.5, "se3"), kTwisted), 0);
}

/// Stretched by 3 and by 300 times what is small.
TEST(PartRange, StressOfAContinuumForSmallStrains) {
  const auto pulled_bar = [](double force, const std::string& law) {
    return fmt::format(R"toml(
[materials]
m = {{ E = 1e7, nu = 0.3, rho = 1000 }}
[bodies.b.solid]
mesh = {{ from = [0, -0.05], to = [1, 0.05], cells = [20, 2] }}
material = "m"
thickness = 0.1
as = "continuum"
law = "{}"
[bodies.b.solid.interfaces]
l = {{ set = "x_min" }}
r = {{ set = "x_max" }}
[joints]
c = {{ fixed = ["ground", "b.l"] }}
[loads]
f = {{ at = "b.r", force = [{}, 0, 0] }}
[simulation]
type = "static"
)toml",
                       law, force);
  };
  const char* const kReaches = "the stress in the part 'b' reaches ";
  EXPECT_GT(said(pulled_bar(1e5, "st_venant_kirchhoff"), kReaches, SolveStatus::Inaccurate), 0.5);
  EXPECT_GT(said(pulled_bar(1e4, "st_venant_kirchhoff"), kReaches), 0.05);
  EXPECT_EQ(said(pulled_bar(1e3, "st_venant_kirchhoff"), kReaches), 0);
  EXPECT_EQ(said(pulled_bar(3e4, "neo_hookean"), kReaches), 0);
}

}  // namespace
}  // namespace liesl::test::part_range_test
