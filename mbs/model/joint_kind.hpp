#pragma once
/// @file
/// Kinds of joints as a table: rows that constrain, coordinates that remain. Everything that
/// depends on the kind of a joint reads it: the equations, the search for a plane, units of
/// responses, the reader and the reference of scenes. A new kind is a value of `JointType` and a
/// row of the table in joint_kind.cpp (docs/extending.md).

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace liesl {

/// Joints by the relative motion they leave (a subgroup of SE(3), but for the universal joint).
enum class JointType {
  Fixed,        ///< none
  Revolute,     ///< angle about `axis`
  Prismatic,    ///< displacement along `axis`
  Cylindrical,  ///< displacement and angle
  Spherical,    ///< all rotations
  Universal,    ///< angle about `axis` (of a), angle about `axis2` (of b)
  Planar,       ///< two displacements normal to `axis`, angle about it
  Screw,        ///< angle about `axis`, displacement along it in proportion
  Rod,          ///< all motions that keep the distance of the ports
  Cylinder,     ///< all; its coordinate is the change of the distance of the ports
  Bushing       ///< all six; springs and dampers act on its coordinates
};

/// One scalar row of a joint, by the numbers 0, 1, 2 of the joint's axes e: the first is `axis`,
/// the second `axis2` or any normal to the first, the third completes them. R, p: relative motion
/// of the ports (mbs/couplings/rows.hpp).
struct JointRow {
  enum class Kind {
    Displacement,   ///< e_m . p
    Perpendicular,  ///< e_m . R e_n
    Angle,          ///< atan2(e_m . R e_n, e_k . R e_k)
    Screw,          ///< e_k . p - pitch / (2 pi) times the angle about e_k
    Distance        ///< |p| less its value in the scene as given
  };
  Kind kind = Kind::Displacement;
  int m = 0, n = 0, k = 0;

  static constexpr JointRow displacement(int m) { return {Kind::Displacement, m, 0, 0}; }
  static constexpr JointRow perpendicular(int m, int n) { return {Kind::Perpendicular, m, n, 0}; }
  static constexpr JointRow angle(int m, int n, int k) { return {Kind::Angle, m, n, k}; }
  static constexpr JointRow screw(int k) { return {Kind::Screw, 0, 0, k}; }
  static constexpr JointRow distance() { return {Kind::Distance, 0, 0, 0}; }
  /// Number of the axis that an angle is about.
  int about() const { return kind == Kind::Angle ? 3 - m - n : k; }
};

/// Row of the table.
struct JointKind {
  JointType type;
  std::string_view name;              ///< key of scenes: "revolute"
  std::string_view motion;            ///< what it leaves, for the reference of scenes
  int axes;                           ///< that a scene gives: 0, 1 (axis), 2 (axis, axis2)
  std::vector<JointRow> constraints;  ///< with a multiplier each
  std::vector<JointRow> coordinates;  ///< zero in the scene as given
  bool pitch = false;                 ///< needs `JointSpec::pitch`
  bool elastic = false;  ///< may have springs and dampers of its own on its coordinates

  int coordinate_count() const { return static_cast<int>(coordinates.size()); }
  /// "m" or "rad". @pre 0 <= coordinate < coordinate_count()
  const char* unit(int coordinate) const;
  /// The part of a displacement from port a to port b, at angle zero, that the joint allows, m.
  Eigen::Vector3d free_part(const Eigen::Vector3d& axis, const Eigen::Vector3d& displacement) const;
  /// Do its ports stay where they are, apart from each other, since it acts on their distance?
  bool acts_on_distance() const;
  /// Names the coordinates with their units: "Coordinate 0: angle (rad)."
  std::string coordinates_text() const;
};

/// All kinds, in the order of `JointType`.
const std::vector<JointKind>& joint_kinds();
const JointKind& kind_of(JointType type);
/// The largest number of coordinates that a joint has.
int max_coordinates();

}  // namespace liesl
