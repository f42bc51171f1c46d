/// @file
/// Faults in a scene: each is found at its place and said in words, and nothing else is.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "apps/good_scene.hpp"
#include "apps/scene/load_scene.hpp"
#include "reference/places.hpp"

namespace liesl::test::bad_scene_test {
namespace {

using test::changed;
using test::kGoodScene;

/// `to` replaces `from`; '@' in it marks where the problem is expected and is taken out.
struct BadScene {
  const char* name;
  const char* from;
  const char* to;
  std::vector<const char*> words;
};

void PrintTo(const BadScene& scene, std::ostream* out) { *out << scene.name; }

class Bad : public testing::TestWithParam<BadScene> {};

TEST_P(Bad, IsRefusedAtItsPlace) {
  const BadScene& c = GetParam();
  const test::MarkedText marked(changed(kGoodScene, c.from, c.to));
  const auto read = [](const auto& text, const auto& file) { read_scene(text, file); };
  test::expect_refused(marked, "scene.toml", read, c.words);
}

// clang-format off
const BadScene kScenes[] = {
    // Keys and types.
    {"UnknownKey", "step = 1e-3", "@stepp = 1e-3", {"unknown key", "simulation.stepp", "did you mean 'step'"}},
    {"UnknownTable", "[forces]", "[@forcess]", {"unknown key 'forcess'", "'forces'"}},
    {"UnknownKeyOfShape", "diameter = 0.02, shear", "diameter = 0.02, @width = 1, shear", {"sections.round.width", "of this kind"}},
    {"MissingKey", "steel = { E = 210e9, nu = 0.3", "steel = @{ nu = 0.3", {"missing key 'materials.steel.E'", "Young"}},
    {"MissingKeyOfShape", "wall = { type = \"tube\", diameter = 0.02, thickness = 0.002 }", "wall = @{ type = \"tube\", diameter = 0.02 }", {"missing key 'sections.wall.thickness'"}},
    {"WrongType", "mass = 0.2", "mass = @\"0.2\"", {"'bodies.slider.rigid.mass' is a string", "a number > 0 (kg)"}},
    {"NotANumber", "E = 210e9", "E = @true", {"expected a number"}},
    {"NumberForInteger", "elements = 4", "elements = @4.5", {"an integer"}},
    {"ShortVector", "gravity = [0, -9.81, 0]", "gravity = @[0, -9.81]", {"2 entries", "a list of 3 numbers (m/s^2)"}},
    {"WordInVector", "gravity = [0, -9.81, 0]", "gravity = [0, @\"down\", 0]", {"gravity.1", "a string"}},
    {"Infinite", "rest = 0.01", "rest = @inf", {"inf", "finite"}},
    {"NotFinite", "at = [0.6, 0, 0], mass", "at = [0.6, @nan, 0], mass", {"nan", "finite"}},
    {"OutOfRange", "nu = 0.3", "nu = @0.7", {"out of range: 0.7", "in (-1, 0.5)"}},
    {"NegativePenalty", "step = 1e-3", "step = 1e-3\nconstraints = \"penalty\"\npenalty = @-1", {"out of range: -1"}},
    {"AbsurdPenalty", "step = 1e-3", "step = 1e-3\nconstraints = \"augmented\"\npenalty_rotation = @1e30", {"out of range: 1e+30"}},
    {"PenaltyOfMultipliers", "step = 1e-3", "step = 1e-3\n@penalty = 1e9", {"simulation.penalty", "of this kind", "'penalty' is for constraints = penalty, augmented"}},
    {"AbsurdPenaltyDamping", "step = 1e-3", "step = 1e-3\nconstraints = \"penalty\"\npenalty_damping = @1e6", {"out of range: 1e+06", "in [0, 1] (s)"}},
    {"PenaltyInStatics", "step = 1e-3", "step = 1e-3\ntype = \"static\"\nconstraints = @\"penalty\"", {"for motions only"}},
    {"MassOfNoSegments", "elements = 4 }", "elements = 4, mass = @\"lumped\" }", {"beam 'crank' has no 'mass'", "as = \"segments\""}},
    {"NegativeLength", "thickness = 0.002", "thickness = @-0.002", {"out of range", "> 0"}},
    {"UnknownOption", "\"circle\"", "@\"circel\"", {"\"circel\"", "did you mean 'circle'"}},
    {"TwoTypesOfJoint", "pin = { revolute = [\"crank.end\", \"rod.start\"]", "pin = { fixed = [\"crank.end\", \"rod.start\"], revolute = @[\"crank.end\", \"rod.start\"]", {"both 'fixed' and 'revolute'", "exactly one of"}},
    {"NoTypeOfJoint", "pin = { revolute = [\"crank.end\", \"rod.start\"] }", "pin = @{ axis = [0, 0, 1] }", {"missing", "exactly one of", "revolute"}},
    {"OnePort", "pin = { revolute = [\"crank.end\", \"rod.start\"]", "pin = { revolute = @[\"crank.end\"]", {"1 entries", "two strings"}},
    {"NameWithDot", "round = {", "@\"a.b\" = { type = \"circle\", diameter = 0.1 }\nround = {", {"not a name", "without dots"}},
    {"ManyElements", "elements = 4", "elements = @10001", {"out of range", "10000"}},
    // Gears, cylinders, bushings, springs with tables, points, tapers.
    {"GearOfNoJoint", "[loads]", "[gears]\nmesh = { of = [\"motor\", @\"pim\"], ratio = 2 }\n[loads]", {"no joint 'pim'", "'pin'"}},
    {"GearOfNoCoordinate", "[loads]", "[gears]\nmesh = { of = [\"motor\", @\"pin.1\"], ratio = 2 }\n[loads]", {"'pin.1' is no coordinate"}},
    {"GearOfOneCoordinate", "[loads]", "[gears]\nmesh = { of = @[\"pin\", \"pin\"], ratio = 2 }\n[loads]", {"couples a coordinate with itself"}},
    {"GearWithoutRatio", "[loads]", "[gears]\nmesh = { of = [\"motor\", \"pin\"], ratio = @0 }\n[loads]", {"ratio of gear 'mesh' is 0"}},
    {"GearNamedTwice", "[forces]\nspring", "[gears]\nspring = { of = [\"motor\", \"pin\"], ratio = 2 }\n[forces]\n@spring", {"duplicate name 'spring' in [gears] and [forces]"}},
    {"SpringTable", "rest = 0.01", "spring = { table = [[0, 0], @[0, 1]] }", {"x = 0 follows x = 0", "increasing x"}},
    {"CylinderOfOnePlace", "pin = { revolute = [\"crank.end\"", "pin = { cylinder = @[\"crank.end\"", {"cylinder 'pin' joins two ports at the same place"}},
    {"BushingWithoutLaw", "pin = { revolute = [\"crank.end\", \"rod.start\"] }", "pin = @{ bushing = [\"crank.end\", \"rod.start\"] }", {"bushing 'pin' has no force law", "6 numbers"}},
    {"BushingOfTwoNumbers", "pin = { revolute = [\"crank.end\", \"rod.start\"] }", "pin = { bushing = [\"crank.end\", \"rod.start\"], stiffness = @[1, 2] }", {"2 entries", "6 numbers"}},
    {"BushingNotSymmetric", "pin = { revolute = [\"crank.end\", \"rod.start\"] }", "pin = { bushing = [\"crank.end\", \"rod.start\"], stiffness = @[[1, 1, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], [0, 0, 0, 1, 0, 0], [0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1]] }", {"'stiffness' is not symmetric", "order of the coordinates"}},
    {"BushingOfUnlikeUnits", "pin = { revolute = [\"crank.end\", \"rod.start\"] }", "pin = { bushing = [\"crank.end\", \"rod.start\"], stiffness = @[[1e9, 0, 0, 0, 0, 0], [0, 1e9, 0, 0, 0, 0], [0, 0, 1e9, 0, 0, 0], [0, 0, 0, 1, 0.5, 0], [0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1]] }", {"'stiffness' is not symmetric"}},
    {"BushingThatPushes", "pin = { revolute = [\"crank.end\", \"rod.start\"] }", "pin = { bushing = [\"crank.end\", \"rod.start\"], damping = @[[1, 2, 0, 0, 0, 0], [2, 1, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], [0, 0, 0, 1, 0, 0], [0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1]] }", {"'damping' has a negative eigenvalue", "symmetric matrix"}},
    {"BushingOfThreeRows", "pin = { revolute = [\"crank.end\", \"rod.start\"] }", "pin = { bushing = [\"crank.end\", \"rod.start\"], stiffness = @[[1, 0, 0], [0, 1, 0], [0, 0, 1]] }", {"3 rows", "6 rows of 6"}},
    {"BushingOfOneNumber", "pin = { revolute = [\"crank.end\", \"rod.start\"] }", "pin = { bushing = [\"crank.end\", \"rod.start\"], stiffness = @3 }", {"1 numbers for 6 coordinates"}},
    {"StiffnessOfARevolute", "\"rod.start\"] }", "\"rod.start\"], stiffness = @3 }", {"revolute joint 'pin' has no 'stiffness'", "on = \"pin\""}},
    {"NoPointOfTheGround", "between = [\"ground\"", "between = [@\"ground.hook\"", {"the ground has no point 'hook'", "ground.points"}},
    {"TaperOfOneSection", "elements = 4 }", "elements = 4, taper = @true }", {"has 'taper' but one section"}},
    {"TaperBetweenTypes", "section = \"round\"", "taper = true, section = [\"round\", @\"wall\"]", {"tapers from 'round' to 'wall'", "one type"}},
    {"PointOnNoNode", "elements = 4 }", "elements = 4, points = { lug = { on = @\"node9\", at = [0, 0, 0] } } }", {"has no node 'node9'", "node4"}},
    {"PointNamedAsANode", "elements = 4 }", "elements = 4, points = { @end = { on = \"mid\", at = [0, 0, 0] } } }", {"'end', which is one of its nodes"}},
    {"GravityScaleAlone", "gravity = [0, -9.81, 0]", "gravity_scale = @\"t\"", {"'gravity_scale' without gravity"}},
    {"RotationOfTheGround", "\"position\", at = \"slider.origin\"", "\"rotation\", at = @\"ground\"", {"is of the ground"}},
    // Names of nothing.
    {"NoSection", "section = \"round\"", "section = @\"ruond\"", {"no section 'ruond'", "did you mean 'round'"}},
    {"NoMaterial", "section = \"round\", material = \"steel\"", "section = \"round\", material = @\"Steal\"", {"no material 'Steal'", "'steel'"}},
    {"NoBody", "[\"crank.end\", \"rod.start\"]", "[@\"cranck.end\", \"rod.start\"]", {"no body 'cranck'", "'crank'"}},
    {"NoPort", "[\"crank.end\", \"rod.start\"]", "[\"crank.end\", @\"rod.strat\"]", {"no port 'strat'", "did you mean 'start'"}},
    {"NoPoint", "{ at = \"slider.tip\"", "{ at = @\"slider.tap\"", {"no port 'tap'", "'tip'"}},
    {"BodyForPort", "{ at = \"slider.tip\"", "{ at = @\"slider\"", {"a body, not a port", "origin"}},
    {"NoJoint", "on = \"guide\"", "on = @\"giude\"", {"no joint 'giude'", "'guide'"}},
    {"OddOrder", "elements = 4 }", "elements = 4, order = @3 }", {"beam 'crank' has order 3", "2 or 4"}},
    {"OrderTooHigh", "elements = 4 }", "elements = 4, order = @6 }", {"order"}},
    {"OrderOfARigidBeam", "elements = 4 }", "elements = 4, as = \"rigid\", order = @4 }", {"beam 'crank' of order 4 as \"rigid\"", "order = 2"}},
    {"NoSuchUpdate", "step = 1e-3", "step = 1e-3\nformalism = \"classical\"\nupdate = @\"r3so3\"", {"'simulation.update'", "classical"}},
    {"UpdateInStatics", "step = 1e-3", "step = 1e-3\ntype = \"static\"\nupdate = @\"r3so3\"", {"'simulation.update' is for motions only", "simulation.type = \"dynamic\""}},
    {"NoBeam", "over = \"rod\"", "over = @\"slider\"", {"'slider' is rigid", "a beam"}},
    {"KeyOfOtherResponses", "response = \"deflection\", of = \"crank\"", "response = \"energy\", @at = \"mid\"", {"'at' is for response = position,", "displacement", "deflection, section_force"}},
    {"MidOfOddBeam", "response = \"deflection\", of = \"crank\"", "response = \"deflection\", of = \"rod\", at = @\"mid\"", {"5 elements", "even number"}},
    {"NoNode", "response = \"deflection\", of = \"crank\"", "response = \"deflection\", of = \"crank\", at = @\"node9\"", {"no node 'node9'", "node3"}},
    {"PortMidOfOddBeam", "{ at = \"slider.tip\"", "{ at = @\"rod.mid\"", {"'mid'", "even number of elements"}},
    // Bodies.
    {"ZeroLength", "to = [0.2, 0, 0]", "to = @[0, 0, 0]", {"zero length", "two points"}},
    {"NoEnd", "crank = { beam = { from = [0, 0, 0], to = [0.2, 0, 0]", "crank = { beam = @{ from = [0, 0, 0]", {"no 'to'"}},
    {"NoMass", "mass = 0.2", "mass = @0", {"out of range: 0", "> 0 (kg)"}},
    {"TextThatEnds", "name = \"good\"", "name = @\"a\\u0000b\"", {"holds a NUL character"}},
    {"SquareNoNumber", "mass = 0.2", "mass = @1e200", {"out of range: 1e+200", "at most 1e+100"}},
    {"NoDensity", "rho = 7850 }", "rho = @0.0 }", {"no mass", "rho = 0", "density > 0"}},
    {"IndefiniteInertia", "inertia = [1e-4, 1e-4, 1e-4]", "inertia = @[1e-4, 1e-4, -1e-4]", {"not positive semi-definite", "radius r"}},
    {"InertiaOfNoBody", "inertia = [1e-4, 1e-4, 1e-4]", "inertia = @[1e-4, 1e-4, 3e-4]", {"of no body", "0.0003"}},
    {"WallsMeet", "thickness = 0.002", "thickness = @0.02", {"section 'wall'"}},
    {"UpAlongAxis", "section = \"round\", material", "section = \"round\", up = @[1, 0, 0], material", {"'up' along its axis"}},
    {"SectionsThanElements", "section = \"round\"", "section = @[\"round\", \"round\", \"round\", \"round\", \"round\"]", {"5 sections for 4 elements"}},
    {"GroundBody", "slider = {", "@ground = { rigid = { at = [0, 0, 0], mass = 1, inertia = [1, 1, 1] } }\nslider = {", {"'ground' is the inertial frame"}},
    {"NoMaterialGiven", "beam = { from = [0, 0, 0], to = [0.2, 0, 0], section = \"round\", material = \"steel\"", "beam = @{ from = [0, 0, 0], to = [0.2, 0, 0], section = \"round\"", {"no material"}},
    // Joints and drives.
    {"EndsApart", "[\"crank.end\", \"rod.start\"]", "@[\"crank.start\", \"rod.start\"]", {"0.2 m apart", "'pin'"}},
    {"ZeroAxis", "axis = [0, 0, 2]", "axis = @[0, 0, 0]", {"zero vector"}},
    {"GroundToGround", "guide = { prismatic = [\"ground\", \"slider.origin\"]", "guide = { prismatic = @[\"ground\", \"ground\"]", {"joins the ground to itself"}},
    {"NoCoordinate", "ramp = 0.1 }", "ramp = 0.1, coordinate = @1 }", {"no coordinate 1", "0 to 0"}},
    {"TwoDrives", "drive = { rate = 10, ramp = 0.1 }", "drive = [{ rate = 10 }, @{ rate = 5 }]", {"two drives on coordinate 0", "'motor'"}},
    {"DriveOnSpherical", "pin = { revolute = [\"crank.end\", \"rod.start\"] }", "pin = { spherical = [\"crank.end\", \"rod.start\"], drive = @{ rate = 1 } }", {"spherical joint 'pin' has no coordinate 0"}},
    {"SkewUniversal", "pin = { revolute = [\"crank.end\", \"rod.start\"] }", "pin = { universal = [\"crank.end\", \"rod.start\"], axis2 = @[0, 1, 1] }", {"45 degrees", "right angles"}},
    {"ScrewWithoutPitch", "pin = { revolute = [\"crank.end\", \"rod.start\"] }", "pin = @{ screw = [\"crank.end\", \"rod.start\"] }", {"screw joint 'pin' has no pitch", "a displacement a turn (m)"}},
    {"ScrewOfPitchZero", "pin = { revolute = [\"crank.end\", \"rod.start\"] }", "pin = { screw = [\"crank.end\", \"rod.start\"], pitch = @0 }", {"screw joint 'pin' has zero pitch", "revolute"}},
    {"PitchOfRevolute", "pin = { revolute = [\"crank.end\", \"rod.start\"] }", "pin = { revolute = [\"crank.end\", \"rod.start\"], pitch = @0.01 }", {"revolute joint 'pin' has no pitch", "screw"}},
    {"DriveNotFinite", "drive = { rate = 10, ramp = 0.1 }", "drive = @{ expression = \"sqrt((t-0.001)*(t-0.003))\" }", {"the drive of 'motor' is not finite at t = 0.001", "finite number during"}},
    {"ScaleNotFinite", "scale = { table = [[0, 0], [1, 4]] }", "scale = @{ expression = \"sqrt((t-0.001)*(t-0.003))\" }", {"the scale of load 'push' is not finite at t = 0.001"}},
    {"NotANumberAtTheEnd", "force = \"sin(2*pi*t)\"", "force = @\"sqrt(0.4-t)\"", {"the expression is not a number at t = 0.4"}},
    {"ForceWithinABody", "between = [\"ground\", \"slider.tip\"]", "between = @[\"slider.origin\", \"slider.tip\"]", {"between two points of the rigid body 'slider'", "keep their distance"}},
    {"ForceWithinTheGround", "[forces]\nspring = { on = \"guide\", stiffness = 10, damping = 0.5, rest = 0.01 }", "[ground.points]\npost = [0, 1, 0]\n[forces]\nspring = { between = @[\"ground\", \"ground.post\"], stiffness = 10 }", {"between two points of the ground"}},
    {"NoDrives", "drive = { rate = 10, ramp = 0.1 }", "drive = @[]", {"'joints.motor.drive' is empty", "leave the key out"}},
    {"SecondAxisOfRevolute", "pin = { revolute = [\"crank.end\", \"rod.start\"] }", "pin = { revolute = [\"crank.end\", \"rod.start\"], axis2 = @[1, 0, 0] }", {"revolute joint 'pin' has no second axis", "universal"}},
    {"InterpolationOfRate", "drive = { rate = 10, ramp = 0.1 }", "drive = { rate = 10, interpolation = @\"cubic\" }", {"'interpolation' but no 'table'"}},
    {"RampOfExpression", "drive = { rate = 10, ramp = 0.1 }", "drive = { expression = \"t\", ramp = @0.1 }", {"'ramp' but no 'rate'"}},
    {"EndlessInteger", "step = 1e-3", "output_every = @1000000000000", {"out of range: 1e+12", "an integer", "at most 1e+09"}},
    {"IntegerWithExponent", "step = 1e-3", "output_every = @1e3", {"'simulation.output_every' is a number", "an integer", "without point and exponent"}},
    {"EndlessIntegerWithExponent", "step = 1e-3", "output_every = @1e12", {"out of range: 1e+12", "at most 1e+09"}},
    {"DuplicateName", "spring = { on", "@motor = { on", {"duplicate name 'motor'", "[joints] and [forces]"}},
    {"SpringOnNothing", "on = \"guide\"", "on = @\"guide.1\"", {"'guide.1' is no coordinate", "0 to 0"}},
    // Functions.
    {"TableBackwards", "[[0, 0], [1, 4]]", "[[0, 0], [1, 4], @[1, 5]]", {"t = 1 follows t = 1", "increasing"}},
    {"ShortTable", "[[0, 0], [1, 4]]", "@[[0, 0]]", {"1 rows", "two or more"}},
    {"BadExpression", "\"sin(2*pi*t)\"", "@\"sin(2*pi*x)\"", {"x", "expression of t"}},
    {"SingularExpression", "\"sin(2*pi*t)\"", "@\"1/t\"", {"at t = 0", "finite"}},
    {"NoLoad", "push = { at = \"slider.tip\", force = [1, 0, 0], ", "push = @{ at = \"slider.tip\", ", {"load 'push' is zero"}},
    // Simulation.
    {"StepAboveDuration", "step = 1e-3", "step = @0.6", {"longer than the duration", "0.5 s"}},
    {"ZeroDuration", "duration = 0.5", "duration = @0", {"out of range: 0", "> 0 (s)"}},
    {"ZeroStep", "step = 1e-3", "step = @0", {"out of range: 0", "> 0 (s)"}},
    {"RhoAboveOne", "step = 1e-3", "rho_inf = @1.5", {"in [0, 1]"}},
    {"UnknownResponse", "\"position\"", "@\"postion\"", {"did you mean 'position'"}},
    {"KeyOfOtherResponse", "of = \"crank\"", "of = \"crank\", @axis = [1, 0, 0]", {"unknown key 'responses.bend.axis'"}},
    // The parser's own.
    {"DuplicateKey", "step = 1e-3", "step = 1e-3\nduration = @2", {"duplicate name"}},
    {"Syntax", "step = 1e-3", "step = @= 1e-3", {"not TOML"}},
};
// clang-format on

TEST(LongText, NamesThatNoFileTakesAreRefused) {
  const std::string name(256, 'n'), good(255, 'n');
  const std::string entry = " = { type = \"circle\", diameter = 0.1 }\nround = {";
  EXPECT_NO_THROW(read_scene(changed(kGoodScene, "round = {", good + entry), "scene.toml"));
  try {
    read_scene(changed(kGoodScene, "round = {", name + entry), "scene.toml");
    FAIL() << "not refused";
  } catch (const InputError& error) {
    ASSERT_EQ(error.problems.size(), 1u);
    EXPECT_EQ(error.problems[0].line, 8);
    EXPECT_NE(error.problems[0].text().find("a name of 256 characters"), std::string::npos);
  }
  EXPECT_THROW(read_scene(changed(kGoodScene, "\"good\"", '"' + name + '"'), "scene.toml"),
               InputError);
}

TEST(LongText, IsShortenedInMessages) {
  const std::string endless(100000, '1');
  const std::pair<const char*, std::string> faults[] = {
      {"\"sin(2*pi*t)\"", "\"x+" + endless + "\""},
      {"step = 1e-3", "a" + endless + " = 1"},
      {"\"circle\"", "\"" + endless + "\""},
  };
  for (const auto& [from, to] : faults) try {
      read_scene(changed(kGoodScene, from, to), "scene.toml");
      ADD_FAILURE() << "not refused: " << from;
    } catch (const InputError& error) {
      for (const auto& problem : error.problems) {
        EXPECT_LT(problem.text().size(), 1500u);
        EXPECT_NE(problem.text().find("characters)"), std::string::npos) << problem.text();
      }
    }
  try {
    read_scene(kGoodScene, "scene.toml", {"simulation.stepp=" + endless});
    ADD_FAILURE() << "not refused";
  } catch (const InputError& error) {
    EXPECT_LT(std::string(error.what()).size(), 1500u);
    EXPECT_NE(std::string(error.what()).find("did you mean 'step'?"), std::string::npos);
  }
  // Between UTF-8 characters only.
  const InputProblem umlauts{"f",
                             0,
                             0,
                             [] {
                               std::string text;
                               for (int i = 0; i < 1000; ++i) text += "\u00e4";
                               return "x" + text;
                             }(),
                             "",
                             ""};
  const std::string text = umlauts.text().substr(3);
  EXPECT_EQ(text[text.find("...") - 1], '\xa4');
  EXPECT_EQ(text[text.rfind("...") + 3], '\xc3');
}

TEST(OneMistake, IsOneProblem) {
  const std::tuple<const char*, const char*, const char*> mistakes[] = {
      {"diameter = 0.02, shear", "diametr = 0.02, shear", "did you mean 'diameter'?"},
      {"E = 210e9", "e = 210e9", "did you mean 'E'?"},
      {"pin = { revolute", "pin = { revolut", "did you mean 'revolute'?"},
  };
  for (const auto& [from, to, hint] : mistakes) try {
      read_scene(changed(kGoodScene, from, to), "scene.toml");
      ADD_FAILURE() << to << " is not refused";
    } catch (const InputError& error) {
      EXPECT_EQ(error.problems.size(), 1u) << error.what();
      EXPECT_NE(std::string(error.what()).find(hint), std::string::npos) << error.what();
    }
}

TEST(Units, ShippedScenesLookRight) {
  EXPECT_TRUE(read_scene(kGoodScene, "scene.toml").warnings.empty());
  for (const char* folder : {"scenes", "stability"})
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(test::kDataDir) / folder))
      if (entry.path().extension() == ".toml") {
        EXPECT_TRUE(load_scene(entry.path()).warnings.empty()) << entry.path();
      }
}

TEST(Units, LikelyMistakesAreNamed) {
  const std::tuple<const char*, const char*, const char*> mistakes[] = {
      {"E = 210e9", "E = 210", "210 GPa is 2.1e+11 Pa"},
      {"E = 210e9", "E = 210e3", "210000 MPa is 2.1e+11 Pa"},
      {"E = 210e9", "E = 210e12", "stiffer than diamond"},
      {"pin = { revolute = [\"crank.end\", \"rod.start\"] }",
       "pin = { screw = [\"crank.end\", \"rod.start\"], pitch = 5 }", "5 mm is 0.005 m"},
      {"rho = 7850", "rho = 7.85", "7.85 g/cm^3 is 7850 kg/m^3"},
      {"rho = 7850", "rho = 7.85e6", "heavier than any solid"},
      {"diameter = 0.02, shear", "diameter = 10, shear", "10 mm is 0.01 m"},
      {"-9.81", "-9810", "9810 mm/s^2 is 9.81 m/s^2"},
  };
  for (const auto& [from, to, hint] : mistakes) {
    const auto warnings = read_scene(changed(kGoodScene, from, to), "scene.toml").warnings;
    ASSERT_EQ(warnings.size(), 1u) << to;
    EXPECT_NE(warnings[0].find(hint), std::string::npos) << warnings[0];
  }
}

/// Statics and modes take loads at one instant, before which a ramp may not have begun.
TEST(Instant, LoadsThatAreZeroThenAreNamed) {
  const auto warnings_at = [](const std::string& keys) {
    return read_scene(changed(kGoodScene, "step = 1e-3", keys), "scene.toml").warnings;
  };
  const auto told = warnings_at("type = \"static\"");
  ASSERT_EQ(told.size(), 2u);
  EXPECT_NE(told[0].find("the force of 'rope' is 0 at simulation.at = 0 s"), std::string::npos);
  EXPECT_NE(told[1].find("the scale of load 'push' is 0 at simulation.at = 0 s"),
            std::string::npos);
  EXPECT_EQ(warnings_at("type = \"modes\"").size(), 2u);
  EXPECT_TRUE(warnings_at("type = \"static\"\nat = 0.1").empty());
  EXPECT_TRUE(warnings_at("step = 1e-3").empty());
}

TEST(Units, LikelyMistakesOfMeshedPartsAreNamed) {
  const std::string plate = R"toml(gravity = [0, -9.81, 0]
[materials]
steel = { E = 210e9, rho = 7850 }
[bodies.plate.solid]
mesh = { from = [0, 0], to = [0.4, 0.04], cells = [20, 4] }
material = "steel"
thickness = 0.005
damping = 1e-6
[bodies.plate.solid.interfaces]
left = { set = "x_min" }
right = { set = "x_max" }
[joints]
hinge = { revolute = ["ground", "plate.left"] }
[simulation]
duration = 0.1
)toml";
  EXPECT_TRUE(read_scene(plate, "scene.toml").warnings.empty());
  const std::tuple<const char*, const char*, const char*> mistakes[] = {
      {"thickness = 0.005", "thickness = 5", "5 mm is 0.005 m"},
      {"damping = 1e-6", "damping = 2", "bodies.plate.solid.damping = 2 s is about"},
  };
  for (const auto& [from, to, hint] : mistakes) {
    const auto warnings = read_scene(changed(plate, from, to), "scene.toml").warnings;
    ASSERT_EQ(warnings.size(), 1u) << to;
    EXPECT_NE(warnings[0].find(hint), std::string::npos) << warnings[0];
  }
}

INSTANTIATE_TEST_SUITE_P(Scene, Bad, testing::ValuesIn(kScenes),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace liesl::test::bad_scene_test
