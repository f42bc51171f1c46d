#pragma once
/// @file
/// A small result with known numbers, and a folder that goes away.

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "apps/output/results.hpp"

namespace liesl::test {

/// Numbers 1000 + 0.1, 1001 + 0.1, ... so that every place of a block is told apart.
inline std::vector<double> counting(std::size_t count, double first = 1000) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = first + static_cast<double>(i) + 0.1;
  return values;
}

/// Records of a beam of two elements and a rigid body.
inline std::vector<output::BodyResult> sample_bodies(std::size_t n) {
  std::vector<output::BodyResult> bodies;
  bodies.push_back({"rod",
                    "beam",
                    3,
                    {{0, 1}, {1, 2}},
                    counting(n * 9),
                    counting(n * 27),
                    counting(n * 18),
                    counting(n * 12),
                    counting(n * 24, 5000)});
  bodies.push_back(
      {"top/left", "rigid", 1, {}, counting(n * 3), counting(n * 9), counting(n * 6), {}, {}});
  return bodies;
}

/// Five records of a beam of two elements and a rigid body.
inline output::Results sample_results() {
  const std::size_t n = 5;
  output::Results r;
  r.name = "sample & <test>";
  r.space = "spatial";
  for (std::size_t i = 0; i < n; ++i) r.times.push_back(0.1 * static_cast<double>(i));
  r.bodies = sample_bodies(n);
  r.meshes.push_back({"plate",
                      4,
                      {0, 1, 4, 3, 1, 2, 5, 4},
                      {0.5, 1},
                      {0, 2, 4},
                      counting(3 * 6 * 3),
                      counting(3 * 6 * 3, 700)});
  r.meshes[0].thickness = 0.01;
  r.joints.push_back({"pin", "cylindrical", {"m", "rad"}, counting(n * 2), counting(n * 6)});
  r.energies = {counting(n), counting(n, 1), counting(n, 2), counting(n, 3), counting(n, 4)};
  r.constraint_residual = std::vector<double>(n, 1e-12);
  r.responses.push_back({"bend", "m", 1, {0.1, -0.4, 0.3, 0.2, 1.0 / 3.0}});
  r.responses.push_back({"tip, far", "m", 3, counting(n * 3)});
  return r;
}

/// A new folder under the system's temporary one, removed in the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "liesl-test-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace liesl::test
