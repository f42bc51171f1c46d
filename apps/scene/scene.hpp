#pragma once
/// @file
/// Scenes: from a TOML file to a mechanism, what to compute and what to report.
///
///     const Scene scene = load_scene("slider_crank.toml", {"simulation.step=5e-5"});
///
/// Keys: docs/scene_reference.md.

#include <filesystem>
#include <string>
#include <vector>

#include "apps/input/document.hpp"
#include "mbs/model/mechanism.hpp"
#include "mbs/model/response.hpp"
#include "mbs/solvers/options.hpp"

namespace liesl {

struct Scene {
  Mechanism mechanism;
  SimulationOptions simulation;
  std::vector<ResponseSpec> responses;
  std::vector<std::string> warnings;  ///< what is accepted but looks like a mistake
  std::string file;                   ///< where it was read
  std::string input;                  ///< the file's text and the overrides, for the input's hash
};

/// Reads a scene, with changes "key.path=value".
/// @throws InputError with every problem of the file
Scene load_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

/// The same from text; `file` is what messages call it.
Scene read_scene(const std::string& text, const std::string& file,
                 const std::vector<std::string>& overrides = {});

}  // namespace liesl
