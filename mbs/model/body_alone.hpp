#pragma once
/// @file
/// One body of a mechanism by itself, as its joints and springs hold it.

#include <vector>

#include "mbs/model/parameter.hpp"

namespace liesl {

/// What joins the body to another one joins it to the ground, at the place that it has in the scene
/// as given. Drives hold at 0. Without loads, gears, weight and velocities.
struct BodyAlone {
  Mechanism mechanism;      ///< its one body has the number 0
  int body = 0;             ///< its number in the whole
  std::vector<int> forces;  ///< by number in `mechanism`: that in the whole
};

/// @throws std::invalid_argument for a body that does not exist
BodyAlone body_alone(const Mechanism& whole, int body);

/// A parameter of the whole as one of the body alone: section laws, inertia, fractions of the body
/// and forces on it. What else it changes is left out.
Parameter parameter_alone(const Parameter& whole, const BodyAlone& alone);

}  // namespace liesl
