#pragma once
/// @file
/// Constructive solid geometry on level sets (thesis ch. 3.2.2; Shapiro 2007): union = max,
/// intersection = min, difference a - b = min(a, -b).

#include <optional>
#include <utility>

#include "mbs/levelset/level_set.hpp"

namespace liesl::levelset {

/// An operand and its name in the tree: parameters appear as "name.parameter", or under their own
/// name if the name is empty.
struct Operand {
  std::string name;
  LevelSetPtr shape;
  std::string label = {};  ///< what `LevelSet::part` finds it by, if that is not the name
};

/// With a radius r the operation is smooth: intersection of two distances a, b
///   phi = max(r, min(a, b)) - |(max(r - a, 0), max(r - b, 0))|,
/// an arc of radius r where two planes meet at a right angle, min(a, b) elsewhere; union and
/// difference by complement. The radius is then the last parameter, "radius". More than two
/// operands are combined from the first to the last.
LevelSetPtr unite(std::vector<Operand> operands, std::optional<double> radius = {});
LevelSetPtr intersect(std::vector<Operand> operands, std::optional<double> radius = {});
/// The first operand without all others.
LevelSetPtr subtract(std::vector<Operand> operands, std::optional<double> radius = {});

/// A planar shape between z = -height/2 and height/2; parameters "height", then the shape's.
LevelSetPtr extrude(double height, LevelSetPtr shape);

/// Union of a shape and its mirror image about the line through (x, y) at `angle`; parameters of
/// the shape, then x, y, angle. `part` finds features as they are written, not their images.
LevelSetPtr mirrored_in_plane(double x, double y, double angle, Operand shape);
/// ... about the plane through a position, y = 0 of the turned axes; x, y, z, rx, ry, rz.
LevelSetPtr mirrored(const Pose& plane, Operand shape);

}  // namespace liesl::levelset
