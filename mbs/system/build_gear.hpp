#pragma once
/// @file
/// Gears: a constraint between coordinates of two joints.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mbs/system/model.hpp"

namespace liesl {

/// A coordinate of a joint as the one constraint of a coupling.
/// @throws std::invalid_argument if the joint has no such coordinate in this space
template <FrameGroup G>
Coupling<G> gear_side(const Mechanism& mechanism, const Model<G>& model, const GearSpec& gear,
                      const GearSpec::Coordinate& of, double factor) {
  const std::string& joint = mechanism.joints.at(static_cast<std::size_t>(of.joint)).name;
  for (const Coupling<G>& c : model.couplings) {
    if (!c.is_joint || c.name != joint) continue;
    for (const CouplingRow<G>& row : c.rows)
      if (row.coordinate == of.coordinate) {
        Coupling<G> side;
        side.name = gear.name;
        side.a = c.a;
        side.b = c.b;
        side.is_joint = false;
        side.rows.push_back(
            {row.row.scaled(factor), Role::Constraint, TimeFunction(), {}, -1, -1, -1});
        return side;
      }
  }
  throw std::invalid_argument(fmt::format("gear '{}': joint '{}' has no coordinate {} here",
                                          gear.name, joint, of.coordinate));
}

/// q_second - ratio q_first = 0, as two couplings with one multiplier. With a ratio above 1 the
/// equation is divided by it, so that neither side outweighs the other.
/// @throws std::invalid_argument for a ratio of 0, or coordinates that are not there
template <FrameGroup G>
void build_gear(const Mechanism& mechanism, const GearSpec& gear, Model<G>& model) {
  if (gear.ratio == 0 || !std::isfinite(gear.ratio))
    throw std::invalid_argument(fmt::format("gear '{}': expected a ratio other than 0", gear.name));
  const double scale = std::max(1., std::abs(gear.ratio));
  Coupling<G> first = gear_side(mechanism, model, gear, gear.first, -gear.ratio / scale);
  Coupling<G> second = gear_side(mechanism, model, gear, gear.second, 1 / scale);
  second.continued = true;
  model.couplings.push_back(std::move(first));
  model.couplings.push_back(std::move(second));
}

}  // namespace liesl
