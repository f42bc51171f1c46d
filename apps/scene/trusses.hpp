#pragma once
/// @file
/// Trusses of a scene as the bars and joints that they are made of.

#include <map>
#include <string>
#include <vector>

#include "apps/input/problem.hpp"
#include "apps/input/validate.hpp"

namespace liesl {

/// What a scene and its studies call the parts of its trusses.
struct TrussNames {
  /// Bars of a truss, "T", and of a group of its bars, "T.chord".
  std::map<std::string, std::vector<std::string>> bars;
  /// Port of a node, "T.n1" -> "T_chord1.end".
  std::map<std::string, std::string> nodes;
  bool any() const { return !bars.empty(); }
};

/// Replaces every body with a `truss` by its bars: beams T_GROUPk of one element, k from 1 in each
/// group, and joints T_jN. At a node all bars meet in a spherical joint with the first of them, or
/// with the ground; one joint of each bar is universal, in a tree from the held nodes, so that no
/// bar spins about its axis. Joints without moments: each bar carries a normal force alone.
/// @param root a scene with the defaults of the schema, or without them
/// @param broken entries that are left as they are
TrussNames expand_trusses(toml::table& root, const Broken& broken, Problems& problems);

}  // namespace liesl
