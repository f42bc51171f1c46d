#include "apps/output/shape_writer.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>

#include "apps/output/file.hpp"
#include "mbs/levelset/csg.hpp"
#include "mbs/levelset/features.hpp"

namespace liesl::test::shape_writer_test {
namespace {

using namespace output;

namespace fs = std::filesystem;
using namespace levelset;

LevelSetPtr plate_with_hole() {
  std::vector<Operand> operands;
  operands.push_back({"plate", rectangle(0.1, 0.06, 0.005)});
  operands.push_back({"hole", levelset::circle(0.02)});
  return subtract(std::move(operands));
}

class ShapeFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / ("liesl_shape_" + std::to_string(::getpid()));
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }
  fs::path folder;
};

TEST_F(ShapeFile, DxfHoldsTheOutlineInMillimetres) {
  const auto lines = outline(*plate_with_hole(), {{-0.06, -0.04, 0}, {0.06, 0.04, 0}}, 120, 80);
  write_dxf(folder / "part.dxf", lines);
  std::istringstream text(read_file(folder / "part.dxf"));
  std::string code, value;
  int polylines = 0, vertices = 0, closed = 0;
  double area = 0, largest = 0, x = 0;
  std::vector<Eigen::Vector2d> points;
  const auto finish = [&] {
    Polyline line{points, true};
    area += enclosed_area(line);
    points.clear();
  };
  while (std::getline(text, code) && std::getline(text, value)) {
    if (code == "0") finish();
    polylines += value == "LWPOLYLINE";
    if (code == "90") vertices += std::stoi(value);
    if (code == "70" && polylines > 0) closed += value == "1";
    if (code == "10") x = std::stod(value), largest = std::max(largest, x);
    if (code == "20") points.emplace_back(x, std::stod(value));
  }
  EXPECT_EQ(value, "EOF");
  EXPECT_EQ(polylines, 2);
  EXPECT_EQ(closed, 2);
  EXPECT_EQ(static_cast<std::size_t>(vertices), lines[0].points.size() + lines[1].points.size());
  EXPECT_NEAR(largest, 50, 1e-6);
  const double pi = 3.141592653589793;
  EXPECT_NEAR(area, 100 * 60 - (4 - pi) * 25 - pi * 400, 1);
}

TEST_F(ShapeFile, SvgHasOnePathWithAHole) {
  const auto lines = outline(*plate_with_hole(), {{-0.06, -0.04, 0}, {0.06, 0.04, 0}}, 60, 40);
  write_svg(folder / "part.svg", lines);
  const std::string text = read_file(folder / "part.svg");
  EXPECT_EQ(text.substr(0, 5), "<svg ");
  EXPECT_NE(text.find("width=\"104mm\""), std::string::npos) << text.substr(0, 200);
  EXPECT_EQ(std::count(text.begin(), text.end(), 'Z'), 2);
  write_svg(folder / "empty.svg", {});
  EXPECT_EQ(read_file(folder / "empty.svg").find("nan"), std::string::npos);
}

using Point = std::array<float, 3>;

/// Normal and corners of the triangles of a binary STL.
std::vector<std::array<Point, 4>> triangles_in(const fs::path& path) {
  const std::string bytes = read_file(path);
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof count);
  EXPECT_EQ(bytes.size(), 84 + 50 * std::size_t(count));
  std::vector<std::array<Point, 4>> triangles(count);
  for (std::uint32_t t = 0; t < count; ++t)
    std::memcpy(triangles[t].data(), bytes.data() + 84 + 50 * t, sizeof triangles[t]);
  return triangles;
}

TEST_F(ShapeFile, StlHasTheVolumeInCubicMillimetres) {
  const LevelSetPtr ball = sphere(0.01);
  const Surface s = surface(*ball, {{-0.015, -0.015, -0.015}, {0.015, 0.015, 0.015}}, 30, 30, 30);
  write_stl(folder / "ball.stl", s);
  const auto vector = [](const Point& p) { return Eigen::Vector3d(p[0], p[1], p[2]); };
  double volume = 0, outward = 0;
  for (const auto& t : triangles_in(folder / "ball.stl")) {
    const Eigen::Vector3d a = vector(t[1]), b = vector(t[2]), c = vector(t[3]);
    volume += a.dot(b.cross(c)) / 6;
    const Eigen::Vector3d n = (b - a).cross(c - a);
    EXPECT_NEAR((n.norm() * vector(t[0]) - n).norm(), 0, 1e-3);
    outward += n.dot(a);
  }
  EXPECT_NEAR(volume, enclosed_volume(s) * 1e9, 1e-3);
  EXPECT_NEAR(volume, 4188.79, 30);
  EXPECT_NEAR(outward, 6 * volume, 1);
}

/// A part whose faces lie on the grid, so that many points of its surface coincide.
TEST_F(ShapeFile, StlIsClosedAndHasNoEmptyTriangles) {
  const Surface s =
      surface(*plate_with_hole(), {{-0.05, -0.03, -0.01}, {0.05, 0.03, 0.01}}, 40, 24, 8);
  write_stl(folder / "plate.stl", s);
  const auto triangles = triangles_in(folder / "plate.stl");
  EXPECT_LT(triangles.size(), s.triangles.size());
  std::map<std::pair<Point, Point>, int> edges;  // + one way, - the other
  for (const auto& t : triangles)
    for (int i = 0; i < 3; ++i) {
      const Point &a = t[1 + i], &b = t[1 + (i + 1) % 3];
      EXPECT_NE(a, b);
      edges[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  EXPECT_FALSE(edges.empty());
  for (const auto& [edge, balance] : edges) EXPECT_EQ(balance, 0);
}

TEST_F(ShapeFile, VtuHoldsCellsAndFields) {
  const SolidMesh mesh = quad_grid({0, 0}, {2, 1}, 2, 1);
  Eigen::MatrixXd fraction(1, 2), u = Eigen::MatrixXd::Zero(3, 6);
  fraction << 0.25, 1;
  write_vtu(folder / "part.vtu", mesh, {{"fraction", fraction}}, {{"displacement", u}});
  const std::string text = read_file(folder / "part.vtu");
  EXPECT_NE(text.find("NumberOfPoints=\"6\" NumberOfCells=\"2\""), std::string::npos);
  EXPECT_NE(text.find("0 1 4 3\n1 2 5 4\n"), std::string::npos);
  EXPECT_NE(text.find("0.25\n1\n"), std::string::npos);
  EXPECT_THROW(write_vtu(folder / "bad.vtu", mesh, {{"fraction", u}}), std::invalid_argument);
}

}  // namespace
}  // namespace liesl::test::shape_writer_test
