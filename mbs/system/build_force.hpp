#pragma once
/// @file
/// Springs, dampers and actuators.

#include "mbs/system/build_port.hpp"

namespace liesl {

/// Gives an equation the law of force number `index`, and the role that goes with it.
template <FrameGroup G>
void set_force(CouplingRow<G>& equation, const ForceSpec& force, int index) {
  equation.force = index;
  equation.law = {force.stiffness, force.damping, force.rest, force.force, force.curve};
  const bool actuator = force.stiffness == 0 && force.damping == 0 && !force.curve;
  equation.role = actuator ? Role::Actuator : Role::Compliant;
}

/// Force number `index` of the mechanism, between two ports.
template <FrameGroup G>
Coupling<G> build_force(const Mechanism& mechanism, int index, const Ports<G>& ports) {
  const ForceSpec& force = mechanism.forces[static_cast<std::size_t>(index)];
  Coupling<G> c;
  c.name = force.name;
  c.is_joint = false;
  c.a = ports.of(force.a);
  c.b = ports.of(force.b);
  c.rows.push_back({Row<G>::distance(), Role::Constraint, TimeFunction(), {}, 0});
  set_force(c.rows.front(), force, index);
  return c;
}

}  // namespace liesl
