#pragma once
/// @file
/// Section laws of a beam in the axes of a group of frames.

#include "mbs/bodies/law_derivative.hpp"
#include "mbs/sections/section_law.hpp"
#include "mbs/system/plane.hpp"

namespace liesl {

/// Laws of the elements of a beam, or their derivatives, from the section axes in space.
template <class G>
std::vector<ElementSection<G>> reduce_laws(const BeamSpec& beam,
                                           const std::vector<SectionLaw>& laws,
                                           const Space<G>& space) {
  std::vector<ElementSection<G>> reduced;
  for (size_t e = 0; e < laws.size(); ++e) {
    const SE3 align = space.alignment(beam.nodes[e]);
    reduced.push_back({space.reduce_law(laws[e].K, align), space.reduce_law(laws[e].M, align)});
  }
  return reduced;
}

}  // namespace liesl
