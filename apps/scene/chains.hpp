#pragma once
/// @file
/// Beams of a scene that are chains of segments.

#include "apps/scene/reader.hpp"

namespace liesl {

/// The beam of a body that is a chain of segments, null if it is none. @param body -1: the ground
inline const BeamSpec* chain_of(const Mechanism& m, int body) {
  if (body < 0) return nullptr;
  const auto* beam = std::get_if<BeamSpec>(&m.bodies[static_cast<std::size_t>(body)].kind);
  return beam && model_of(*beam, m.formalism) == BeamModel::Segments ? beam : nullptr;
}

/// Refuses an entry of a top-level table.
inline void refuse_chain(Reader& reader, const char* group, const std::string& name,
                         const std::string& what, const std::string& expected) {
  const auto at = reader.root[group][name];
  reader.problems.add(at.node() ? *at.node() : static_cast<const toml::node&>(reader.root), what,
                      expected, "formalism se3 has it");
}

/// What a chain in space cannot do, which has no torsion, is refused.
void check_chains_in_space(Reader& reader);

}  // namespace liesl
