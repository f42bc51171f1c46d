#pragma once
/// @file
/// A scene as a file that studies name, removed in the end.

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace liesl::test {

class SceneFile {
 public:
  explicit SceneFile(const std::string& text) { std::ofstream(path_) << text; }
  ~SceneFile() { std::filesystem::remove(path_); }
  SceneFile(const SceneFile&) = delete;
  SceneFile& operator=(const SceneFile&) = delete;

  std::string path() const { return path_.string(); }

 private:
  static inline int count_ = 0;
  const std::filesystem::path path_ =
      std::filesystem::temp_directory_path() /
      ("liesl_scene_" + std::to_string(::getpid()) + "_" + std::to_string(count_++) + ".toml");
};

}  // namespace liesl::test
