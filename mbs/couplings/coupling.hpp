#pragma once
/// @file
/// Couplings between two ports: joints with their drives, springs, dampers, actuators.

#include <optional>
#include <string>
#include <vector>

#include "mbs/couplings/rows.hpp"
#include "mbs/model/force_curve.hpp"
#include "mbs/model/time_function.hpp"

namespace liesl {

/// A frame rigidly tied to a node: H_node * offset; the ground if body < 0.
template <FrameGroup G>
struct PortOf {
  int body = -1;                                 ///< index of the body, -1 = ground
  int node = 0;                                  ///< global node number (unused on the ground)
  int slot = 0;                                  ///< which of the body's coupled nodes it is
  G offset = G::identity();                      ///< on the ground the frame itself
  bool at_node = true;                           ///< offset is the identity
  typename G::Matrix J = G::Matrix::Identity();  ///< port increment = J node increment

  static PortOf ground(const G& frame) {
    PortOf p;
    p.offset = frame;
    return p;
  }
  static PortOf on(int body, int node, const G& offset) {
    PortOf p;
    p.body = body;
    p.node = node;
    p.offset = offset;
    p.at_node = G::log(offset).norm() == 0;
    p.J = offset.AdInv();
    return p;
  }
  template <class FrameList>
  G frame(const FrameList& H) const {
    return body < 0 ? offset : at_node ? H[node] : H[node] * offset;
  }
};

/// f = stiffness (q - rest) + curve(q - rest) + damping dq/dt - force(t).
struct ForceLaw {
  double stiffness = 0, damping = 0, rest = 0;
  TimeFunction force;
  std::optional<ForceCurve> curve = {};

  /// Force of the spring, its derivative by q, and its energy, at q.
  double elastic(double q) const {
    const double x = q - rest;
    return curve ? stiffness * x + (*curve)(x) : stiffness * x;
  }
  double slope(double q) const { return curve ? stiffness + curve->slope(q - rest) : stiffness; }
  double energy(double q) const {
    const double x = q - rest;
    return 0.5 * stiffness * x * x + (curve ? curve->energy(x) : 0);
  }
};

/// What a row is for, in the order in which a coupling keeps its rows.
enum class Role {
  Constraint,  ///< row = target(t), with a multiplier
  Compliant,   ///< force law with stiffness or damping
  Actuator,    ///< force law without
  Redundant,   ///< constraint that repeats others; only watched
  Observed     ///< joint coordinate that nothing acts on
};

template <FrameGroup G>
struct CouplingRow {
  Row<G> row;
  Role role = Role::Constraint;
  TimeFunction target;  ///< constraint: row = target(t)
  ForceLaw law;         ///< force
  int coordinate = -1;  ///< number of the joint coordinate that this row is, -1 = none
  int force = -1;       ///< number in Mechanism::forces of its law, -1 = none
  int drive = -1;       ///< number in Mechanism::drives of its target, -1 = none
};

/// A joint or a force element: the rows between port a and port b.
template <FrameGroup G>
struct Coupling {
  std::string name;
  PortOf<G> a, b;
  std::vector<CouplingRow<G>> rows;  ///< sorted by role
  int first_row = 0;                 ///< in State::rows
  int first_constraint = 0;          ///< in State::lambda
  int constraints = 0;               ///< rows with a multiplier
  int active = 0;                    ///< those and the compliant ones: rows of the joint system
  int acting = 0;                    ///< those and the actuators
  bool is_joint = true;
  /// Its one constraint is that of the coupling before it, of whose row and its own it holds the
  /// sum: both have the same multiplier. (A gear: coordinates of two joints.)
  bool continued = false;
};

}  // namespace liesl
