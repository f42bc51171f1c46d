#pragma once
/// @file
/// What makes a shape, a section or a material impossible.

#include <string>

#include "mbs/sections/section.hpp"

namespace liesl {

/// What is wrong with the shape as a piece of matter (empty = nothing): non-positive lengths,
/// walls that meet, indefinite matrices. One sentence: expected, got, hint.
std::string what_is_wrong(const Shape& shape);

/// The same for a section: its shape, shear factors and torsion constant.
std::string what_is_wrong(const Section& section);

/// The same for a material: E > 0, -1 < nu <= 0.5, rho > 0.
std::string what_is_wrong(const Material& material);

}  // namespace liesl
