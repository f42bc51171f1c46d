#pragma once
/// @file
/// Reference frames of beam nodes from geometry: straight lines, circular arcs, splines.
///
/// x of a frame is the tangent, y and z are the section axes. Where the scene does not prescribe
/// how the section is turned (`Orientation::up` is zero), the rule is:
///   straight, spline (at its start): z = the part of the global Z normal to the tangent; if the
///     tangent is parallel to Z, z = the global Y. For a beam in the plane of global x and y: y
///     lies in that plane, z = global Z.
///   arc: z = the arc's normal, the one of the two that points along +Z; if both are normal to Z
///     along +Y, and if normal to both along +X. For an arc in the plane of x and y: z = global Z.

#include <Eigen/Core>
#include <vector>

#include "liegroup/se3.hpp"

namespace liesl {

/// How the section is turned about the axis of the beam.
struct Orientation {
  /// Fixes the section's y axis at the start: y = the part of `up` normal to the tangent,
  /// normalised. Zero: the rule above.
  Eigen::Vector3d up = Eigen::Vector3d::Zero();
  /// Further rotation about the axis, rad, from 0 at the start to this at the end, linear in the
  /// arc length; positive about +x (right-handed).
  double pre_twist = 0;
};

/// R = [x y z] with x along `tangent` (any length) and y, z by `up` or the rule for straight beams.
/// @throws std::invalid_argument if the tangent is zero or `up` is parallel to it
Eigen::Matrix3d section_axes(const Eigen::Vector3d& tangent,
                             const Eigen::Vector3d& up = Eigen::Vector3d::Zero());

/// n + 1 frames on the line from -> to, equally spaced.
/// @throws std::invalid_argument if n < 1, the ends coincide, or an element twists by pi or more
std::vector<SE3> straight(const Eigen::Vector3d& from, const Eigen::Vector3d& to, int n,
                          const Orientation& orientation = {});

/// Circular arc that starts at `from` along `tangent` and turns by `angle` towards `centre`.
struct Arc {
  Eigen::Vector3d from, tangent, centre;
  double angle = 0;  ///< rad, in (0, 2 pi]

  /// By radius and the normal about which the arc turns to the left (right-hand rule).
  static Arc with_radius(const Eigen::Vector3d& from, const Eigen::Vector3d& tangent,
                         const Eigen::Vector3d& normal, double radius, double angle);
  /// From a through b to c. @throws std::invalid_argument if they lie on a line
  static Arc through(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);
};

/// n + 1 frames on an arc, equally spaced. Without pre-twist an element of length L along the arc
/// has the exact d0 = log(H_A^-1 H_B) = [L 0 0, kappa L R_0^T n] (constant curvature kappa =
/// 1/radius about the normal n of the turn): [L 0 0, 0 0 +-kappa L] where z = +-n.
/// @throws std::invalid_argument for a tangent that is not normal to centre - from, an angle
/// outside (0, 2 pi], n < 1, or an element that turns by pi or more
std::vector<SE3> arc(const Arc& arc, int n, const Orientation& orientation = {});

/// n + 1 frames on the C2 cubic spline through the points, equally spaced by arc length, which turn
/// about the tangent as little as possible. Parameter: chord length; ends: not-a-knot (two points
/// make a line, three a parabola). In a plane the normal of the plane stays fixed in the section.
/// @throws std::invalid_argument for less than two points, neighbours that coincide, n < 1, or an
/// element that turns by pi or more
std::vector<SE3> spline(const std::vector<Eigen::Vector3d>& points, int n,
                        const Orientation& orientation = {});

}  // namespace liesl
