#pragma once
/// @file
/// Shipped studies that ctest has solved: the fixture study.NAME of tests/CMakeLists.txt writes
/// each into a folder once; what its status and limits must be is asserted by study.NAME.end.

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace liesl::test {

extern const char* const
    kSolvedDir;  ///< of all studies (defined in a source that the build generates)

/// Results of `liesl optimize` of a study as shipped.
/// @throws std::runtime_error if it has not been solved
inline std::filesystem::path solved_folder(const std::string& name) {
  const auto folder = std::filesystem::path(kSolvedDir) / name;
  if (!std::filesystem::exists(folder / "summary.json"))
    throw std::runtime_error(folder.string() +
                             " holds no results, expected those of the fixture: " +
                             "ctest --test-dir build/release -R '^study." + name + "$'");
  return folder;
}

/// Its summary.json.
inline nlohmann::json solved_summary(const std::string& name) {
  std::ifstream in(solved_folder(name) / "summary.json");
  return nlohmann::json::parse(in);
}

}  // namespace liesl::test
