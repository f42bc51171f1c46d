#pragma once
/// @file
/// Scenes from TOML files.
///
///     const Scene scene = load_scene("slider_crank.toml", {"simulation.step=5e-5"});
///
/// Keys: docs/scene_reference.md.

#include <filesystem>
#include <string>
#include <vector>

#include "apps/input/problem.hpp"
#include "apps/scene/scene.hpp"

namespace liesl {

/// Reads a scene, with changes "key.path=value".
/// @throws InputError with every problem of the file
Scene load_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

/// The same from text; `file` is what messages call it.
Scene read_scene(const std::string& text, const std::string& file,
                 const std::vector<std::string>& overrides = {});

}  // namespace liesl
