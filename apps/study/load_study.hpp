#pragma once
/// @file
/// Studies from TOML files.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "apps/input/problem.hpp"
#include "apps/study/study.hpp"

namespace liesl {

/// Reads a study and its scene, with changes "key.path=value" to either (see split_overrides).
/// @throws InputError with every problem of both files
Study load_study(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

/// The same from text. The scene is looked for relative to `folder`.
Study read_study(const std::string& text, const std::string& file,
                 const std::filesystem::path& folder,
                 const std::vector<std::string>& overrides = {});

/// What is wrong with the path of a key, as it may be changed in a study or scene and, of a study,
/// in its scene; empty if it leads to a key. Values are not looked at.
/// @throws InputError if a file cannot be read
std::optional<InputProblem> key_problem(const std::filesystem::path& path, const std::string& key);

}  // namespace liesl
