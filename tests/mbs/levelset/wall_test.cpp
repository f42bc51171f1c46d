#include "mbs/levelset/wall.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "liegroup/numdiff.hpp"
#include "mbs/levelset/csg.hpp"
#include "mbs/levelset/features.hpp"
#include "mbs/solids/mesh.hpp"

namespace liesl::test::wall_test {
namespace {

using namespace levelset;
using Eigen::VectorXd;

/// A plate with two holes.
LevelSetPtr plate(LevelSetPtr one, LevelSetPtr two) {
  std::vector<Operand> operands;
  operands.push_back({"plate", rectangle(0.2, 0.1)});
  operands.push_back({"one", std::move(one)});
  operands.push_back({"two", std::move(two)});
  return subtract(std::move(operands));
}
LevelSetPtr hole(double x, double y, double radius) {
  return placed_in_plane(x, y, 0.3, levelset::circle(radius));
}
Eigen::Matrix3Xd samples() { return quad_grid({-0.1, -0.05}, {0.1, 0.05}, 40, 20).nodes; }

Wall wall(const LevelSet& shape, const std::string& a, const std::string& b) {
  return wall_between(*shape.part(a), *shape.part(b), samples(), shape.size());
}

TEST(Wall, BetweenCirclesIsTheirDistanceAlsoWhenTheyOverlap) {
  for (const double gap : {0.03, 0.004, 0.0, -0.005}) {
    const double d = 0.02 + 0.015 + gap;
    const LevelSetPtr shape =
        plate(hole(-0.03, 0.001, 0.02),
              hole(-0.03 + d * std::cos(0.2), 0.001 + d * std::sin(0.2), 0.015));
    const Wall w = wall(*shape, "one", "two");
    EXPECT_NEAR(w.thickness, gap, 1e-12);
    EXPECT_NEAR(wall(*shape, "two", "one").thickness, gap, 1e-12);
    EXPECT_NEAR(w.middle[0], -0.03 + (0.02 + gap / 2) * std::cos(0.2), 1e-7);
  }
}

TEST(Wall, ToTheOutlineIsTheDistanceToTheNearestSide) {
  const LevelSetPtr shape = plate(hole(-0.03, 0.02, 0.02), hole(0.06, 0, 0.02));
  EXPECT_NEAR(wall(*shape, "one", "plate").thickness, 0.05 - 0.02 - 0.02, 1e-12);
  EXPECT_NEAR(wall(*shape, "two", "plate").thickness, 0.1 - 0.06 - 0.02, 1e-12);
}

/// A long slot along a side: the best sample is far from where it is nearest.
TEST(Wall, BetweenAFlatSideAndAnEdge) {
  for (const double b : {0.0076, 0.0099911759}) {
    const LevelSetPtr shape =
        plate(placed_in_plane(0.013, 0.041 - b, 0, super_ellipse(0.0349576473, b, 4, 4)),
              hole(-0.06, 0, 0.01));
    const Wall w = wall(*shape, "one", "plate");
    EXPECT_NEAR(w.thickness, 0.009, 1e-9) << b;
    for (int k = 0; k < shape->size(); ++k) {
      if (shape->parameters()[k].name == "one.b") {
        EXPECT_NEAR(w.derivative[k], -1, 1e-8);
      }
    }
  }
}

/// Ends of super-ellipses are flat to the third order: no curvature where they are nearest.
TEST(Wall, BetweenFlatEnds) {
  const LevelSetPtr shape = plate(placed_in_plane(-0.043, 0, 0, super_ellipse(0.025, 0.006, 4, 4)),
                                  placed_in_plane(0.031, 0, 0, super_ellipse(0.03, 0.007, 4, 4)));
  EXPECT_NEAR(wall(*shape, "one", "two").thickness, 0.019, 1e-10);
  EXPECT_NEAR(wall(*shape, "one", "plate").thickness, 0.032, 1e-10);
  EXPECT_NEAR(wall(*shape, "two", "plate").thickness, 0.039, 1e-10);
  const VectorXd gap = wall(*shape, "one", "two").derivative;
  for (int k = 0; k < shape->size(); ++k) {
    const std::string& name = shape->parameters()[k].name;
    const double of_gap = name == "one.a" || name == "two.a" || name == "one.x" ? -1
                          : name == "two.x"                                     ? 1
                                                                                : 0;
    const bool turns = shape->parameters()[k].unit == "rad";  // the place is found to micrometres
    EXPECT_NEAR(gap[k], of_gap, turns ? 1e-5 : 1e-8) << name;
  }
}

TEST(Wall, DerivativePassesTheStepSweep) {
  const LevelSetPtr shape =
      plate(placed_in_plane(-0.03, 0.002, 0.3, super_ellipse(0.02, 0.015, 2.5, 3)),
            placed_in_plane(0.015, -0.004, 0.2, ellipse(0.012, 0.02)));
  for (const char* to : {"two", "plate"}) {
    const VectorXd p0 = shape->start();
    const VectorXd scale = (0.02 * p0.cwiseAbs()).cwiseMax(1e-4);
    const auto thickness = [&](const VectorXd& s) {
      shape->set(p0 + s.cwiseProduct(scale));
      return wall(*shape, "one", to).thickness / 0.01;
    };
    shape->set(p0);
    const VectorXd d = wall(*shape, "one", to).derivative;
    const Eigen::MatrixXd J = (d.cwiseProduct(scale) / 0.01).transpose();
    const StepSweep sweep = step_sweep(thickness, VectorXd(VectorXd::Zero(p0.size())), J);
    EXPECT_LE(sweep.best_error, 1e-9) << to;
    EXPECT_GE(sweep.slope_points, 3) << to;
    EXPECT_NEAR(sweep.slope, 2, 0.1) << to;
  }
}

/// Points of |x/a|^xi + |y/b|^xi = 1 about (cx, cy).
Eigen::Matrix2Xd super_ellipse_points(double cx, double cy, double a, double b, double xi) {
  constexpr int n = 4000;
  Eigen::Matrix2Xd points(2, n);
  for (int i = 0; i < n; ++i) {
    const double t = 2 * std::numbers::pi * i / n, c = std::cos(t), s = std::sin(t);
    points.col(i) << cx + a * std::copysign(std::pow(std::abs(c), 2 / xi), c),
        cy + b * std::copysign(std::pow(std::abs(s), 2 / xi), s);
  }
  return points;
}

/// phi of a super-ellipse is no distance; the wall is, against the smallest distance of points of
/// both outlines.
TEST(Wall, BetweenSuperEllipsesIsTheDistanceOfTheirOutlines) {
  for (const double shift : {0.006, 0.003, 0.0015}) {
    const double x = 0.033 + shift, y = 0.021 + shift;
    const LevelSetPtr shape =
        plate(placed_in_plane(-0.02, 0, 0, super_ellipse(0.02, 0.015, 3, 3)),
              placed_in_plane(-0.02 + x, y, 0, super_ellipse(0.02, 0.01, 3, 3)));
    const auto one = super_ellipse_points(-0.02, 0, 0.02, 0.015, 3);
    const auto two = super_ellipse_points(-0.02 + x, y, 0.02, 0.01, 3);
    double distance = 1;
    for (int i = 0; i < one.cols(); ++i)
      distance = std::min(distance, (two.colwise() - one.col(i)).colwise().norm().minCoeff());
    EXPECT_NEAR(wall(*shape, "one", "two").thickness, distance, 1e-5 * distance);
  }
}

TEST(Part, IsFoundByNameAndByPathWithItsSignAndFirstParameter) {
  std::vector<Operand> inner;
  inner.push_back({"ring", levelset::circle(0.03)});
  inner.push_back({"core", hole(0, 0, 0.01)});
  std::vector<Operand> outer;
  outer.push_back({"plate", rectangle(0.2, 0.1)});
  outer.push_back({"cut", subtract(std::move(inner))});
  const LevelSetPtr shape = subtract(std::move(outer));
  EXPECT_EQ(shape->part("plate")->sign, 1);
  EXPECT_EQ(shape->part("cut")->sign, -1);
  EXPECT_EQ(shape->part("cut.core")->sign, 1);  // a hole of a hole is material
  EXPECT_EQ(shape->part("core")->first, 4);
  EXPECT_EQ(shape->parameters()[4].name, "cut.core.x");
  EXPECT_FALSE(shape->part("bore"));
}

}  // namespace
}  // namespace liesl::test::wall_test
