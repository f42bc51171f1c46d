#pragma once
/// @file
/// A parameter of a mechanism from the mechanism at neighbouring values of it.

#include <functional>

#include "mbs/model/parameter.hpp"
#include "mbs/solvers/options.hpp"

namespace liesl {

/// d/dp by central differences of fourth order of the *data* (moduli, dimensions, masses, tables):
/// exact to round-off for what is proportional to p, as nearly all of it is. The derivatives of the
/// equations by the data are analytic. Where something else changes, geometry above all, the
/// parameter is `NearbyMechanisms`, of which the equations themselves are differenced.
/// @param at the mechanism at p  @param changed that at p + change  @param step of the differences
/// @param simulation whose steps tell whether a function of time changes
/// @throws std::invalid_argument if the unknowns change (bodies, elements, joints), a mesh, or
/// nothing
Parameter parameter_of(const std::string& name, const Mechanism& at,
                       const std::function<Mechanism(double change)>& changed, double step,
                       const SimulationOptions& simulation);

}  // namespace liesl
