#pragma once
/// @file
/// Quantities that a scene names and a study limits; what they mean, not how they are computed.

#include <optional>
#include <string>
#include <vector>

#include "mbs/model/element_place.hpp"
#include "mbs/model/mechanism.hpp"

namespace liesl {

/// In whose axes the components of a vector, and `axis`, are.
enum class Axes { Inertial, Body };

/// What of a signed response y is taken: y itself, or one side of it, max(y, 0) or max(-y, 0),
/// which a limit then holds alone.
enum class Side { Both, Up, Down };

/// docs/responses.md has the formulas.
enum class ResponseKind {
  Position,         ///< of port `at`, inertial, m; along `axis` if given
  Velocity,         ///< of port `at`, m/s, in `in`: inertial or the port's axes; along `axis`
  AngularVelocity,  ///< of port `at`, rad/s, in `in`; along `axis`
  Rotation,       ///< of port `at` since the scene as given, rotation vector of at most pi, rad; in
                  ///< `in`: inertial or the port's axes; along `axis`
  Displacement,   ///< of port `at` seen from node 0 of its body, minus its undeformed value, m;
                  ///< in `in`: inertial or the axes of node 0; along `axis`
  Deflection,     ///< offset of a beam's point from the chord start-end, minus its undeformed
                  ///< value, m; signed in a planar scene, two components (y, z) in space
  Elongation,     ///< change of the distance of the ports `at` and `to` (of a beam: its ends), m
  Coordinate,     ///< of a joint, m or rad
  JointForce,     ///< that the joint transmits to its port b, N: norm, or along `axis`, in `in`
  DriveForce,     ///< force or torque of the drive on `coordinate` of a joint, N or N m; it does
                  ///< positive work where the coordinate grows
  SectionForce,   ///< `component` of [N, Vy, Vz, Mx, My, Mz] at `place` of one element, N or N m
  Stress,         ///< largest von Mises stress, Pa: of a beam over both ends of its elements, or at
                  ///< a `point`; of a meshed part over its cells, v^(1/2) of that of the material
                  ///< at the centre, v the fraction
  Energy,         ///< kinetic + elastic (springs, too) + potential, J
  Compliance,     ///< twice the elastic energy of a beam or part: load times displacement, J
  AxialStress,    ///< N/A of a beam, tension positive, of the element where it is largest, Pa
  Buckling,       ///< compressive force of a beam over its Euler load, the largest; 0 in tension
  LocalBuckling,  ///< largest compressive stress of a section over that of its wall
  Translation,    ///< of port `at` since the scene as given, inertial, m; along `axis`
  Acceleration,   ///< of port `at`, m/s^2, in `in`; along `axis`
  AngularAcceleration  ///< of port `at`, rad/s^2, in `in`; along `axis`
};

struct ResponseSpec {
  std::string name;
  ResponseKind kind = ResponseKind::Position;
  Port at;        ///< of the kinds of a port, Displacement and Elongation
  Port to;        ///< Elongation
  int body = -1;  ///< Deflection and from SectionForce on but Energy; Elongation: of both ports, -1
                  ///< if they are of two bodies
  double s = 0.5;  ///< Deflection: place on the beam by node number / n, in [0, 1];
                   ///< `everywhere` = largest over the nodes
  bool everywhere = false;
  int element = 0;                           ///< SectionForce; Stress at one `point`
  ElementPlace place = ElementPlace::First;  ///< SectionForce
  /// Stress: a stress point of `element`, counted over its first end, then its last; -1 = largest
  int point = -1;
  int component = 0;         ///< SectionForce, 0..5
  double factor = 1;         ///< Buckling: K of the buckling length K L; LocalBuckling: knock-down
  int joint = -1;            ///< Coordinate, JointForce, DriveForce
  int coordinate = 0;        ///< Coordinate, DriveForce
  std::optional<Vec3> axis;  ///< unit
  Axes in = Axes::Body;      ///< of vectors but Position and Translation; JointForce
  Side side = Side::Both;    ///< of responses with one component
};

/// Body whose deformation a response measures; -1: none, or several.
inline int deformed_body(const ResponseSpec& r) {
  return r.kind == ResponseKind::Displacement ? r.at.body : r.body;
}

}  // namespace liesl
