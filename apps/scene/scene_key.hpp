#pragma once
/// @file
/// A number in a scene by its key path, as `--set` addresses it.

#include <string>
#include <vector>

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

}  // namespace liesl
