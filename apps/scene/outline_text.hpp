#pragma once
/// @file
/// Outlines as a scene writes them.

#include <string>
#include <vector>

#include "mbs/levelset/shape_spec.hpp"

namespace liesl {

/// What a scene calls the features, in the order of FeatureKind.
const std::vector<std::string>& feature_words();

/// The table [bodies.PART.solid.outline] as text that a scene may hold in the place of its own; it
/// is read back to the same numbers.
std::string outline_text(const std::string& part, const levelset::ShapeSpec& outline);

}  // namespace liesl
