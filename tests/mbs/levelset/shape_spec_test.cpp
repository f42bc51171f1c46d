/// @file
/// Shapes as data: the tree is built as it is written, and what makes no tree is named.
#include "mbs/levelset/shape_spec.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "mbs/levelset/csg.hpp"
#include "mbs/levelset/features.hpp"

namespace liesl::test::shape_spec_test {
namespace {

using namespace levelset;

ShapeSpec plate_with_holes() {
  return {2,
          {{"plate", FeatureKind::Rectangle, {0, 0, 0, 2, 1, 0.1}, {}},
           {"left", FeatureKind::Circle, {-0.5, 0, 0, 0.2}, {}},
           {"right", FeatureKind::SuperEllipse, {0.5, 0, 0.3, 0.3, 0.2, 3, 4}, {}},
           {"holes", FeatureKind::Union, {0.05}, {"left", "right"}},
           {"shape", FeatureKind::Difference, {}, {"plate", "holes"}}}};
}

TEST(ShapeSpec, IsTheTreeOfItsFeatures) {
  std::vector<Operand> holes, all;
  holes.push_back({"left", placed_in_plane(-0.5, 0, 0, levelset::circle(0.2))});
  holes.push_back({"right", placed_in_plane(0.5, 0, 0.3, super_ellipse(0.3, 0.2, 3, 4))});
  all.push_back({"plate", placed_in_plane(0, 0, 0, rectangle(2, 1, 0.1))});
  all.push_back({"holes", unite(std::move(holes), 0.05)});
  const auto expected = subtract(std::move(all)), built = make_shape(plate_with_holes());
  ASSERT_EQ(built->size(), expected->size());
  EXPECT_EQ(built->start(), expected->start());
  for (double x = -1.1; x <= 1.1; x += 0.1)
    for (double y = -0.6; y <= 0.6; y += 0.1)
      EXPECT_EQ(built->value({x, y, 0}), expected->value({x, y, 0})) << x << ' ' << y;
}

TEST(ShapeSpec, ParametersKeepTheirNamesAtAnyDepth) {
  const auto shape = make_shape(plate_with_holes());
  EXPECT_EQ(shape->parameters()[0].name, "plate.x");
  EXPECT_EQ(shape->parameters()[9].name, "left.radius");
  EXPECT_EQ(shape->parameters()[13].name, "right.a");
  EXPECT_EQ(shape->parameters().back().name, "holes.radius");
}

TEST(ShapeSpec, TakesValuesInTheOrderOfTheParameters) {
  ShapeSpec spec = plate_with_holes();
  Eigen::VectorXd p = make_shape(spec)->start();
  p += Eigen::VectorXd::LinSpaced(p.size(), 0.001, 0.002);
  set_values(spec, p);
  EXPECT_EQ(make_shape(spec)->start(), p);
  EXPECT_THROW(set_values(spec, p.head(5)), std::invalid_argument);
}

TEST(ShapeSpec, NamesEveryError) {
  const auto errors_with = [](auto change) {
    ShapeSpec spec = plate_with_holes();
    change(spec.features);
    EXPECT_THROW(make_shape(spec), std::invalid_argument);
    std::string text;
    for (const auto& error : shape_errors(spec)) text += error.feature + " " + error.text + "; ";
    return text;
  };
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  EXPECT_TRUE(shape_errors(plate_with_holes()).empty());
  EXPECT_TRUE(has(errors_with([](auto& f) { f[3].operands[0] = "lift"; }), "'lift'"));
  EXPECT_TRUE(has(errors_with([](auto& f) { f[4].operands.push_back("left"); }),
                  "left is used by more than one operation"));
  EXPECT_TRUE(has(errors_with([](auto& f) { f[4].operands.pop_back(); }), "parts of nothing"));
  EXPECT_TRUE(
      has(errors_with([](auto& f) { f[3].operands.push_back("shape"); }), "is a part of itself"));
  EXPECT_TRUE(has(errors_with([](auto& f) { f[3].operands.clear(); }), "no features"));
  EXPECT_TRUE(has(errors_with([](auto& f) { f[3].values[0] = -1; }), "negative radius"));
  EXPECT_TRUE(has(errors_with([](auto& f) { f[1].values[3] = 0; }), "radius is 0"));
  EXPECT_TRUE(has(errors_with([](auto& f) { f[1].values.pop_back(); }), "values"));
  EXPECT_TRUE(has(errors_with([](auto& f) { f[1].kind = FeatureKind::Sphere; }), "in the plane"));
  EXPECT_TRUE(has(errors_with([](auto& f) { f[2].name = "left"; }), "twice"));
}

/// A mirror has one operand and a placement; its numbers come after those of the operand.
TEST(ShapeSpec, MirrorsOneFeatureAtAPlacement) {
  ShapeSpec spec = plate_with_holes();
  spec.features[3] = {"pair", FeatureKind::Mirror, {0.1, 0, 1.5}, {"left"}};
  spec.features[4].operands = {"plate", "pair", "right"};
  ASSERT_TRUE(shape_errors(spec).empty());
  const auto shape = make_shape(spec);
  EXPECT_EQ(shape->parameters()[9].name, "left.radius");
  EXPECT_EQ(shape->parameters()[12].name, "pair.angle");
  EXPECT_EQ(shape->start()[12], 1.5);
  Eigen::VectorXd p = shape->start();
  p[10] = 0.2;
  set_values(spec, p);
  EXPECT_EQ(spec.features[3].values, (std::vector<double>{0.2, 0, 1.5}));
  ASSERT_TRUE(shape->part("left"));
  EXPECT_EQ(shape->part("left")->first, 6);
  EXPECT_EQ(shape->part("left")->sign, -1);
  EXPECT_EQ(feature_parameters(FeatureKind::Mirror, 2).size(), 3u);
  EXPECT_EQ(feature_parameters(FeatureKind::Mirror, 3).size(), 6u);
  spec.features[3].operands = {"left", "right"};
  spec.features[4].operands = {"plate", "pair"};
  ASSERT_EQ(shape_errors(spec).size(), 1u);
  EXPECT_EQ(shape_errors(spec)[0].text, "mirrors more than one feature: unite them first");
  spec.features[3].operands = {"left"};
  spec.features[4].operands.push_back("right");
  spec.features[3].values.pop_back();
  EXPECT_THROW(make_shape(spec), std::invalid_argument);
}

TEST(ShapeSpec, EveryKindMakesAShapeOfItsParameters) {
  for (int dim : {2, 3})
    for (int k = 0; k < static_cast<int>(FeatureKind::Union); ++k) {
      const auto kind = static_cast<FeatureKind>(k);
      if (is_curve(kind) || (dim == 2 && is_spatial(kind))) continue;
      const auto names = feature_parameters(kind, dim);
      FeatureSpec f{"f", kind, {}, {}};
      for (std::size_t i = 0; i < names.size(); ++i) f.values.push_back(2 + 0.1 * double(i));
      const auto shape = make_feature(f, dim);
      ASSERT_EQ(shape->size(), static_cast<int>(names.size()));
      for (int i = 0; i < shape->size(); ++i) EXPECT_EQ(shape->start()[i], f.values[i]) << k;
    }
}

}  // namespace
}  // namespace liesl::test::shape_spec_test
