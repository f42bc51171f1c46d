#pragma once
/// @file
/// Reads what `liesl sensitivity` differentiates, and by what.

#include <filesystem>
#include <string>
#include <vector>

#include "apps/scene/scene_key.hpp"
#include "apps/tasks/sensitivity_problem.hpp"

namespace liesl {

/// A file of the kind "sensitivity".
struct SensitivityFile {
  std::string name;
  std::string input;  ///< text of the file and the scene and the changes, for the input's hash
  SceneText scene;
  std::vector<std::string> by;  ///< keys of the scene
  SensitivityRequest request;
};

/// @param changes "key=value" of the file, then of the scene  @throws InputError with all problems
SensitivityFile load_sensitivity(const std::filesystem::path& path,
                                 const std::vector<std::string>& changes);

/// "peak", "p=8"; those of the command line and of files. @param where it was written, for messages
/// @throws InputError for words that are none; all four without a parameter if there are no words
std::vector<FunctionalSpec> functionals_of(const std::vector<std::string>& words,
                                           const std::string& where);

/// @param where they were written, for messages
/// @throws InputError for a time that is not within the motion
void require_times(const std::vector<FunctionalSpec>& functionals, double duration,
                   const std::string& where);

SensitivityMethod method_of(const std::string& word);

}  // namespace liesl
