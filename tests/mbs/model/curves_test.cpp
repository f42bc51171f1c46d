/// @file
/// Reference frames on curves: exactness of lines and arcs, order of splines, invariance.

#include "mbs/model/curves.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "mbs/model/cubic_spline.hpp"

namespace liesl::test::curves_test {
namespace {

constexpr double pi = std::numbers::pi;
using Vec3 = Eigen::Vector3d;
using Vec6 = SE3::Tangent;

/// Deformation-free relative motion of an element.
Vec6 d0(const SE3& A, const SE3& B) { return SE3::log(A.inverse() * B); }

Vec6 vec6(double a, double b, double c, double d, double e, double f) {
  return (Vec6() << a, b, c, d, e, f).finished();
}

SE3 rigid_motion() { return SE3::exp(vec6(1, -2, 0.5, 0.7, -0.4, 1.1)); }

void expect_frames(const std::vector<SE3>& frames) {
  for (const auto& H : frames) {
    EXPECT_LT((H.R.transpose() * H.R - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_NEAR(H.R.determinant(), 1, 1e-14);
  }
}

TEST(SectionAxes, FollowTheRule) {
  const auto R = section_axes({3, 4, 0});  // in the plane: y in the plane, z = Z
  EXPECT_TRUE(R.col(0).isApprox(Vec3(0.6, 0.8, 0), 1e-15));
  EXPECT_TRUE(R.col(1).isApprox(Vec3(-0.8, 0.6, 0), 1e-15));
  EXPECT_TRUE(R.col(2).isApprox(Vec3(0, 0, 1), 1e-15));
  EXPECT_EQ(section_axes({-1, 0, 0}).col(2), Vec3(0, 0, 1));
  EXPECT_EQ(section_axes({0, 0, 2}).col(2), Vec3(0, 1, 0));
  EXPECT_EQ(section_axes({0, 0, -2}).col(2), Vec3(0, 1, 0));
  const auto inclined = section_axes({1, 1, 1});
  EXPECT_GT(inclined(2, 2), 0);
  EXPECT_NEAR(inclined(2, 1), 0, 1e-15);  // y is horizontal
}

TEST(SectionAxes, UpGivesTheDirectionOfY) {
  const auto R = section_axes({2, 0, 0}, {5, 0, 3});
  EXPECT_TRUE(R.col(1).isApprox(Vec3(0, 0, 1), 1e-15));
  EXPECT_TRUE(R.col(2).isApprox(Vec3(0, -1, 0), 1e-15));
  EXPECT_THROW(section_axes({2, 0, 0}, {-1, 0, 0}), std::invalid_argument);
  EXPECT_THROW(section_axes({0, 0, 0}), std::invalid_argument);
}

TEST(Straight, ElementsAreStraight) {
  const Vec3 from(1, 2, 3), to(4, 6, 3);
  const auto frames = straight(from, to, 4);
  ASSERT_EQ(frames.size(), 5u);
  expect_frames(frames);
  EXPECT_EQ(frames.front().x, from);
  EXPECT_EQ(frames.back().x, to);
  for (int i = 0; i < 4; ++i)
    EXPECT_LT((d0(frames[i], frames[i + 1]) - vec6(1.25, 0, 0, 0, 0, 0)).norm(), 1e-14);
}

TEST(Straight, PreTwistIsAScrew) {
  const auto frames = straight({0, 0, 0}, {2, 0, 0}, 5, {.pre_twist = pi / 2});
  for (int i = 0; i < 5; ++i)
    EXPECT_LT((d0(frames[i], frames[i + 1]) - vec6(0.4, 0, 0, pi / 10, 0, 0)).norm(), 1e-14);
  EXPECT_TRUE(frames.back().R.col(1).isApprox(Vec3(0, 0, 1), 1e-14));  // y has turned to Z
}

TEST(Straight, RefusesWhatIsNoBeam) {
  EXPECT_THROW(straight({1, 1, 1}, {1, 1, 1}, 4), std::invalid_argument);
  EXPECT_THROW(straight({0, 0, 0}, {1, 1, 1}, 0), std::invalid_argument);
  EXPECT_THROW(straight({0, 0, 0}, {1, 0, 0}, 2, {.pre_twist = 2 * pi}), std::invalid_argument);
  EXPECT_THROW(straight({0, 0, 0}, {1, 0, 0}, 2, {.pre_twist = 4 * pi}), std::invalid_argument);
  EXPECT_NO_THROW(straight({0, 0, 0}, {1, 0, 0}, 3, {.pre_twist = 2 * pi}));
}

/// The 45 degree bend: radius 100, towards +y; and the same to the right.
TEST(ArcFrames, ConstantCurvatureAboutZ) {
  const double R = 100, angle = pi / 4, kappa = 1 / R;
  const int n = 8;
  const double L = R * angle / n;
  for (double side : {1.0, -1.0}) {
    const auto frames = arc({{0, 0, 0}, {1, 0, 0}, {0, side * R, 0}, angle}, n);
    ASSERT_EQ(frames.size(), 9u);
    expect_frames(frames);
    for (int i = 0; i < n; ++i) {
      EXPECT_LT((d0(frames[i], frames[i + 1]) - vec6(L, 0, 0, 0, 0, side * kappa * L)).norm(),
                1e-13);
      EXPECT_TRUE(frames[i].R.col(2).isApprox(Vec3(0, 0, 1), 1e-15));
    }
    const double c = std::cos(angle);
    EXPECT_LT((frames.back().x - Vec3(R * c, side * R * (1 - c), 0)).norm(), 1e-13);
  }
}

TEST(ArcFrames, NormalOutOfThePlaneAndUp) {
  // In the plane of x and z the normal is -+Y: z = +Y.
  const Arc in_xz{{0, 0, 0}, {1, 0, 0}, {0, 0, 2}, pi / 2};
  const auto frames = arc(in_xz, 4);
  EXPECT_TRUE(frames[0].R.col(2).isApprox(Vec3(0, 1, 0), 1e-15));
  EXPECT_NEAR(std::abs(d0(frames[0], frames[1])[5]), pi / 8, 1e-14);
  // With y = global Y the same arc bends about y.
  const auto turned = arc(in_xz, 4, {.up = {0, 1, 0}});
  EXPECT_TRUE(turned[0].R.col(1).isApprox(Vec3(0, 1, 0), 1e-15));
  EXPECT_LT((d0(turned[0], turned[1]) - vec6(pi / 4, 0, 0, 0, -pi / 8, 0)).norm(), 1e-14);
}

TEST(ArcFrames, ThreeWaysToSayTheSame) {
  const SE3 H = rigid_motion();
  const Vec3 a = H * Vec3(0, 0, 0), b = H * Vec3(2, 2, 0), c = H * Vec3(2, -2, 0);
  const Arc by_points = Arc::through(a, b, H * Vec3(4, 0, 0));
  EXPECT_NEAR(by_points.angle, pi, 1e-14);
  EXPECT_LT((by_points.centre - H * Vec3(2, 0, 0)).norm(), 1e-14);
  EXPECT_NEAR(Arc::through(a, b, c).angle, 1.5 * pi, 1e-14);
  const Arc by_radius =
      Arc::with_radius(a, H.R * Vec3(0, 1, 0), H.R * Vec3(0, 0, -1), 2, by_points.angle);
  const auto x = arc(by_points, 6), y = arc(by_radius, 6);
  for (int i = 0; i <= 6; ++i) {
    EXPECT_LT((x[i].x - y[i].x).norm(), 1e-14);
    EXPECT_LT((x[i].R - y[i].R).norm(), 1e-14);
  }
  EXPECT_LT((x[3].x - b).norm(), 1e-14);
}

TEST(ArcFrames, AreCarriedByARigidMotion) {
  const SE3 H = rigid_motion();
  const Arc a{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}, 2};
  const Arc moved{H * a.from, H.R * a.tangent, H * a.centre, a.angle};
  const Vec3 up(-1, 0.3, 0.2);
  const auto before = arc(a, 5, {.up = up, .pre_twist = 0.6});
  const auto after = arc(moved, 5, {.up = H.R * up, .pre_twist = 0.6});
  for (int i = 0; i < 5; ++i)
    EXPECT_LT((d0(before[i], before[i + 1]) - d0(after[i], after[i + 1])).norm(), 1e-14);
}

TEST(ArcFrames, RefusesImpossibleArcs) {
  EXPECT_THROW(arc({{0, 0, 0}, {1, 0.1, 0}, {0, 1, 0}, 1}, 4), std::invalid_argument);
  EXPECT_THROW(arc({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, 1}, 4), std::invalid_argument);
  EXPECT_THROW(arc({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, -1}, 4), std::invalid_argument);
  EXPECT_THROW(arc({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2 * pi}, 2), std::invalid_argument);
  EXPECT_NO_THROW(arc({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2 * pi}, 3));
  EXPECT_THROW(Arc::through({0, 0, 0}, {1, 1, 1}, {3, 3, 3}), std::invalid_argument);
  EXPECT_THROW(Arc::with_radius({0, 0, 0}, {1, 0, 0}, {2, 0, 0}, 1, 1), std::invalid_argument);
  EXPECT_THROW(Arc::with_radius({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 0, 1), std::invalid_argument);
}

TEST(Spline, OfPointsOnALineIsTheLine) {
  const Vec3 a(1, 0, 2), e(2, -1, 0.5);
  const auto s = spline({a, a + 0.3 * e, a + 0.4 * e, a + e}, 5);
  const auto line = straight(a, a + e, 5);
  for (int i = 0; i <= 5; ++i) {
    EXPECT_LT((s[i].x - line[i].x).norm(), 1e-13);
    EXPECT_LT((s[i].R - line[i].R).norm(), 1e-13);
  }
  EXPECT_LT((spline({a, a + e}, 2)[1].x - (a + e / 2)).norm(), 1e-14);
}

/// The chords are equal, so that the parabola is parametrised by x.
TEST(Spline, OfThreePointsIsAParabola) {
  const auto s = spline({{-1, 0, 0}, {0, 1, 0}, {1, 0, 0}}, 8);
  for (const auto& H : s) EXPECT_NEAR(H.x[1], 1 - H.x[0] * H.x[0], 1e-14);
  const double length = std::sqrt(5) + std::asinh(2) / 2;  // of y = 1 - x^2 over [-1, 1]
  EXPECT_NEAR(CubicSpline({{-1, 0, 0}, {0, 1, 0}, {1, 0, 0}}).length(), length, 1e-10);
}

TEST(Spline, HasTwoContinuousDerivatives) {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0.5, 0}, {1.5, 2, 1}, {3, 2, -1}, {4, 0, 0}};
  const CubicSpline curve(points);
  double knot = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    knot += (points[i] - points[i - 1]).norm();
    EXPECT_LT((curve.position(knot) - points[i]).norm(), 1e-14);
    if (i + 1 == points.size()) break;
    const double e = 1e-4;
    const Vec3 before = (curve.derivative(knot) - curve.derivative(knot - e)) / e;
    const Vec3 after = (curve.derivative(knot + e) - curve.derivative(knot)) / e;
    EXPECT_LT((after - before).norm(), 1e-2) << i;  // O(e) if C2, O(1) if C1
    EXPECT_LT((curve.derivative(knot + 1e-12) - curve.derivative(knot - 1e-12)).norm(), 1e-10);
  }
}

TEST(Spline, NodesAreEquallySpacedByArcLength) {
  const std::vector<Vec3> points = {{0, 0, 0}, {0.2, 0.5, 0}, {1.5, 2, 1}, {3, 2, -1}};
  const CubicSpline curve(points);
  const int n = 7, fine = 20000;
  double walked = 0;
  Vec3 last = curve.position(0);
  const auto frames = spline(points, n);
  int node = 1;
  double total = 0;
  for (std::size_t i = 1; i < points.size(); ++i) total += (points[i] - points[i - 1]).norm();
  for (int k = 1; k <= fine; ++k) {
    const Vec3 x = curve.position(total * k / fine);
    const double step = (x - last).norm();
    if (node <= n && walked + step >= node * curve.length() / n * (1 - 1e-6)) {
      EXPECT_LT((x - frames[std::size_t(node)].x).norm(), 1.1 * step) << node;
      ++node;
    }
    walked += step, last = x;
  }
  EXPECT_EQ(node, n + 1);
  EXPECT_NEAR(walked, curve.length(), 1e-6);
}

TEST(Spline, InAPlaneKeepsTheNormal) {
  const auto frames = spline({{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {3, -2, 0}, {2, -3, 0}}, 12);
  expect_frames(frames);
  for (const auto& H : frames) EXPECT_LT((H.R.col(2) - Vec3(0, 0, 1)).norm(), 1e-13);
}

/// Frames of minimal twist on a helix of radius r and pitch 2 pi c turn against the Frenet frame by
/// the integral of the torsion, c/(r^2 + c^2) an arc length. Order 3, that of the tangent at the
/// ends.
TEST(Spline, ConvergesToTheMinimalTwistOfAHelix) {
  const double r = 1, c = 0.4, turns = 1, torsion = c / (r * r + c * c);
  const double length = 2 * pi * turns * std::hypot(r, c);
  double previous = 0;
  for (int m : {32, 64}) {
    std::vector<Vec3> points;
    for (int i = 0; i <= m; ++i) {
      const double a = 2 * pi * turns * i / m;
      points.emplace_back(r * std::cos(a), r * std::sin(a), c * a);
    }
    const auto frames = spline(points, 10, {.up = {-1, 0, 0}});  // y = Frenet normal at the start
    const double angle = -torsion * length;
    const Vec3 t = Vec3(0, r, c).normalized(), normal(-1, 0, 0), binormal = t.cross(normal);
    const Vec3 y = std::cos(angle) * normal + std::sin(angle) * binormal;
    const double error = (frames.back().R.col(1) - y).norm();
    if (previous > 0) {
      EXPECT_NEAR(std::log2(previous / error), 3, 0.1) << m;
    }
    previous = error;
  }
  EXPECT_LT(previous, 2e-4);
}

TEST(Spline, PreTwistTurnsTheFramesAboutTheTangent) {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 1, 0}, {2, 0, 1}, {3, -2, 0}};
  const auto plain = spline(points, 6), twisted = spline(points, 6, {.pre_twist = 0.9});
  for (int i = 0; i <= 6; ++i) {
    const Vec3 w = SO3::log(plain[i].R.transpose() * twisted[i].R);
    EXPECT_LT((w - Vec3(0.15 * i, 0, 0)).norm(), 1e-13);
  }
}

TEST(Spline, RefusesBadPoints) {
  EXPECT_THROW(spline({{0, 0, 0}}, 4), std::invalid_argument);
  EXPECT_THROW(spline({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}, 4), std::invalid_argument);
  EXPECT_THROW(spline({{0, 0, 0}, {1, 0, 0}}, 0), std::invalid_argument);
}

}  // namespace
}  // namespace liesl::test::curves_test
