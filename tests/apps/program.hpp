#pragma once
/// @file
/// The program itself, started as a user does, in a folder of its own.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "reference/places.hpp"

namespace liesl::test {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

inline const fs::path kData = kDataDir;

inline std::string text_of(const fs::path& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

struct Outcome {
  int code = -1;
  std::string out, err;
};

class Program : public testing::Test {
 protected:
  fs::path dir_ =
      fs::temp_directory_path() / ("liesl_test_" + std::to_string(getpid()) + "_" +
                                   testing::UnitTest::GetInstance()->current_test_info()->name());
  void SetUp() override { fs::create_directories(dir_); }
  void TearDown() override { fs::remove_all(dir_); }

  /// Starts it; what it prints goes to files whose names end with `tag`.
  pid_t start(Words words, const std::string& tag = "") const {
    words.insert(words.begin(), kProgram);
    const pid_t child = fork();
    if (child != 0) return child;
    for (const auto& [name, number] : {std::pair{"out", 1}, std::pair{"err", 2}})
      dup2(open((dir_ / (name + tag)).c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), number);
    std::vector<char*> args;
    for (auto& word : words) args.push_back(word.data());
    args.push_back(nullptr);
    execv(args[0], args.data());
    _exit(127);
  }
  Outcome wait_for(pid_t child, const std::string& tag = "") const {
    int status = 0;
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status),
            text_of(dir_ / ("out" + tag)), text_of(dir_ / ("err" + tag))};
  }
  Outcome run(const Words& words) const { return wait_for(start(words)); }

  fs::path results() const { return dir_ / "results"; }
  Json summary() const { return Json::parse(text_of(results() / "summary.json")); }
  fs::path write(const char* name, const std::string& text) const {
    std::ofstream(dir_ / name) << text;
    return dir_ / name;
  }
  /// Until the first checkpoint is there.
  bool wait_for_results() const {
    for (int i = 0; i < 20000 && !fs::exists(results() / "summary.json"); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return fs::exists(results() / "summary.json");
  }
};

inline std::string scene(const char* name) {
  return kData / "scenes" / (std::string(name) + ".toml");
}
inline std::string study(const char* name) {
  return kData / "studies" / (std::string(name) + ".toml");
}

/// Keys of the table under a heading of docs/outputs.md; those that are not always there are
/// described as "only ...".
struct Documented {
  std::set<std::string> always, sometimes;
};

inline Documented documented(const std::string& heading) {
  std::istringstream page(text_of(kData / "../docs/outputs.md"));
  Documented keys;
  bool here = false;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("##", 0) == 0) here = (line + "\n").rfind(heading, 0) == 0;
    if (!here || line.rfind("| `", 0) != 0) continue;
    const bool optional = line.find("| only ") != std::string::npos;
    const std::string names = line.substr(0, line.find('|', 2));
    for (size_t a = names.find('`'); a != std::string::npos; a = names.find('`', a + 1)) {
      const size_t b = names.find('`', a + 1);
      (optional ? keys.sometimes : keys.always).insert(names.substr(a + 1, b - a - 1));
      a = b;
    }
  }
  return keys;
}

inline std::set<std::string> keys(const Json& json) {
  std::set<std::string> names;
  for (const auto& [name, value] : json.items()) names.insert(name);
  return names;
}

}  // namespace liesl::test
