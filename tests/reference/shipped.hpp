#pragma once
/// @file
/// Shipped scenes and studies: what the tests of sizing work on.

#include <filesystem>
#include <string>
#include <vector>

#include "apps/scene/load_scene.hpp"
#include "apps/study/load_study.hpp"
#include "apps/study/study.hpp"
#include "mbs/motion.hpp"
#include "reference/places.hpp"

namespace liesl::test {

using Changes = std::vector<std::string>;  ///< key.path=value

inline Scene shipped_scene(const std::string& name, const Changes& changes = {}) {
  return load_scene(std::filesystem::path(kDataDir) / "scenes" / (name + ".toml"), changes);
}

inline Study shipped_study(const std::string& name, const Changes& changes = {}) {
  return load_study(std::filesystem::path(kDataDir) / "studies" / (name + ".toml"), changes);
}

/// Of data/stability, where methods fail.
inline Study stability_study(const std::string& name, const Changes& changes = {}) {
  const auto folder = std::filesystem::path(kDataDir) / "stability" / "studies";
  return load_study(folder / (name + ".toml"), changes);
}

}  // namespace liesl::test
