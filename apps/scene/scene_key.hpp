#pragma once
/// @file
/// A number in a scene by its key path, as `--set` addresses it; keys that name other files.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "apps/input/problem.hpp"

namespace liesl {

struct SceneNumber {
  double value = 0;
  std::string unit;  ///< as the reference gives it
};

/// A scene as it was written, with changes "key=value" to it.
struct SceneText {
  std::string text, file;
  std::vector<std::string> changes;
};

/// The number at "sections.rod.diameter" or "loads.push.force.1", after the changes.
/// @throws InputError if there is no such key, or no number written there
SceneNumber number_at(const SceneText& scene, const std::string& key);

/// Calls `found` with the path of each key that names a file, and its value.
void for_each_file(toml::table& scene,
                   const std::function<void(const std::string&, toml::value<std::string>&)>& found);

/// A file named in a scene as a whole path, that holds in any folder. @param scene its file
std::string whole_path(const std::filesystem::path& scene, const std::string& named);

/// Changes "key.path=value" that make the files named in a scene, with the changes `overrides`,
/// whole paths. @param scene its file  @throws InputError if the text is not TOML
std::vector<std::string> whole_paths(const std::string& text, const std::string& scene,
                                     const std::vector<std::string>& overrides);

}  // namespace liesl
