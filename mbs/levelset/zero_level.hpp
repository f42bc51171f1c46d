#pragma once
/// @file
/// The outline of a shape: points on phi = 0, to the last digits.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "mbs/levelset/level_set.hpp"

namespace liesl::levelset {

struct Box {
  Eigen::Vector3d from, to;  ///< m
};

/// Points of a line in order; the material lies on its left.
struct Polyline {
  std::vector<Eigen::Vector2d> points;  ///< a closed line does not repeat its first point
  bool closed = true;
};

/// Outlines in the plane z = 0 of the part of a shape in a box, all closed: marching triangles on
/// nx x ny squares (and a margin of one), then Newton's method onto phi = 0. Points are in
/// floating-point accuracy on the outline; what is narrower than a square may be lost, and corners
/// are cut within a square.
std::vector<Polyline> outline(const LevelSet& shape, const Box& box, int nx, int ny);

/// Triangles, corners counter-clockwise seen from outside (right-hand rule).
struct Surface {
  Eigen::Matrix3Xd points;
  std::vector<std::array<int, 3>> triangles;
};

/// Surface of the part of a shape in a box, closed: marching tetrahedra, then Newton.
Surface surface(const LevelSet& shape, const Box& box, int nx, int ny, int nz);

/// Area enclosed (m^2), volume enclosed (m^3): positive round material, negative round holes.
double enclosed_area(const Polyline& line);
double enclosed_volume(const Surface& surface);

}  // namespace liesl::levelset
