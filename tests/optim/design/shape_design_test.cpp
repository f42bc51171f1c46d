#include <gtest/gtest.h>

#include <stdexcept>

#include "mbs/levelset/shape_spec.hpp"
#include "mbs/solids/plate.hpp"
#include "optim/design/shape.hpp"

namespace liesl::test::shape_design_test {
namespace {

using Eigen::VectorXd;

/// What is said of a design; empty if it is taken.
std::string refusal(const ShapeDesignSpec& spec) {
  Plate plate({2, false, Tie::Rigid});
  try {
    ShapeDesign design(spec, *plate.shape, plate.model);
    return {};
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
}

ShapeVariableSpec radius(double lower, double upper) {
  return {"r", {{"two.radius", 1}}, lower, upper, {}};
}

TEST(ShapeDesign, RefusesByNameEverythingAtOnce) {
  const std::string text = refusal({{radius(-0.001, 0.02),
                                     {"b", {{"one.bb", 1}}, 0.001, 0.02, {}},
                                     {"again", {{"two.radius", 1}}, 0.03, 0.02, {}}},
                                    {{"w", "three", "two", 0.001}, {"v", "one", "middle", -1}}});
  for (const char* words :
       {"no parameter 'one.bb'", "'again': bounds [0.03, 0.02]", "already follows 'r'",
        "no feature 'three'", "'middle' is neither a feature nor an interface", "least -1"})
    EXPECT_NE(text.find(words), std::string::npos) << words << " in\n" << text;
}

TEST(ShapeDesign, RefusesBoundsThatTurnAFeatureInsideOut) {
  const std::string text = refusal({{radius(-0.001, 0.02)}, {}});
  EXPECT_NE(text.find("'two.radius' becomes -0.001, which turns the feature inside out"),
            std::string::npos)
      << text;
  EXPECT_EQ(refusal({{radius(0.001, 0.02)}, {}}), "");
  // through a link, and through an error of the shape
  EXPECT_NE(refusal({{{"h", {{"one.a", 1}, {"one.b", 2}}, 0.01, 0.04, {}}}, {}})
                .find("'one.b' becomes -0.027"),
            std::string::npos);
  EXPECT_NE(refusal({{{"f", {{"plate.fillet", 1}}, 0.001, 0.04, {}}}, {}})
                .find("fillet is larger than half the shorter side"),
            std::string::npos);
}

TEST(ShapeDesign, LinksParametersWithTheirFactors) {
  Plate plate({2, false, Tie::Rigid});
  const ShapeDesign design(
      {{{"apart", {{"two.x", 1}, {"one.x", -1}}, 0.13, 0.16, {}}, radius(0.005, 0.02)}, {}},
      *plate.shape, plate.model);
  VectorXd x = design.start();
  EXPECT_DOUBLE_EQ(x[0], 0.141);
  EXPECT_EQ(design.units()[0], "m");
  x[0] += 0.01;
  x[1] = 0.017;
  const VectorXd change = design.parameters(x) - plate.shape->start();
  for (int k = 0; k < change.size(); ++k) {
    const std::string& name = plate.shape->parameters()[k].name;
    const double expected = name == "two.x"        ? 0.01
                            : name == "one.x"      ? -0.01
                            : name == "two.radius" ? 0.017 - 0.0131
                                                   : 0;
    EXPECT_NEAR(change[k], expected, 1e-15) << name;
  }
}

/// A plate with two holes at both sides of y = 0, linked with factors 1 and -1 or mirrored: at
/// every design it is symmetric, and both are the same part with the same derivatives.
TEST(ShapeDesign, ASymmetricPartStaysSymmetric) {
  using namespace levelset;
  const ShapeSpec linked{
      2,
      {{"upper", FeatureKind::SuperEllipse, {0.1, 0.04, 0.3, 0.03, 0.01, 3, 4}, {}},
       {"lower", FeatureKind::SuperEllipse, {0.1, -0.04, -0.3, 0.03, 0.01, 3, 4}, {}},
       {"plate", FeatureKind::Rectangle, {0.1, 0, 0, 0.19, 0.13, 0.02}, {}},
       {"part", FeatureKind::Difference, {}, {"plate", "upper", "lower"}}}};
  const ShapeSpec mirror{
      2,
      {{"upper", FeatureKind::SuperEllipse, {0.1, 0.04, 0.3, 0.03, 0.01, 3, 4}, {}},
       {"both", FeatureKind::Mirror, {0, 0, 0}, {"upper"}},
       {"plate", FeatureKind::Rectangle, {0.1, 0, 0, 0.19, 0.13, 0.02}, {}},
       {"part", FeatureKind::Difference, {}, {"plate", "both"}}}};
  const auto links = [](const char* what, double factor) {
    return std::vector<DrivenParameter>{{std::string("upper.") + what, 1},
                                        {std::string("lower.") + what, factor}};
  };
  const ShapeDesignSpec by_links{{{"x", links("x", 1), 0.05, 0.15, {}},
                                  {"y", links("y", -1), 0.02, 0.06, {}},
                                  {"turn", links("angle", -1), -1, 1, {}},
                                  {"b", links("b", 1), 0.005, 0.02, {}}},
                                 {}},
      by_mirror{{{"x", {{"upper.x", 1}}, 0.05, 0.15, {}},
                 {"y", {{"upper.y", 1}}, 0.02, 0.06, {}},
                 {"turn", {{"upper.angle", 1}}, -1, 1, {}},
                 {"b", {{"upper.b", 1}}, 0.005, 0.02, {}}},
                {}};
  const int nx = 20, ny = 14;
  const SolidModel model(quad_grid({0, -0.07}, {0.2, 0.07}, nx, ny), {"steel", 210e9, 0.3, 7850},
                         {}, {});
  const auto shape_a = make_shape(linked), shape_b = make_shape(mirror);
  const ShapeDesign a(by_links, *shape_a, model), b(by_mirror, *shape_b, model);
  for (const double step : {0.0, 0.3, 0.8}) {
    const VectorXd x = a.start() + step * VectorXd(Eigen::Vector4d(0.04, -0.015, -0.9, 0.008));
    shape_a->set(a.parameters(x));
    shape_b->set(b.parameters(x));
    const Fractions f = volume_fractions(model.mesh(), *shape_a),
                    g = volume_fractions(model.mesh(), *shape_b);
    const Eigen::MatrixXd df = f.derivative * a.jacobian(), dg = g.derivative * b.jacobian();
    for (int i = 0; i < model.mesh().node_count(); ++i) {
      const Eigen::Vector3d up = model.mesh().nodes.col(i), down(up[0], -up[1], 0);
      EXPECT_NEAR(shape_a->value(up), shape_a->value(down), 1e-15);
      EXPECT_NEAR(shape_b->value(up), shape_b->value(down), 1e-15);
    }
    // The cells are cut into triangles that are not symmetric.
    const VectorXd& v = g.value;
    EXPECT_NEAR(v.head(nx * ny / 2).sum() / v.tail(nx * ny / 2).sum(), 1, 1e-3);
    EXPECT_LT((f.value - g.value).cwiseAbs().maxCoeff(), 1e-12) << step;
    EXPECT_LT((df - dg).cwiseAbs().maxCoeff(), 1e-9 * df.cwiseAbs().maxCoeff()) << step;
    EXPECT_GT(df.cwiseAbs().colwise().sum().minCoeff(), 0);
  }
}

/// A circle's radius and place move its outline as fast as themselves, its angle not at all.
TEST(ShapeDesign, ReachIsInCells) {
  Plate plate({2, false, Tie::Rigid});
  const ShapeDesign design({{radius(0.005, 0.02),
                             {"x", {{"two.x", 2}}, 0.1, 0.15, {}},
                             {"turn", {{"two.angle", 1}}, -1, 1, {}}},
                            {}},
                           *plate.shape, plate.model);
  const VectorXd bounds = design.step_bounds(plate.fractions().derivative, 3);
  const double h = std::sqrt(0.2 / 27 * 0.06 / 9);
  EXPECT_NEAR(bounds[0], 3 * h, 1e-9);
  EXPECT_NEAR(bounds[1], 3 * h / 2, 0.02 * h);
  EXPECT_GT(bounds[2], 1e6);
}

TEST(ShapeDesign, WallsToAnInterfaceHaveARowANode) {
  Plate plate({2, false, Tie::Rigid});
  const ShapeDesign design({{radius(0.005, 0.02)}, {{"end", "two", "right", 0.01}}}, *plate.shape,
                           plate.model);
  ASSERT_EQ(design.wall_names().size(), plate.model.interfaces()[1].nodes.size());
  RowMatrix dg(static_cast<int>(design.wall_names().size()), 1);
  const VectorXd g = design.walls(&dg);
  for (int i = 0; i < g.size(); ++i) {
    const Eigen::Vector3d node = plate.model.mesh().nodes.col(plate.model.interfaces()[1].nodes[i]);
    const double distance = (node - Eigen::Vector3d(0.141, 0.019, 0)).norm() - 0.0131;
    EXPECT_NEAR(g[i], 1 - distance / 0.01, 1e-12);
    EXPECT_NEAR(dg(i, 0), 1 / 0.01, 1e-9);
  }
}

}  // namespace
}  // namespace liesl::test::shape_design_test
