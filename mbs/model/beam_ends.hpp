#pragma once
/// @file
/// Sections at the ends of beam elements and their stress points: those of a taper, else the
/// element's.

#include <string_view>
#include <vector>

#include "mbs/model/element_place.hpp"
#include "mbs/model/mechanism.hpp"
#include "mbs/sections/stress.hpp"

namespace liesl {

/// The section of element e at its first or last node, in its middle that of the element.
const Section& section_at(const BeamSpec& beam, std::size_t e, ElementPlace place);

/// Does the dimension `name`, or any, differ between both ends of an element?
bool tapers(const BeamSpec& beam, std::string_view name);
bool tapers(const BeamSpec& beam);

/// Points where the stress of element e can be largest: those of the section at its first node,
/// then those at its last, as many.
std::vector<StressPoint> element_stress_points(const BeamSpec& beam, std::size_t e);

/// d S / d dimension at the same points, if the dimension changes alike along the element.
/// @throws std::invalid_argument for an unknown name
std::vector<Eigen::Matrix<double, 3, 6>> element_stress_derivative(const BeamSpec& beam,
                                                                   std::size_t e,
                                                                   std::string_view dimension);

}  // namespace liesl
