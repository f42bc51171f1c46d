#include "mbs/levelset/zero_level.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>

#include "mbs/levelset/shapes.hpp"
#include "mbs/levelset/simplex.hpp"

namespace liesl::test::zero_level_test {
namespace {

using Eigen::Vector3d;
constexpr double kPi = std::numbers::pi;

double area(const std::vector<Polyline>& lines) {
  double sum = 0;
  for (const Polyline& line : lines) sum += enclosed_area(line);
  return sum;
}

TEST(Outline, PointsLieOnTheOutlineAndTheAreaConvergesWithOrderTwo) {
  double previous = 0;
  for (int n : {20, 40, 80, 160}) {
    double error = 0;  // over several places, since one may lie luckily on the grid
    for (int place = 0; place < 10; ++place) {
      const LevelSetPtr shape =
          placed_in_plane(0.003 * place, 0.007 * place, 0.3 * place, ellipse(0.7, 0.4));
      const auto lines = outline(*shape, {{-1, -1, 0}, {1, 1, 0}}, n, n);
      ASSERT_EQ(lines.size(), 1u);
      EXPECT_TRUE(lines[0].closed);
      for (const auto& x : lines[0].points) EXPECT_NEAR(shape->value({x[0], x[1], 0}), 0, 1e-15);
      error += std::abs(area(lines) - kPi * 0.7 * 0.4);
    }
    if (previous > 0) {
      EXPECT_NEAR(std::log2(previous / error), 2, 0.06);
    }
    previous = error;
  }
}

TEST(Outline, HolesRunTheOtherWayAndTheBoxClosesThePart) {
  const LevelSetPtr plate =
      subtract(pair(half_space(), placed_in_plane(-0.5, 0, 0, circle(0.2))));  // material: x < 0
  const auto lines = outline(*plate, {{-1, -0.5, 0}, {1, 0.5, 0}}, 100, 50);
  ASSERT_EQ(lines.size(), 2u);
  for (const Polyline& line : lines) EXPECT_TRUE(line.closed);
  EXPECT_LT(std::min(enclosed_area(lines[0]), enclosed_area(lines[1])), 0);
  EXPECT_NEAR(area(lines), 1 - kPi * 0.04, 2e-4);
}

TEST(Outline, NothingLeftIsNoLine) {
  EXPECT_TRUE(
      outline(*placed_in_plane(5, 5, 0, circle(0.1)), {{0, 0, 0}, {1, 1, 0}}, 10, 10).empty());
}

TEST(Surface, OfABallIsClosedOutwardAndItsVolumeConvergesWithOrderTwo) {
  const LevelSetPtr ball = placed(Pose{{0.02, 0.01, -0.03}, Eigen::Vector3d::Zero()}, sphere(0.7));
  double previous = 0;
  for (int n : {16, 32}) {
    const Surface s = surface(*ball, {{-1, -1, -1}, {1, 1, 1}}, n, n, n);
    std::map<std::pair<int, int>, int> edges;  // every edge once each way
    for (const auto& t : s.triangles)
      for (int i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
    for (const auto& [edge, times] : edges) {
      EXPECT_EQ(times, 1);
      EXPECT_TRUE(edges.count({edge.second, edge.first}));
    }
    for (Eigen::Index i = 0; i < s.points.cols(); ++i)
      EXPECT_NEAR(ball->value(s.points.col(i)), 0, 1e-14);
    const double error = std::abs(enclosed_volume(s) - 4 * kPi / 3 * 0.343);
    EXPECT_GT(enclosed_volume(s), 0);
    if (previous > 0) {
      EXPECT_NEAR(std::log2(previous / error), 2, 0.05);
    }
    previous = error;
  }
}

TEST(Simplex, SharesAreVolumesByDividedDifferences) {
  // Independent: sum over positive corners of f_i^n / prod_{j != i} (f_i - f_j).
  const auto divided = [](const auto& f) {
    double sum = 0;
    for (std::size_t i = 0; i < f.size(); ++i) {
      if (f[i] < 0) continue;
      double term = 1;
      for (std::size_t j = 0; j < f.size(); ++j)
        if (j != i) term *= f[i] / (f[i] - f[j]);
      sum += term;
    }
    return sum;
  };
  for (const std::array<double, 4>& f : {std::array<double, 4>{1, -2, -0.5, -3},
                                         {1, 2, -0.5, -3},
                                         {-1, 2, 0.5, 3},
                                         {0.3, -2, 0.7, -1}})
    EXPECT_NEAR(positive_share(f), divided(f), 1e-14);
  for (const std::array<double, 3>& f :
       {std::array<double, 3>{1, -2, -0.5}, {1, 2, -0.5}, {-0.1, 0.7, 0.9}})
    EXPECT_NEAR(positive_share(f), divided(f), 1e-14);
  EXPECT_EQ(positive_share(std::array<double, 3>{0, 0, 0}), 1);
  EXPECT_EQ(positive_share(std::array<double, 4>{-1, -1, -1, -1}), 0);
}

TEST(Simplex, TetrahedraFillTheCubeWithPositiveVolumes) {
  const auto corner = [](int c) { return Vector3d((c + 1) / 2 % 2, c / 2 % 2, c / 4); };
  for (const auto& cut : kTetrahedra) {
    double sum = 0;
    for (const auto& t : cut) {
      const Vector3d o = corner(t[0]);
      const double volume = (corner(t[1]) - o).dot((corner(t[2]) - o).cross(corner(t[3]) - o)) / 6;
      EXPECT_GT(volume, 0.1);
      sum += volume;
    }
    EXPECT_NEAR(sum, 1, 1e-15);
  }
}

}  // namespace
}  // namespace liesl::test::zero_level_test
