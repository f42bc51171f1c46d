#pragma once
/// @file
/// Planar or spatial: what a scene asks for, and what it allows.

#include <string>
#include <variant>

#include "apps/scene/scene.hpp"
#include "mbs/system/plane.hpp"

namespace liesl {

/// Where a scene is computed, and why.
struct ChosenSpace {
  std::variant<Space<SE2>, Space<SE3>> space;
  std::string name;  ///< "planar" or "spatial"
  std::string reason;
};
/// @throws InputError if the scene asks for "planar" and leaves the plane
ChosenSpace choose_space(const Scene& scene);

}  // namespace liesl
