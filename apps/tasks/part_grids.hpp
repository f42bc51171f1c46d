#pragma once
/// @file
/// Grids of meshed parts, as a verification refines them.

#include <string>
#include <vector>

#include "apps/scene/scene.hpp"
#include "apps/scene/scene_key.hpp"

namespace liesl {

struct PartGrid {
  std::string name;         ///< of the body
  std::vector<long> cells;  ///< in each direction; empty: its mesh is from a file
  /// Of the error of what it deforms: 2, with an outline through its cells 1.
  int order = 2;

  /// For twice the cells in each direction?
  bool has_room() const;
};

/// Of the meshed parts of a scene, in their order. @param text what it was read from
std::vector<PartGrid> part_grids(const SceneText& text, const Mechanism& mechanism);

/// "key.path=value" that gives grids `factor` times their cells in each direction (whole, or 0.5);
/// empty where one of them cannot be halved.
std::vector<std::string> grid_changes(const std::vector<PartGrid>& grids, double factor);

}  // namespace liesl
