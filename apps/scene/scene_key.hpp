#pragma once
/// @file
/// A number in a scene by its key path, as `--set` addresses it.

#include <filesystem>
#include <string>
#include <vector>

namespace liesl {

struct SceneNumber {
  double value = 0;
  std::string unit;  ///< as the reference gives it
};

/// The number at "sections.rod.diameter" or "loads.push.force.1", after the changes "key=value".
/// @throws InputError if there is no such key, or no number written there
SceneNumber number_at(const std::filesystem::path& scene, const std::vector<std::string>& changes,
                      const std::string& key);

}  // namespace liesl
