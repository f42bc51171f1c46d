#pragma once
/// @file
/// One of every feature, for the tests that hold for all of them.

#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "mbs/levelset/closed_curve.hpp"
#include "mbs/levelset/csg.hpp"
#include "mbs/levelset/features.hpp"

namespace liesl::test {

using namespace levelset;

/// A wavy ring of points about the origin.
inline std::vector<Eigen::Vector2d> ring(int n, double radius, double wave = 0.1) {
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * std::numbers::pi * i / n, r = radius * (1 + wave * std::cos(3 * a + 0.4));
    points.emplace_back(r * std::cos(a), r * std::sin(a));
  }
  return points;
}

struct NamedShape {
  std::string name;
  std::function<LevelSetPtr()> make;
  bool is_distance = false;  ///< |d phi/dx| = 1 everywhere but at kinks
};

inline LevelSetPtr tilted(LevelSetPtr shape) {
  return placed({{0.1, -0.05, 0.15}, {0.3, -0.5, 0.7}}, std::move(shape));
}
inline LevelSetPtr turned(LevelSetPtr shape) {
  return placed_in_plane(0.1, -0.05, 0.4, std::move(shape));
}

inline std::vector<Operand> pair(LevelSetPtr a, LevelSetPtr b) {
  std::vector<Operand> operands;
  operands.push_back({"a", std::move(a)});
  operands.push_back({"b", std::move(b)});
  return operands;
}

inline LevelSetPtr two_circles_united(std::optional<double> radius) {
  return unite(pair(placed_in_plane(-0.2, 0, 0, levelset::circle(0.5)),
                    placed_in_plane(0.3, 0.1, 0, levelset::circle(0.4))),
               radius);
}

inline std::vector<NamedShape> all_shapes() {
  return {
      {"half-plane", [] { return turned(half_space()); }, true},
      {"half-space", [] { return tilted(half_space()); }, true},
      {"circle", [] { return turned(levelset::circle(0.6)); }, true},
      {"sphere", [] { return tilted(sphere(0.6)); }, true},
      {"rectangle", [] { return turned(rectangle(1.2, 0.8)); }, true},
      {"rectangle with fillet", [] { return turned(rectangle(1.2, 0.8, 0.15)); }, true},
      {"box with fillet", [] { return tilted(box(1.2, 0.8, 1.0, 0.1)); }, true},
      {"ellipse", [] { return turned(ellipse(0.7, 0.4)); }},
      {"ellipsoid", [] { return tilted(ellipsoid(0.7, 0.4, 0.5)); }},
      {"super-ellipse", [] { return turned(super_ellipse(0.7, 0.4, 3, 4)); }},
      {"super-ellipse, roots", [] { return turned(super_ellipse(0.7, 0.4, 4, 4)); }},
      {"super-ellipse, higher roots", [] { return turned(super_ellipse(0.7, 0.4, 8, 8)); }},
      {"superformula",
       [] {
         return turned(superformula({0.6, 1.1, 0.9, 6, 3, 2.5, 3.5}));
       }},
      {"polyline", [] { return turned(closed_curve(CurveKind::Polyline, ring(7, 0.6))); }, true},
      {"spline", [] { return turned(closed_curve(CurveKind::Spline, ring(9, 0.6))); }, true},
      {"NURBS",
       [] {
         return turned(
             closed_curve(CurveKind::Nurbs, ring(8, 0.8), {1, 2, 0.7, 1, 1.3, 1, 0.6, 1.1}));
       },
       true},
      {"extrusion", [] { return tilted(extrude(0.9, turned(ellipse(0.7, 0.4)))); }},
      {"slab", [] { return tilted(slab(0.9)); }, true},
      {"mirror",
       [] {
         return mirrored_in_plane(0.1, -0.05, 0.4,
                                  {"one", placed_in_plane(0.25, 0.35, 0.2, ellipse(0.6, 0.25))});
       }},
      {"mirror in space",
       [] {
         return mirrored(
             {{0.1, -0.05, 0.15}, {0.3, -0.5, 0.7}},
             {"one", placed({{0.2, 0.45, 0.1}, {0.2, 0.1, 0}}, ellipsoid(0.4, 0.3, 0.3))});
       }},
      {"union", [] { return two_circles_united({}); }},
      {"smooth union", [] { return two_circles_united(0.2); }},
      {"smooth intersection",
       [] {
         return intersect(
             pair(turned(rectangle(1.2, 0.8)), placed_in_plane(0.2, 0.1, 0, levelset::circle(0.5))),
             0.15);
       }},
      {"smooth difference",
       [] {
         return subtract(
             pair(turned(rectangle(1.2, 0.8)), placed_in_plane(0.5, 0.1, 0, levelset::circle(0.3))),
             0.1);
       }},
  };
}

/// Of `all_shapes`; throws where none has that name.
inline NamedShape shape_named(std::string_view name) {
  for (NamedShape& shape : all_shapes())
    if (shape.name == name) return shape;
  throw std::invalid_argument("no shape '" + std::string(name) + "'");
}

}  // namespace liesl::test
