#pragma once
/// @file
/// States that go with the geometry: what is known of the derivatives by a geometry beforehand.

#include <vector>

#include "mbs/sensitivity/state_sensitivity.hpp"
#include "mbs/system/parameter_residual.hpp"

namespace liesl {

/// The parameters, each on the model that is simulated: a column each.
template <FrameGroup G>
using Parameters = std::vector<ParameterResidual<G>>;

/// Is it a geometry with which the states of nodes can go (`NearbyModels::lift`)?
template <FrameGroup G>
bool lifted(const ParameterResidual<G>& parameter);
template <FrameGroup G>
bool any_lifted(const Parameters<G>& parameters);

/// What a state that goes with the geometry changes by: eta = xi, v' = ad(v) xi, a' = ad(a) xi, w'
/// = ad(vdot) xi at each node, a column each; zero of all other parameters. It obeys every relation
/// of a step, which are linear in these, since T^-1(dq) xi - T^-1(-dq) xi = ad(dq) xi. What is left
/// of the derivatives then has r_p and Phi_p of `add_lifted` for its right side: at constant frames
/// r_p is EA/L of a length, and round-off of what cancels it is 1e-8 of the accelerations.
/// Positions go with the first frame of their body, R_0 xi, which obeys the relations of a step but
/// for its error of integration: `StepSensitivity::lag`.
template <FrameGroup G>
StateSensitivity lift_of(const Model<G>& model, const Parameters<G>& parameters, const State<G>& s);

}  // namespace liesl
