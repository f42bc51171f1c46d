#include "apps/output/plot_program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "apps/output/installation.hpp"
#include "apps/output/io_error.hpp"
#include "apps/output/own_files.hpp"

namespace fs = std::filesystem;

namespace liesl::output {
namespace {

struct Outcome {
  int code = -1;
  std::string text;  ///< of stdout and stderr
};

/// Runs a program to its end. @throws IoError if it cannot be started
Outcome run(std::vector<std::string> arguments) {
  std::array<int, 2> pipe;
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0)
    throw IoError("run", arguments[0], std::strerror(errno));
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, pipe[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, pipe[1], STDERR_FILENO);
  std::vector<char*> argv;
  for (auto& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  pid_t pid = 0;
  const int error = ::posix_spawnp(&pid, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(pipe[1]);
  Outcome outcome;
  std::array<char, 4096> block;
  for (ssize_t n = 1; error == 0 && n > 0;) {
    n = ::read(pipe[0], block.data(), block.size());
    if (n > 0) outcome.text.append(block.data(), static_cast<std::size_t>(n));
    if (n < 0 && errno == EINTR) n = 1;
  }
  ::close(pipe[0]);
  if (error != 0) throw IoError("run", arguments[0], std::strerror(error));
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

}  // namespace

std::vector<fs::path> draw(const fs::path& folder, const std::string& x, const std::string& y) {
  const char* chosen = std::getenv("LIESL_PYTHON");
  const std::string python = chosen && *chosen ? chosen : LIESL_PYTHON;
  const fs::path plot = share_path() / "plot/plot.py";
  if (!fs::exists(plot)) throw IoError("draw with", plot, "no such file; install liesl again");
  std::vector<std::string> arguments = {python, plot.string(), folder.string()};
  if (!x.empty()) arguments.insert(arguments.end(), {"--x=" + x, "--y=" + y});
  const Outcome outcome = run(std::move(arguments));
  std::vector<fs::path> pictures;
  std::string last;
  std::istringstream lines(outcome.text);
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with(".png") || line.ends_with(".svg")) pictures.emplace_back(line);
    if (!line.empty()) last = line;
  }
  std::vector<std::string> drawn;
  for (const fs::path& picture : pictures) drawn.push_back("plots/" + picture.filename().string());
  if (!drawn.empty()) mark_files(folder, drawn);
  if (outcome.code != 0) throw IoError("draw", folder, last.empty() ? "no reason given" : last);
  return pictures;
}

}  // namespace liesl::output
