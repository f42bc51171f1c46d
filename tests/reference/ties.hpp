#pragma once
/// @file
/// Interfaces of meshed parts, rigid or averaged.

#include <memory>
#include <utility>

#include "mbs/solids/solid_model.hpp"

namespace liesl::test {

/// The same mesh with all its interfaces tied in another way.
inline std::shared_ptr<const SolidModel> with_ties(const SolidModel& m, Tie tie) {
  auto interfaces = m.interfaces();
  for (Interface& f : interfaces) f.tie = tie;
  return std::make_shared<const SolidModel>(m.mesh(), m.material(), std::move(interfaces),
                                            SolidModel::Options{m.thickness(), m.law()});
}

}  // namespace liesl::test
