#pragma once
/// @file
/// From a file to a TOML table in which every value knows its place, and changes to it by key.

#include <filesystem>
#include <string>
#include <vector>

#include "apps/input/problem.hpp"
#include "apps/input/schema.hpp"

namespace liesl {

/// Larger files are refused.
inline constexpr std::uintmax_t kLargestFile = 16u << 20;

/// A parsed file. Move only in practice: copies of TOML nodes forget their places.
struct Document {
  std::string file;  ///< as given by the user, for messages
  std::string text;  ///< what was read
  toml::table root;
};

/// Reads and parses a file.
/// @throws InputError if it is missing, a directory, unreadable, huge, empty or not TOML
Document load_document(const std::filesystem::path& path);

/// The text of a file. @param expected what it should be, for messages
/// @throws InputError if it is missing, a directory, unreadable or huge
std::string load_text(const std::filesystem::path& path, const std::string& expected);

/// Parses text. @throws InputError if it is empty or not TOML (the parser stops at the first
/// error).
Document parse_document(std::string text, std::string file);

/// Applies changes "key.path=value" to a file of the given kind, before it is validated.
/// Values are TOML; words that are not are strings. Tables on the way are made as needed, but not
/// entries with names of the user. Entries of lists are addressed by their number.
void apply_overrides(toml::table& root, FileKind kind, const std::vector<std::string>& overrides,
                     Problems& problems);

/// A change of a scene, without the "scene." by which it is given with a study.
std::string without_scene(const std::string& text);

/// Which of the overrides given with a study are meant for its scene: those that begin with
/// "scene." and those whose first key only scenes have.
struct SplitOverrides {
  std::vector<std::string> study, scene;
};
SplitOverrides split_overrides(const std::vector<std::string>& overrides);

/// Moves the changes of the table `set` of a study (keys are paths of the scene) into the scene.
void apply_set(toml::table& set, toml::table& scene, Problems& problems);

/// A file with a key `by` is a sensitivity, one with a key `quantity` or `reference` is a
/// comparison, one with `grid`, `table`, `study` or `limits` is a batch, one with `scene`,
/// `design`, `objective`, `constraints` or `cycle` a study, unless it has `bodies`.
FileKind kind_of(const toml::table& root);

/// A file of another kind than a command reads has no key that could be reported.
/// @throws InputError with the problems so far and "this is a batch, not a study". A file that has
/// no key of any kind passes: what it lacks is reported.
void expect_kind(const toml::table& root, FileKind wanted, Problems& problems);

}  // namespace liesl
