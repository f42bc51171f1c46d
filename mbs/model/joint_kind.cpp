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
constexpr JointRow kAngle3 = JointRow::angle(1, 0, 0);  // about the third
constexpr JointRow kDistance = JointRow::distance();

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
      {Rod, "rod", "Massless rod: keeps the distance of the ports.", 0, {kDistance}, {}},
      {Cylinder,
       "cylinder",
       "Hydraulic cylinder, linear actuator: acts along the line between the ports, driven or with "
       "`stiffness`, `damping` and `force`. The coordinate is the change of their distance.",
       0,
       {},
       {kDistance},
       false,
       true},
      {Bushing,
       "bushing",
       "Springs and dampers, `stiffness` and `damping`, in all six directions: along `axis2`, "
       "`axis` x `axis2` and `axis` (by default x, y, z), and about the same. It acts at the place "
       "of the second port; angles are right for small ones (errors of their square).",
       2,
       {},
       {kY, kZ, kX, kAngle2, kAngle3, kAngle},
       false,
       true},
  };
}

}  // namespace

const char* JointKind::unit(int coordinate) const {
  const JointRow::Kind kind = coordinates.at(static_cast<std::size_t>(coordinate)).kind;
  const bool length = kind == JointRow::Kind::Displacement || kind == JointRow::Kind::Distance;
  return length ? "m" : "rad";
}

bool JointKind::acts_on_distance() const {
  const auto on_distance = [](const JointRow& row) { return row.kind == JointRow::Kind::Distance; };
  return std::any_of(constraints.begin(), constraints.end(), on_distance) ||
         std::any_of(coordinates.begin(), coordinates.end(), on_distance);
}

Eigen::Vector3d JointKind::free_part(const Eigen::Vector3d& axis,
                                     const Eigen::Vector3d& displacement) const {
  const auto held = [this](int m) {
    return std::any_of(constraints.begin(), constraints.end(), [m](const JointRow& row) {
      return row.kind == JointRow::Kind::Displacement && row.m == m;
    });
  };
  const Eigen::Vector3d along = axis * axis.dot(displacement);
  if (!held(0) && !held(1)) return displacement;
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
