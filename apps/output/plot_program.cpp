#include "apps/output/plot_program.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "apps/output/file.hpp"
#include "apps/output/installation.hpp"
#include "apps/output/io_error.hpp"
#include "apps/output/own_files.hpp"

namespace fs = std::filesystem;

namespace liesl::output {
namespace {

struct Outcome {
  int code = -1;
  int signal = 0;    ///< that ended it; 0: none
  std::string text;  ///< of stdout and stderr
};

bool space_is_limited() {
  rlimit space{};
  return ::getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY;
}

/// Libraries that have no memory may try for ever: where it is limited, time is, too.
void limit_time(pid_t pid) {
  constexpr rlim_t kSeconds = 120;              // of the processor; pictures take a few
  const rlimit limit{kSeconds, kSeconds + 10};  // SIGXCPU, then SIGKILL
  if (space_is_limited()) ::prlimit(pid, RLIMIT_CPU, &limit, nullptr);
}

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
  if (error == 0) limit_time(pid);
  Outcome outcome;
  std::array<char, 4096> block;
  for (ssize_t n = 1; error == 0 && n > 0;) {
    n = ::read(pipe[0], block.data(), block.size());
    if (n > 0) outcome.text.append(block.data(), static_cast<std::size_t>(n));
    if (n < 0 && errno == EINTR) n = 1;
  }
  ::close(pipe[0]);
  if (error != 0)
    throw IoError("run", arguments[0], error == ENOMEM ? "out of memory" : std::strerror(error));
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  outcome.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  return outcome;
}

/// Has the script, or a library under it, ended because its address space is limited?
bool lacked_memory(const Outcome& outcome) {
  constexpr std::array kWords = {"MemoryError",    "SystemError",   "failed to map segment",
                                 "annot allocate", "out of memory", "bad_alloc"};
  constexpr std::array kSignals = {SIGPROF, SIGXCPU, SIGABRT, SIGSEGV, SIGBUS};
  return space_is_limited() && (std::ranges::count(kSignals, outcome.signal) > 0 ||
                                std::ranges::any_of(kWords, [&](const char* word) {
                                  return outcome.text.find(word) != std::string::npos;
                                }));
}

/// @param last line that it printed
std::string reason_of(const Outcome& outcome, const std::string& last) {
  if (lacked_memory(outcome))
    return fmt::format(
        "out of memory{}; allow it more address space (its linear algebra alone takes 128 MB)",
        last.empty() ? "" : " (" + last + ")");
  if (outcome.signal > 0) return fmt::format("it was ended by signal {}", outcome.signal);
  return last.empty() ? "no reason given" : last;
}

/// Where pictures are before they are whole: beside those of an earlier drawing, known as liesl's
/// by its name (`writer_of_part`), and gone at the end.
class PartFolder {
 public:
  explicit PartFolder(const fs::path& folder)
      : path_(folder / fmt::format(".{}.part-{}", kPictures, ::getpid())) {}
  ~PartFolder() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  PartFolder(const PartFolder&) = delete;
  PartFolder& operator=(const PartFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Moves pictures to their place in a results folder, which knows them before they are there.
std::vector<fs::path> move_pictures(const fs::path& folder,
                                    const std::vector<fs::path>& pictures) try {
  std::vector<std::string> names;
  for (const fs::path& picture : pictures)
    names.push_back((kPictures / picture.filename()).generic_string());
  if (names.empty()) return {};
  mark_files(folder, names);
  fs::create_directories(folder / kPictures);
  std::vector<fs::path> placed;
  for (std::size_t i = 0; i < names.size(); ++i) {
    placed.push_back(folder / names[i]);
    fs::rename(pictures[i], placed.back());
  }
  return placed;
} catch (const fs::filesystem_error& error) {
  throw IoError("write to", folder / kPictures, error.code().message());
}

}  // namespace

std::vector<fs::path> draw(const fs::path& folder, const std::string& x, const std::string& y) {
  const char* chosen = std::getenv("LIESL_PYTHON");
  const std::string python = chosen && *chosen ? chosen : LIESL_PYTHON;
  const fs::path plot = share_path() / "plot/plot.py";
  if (!fs::exists(plot)) throw IoError("draw with", plot, "no such file; install liesl again");
  remove_parts(folder);
  const PartFolder part(folder);
  std::vector<std::string> arguments = {python, plot.string(), folder.string(), "--to",
                                        part.path().string()};
  if (!x.empty()) arguments.insert(arguments.end(), {"--x=" + x, "--y=" + y});
  const Outcome outcome = run(std::move(arguments));
  std::vector<fs::path> pictures;
  std::string last;
  std::istringstream lines(outcome.text);
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with(".png") || line.ends_with(".svg")) pictures.emplace_back(line);
    if (!line.empty()) last = line;
  }
  if (outcome.code != 0) throw IoError("draw", folder, reason_of(outcome, last));
  return move_pictures(folder, pictures);
}

}  // namespace liesl::output
