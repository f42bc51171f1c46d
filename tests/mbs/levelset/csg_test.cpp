#include <gtest/gtest.h>

#include <random>

#include "liegroup/so3.hpp"
#include "mbs/levelset/shapes.hpp"

namespace liesl::test::csg_test {
namespace {

using Eigen::Vector3d;

LevelSetPtr a() { return placed_in_plane(-0.2, 0, 0, circle(0.5)); }
LevelSetPtr b() { return placed_in_plane(0.3, 0.1, 0.3, rectangle(0.6, 0.5, 0.1)); }
LevelSetPtr c() { return placed_in_plane(0.1, -0.3, 0, ellipse(0.4, 0.2)); }

std::vector<Vector3d> points() {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(-1, 1);
  std::vector<Vector3d> p;
  for (int i = 0; i < 200; ++i) p.emplace_back(u(random), u(random), u(random));
  return p;
}

TEST(Csg, SharpOperationsFollowTheLawsOfSets) {
  const LevelSetPtr A = a(), B = b();
  const auto same = [](const LevelSetPtr& l, const LevelSetPtr& r) {
    for (const Vector3d& x : points()) EXPECT_EQ(l->value(x), r->value(x));
  };
  same(unite(pair(a(), b())), unite(pair(b(), a())));
  same(unite(pair(a(), a())), a());
  same(intersect(pair(a(), a())), a());
  same(unite(pair(unite(pair(a(), b())), c())), unite(pair(a(), unite(pair(b(), c())))));
  same(intersect(pair(a(), unite(pair(b(), c())))),
       unite(pair(intersect(pair(a(), b())), intersect(pair(a(), c())))));
  same(unite(pair(a(), intersect(pair(a(), b())))), a());
  for (const Vector3d& x : points()) {
    EXPECT_EQ(subtract(pair(a(), b()))->value(x), std::min(A->value(x), -B->value(x)));
    EXPECT_EQ(unite(pair(a(), b()))->value(x), std::max(A->value(x), B->value(x)));
  }
}

TEST(Csg, ThirdOperandOfADifferenceIsTakenAwayToo) {
  std::vector<Operand> three = pair(a(), b());
  three.push_back({"c", c()});
  const LevelSetPtr flat = subtract(std::move(three));
  const LevelSetPtr nested = subtract(pair(subtract(pair(a(), b())), c()));
  for (const Vector3d& x : points()) EXPECT_EQ(flat->value(x), nested->value(x));
}

TEST(Csg, SmoothOperationsAreBoundedBySharpOnesAndObeyDeMorgan) {
  const double r = 0.2;
  const LevelSetPtr u = unite(pair(a(), b()), r), i = intersect(pair(a(), b()), r);
  const LevelSetPtr U = unite(pair(a(), b())), I = intersect(pair(a(), b()));
  const LevelSetPtr A = a(), B = b();
  int blended = 0;
  for (const Vector3d& x : points()) {
    EXPECT_GE(u->value(x), U->value(x) - 1e-15);  // material is added in the corner
    EXPECT_LE(i->value(x), I->value(x) + 1e-15);  // and taken off the edge
    if (U->value(x) <= -r) {
      EXPECT_EQ(u->value(x), U->value(x));
    }
    blended += u->value(x) > U->value(x);
  }
  EXPECT_GT(blended, 5);
}

TEST(Csg, EdgeBetweenTwoPlanesIsRoundedWithTheRadius) {
  const double r = 0.3;  // material x < 0 and y < 0; the arc's centre is (-r, -r)
  const LevelSetPtr edge =
      intersect(pair(half_space(), placed_in_plane(0, 0, std::numbers::pi / 2, half_space())), r);
  for (double t = 0.05; t < std::numbers::pi / 2; t += 0.1) {
    EXPECT_NEAR(edge->value({r * (std::cos(t) - 1), r * (std::sin(t) - 1), 0}), 0, 1e-15);
  }
}

/// About the line through (0.1, -0.05) at 0.4: phi is the same at both sides, and that of the
/// union of the shape and of what its mirror image was made as.
TEST(Csg, AMirrorIsTheUnionWithTheImage) {
  const double x0 = 0.1, y0 = -0.05, line = 0.4, x = 0.25, y = 0.35, angle = 0.2;
  const LevelSetPtr both = mirrored_in_plane(
      x0, y0, line, {"one", placed_in_plane(x, y, angle, superformula({0.3, 1, 1, 3, 4, 6, 6}))});
  const double c = std::cos(2 * line), s = std::sin(2 * line);
  const auto image = [&](const Vector3d& p) {
    const double u = p[0] - x0, v = p[1] - y0;
    return Vector3d(x0 + c * u + s * v, y0 + s * u - c * v, p[2]);
  };
  // The superformula is symmetric to its own axis: its image is itself, placed elsewhere.
  const Vector3d there = image({x, y, 0});
  const LevelSetPtr united =
      unite(pair(placed_in_plane(x, y, angle, superformula({0.3, 1, 1, 3, 4, 6, 6})),
                 placed_in_plane(there[0], there[1], 2 * line - angle,
                                 superformula({0.3, 1, 1, 3, 4, 6, 6}))));
  for (const Vector3d& p : points()) {
    EXPECT_NEAR(both->value(p), both->value(image(p)), 1e-14);
    EXPECT_NEAR(both->value(p), united->value(p), 1e-14);
  }
  EXPECT_EQ(both->parameters()[0].name, "one.x");
  EXPECT_EQ(both->parameters().back().name, "angle");
  ASSERT_TRUE(both->part("one"));
  EXPECT_EQ(both->part("one")->sign, 1);
  EXPECT_FALSE(both->part("two"));
}

TEST(Csg, AMirrorInSpaceIsSymmetricToItsPlane) {
  const Pose plane{{0.1, -0.05, 0.15}, {0.3, -0.5, 0.7}};
  const LevelSetPtr both =
      mirrored(plane, {"one", placed({{0.2, 0.4, 0.1}, {0.2, 0.1, 0}}, box(0.5, 0.3, 0.2))});
  const Vector3d normal = SO3::exp(plane.rotation).R.col(1);
  for (const Vector3d& p : points()) {
    const Vector3d image = p - 2 * normal.dot(p - plane.position) * normal;
    EXPECT_NEAR(both->value(p), both->value(image), 1e-14);
  }
}

TEST(Csg, ParametersAreNamedByTheirPath) {
  const LevelSetPtr tree = subtract(pair(a(), b()), 0.1);
  std::vector<std::string> names;
  for (const Parameter& p : tree->parameters()) names.push_back(p.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"a.x", "a.y", "a.angle", "a.radius", "b.x", "b.y", "b.angle",
                                      "b.width", "b.height", "b.fillet", "radius"}));
}

}  // namespace
}  // namespace liesl::test::csg_test
