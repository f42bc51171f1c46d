#include <gtest/gtest.h>

#include <random>

#include "liegroup/numdiff.hpp"
#include "mbs/levelset/shapes.hpp"

namespace liesl::test::features_test {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

/// Points where phi is smooth enough for a step of the sweep: the gradient is continuous nearby.
std::vector<Vector3d> smooth_points(const LevelSet& shape, int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> u(-0.9, 0.9);
  std::vector<Vector3d> points;
  for (int tries = 0; tries < 4000 && static_cast<int>(points.size()) < count; ++tries) {
    const Vector3d x(u(random), u(random), 0.6 * u(random));
    Vector3d g, neighbour;
    const double phi = shape.evaluate(x, g, nullptr);
    if (std::abs(phi) > 0.25) continue;  // what counts is the neighbourhood of the outline
    bool smooth = true;
    for (int i = 0; i < 6 && smooth; ++i) {
      const Vector3d d = (i % 2 ? 0.11 : -0.11) * Vector3d::Unit(i / 2);
      shape.evaluate(x + d, neighbour, nullptr);
      smooth = (neighbour - g).norm() < 0.6;
    }
    if (smooth) points.push_back(x);
  }
  return points;
}

class EveryShape : public ::testing::TestWithParam<NamedShape> {};

TEST_P(EveryShape, GradientsPassTheStepSweep) {
  const LevelSetPtr shape = GetParam().make();
  const VectorXd p0 = shape->start();
  ASSERT_EQ(shape->error(), "");
  const auto points = smooth_points(*shape, 12);
  ASSERT_GE(points.size(), 6u);
  int with_slope = 0;
  for (const Vector3d& x : points) {
    Vector3d dx;
    VectorXd dp(shape->size());
    shape->set(p0);
    const double phi = shape->evaluate(x, dx, dp.data());
    EXPECT_NEAR(phi, shape->value(x), 1e-15);  // of coordinates of order 1: five units of round-off
    const auto of_x = [&](const VectorXd& y) {
      return VectorXd::Constant(1, shape->value(y)).eval();
    };
    const StepSweep in_x = step_sweep(of_x, VectorXd(x), Eigen::RowVectorXd(dx.transpose()));
    EXPECT_LE(in_x.best_error, 1e-8) << "x = " << x.transpose();
    const auto of_p = [&](const VectorXd& p) {
      shape->set(p);
      return VectorXd::Constant(1, shape->value(x)).eval();
    };
    const StepSweep in_p = step_sweep(of_p, p0, Eigen::RowVectorXd(dp.transpose()));
    EXPECT_LE(in_p.best_error, 1e-8) << "x = " << x.transpose();
    with_slope += in_p.confirms(1e-8, 0.15);
  }
  EXPECT_GE(with_slope, static_cast<int>(points.size()) * 3 / 4);
}

TEST_P(EveryShape, DistancesHaveSlopeOneAndAllSlopesOneIsNearOnTheOutline) {
  const LevelSetPtr shape = GetParam().make();
  for (const Vector3d& x : smooth_points(*shape, 30)) {
    Vector3d dx;
    shape->evaluate(x, dx, nullptr);
    if (GetParam().is_distance)
      EXPECT_NEAR(dx.norm(), 1, 1e-12);
    else
      EXPECT_GT(dx.norm(), 0.3);
  }
}

INSTANTIATE_TEST_SUITE_P(LevelSet, EveryShape, ::testing::ValuesIn(all_shapes()),
                         [](const auto& shape) {
                           std::string name = shape.param.name;
                           for (char& c : name)
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           return name;
                         });

TEST(LevelSet, EllipseHasSlopeOneOnItsOutline) {
  const LevelSetPtr e = ellipse(0.7, 0.2);
  for (double t = 0.1; t < 6; t += 0.5) {
    Vector3d dx;
    EXPECT_NEAR(e->evaluate({0.7 * std::cos(t), 0.2 * std::sin(t), 0}, dx, nullptr), 0, 1e-15);
    EXPECT_NEAR(dx.norm(), 1, 1e-12);
  }
}

TEST(LevelSet, SuperEllipseHasTheOutlineOfTheThesis) {
  const LevelSetPtr s = super_ellipse(0.3, 0.2, 3, 5);  // eq. 3.4
  for (double x : {0.01, 0.1, 0.2, 0.29}) {
    const double y = 0.2 * std::pow(1 - std::pow(x / 0.3, 3), 1.0 / 5);
    EXPECT_NEAR(s->value({x, y, 0}), 0, 1e-15);
    EXPECT_NEAR(s->value({-x, -y, 3}), 0, 1e-15);
  }
}

/// Products and roots in the place of powers, and powers where there are none.
TEST(LevelSet, SuperEllipseIsItsFormulaWhateverItsExponents) {
  const double a = 0.3, b = 0.2;
  for (const auto& [xi, eta] :
       {std::pair{2.0, 2.0}, {4.0, 4.0}, {8.0, 8.0}, {3.0, 5.0}, {1.5, 2.5}, {9.0, 7.0}}) {
    const LevelSetPtr s = super_ellipse(a, b, xi, eta);
    for (double x : {-0.45, -0.1, 0.0, 0.02, 0.29})
      for (double y : {-0.3, 0.01, 0.15}) {
        const double f = std::pow(std::abs(x) / a, xi) + std::pow(std::abs(y) / b, eta),
                     length = std::hypot(x / a, y / b) / std::hypot(x / (a * a), y / (b * b)),
                     phi = (1 - std::pow(f, 2 / (xi + eta))) * length;
        Vector3d dx;
        EXPECT_NEAR(s->value({x, y, 0}), phi, 1e-15)
            << xi << ", " << eta << " at " << x << ", " << y;
        EXPECT_DOUBLE_EQ(s->evaluate({x, y, 0}, dx, nullptr), s->value({x, y, 0}));
      }
  }
}

TEST(LevelSet, SuperformulaOfACircleIsACircleAndThreeCornersRepeat) {
  const LevelSetPtr round = superformula({0.5, 1, 1, 0, 2, 2, 2});
  EXPECT_NEAR(round->value({0.3, 0.4, 0}), 0, 1e-15);
  const LevelSetPtr three = superformula({0.5, 1, 1, 3, 4.5, 10, 10});
  for (double a : {0.2, 1.1, 1.9}) {
    const double third = 2 * std::numbers::pi / 3;
    const auto at = [&](double t) {
      return three->value({0.4 * std::cos(t), 0.4 * std::sin(t), 0});
    };
    EXPECT_NEAR(at(a), at(a + third), 1e-13);
    EXPECT_NEAR(at(a), at(a + 2 * third), 1e-13);
  }
}

TEST(LevelSet, SplineGoesThroughItsPointsEitherWayRound) {
  auto points = ring(9, 0.6);
  for (int way = 0; way < 2; ++way) {
    const LevelSetPtr s = closed_curve(CurveKind::Spline, points);
    for (const auto& p : points) EXPECT_NEAR(s->value({p[0], p[1], 0}), 0, 1e-15);
    EXPECT_GT(s->value({0, 0, 0}), 0.4);
    EXPECT_LT(s->value({1, 1, 0}), 0);
    std::reverse(points.begin(), points.end());
  }
}

TEST(LevelSet, SplineThroughPointsOfACircleConvergesWithOrderFour) {
  double previous = 0;
  for (int n : {16, 32}) {
    const LevelSetPtr s = closed_curve(CurveKind::Spline, ring(n, 1, 0));
    double worst = 0;
    for (double a = 0; a < 6.28; a += 0.01)
      worst = std::max(worst, std::abs(s->value({std::cos(a), std::sin(a), 0})));
    if (previous > 0) {
      EXPECT_NEAR(std::log2(previous / worst), 4, 0.05);
    }
    previous = worst;
  }
}

TEST(LevelSet, NurbsFollowsItsWeights) {
  const auto points = ring(6, 0.6, 0);
  std::vector<double> weights(6, 1.0);
  const Vector3d corner(points[0][0], points[0][1], 0);
  double previous = -1;
  for (double w : {1.0, 4.0, 40.0, 400.0}) {
    weights[0] = w;
    const double phi = closed_curve(CurveKind::Nurbs, points, weights)->value(corner);
    EXPECT_LT(phi, 0);
    EXPECT_GT(phi, previous);  // the curve comes nearer to the heavy point
    previous = phi;
  }
  EXPECT_GT(previous, -5e-3);
}

TEST(LevelSet, ErrorsAreNamed) {
  EXPECT_NE(turned(circle(-0.1))->error().find("radius"), std::string::npos);
  EXPECT_NE(rectangle(1, 0.2, 0.15)->error().find("fillet"), std::string::npos);
  const LevelSetPtr eight = closed_curve(CurveKind::Polyline, {{0, 0}, {1, 1}, {1, 0}, {0, 1}});
  EXPECT_NE(eight->error().find("crosses itself"), std::string::npos);
  const LevelSetPtr tree = subtract(pair(rectangle(1, 1), circle(-0.1)));
  EXPECT_EQ(tree->error().substr(0, 2), "b:");
  EXPECT_THROW(closed_curve(CurveKind::Spline, ring(3, 1)), std::invalid_argument);
  EXPECT_THROW(closed_curve(CurveKind::Nurbs, ring(5, 1), {1, 2}), std::invalid_argument);
}

}  // namespace
}  // namespace liesl::test::features_test
