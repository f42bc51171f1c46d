#include "apps/output/atomic_folder.hpp"

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>
#include <thread>
#include <utility>

#include "apps/output/io_error.hpp"
#include "apps/output/own_files.hpp"

namespace fs = std::filesystem;

namespace liesl::output {
namespace {

/// `.<name>.<what>` beside `target`.
fs::path sibling(const fs::path& target, const std::string& what) {
  return target.parent_path() / ("." + target.filename().string() + "." + what);
}

/// Refuses a target whose content is not ours to replace.
void check_replaceable(const fs::path& target, bool overwrite) {
  std::error_code error;
  const auto status = fs::status(target, error);
  if (!fs::exists(status)) return;
  if (!fs::is_directory(status)) throw IoError("write to", target, "is a file, not a folder");
  if (fs::is_empty(target, error) && !error) return;
  if (!is_result(target)) {
    throw IoError(
        "write to", target,
        "it holds " + content_of(target) + " and is not a result of liesl; choose another");
  }
  if (!overwrite) {
    throw IoError("write to", target, "holds an earlier result; --force replaces it");
  }
  check_own(target);
}

std::string host() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

/// `.<name>.partial-<pid>@<host>`
fs::path partial_of(const fs::path& target) {
  return sibling(target, "partial-" + std::to_string(::getpid()) + "@" + host());
}

/// When a process began, s of the clock that dates files; none if that cannot be seen.
std::optional<double> begin_of(int pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string line;
  if (!std::getline(file, line) || line.rfind(')') == std::string::npos) return {};
  std::istringstream fields(line.substr(line.rfind(')') + 1));
  std::string word;
  double ticks = 0;  // after the computer began: field 22, of which 2 are left out
  for (int i = 0; i < 19; ++i) fields >> word;
  if (!(fields >> ticks)) return {};
  timespec now{}, up{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  ::clock_gettime(CLOCK_BOOTTIME, &up);
  return static_cast<double>(now.tv_sec - up.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec - up.tv_nsec) +
         ticks / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

/// Who writes into an unfinished folder.
struct Writer {
  fs::path folder;
  int pid = 0;  ///< 0: the folder is none of these
  std::string host;

  explicit Writer(fs::path partial) : folder(std::move(partial)) {
    constexpr std::string_view kWord = ".partial-";
    const std::string name = folder.filename().string();
    const auto at = name.rfind(kWord);
    if (name[0] != '.' || at == std::string::npos || at == 0) return;
    const char* const end = name.data() + name.size();
    const auto [rest, error] = std::from_chars(name.data() + at + kWord.size(), end, pid);
    const bool whole = error == std::errc{} && (rest == end || *rest == '@');
    if (!whole) pid = 0;
    if (whole && rest != end) host = std::string(rest + 1, end);
  }
  bool here() const { return host == output::host(); }
  /// A process of this computer. A program of another name (another version, Python) may be it,
  /// too, unless it has got its number since: it began after the folder was last changed.
  bool alive() const {
    if (::kill(pid, 0) != 0 && errno == ESRCH) return false;
    std::error_code hidden, error;
    const auto program = fs::read_symlink("/proc/" + std::to_string(pid) + "/exe", hidden);
    if (hidden) return hidden != std::errc::no_such_file_or_directory;  // that is a dead one
    const auto plain = [](const fs::path& path) {
      const std::string name = path.filename().string();
      return name.substr(0, name.find(' '));  // "liesl (deleted)" after an installation
    };
    if (plain(program) == plain(fs::read_symlink("/proc/self/exe", error))) return true;
    constexpr double kClocks = 60;  // s that they may differ by
    const std::optional<double> begin = begin_of(pid);
    struct stat changed {};
    if (!begin || ::stat(folder.c_str(), &changed) != 0) return true;
    return *begin <= static_cast<double>(changed.st_mtim.tv_sec) + kClocks;
  }
};

/// One process at a time looks who is writing where, and says that it does. Where the file system
/// has no locks, or a script holds this one while liesl runs, it goes without.
class PlaceLock {
 public:
  explicit PlaceLock(const fs::path& place)
      : file_(::open(place.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    using namespace std::chrono_literals;
    for (int tries = 0; file_ >= 0 && tries < 200; ++tries) {
      if (::flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) break;
      std::this_thread::sleep_for(10ms);
    }
  }
  ~PlaceLock() {
    if (file_ >= 0) ::close(file_);
  }
  PlaceLock(const PlaceLock&) = delete;
  PlaceLock& operator=(const PlaceLock&) = delete;

 private:
  int file_;
};

/// Refuses a target that another process of this computer is writing to.
void check_alone(const fs::path& target) {
  const std::string prefix = sibling(target, "partial-").filename().string();
  for (const auto& entry : fs::directory_iterator(target.parent_path())) {
    if (!entry.path().filename().string().starts_with(prefix)) continue;
    const Writer writer(entry.path());
    if (writer.pid > 0 && writer.pid != ::getpid() && writer.here() && writer.alive())
      throw IoError("write to", target,
                    "process " + std::to_string(writer.pid) +
                        " is writing to it; wait for its end, or choose another folder");
  }
}

/// Puts `from` at the place of the folder `to`; afterwards `from` holds the former one or is gone.
void exchange(const fs::path& from, const fs::path& to) {
  if (!fs::exists(to)) {
    fs::rename(from, to);
    return;
  }
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_EXCHANGE) == 0) return;
  // Not every file system can exchange; remove_leftovers() mends a kill between the next two lines.
  const fs::path aside = sibling(to, "previous");
  fs::rename(to, aside);
  fs::rename(from, to);
  fs::rename(aside, from);
}

}  // namespace

/// Clears up after killed runs: unfinished folders of processes that are gone, and a result that
/// was moved aside while the file system could not exchange two folders.
void remove_leftovers(const fs::path& target) {
  std::error_code error;
  const fs::path aside = sibling(target, "previous");
  if (fs::exists(aside, error) && !fs::exists(target, error)) fs::rename(aside, target, error);
  fs::remove_all(aside, error);

  const std::string own = sibling(target, "partial-").filename().string();
  for (const auto& entry : fs::directory_iterator(target.parent_path(), error)) {
    const Writer writer(entry.path());
    if (writer.pid <= 0 || !entry.is_directory(error)) continue;
    // Without a computer's name: of an earlier version, beside this target only.
    const bool here =
        writer.host.empty() ? entry.path().filename().string().starts_with(own) : writer.here();
    if (here && !writer.alive()) fs::remove_all(entry.path(), error);
  }
}

AtomicFolder::AtomicFolder(const fs::path& target, bool overwrite) try {
  target_ = fs::absolute(target).lexically_normal();
  if (!target_.has_filename()) target_ = target_.parent_path();  // "demo/"
  if (fs::is_symlink(target_)) target_ = fs::canonical(target_);
  fs::create_directories(target_.parent_path());
  const PlaceLock lock(target_.parent_path());
  check_alone(target_);
  remove_leftovers(target_);
  check_replaceable(target_, overwrite);
  partial_ = partial_of(target_);
  fs::remove_all(partial_);
  fs::create_directory(partial_);
  // Two empty folders may as well change places: shows now, not after the run, whether they can
  // (they cannot where the target is a mount point).
  if (fs::exists(target_) && fs::is_empty(target_)) exchange(partial_, target_);
} catch (const fs::filesystem_error& error) {
  throw IoError("write to", target, error.code().message());
}

AtomicFolder::~AtomicFolder() {
  std::error_code error;
  fs::remove_all(partial_, error);
}

const fs::path& AtomicFolder::path() {
  if (committed_) {
    try {
      copy_own(target_, partial_);
    } catch (const fs::filesystem_error& error) {
      throw IoError("write to", partial_, error.code().message());
    }
    committed_ = false;
  }
  return partial_;
}

void AtomicFolder::commit() {
  if (committed_) return;
  try {
    mark_all(partial_);
    exchange(partial_, target_);
    if (fs::exists(partial_)) move_foreign(partial_, target_);  // put there in the meantime
    fs::remove_all(partial_);
    fs::create_directory(partial_);  // says that this process goes on
  } catch (const fs::filesystem_error& error) {
    throw IoError("write to", target_, error.code().message());
  }
  committed_ = true;
}

}  // namespace liesl::output
