#pragma once
/// @file
/// Mechanisms whose beams are chains of segments, of every kind.

#include "mbs/model/mechanism.hpp"

namespace liesl::test {

inline Mechanism segments(Mechanism m, SegmentSpec spec = {}) {
  m.formalism = Formalism::Segments;
  for (auto& body : m.bodies)
    if (auto* beam = std::get_if<BeamSpec>(&body.kind)) beam->segment = spec;
  return m;
}

inline constexpr SegmentSpec kKinds[] = {{AxialPotential::Linear, false},
                                         {AxialPotential::Linear, true},
                                         {AxialPotential::NeoHookean, false}};

}  // namespace liesl::test
