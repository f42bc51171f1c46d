#pragma once
/// @file
/// Quantities that a scene names and a study limits; what they mean, not how they are computed.

#include <optional>
#include <string>
#include <vector>

#include "mbs/model/mechanism.hpp"

namespace liesl {

enum class ResponseKind {
  Position,         ///< of port `at`, inertial, m; along `axis` if given
  Velocity,         ///< of port `at`, inertial, m/s; along `axis` if given
  AngularVelocity,  ///< of port `at`, local frame, rad/s; along `axis` (local) if given
  Displacement,     ///< of port `at` seen from node 0 of its body, minus its undeformed value, m;
                    ///< local axes of node 0; along `axis` (in those axes) if given
  Deflection,       ///< offset of a beam's point from the chord start-end, minus its undeformed
                    ///< value, m; signed in a planar scene, two components (y, z) in space
  Elongation,       ///< change of the distance of the ports `at` and `to` (of a beam: its ends), m
  Coordinate,       ///< of a joint, m or rad
  JointForce,    ///< force that the joint transmits to its port b, in b's axes, N; norm over parts
  SectionForce,  ///< `component` of [N, Vy, Vz, Mx, My, Mz] in one element, N or N m
  Stress,        ///< von Mises stress of a beam, largest over its elements or at a `point`, Pa
  Energy,        ///< kinetic + elastic (springs, too) + potential, J
  Compliance     ///< twice the elastic energy of a beam: load times displacement, J
};

struct ResponseSpec {
  std::string name;
  ResponseKind kind = ResponseKind::Position;
  Port at;         ///< Position, Velocity, AngularVelocity, Displacement, Elongation
  Port to;         ///< Elongation
  int body = -1;   ///< Deflection, SectionForce, Stress, Compliance; Elongation: of both ports, -1
                   ///< if they are of two bodies
  double s = 0.5;  ///< Deflection: place on the beam by node number / n, in [0, 1];
                   ///< `everywhere` = largest over the nodes
  bool everywhere = false;
  int element = 0;           ///< SectionForce; Stress at one `point`
  int point = -1;            ///< Stress: a stress point of `element`; -1 = largest over all
  int component = 0;         ///< SectionForce, 0..5
  int joint = -1;            ///< Coordinate, JointForce
  int coordinate = 0;        ///< Coordinate
  std::optional<Vec3> axis;  ///< unit
};

}  // namespace liesl
