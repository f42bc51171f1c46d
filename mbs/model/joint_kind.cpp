#include "mbs/model/joint_kind.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace liesl {
namespace {

constexpr JointRow kX = JointRow::displacement(0), kY = JointRow::displacement(1),
                   kZ = JointRow::displacement(2);
// The first axis of b stays parallel to that of a; no rotation about it.
constexpr JointRow kParallelY = JointRow::perpendicular(1, 0),
                   kParallelZ = JointRow::perpendicular(2, 0);
constexpr JointRow kNoTurn = JointRow::perpendicular(2, 1), kCross = JointRow::perpendicular(0, 1);
constexpr JointRow kAngle = JointRow::angle(2, 1, 1);   // about the first axis
constexpr JointRow kAngle2 = JointRow::angle(0, 2, 0);  // about the second

std::vector<JointKind> table() {
  using enum JointType;
  return {
      {Fixed, "fixed", "No relative motion.", 0, {kX, kY, kZ, kParallelY, kParallelZ, kNoTurn}, {}},
      {Revolute,
       "revolute",
       "Rotation about `axis`.",
       1,
       {kX, kY, kZ, kParallelY, kParallelZ},
       {kAngle}},
      {Prismatic,
       "prismatic",
       "Displacement along `axis`.",
       1,
       {kY, kZ, kParallelY, kParallelZ, kNoTurn},
       {kX}},
      {Cylindrical,
       "cylindrical",
       "Displacement along and rotation about `axis`.",
       1,
       {kY, kZ, kParallelY, kParallelZ},
       {kX, kAngle}},
      {Spherical, "spherical", "All rotations.", 0, {kX, kY, kZ}, {}},
      {Universal,
       "universal",
       "Rotations about `axis` (of the first body) and `axis2` (of the second).",
       2,
       {kX, kY, kZ, kCross},
       {kAngle, kAngle2}},
      {Planar,
       "planar",
       "Displacements normal to `axis`, rotation about it.",
       1,
       {kX, kParallelY, kParallelZ},
       {kY, kZ, kAngle}},
      {Screw,
       "screw",
       "Rotation about `axis` with a displacement of `pitch` along it for each turn.",
       1,
       {kY, kZ, kParallelY, kParallelZ, JointRow::screw(0)},
       {kAngle},
       true},
  };
}

}  // namespace

const char* JointKind::unit(int coordinate) const {
  return coordinates.at(static_cast<std::size_t>(coordinate)).kind == JointRow::Kind::Displacement
             ? "m"
             : "rad";
}

Eigen::Vector3d JointKind::free_part(const Eigen::Vector3d& axis,
                                     const Eigen::Vector3d& displacement) const {
  const auto held = [this](int m) {
    return std::any_of(constraints.begin(), constraints.end(), [m](const JointRow& row) {
      return row.kind == JointRow::Kind::Displacement && row.m == m;
    });
  };
  const Eigen::Vector3d along = axis * axis.dot(displacement);
  if (!held(0)) return along;
  return held(1) ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : Eigen::Vector3d(displacement - along);
}

std::string JointKind::coordinates_text() const {
  if (coordinates.empty()) return "No coordinate.";
  std::string text = coordinate_count() == 1 ? "Coordinate" : "Coordinates";
  for (int i = 0; i < coordinate_count(); ++i)
    text += fmt::format("{} {}: {} ({})", i == 0 ? "" : ",", i,
                        unit(i) == std::string_view("m") ? "displacement" : "angle", unit(i));
  return text + ".";
}

const std::vector<JointKind>& joint_kinds() {
  static const std::vector<JointKind> kinds = table();
  return kinds;
}

const JointKind& kind_of(JointType type) {
  return joint_kinds().at(static_cast<std::size_t>(type));
}

int max_coordinates() {
  int count = 0;
  for (const JointKind& kind : joint_kinds()) count = std::max(count, kind.coordinate_count());
  return count;
}

}  // namespace liesl
