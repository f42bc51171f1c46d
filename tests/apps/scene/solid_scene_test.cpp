/// @file
/// Meshed parts in scenes: the right part, and faults in it at their places.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "apps/good_scene.hpp"
#include "apps/scene/load_scene.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/volume_fraction.hpp"

namespace liesl::test::solid_scene_test {
namespace {

using test::changed;

const std::string kPlateScene = R"toml(name = "plate"
[materials]
steel = { E = 210e9, nu = 0.3, rho = 7850 }

[bodies.rod.solid]
mesh = { from = [-0.02, -0.015], to = [0.22, 0.015], cells = [48, 6] }
material = "steel"
thickness = 0.02
at = [0.06, 0, 0]
modes = 4

[bodies.rod.solid.interfaces]
big_end = { circle = { centre = [0, 0], radius = 0.009 } }
small_end = { box = { from = [0.19, -0.01], to = [0.21, 0.01] }, tie = "averaged" }

[bodies.rod.solid.outline]
plate = { type = "rectangle", x = 0.1, width = 0.24, height = 0.03, fillet = 0.01 }
hole1 = { type = "super_ellipse", x = 0.06, a = 0.015, b = 0.008, xi = 3, eta = 4 }
hole2 = { type = "spline", x = 0.14, points = [[0.01, 0], [0, 0.006], [-0.01, 0], [0, -0.006]] }
holes = { type = "union", of = ["hole1", "hole2"] }
shape = { type = "difference", of = ["plate", "holes"], radius = 0.001 }

[joints]
motor = { revolute = ["ground", "rod.big_end"], drive = { rate = 10, ramp = 0.1 } }

[simulation]
duration = 0.1
step = 1e-3
)toml";

const SolidSpec& rod_of(const Scene& scene) {
  return std::get<SolidSpec>(scene.mechanism.bodies[0].kind);
}

TEST(SolidScene, HasTheNumbersOfTheFile) {
  const Scene scene = read_scene(kPlateScene, "scene.toml");
  const SolidSpec& rod = rod_of(scene);
  EXPECT_EQ(rod.mesh().cell_count(), 288);
  EXPECT_EQ(rod.model->thickness(), 0.02);
  EXPECT_EQ(rod.modes, 4);
  EXPECT_EQ(rod.model->law().exponent, ErsatzLaw().exponent);
  ASSERT_EQ(rod.interfaces().size(), 2u);
  EXPECT_EQ(rod.interfaces()[0].tie, Tie::Rigid);
  EXPECT_EQ(rod.interfaces()[1].tie, Tie::Averaged);
  EXPECT_NEAR((rod.interfaces()[1].point - Vec3(0.2, 0, 0)).norm(), 0, 1e-15);
  for (const int node : rod.interfaces()[0].nodes) {
    EXPECT_LE(rod.mesh().nodes.col(node).norm(), 0.009 + 1e-9);
  }
  const auto port = scene.mechanism.port("rod.small_end");
  ASSERT_TRUE(port);
  EXPECT_NEAR((scene.mechanism.frame(*port).x - Vec3(0.26, 0, 0)).norm(), 0, 1e-15);
}

TEST(SolidScene, NumbersOfTheOutlineAreParametersByName) {
  SolidSpec rod = rod_of(read_scene(kPlateScene, "scene.toml"));
  const auto shape = make_shape(rod.outline);
  std::map<std::string, double> values;
  for (const auto& p : shape->parameters()) EXPECT_TRUE(values.emplace(p.name, p.value).second);
  EXPECT_EQ(values.at("hole1.a"), 0.015);
  EXPECT_EQ(values.at("hole1.eta"), 4);
  EXPECT_EQ(values.at("plate.x"), 0.1);
  EXPECT_EQ(values.at("plate.angle"), 0);
  EXPECT_EQ(values.at("hole2.p1.y"), 0.006);
  EXPECT_EQ(values.at("shape.radius"), 0.001);
  // A round trip through the values, and a change of one.
  Eigen::VectorXd p = shape->start();
  set_values(rod.outline, p);
  EXPECT_EQ(make_shape(rod.outline)->start(), p);
  for (int i = 0; i < shape->size(); ++i)
    if (shape->parameters()[i].name == "hole1.b") p[i] = 0.004;
  set_values(rod.outline, p);
  EXPECT_EQ(rod.outline.features[1].values, (std::vector<double>{0.06, 0, 0, 0.015, 0.004, 3, 4}));
}

TEST(SolidScene, MirrorsHaveAPlaceInTheCoordinatesOfTheMesh) {
  std::string text = changed(kPlateScene, "{ type = \"union\", of = [\"hole1\", \"hole2\"] }",
                             "{ type = \"mirror\", of = [\"hole1\"], y = 0.002 }");
  text = changed(text, "hole2 = {", "# hole2 = {");
  const SolidSpec rod = rod_of(read_scene(text, "scene.toml"));
  ASSERT_EQ(rod.outline.features[2].kind, levelset::FeatureKind::Mirror);
  EXPECT_EQ(rod.outline.features[2].values, (std::vector<double>{0, 0.002, 0}));
  const auto shape = make_shape(rod.outline);
  for (const double x : {0.04, 0.06, 0.075})
    for (const double y : {0.0, 0.003, 0.007})
      EXPECT_NEAR(shape->value({x, 0.002 + y, 0}), shape->value({x, 0.002 - y, 0}), 1e-15);
}

TEST(SolidScene, HasTheMassOfItsOutline) {
  std::string text = changed(kPlateScene, "cells = [48, 6]", "cells = [192, 24]");
  text = changed(text, "type = \"super_ellipse\", x = 0.06, a = 0.015, b = 0.008, xi = 3, eta = 4",
                 "type = \"circle\", x = 0.06, radius = 0.008");
  text = changed(text, "of = [\"hole1\", \"hole2\"]", "of = [\"hole1\"]");
  text = changed(text, "hole2 = {", "# hole2 = {");
  const SolidSpec rod = rod_of(read_scene(text, "scene.toml"));
  const double pi = std::numbers::pi;
  const double area = 0.24 * 0.03 - (4 - pi) * 1e-4 - pi * 0.008 * 0.008;
  EXPECT_NEAR(rod.model->total_mass(solid_fractions(rod).value) / (7850 * 0.02 * area), 1, 1e-3);
}

TEST(SolidScene, TakesMeshesFromFilesInItsFolder) {
  const auto folder = std::filesystem::temp_directory_path() / "liesl_solid_scene_test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "two.msh")
      << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n1 1 \"left\"\n1 2 \"right\"\n"
         "$EndPhysicalNames\n$Entities\n0 2 1 0\n1 0 0 0 0 1 0 1 1 0\n2 2 0 0 2 1 0 1 2 0\n"
         "1 0 0 0 2 1 0 0 0\n$EndEntities\n$Nodes\n1 6 1 6\n2 1 0 6\n1\n2\n3\n4\n5\n6\n"
         "0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n$EndNodes\n"
         "$Elements\n3 4 1 4\n1 1 1 1\n1 1 4\n1 2 1 1\n2 3 6\n2 1 3 2\n3 1 2 5 4\n4 2 3 6 5\n"
         "$EndElements\n";
  std::string text =
      changed(kPlateScene, "{ from = [-0.02, -0.015], to = [0.22, 0.015], cells = [48, 6] }",
              "{ file = \"two.msh\" }");
  text = changed(text, "{ circle = { centre = [0, 0], radius = 0.009 } }", "{ set = \"left\" }");
  text = changed(text, "{ box = { from = [0.19, -0.01], to = [0.21, 0.01] }, tie = \"averaged\" }",
                 "{ set = \"right\" }");
  text = changed(text, "modes = 4", "modes = 2");
  text.erase(text.find("[bodies.rod.solid.outline]"),
             text.find("[joints]") - text.find("[bodies.rod.solid.outline]"));
  const Scene scene = read_scene(text, (folder / "scene.toml").string());
  EXPECT_EQ(rod_of(scene).mesh().cell_count(), 2);
  EXPECT_NEAR((rod_of(scene).interfaces()[1].point - Vec3(2, 0.5, 0)).norm(), 0, 1e-15);
  EXPECT_NE(scene.input.find("$MeshFormat"), std::string::npos);  // part of the hash
  std::filesystem::remove_all(folder);
}

/// A prism of three tetrahedra.
TEST(SolidScene, TakesTetrahedraAndRefusesWhatTheyCannotHave) {
  const auto folder = std::filesystem::temp_directory_path() / "liesl_tetrahedra_test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "PART.INP")
      << "*NODE\n1, 0, 0, 0\n2, 0, 1, 0\n3, 0, 0, 1\n4, 2, 0, 0\n5, 2, 1, 0\n6, 2, 0, 1\n"
         "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 4\n2, 2, 5, 3, 4\n3, 3, 5, 6, 4\n"
         "*NSET, NSET=left\n1, 2, 3\n*NSET, NSET=right\n4, 5, 6\n*NSET, NSET=bare\n*NSET, "
         "NSET=one\n1\n";
  const std::string text = R"(name = "prism"
gravity = [0, 0, -9.81]
[materials]
steel = { E = 210e9, nu = 0.3, rho = 7850 }
[bodies.rod.solid]
mesh = { file = "PART.INP" }
material = "steel"
modes = 0
interfaces = { left = { set = "left" }, right = { set = "right", tie = "averaged" } }
[joints]
motor = { fixed = ["ground", "rod.left"] }
[simulation]
duration = 0.1
step = 1e-3
)";
  const std::string file = (folder / "scene.toml").string();
  const Scene scene = read_scene(text, file);
  EXPECT_EQ(rod_of(scene).mesh().kind().abaqus, "C3D4");
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("4-node tetrahedron) bend too stiffly"), std::string::npos);
  EXPECT_NEAR(rod_of(scene).model->total_mass(Eigen::VectorXd::Ones(3)), 7850, 1e-9);
  const auto refused = [&](const std::string& from, const std::string& to, const char* words) {
    try {
      read_scene(changed(text, from, to), file);
      ADD_FAILURE() << words;
    } catch (const InputError& error) {
      EXPECT_NE(error.problems[0].text().find(words), std::string::npos)
          << error.problems[0].text();
      EXPECT_EQ(error.problems.size(), 1u) << error.problems.back().text();
    }
  };
  refused("modes = 0", "modes = 0\noutline = { ball = { type = \"sphere\", radius = 0.3 } }",
          "has an outline in a mesh of a kind of cell that it does not cut: 4-node tetrahedron");
  refused(
      "set = \"left\"", "set = \"lift\"",
      "has no set of nodes 'lift'; expected an *NSET of 'PART.INP'; hint: did you mean 'left'?");
  refused("set = \"left\"", "set = \"bare\"",
          "has the set 'bare', which has no node of a cell; expected an *NSET of 'PART.INP' with "
          "nodes of cells; hint: known: left, one, right");
  refused("set = \"left\"", "set = \"one\"", "cannot be held by set 'one': interface 'left'");
  refused("material = \"steel\"\n", "", "has a mesh without 'material'");
  refused("set = \"right\"", "nodes = [4, 5, 7]", "has no node 7");
  refused("set = \"right\"", "nodes = [4, 5, 5.5]", "has no node 5.5");
  const Scene listed = read_scene(changed(text, "set = \"right\"", "nodes = [6, 4, 5]"), file);
  EXPECT_EQ(rod_of(listed).interfaces()[1].nodes, rod_of(scene).interfaces()[1].nodes);
  std::filesystem::remove_all(folder);
}

/// `to` replaces `from`; '@' in it marks where the problem is expected and is taken out.
struct BadPart {
  const char *name, *from, *to;
  std::vector<const char*> words;
};
void PrintTo(const BadPart& part, std::ostream* out) { *out << part.name; }
class BadSolid : public testing::TestWithParam<BadPart> {};

TEST_P(BadSolid, IsRefusedAtItsPlace) {
  const BadPart& c = GetParam();
  const test::MarkedText marked(changed(kPlateScene, c.from, c.to));
  const auto read = [](const auto& text, const auto& file) { read_scene(text, file); };
  test::expect_refused(marked, "scene.toml", read, c.words);
}

// clang-format off
const BadPart kParts[] = {
    {"TooManyModes", "cells = [48, 6] }\nmaterial = \"steel\"\nthickness = 0.02\nat = [0.06, 0, 0]\nmodes = 4", "cells = [12, 3] }\nmaterial = \"steel\"\nthickness = 0.02\nat = [0.06, 0, 0]\nmodes = @150", {"150 modes", "free displacements", "at most"}},
    {"NoMaterial", "material = \"steel\"", "material = @\"steal\"", {"no material 'steal'", "'steel'"}},
    {"NoThickness", "[bodies.rod.solid]\nmesh = { from = [-0.02, -0.015], to = [0.22, 0.015], cells = [48, 6] }\nmaterial = \"steel\"\nthickness = 0.02", "@[bodies.rod.solid]\nmesh = { from = [-0.02, -0.015], to = [0.22, 0.015], cells = [48, 6] }\nmaterial = \"steel\"", {"without 'thickness'"}},
    {"HalfGrid", "{ from = [-0.02, -0.015], to = [0.22, 0.015], cells = [48, 6] }", "@{ from = [-0.02, -0.015], cells = [48, 6] }", {"without 'to'", "as in"}},
    {"MixedGrid", "cells = [48, 6]", "cells = @[48, 6, 2]", {"3 numbers in 'cells'", "planar"}},
    {"EmptyGrid", "to = [0.22, 0.015]", "to = @[0.22, -0.015]", {"empty grid"}},
    {"BrokenCells", "cells = [48, 6]", "cells = @[48, 6.5]", {"not whole"}},
    {"HugeGrid", "cells = [48, 6]", "cells = @[48000, 600]", {"2.88e+07 cells", "at most 1e+06"}},
    {"NoFile", "{ from = [-0.02, -0.015], to = [0.22, 0.015], cells = [48, 6] }", "{ file = @\"none.msh\" }", {"none.msh", "no such file", "relative to the scene"}},
    {"FewNodes", "{ centre = [0, 0], radius = 0.009 }", "@{ centre = [0, 0], radius = 0.001 }", {"'big_end'", "1 nodes", "0.005 m wide"}},
    {"SharedNodes", "{ from = [0.19, -0.01], to = [0.21, 0.01] }", "@{ from = [0, -0.01], to = [0.21, 0.01] }", {"'small_end'", "belongs to interface 'big_end', too"}},
    {"NoSet", "{ circle = { centre = [0, 0], radius = 0.009 } }", "{ set = @\"xmin\" }", {"no set of nodes 'xmin'", "x_min"}},
    {"PointInSpace", "centre = [0, 0]", "centre = @[0, 0, 0]", {"3 numbers in 'centre'", "planar"}},
    {"NoRing", "radius = 0.009 }", "radius = 0.009, inner = @0.01 }", {"empty ring"}},
    {"AxisInThePlane", "radius = 0.009 }", "radius = 0.009, axis = @[0, 0, 1] }", {"'axis'", "planar"}},
    {"TwoRegions", "{ circle = { centre = [0, 0], radius = 0.009 } }", "{ circle = { centre = [0, 0], radius = 0.009 }, set = @\"x_min\" }", {"both 'circle' and 'set'"}},
    {"NoFeature", "holes = { type = \"union\", of = [\"hole1\", \"hole2\"]", "@holes = { type = \"union\", of = [\"hole1\", \"hole3\"]", {"'hole3'", "no feature"}},
    {"KeyOfOtherFeature", "xi = 3, eta = 4", "xi = 3, eta = 4, @radius = 1", {"unknown key", "hole1.radius"}},
    {"RotatedOutOfPlane", "xi = 3, eta = 4", "xi = 3, eta = 4, rx = @1", {"'rx'", "x, y and angle"}},
    {"FarAway", "hole1 = { type = \"super_ellipse\", x = 0.06", "@hole1 = { type = \"super_ellipse\", x = 60", {"wholly outside"}},
    {"CrossesItself", "hole2 = { type = \"spline\", x = 0.14, points = [[0.01, 0], [0, 0.006], [-0.01, 0], [0, -0.006]] }", "@hole2 = { type = \"polyline\", x = 0.14, points = [[0.01, 0.006], [-0.01, -0.006], [-0.01, 0.006], [0.01, -0.006]] }", {"crosses itself"}},
    {"FewPoints", "hole2 = { type = \"spline\", x = 0.14, points = [[0.01, 0], [0, 0.006], [-0.01, 0], [0, -0.006]] }", "@hole2 = { type = \"spline\", x = 0.14, points = [[0.01, 0], [0, 0.006]] }", {"makes no shape"}},
    {"InsideOut", "plate = { type = \"rectangle\", x = 0.1, width = 0.24, height = 0.03, fillet = 0.01 }", "@plate = { type = \"rectangle\", x = 0.1, width = 0.24, height = 0.03, fillet = 0.02 }", {"fillet"}},
    {"OfNothing", "radius = 0.001 }", "radius = 0.001 }\n@spare = { type = \"circle\", x = 0.1, radius = 0.01 }", {"'spare'", "parts of nothing"}},
    {"MirrorOfTwo", "holes = { type = \"union\", of = [\"hole1\", \"hole2\"] }", "@holes = { type = \"mirror\", of = [\"hole1\", \"hole2\"] }", {"mirrors more than one", "unite them first"}},
    {"MirrorInSpace", "holes = { type = \"union\", of = [\"hole1\", \"hole2\"] }", "holes = { type = \"mirror\", of = [\"hole1\"], rz = @1 }", {"'rz'", "x, y and angle"}},
    {"InACircle", "holes = { type = \"union\", of = [\"hole1\", \"hole2\"] }", "@holes = { type = \"union\", of = [\"hole1\", \"hole2\", \"holes\"] }", {"itself"}},
};
// clang-format on

/// The one problem of a changed scene.
InputProblem problem_of(const std::string& text, const std::vector<std::string>& set = {}) {
  try {
    read_scene(text, "scene.toml", set);
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems.size(), 1u) << error.what();
    return error.problems.front();
  }
  ADD_FAILURE() << "not refused";
  return {};
}

/// Line of the first occurrence of a text.
int line_of(const std::string& text, const std::string& what) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + long(text.find(what)), '\n'));
}

TEST(SolidScene, NamesTheInterfaceThatAHoleCutsOff) {
  const auto problem = problem_of(changed(kPlateScene, "b = 0.008", "b = 0.05"));
  EXPECT_NE(problem.what.find("'small_end' is cut off"), std::string::npos) << problem.text();
  EXPECT_EQ(problem.line, line_of(kPlateScene, "small_end"));
  const auto bare = problem_of(
      changed(kPlateScene, "x = 0.06, a = 0.015, b = 0.008", "x = 0, a = 0.03, b = 0.0145"));
  EXPECT_NE(bare.what.find("no material is left at interface 'big_end'"), std::string::npos)
      << bare.text();
}

TEST(SolidScene, OutlineNestedTooDeeplyIsRefused) {
  const auto nested = [](int operations) {
    std::string last = "shape", text = "radius = 0.001 }";
    for (int i = 0; i < operations; ++i) {
      const std::string name = "u" + std::to_string(i);
      text += "\n" + name + " = { type = \"union\", of = [\"" + last + "\"] }";
      last = name;
    }
    return changed(kPlateScene, "radius = 0.001 }", text);
  };
  EXPECT_NO_THROW(read_scene(nested(190), "scene.toml"));
  for (const int operations : {200, 3000}) {
    const std::string text = nested(operations);
    const auto problem = problem_of(text);
    EXPECT_NE(problem.what.find("under more than 200 nested operations"), std::string::npos)
        << problem.text();
    EXPECT_GE(problem.line, line_of(text, "plate = {"));
  }
}

TEST(SolidScene, SaysInStaticsThatAPartDoesNotBuckleByItself) {
  EXPECT_TRUE(read_scene(kPlateScene, "scene.toml", {"simulation.type=static"}).warnings.empty());
  EXPECT_TRUE(read_scene(kPlateScene, "scene.toml", {"simulation.type=modes"}).warnings.empty());
  for (const char* key : {"simulation.critical=true", "simulation.arc_length=true"}) {
    const Scene scene = read_scene(kPlateScene, "scene.toml", {"simulation.type=static", key});
    ASSERT_EQ(scene.warnings.size(), 1u) << key;
    EXPECT_NE(scene.warnings[0].find("part 'rod'"), std::string::npos) << scene.warnings[0];
  }
}

TEST(SolidScene, PlanarMeshesNeedAPlanarScene) {
  const auto tilted =
      problem_of(changed(kPlateScene, "drive = { rate", "axis = [1, 0, 0], drive = { rate"));
  EXPECT_EQ(tilted.line, line_of(kPlateScene, "mesh = "));
  EXPECT_NE(tilted.what.find("the scene is not planar"), std::string::npos) << tilted.text();
  EXPECT_NE(problem_of(kPlateScene, {"simulation.space=spatial"}).what.find("\"spatial\""),
            std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Scene, BadSolid, testing::ValuesIn(kParts),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace liesl::test::solid_scene_test
