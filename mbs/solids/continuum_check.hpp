#pragma once
/// @file
/// Can all nodes of a meshed part move? Asked before it is built.

#include <optional>
#include <string>

#include "mbs/solids/solid_spec.hpp"

namespace liesl {

/// What of a part cannot be simulated as a continuum.
struct ContinuumProblem {
  std::string key;  ///< of the part: "material", "outline", "mesh", "interfaces.NAME"
  std::string text, expected;
  std::string hint = {};
};

/// An incompressible material, a mesh in pieces, an outline that leaves pieces; the first that
/// is found.
std::optional<ContinuumProblem> continuum_problem(const SolidSpec& spec);

}  // namespace liesl
