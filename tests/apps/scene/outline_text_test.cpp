/// @file
/// Outlines written as text are read back to the same numbers, whatever their features.
#include "apps/scene/outline_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "apps/scene/load_scene.hpp"

namespace liesl::test::outline_text_test {
namespace {

using levelset::FeatureKind;
using levelset::FeatureSpec;
using levelset::ShapeSpec;

/// The outline of the only part of a scene that has this one.
ShapeSpec read_back(const ShapeSpec& outline) {
  const std::string mesh = outline.dim == 2
                               ? "from = [0, 0], to = [8, 4], cells = [64, 32]"
                               : "from = [0, 0, 0], to = [8, 4, 2], cells = [32, 16, 8]";
  const std::string corner = outline.dim == 2 ? "[0.5, 0.5]" : "[0.5, 0.5, 2]";
  const std::string scene =
      "[materials]\nsteel = { E = 210e9, nu = 0.3, rho = 7850 }\n"
      "[bodies.\"gestänge\".solid]\nmaterial = \"steel\"\nmesh = { " +
      mesh + " }\n" + (outline.dim == 2 ? "thickness = 0.1\n" : "") +
      "[bodies.\"gestänge\".solid.interfaces]\npin = { box = { from = " +
      (outline.dim == 2 ? "[0, 0]" : "[0, 0, 0]") + ", to = " + corner + " } }\n" +
      outline_text("gestänge", outline) +
      "[joints]\nmotor = { revolute = [\"ground\", \"gestänge.pin\"], drive = { rate = 1 } }\n"
      "[simulation]\nduration = 1\nstep = 0.1\n";
  try {
    const Scene read = read_scene(scene, "scene.toml");
    return std::get<SolidSpec>(read.mechanism.bodies[0].kind).outline;
  } catch (const InputError& error) {
    ADD_FAILURE() << error.what() << '\n' << scene;
    return {};
  }
}

void expect_same(ShapeSpec outline) {
  const ShapeSpec read = read_back(outline);
  ASSERT_EQ(read.features.size(), outline.features.size());
  for (const FeatureSpec& f : outline.features) {
    const auto at = std::find_if(read.features.begin(), read.features.end(),
                                 [&](const FeatureSpec& g) { return g.name == f.name; });
    ASSERT_NE(at, read.features.end()) << f.name;
    EXPECT_EQ(at->kind, f.kind) << f.name;
    EXPECT_EQ(at->values, f.values) << f.name;
    EXPECT_EQ(at->operands, f.operands) << f.name;
  }
}

TEST(OutlineText, OfAPlanarPartIsReadBack) {
  const double third = 1.0 / 3;
  expect_same(
      {2,
       {{"plate", FeatureKind::Rectangle, {4, 2, 0, 9, 5, 0.1}, {}},
        {"gekürzt", FeatureKind::HalfSpace, {7.5, 0, 3.0 + third}, {}},
        {"round", FeatureKind::Circle, {1 + third, 3, 0, 0.3}, {}},
        {"flat", FeatureKind::Ellipse, {2.5, 3, 0.1, 0.4, 0.2}, {}},
        {"square", FeatureKind::SuperEllipse, {3.5, 3, 0, 0.3, 0.2, 3, 4.5}, {}},
        {"star", FeatureKind::Superformula, {4.5, 3, 0.2, 0.3, 1, 1.1, 6, 3, 2.5, 3.5}, {}},
        {"corners", FeatureKind::Polyline, {1.5, 1.5, 0, 0.3, 0, 0, 0.3 * third, -0.3, 0}, {}},
        {"smooth", FeatureKind::Spline, {2.5, 1.5, 0, 0.3, 0, 0, 0.3, -0.3, 0, 0, -0.3}, {}},
        {"free",
         FeatureKind::Nurbs,
         {3.5, 1.5, 0, 0.3, 0, 0, 0.3, -0.3, 0, 0, -0.3, 1, 2, 0.7, 1e-3 + third},
         {}},
        {"both", FeatureKind::Union, {0.05}, {"round", "flat"}},
        {"within", FeatureKind::Intersection, {}, {"square"}},
        {"pair", FeatureKind::Mirror, {5, 0.1, 1.5 + third}, {"corners"}},
        {"all",
         FeatureKind::Difference,
         {0},
         {"plate", "gekürzt", "both", "within", "star", "pair", "smooth", "free"}}}});
}

TEST(OutlineText, OfASpatialPartIsReadBack) {
  expect_same({3,
               {{"block", FeatureKind::Box, {4, 2, 1, 0, 0, 0, 9, 5, 3, 0.25}, {}},
                {"layer", FeatureKind::Slab, {0, 0, 1, 0.01, 0, 0, 1.9}, {}},
                {"ball", FeatureKind::Sphere, {2, 3, 1, 0, 0, 0, 0.5}, {}},
                {"egg", FeatureKind::Ellipsoid, {4, 2, 1, 0.1, 0.2, 0.3, 0.7, 0.6, 0.5}, {}},
                {"bore", FeatureKind::Circle, {6, 2, 1, 0, 0.3, 0, 0.5}, {}},
                {"body", FeatureKind::Intersection, {}, {"block", "layer"}},
                {"pair", FeatureKind::Mirror, {4, 0.1, 0, 0, 0.2, 0.3}, {"ball"}},
                {"all", FeatureKind::Difference, {}, {"body", "pair", "egg", "bore"}}}});
}

}  // namespace
}  // namespace liesl::test::outline_text_test
