#include "apps/batch/case_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "apps/output/atomic_folder.hpp"
#include "apps/output/file.hpp"
#include "apps/output/io_error.hpp"
#include "apps/output/own_files.hpp"

namespace liesl {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

bool good(const std::string& status) {
  return status == "done" || status == "converged" || status == "optimal";
}

/// States that a command leaves when it was stopped before its end.
bool unfinished(const std::string& status) {
  return status == "running" || status == "interrupted";
}

Json read_json(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return {};
  try {
    return Json::parse(output::read_file(path));
  } catch (const Json::exception&) {
    return {};
  }
}

/// End of a case by its summary; empty if the summary tells of none, or is damaged.
std::optional<CaseEnd> end_of(const Json& summary) try {
  const std::string status = summary.is_object() ? summary.value("status", "running") : "running";
  if (unfinished(status)) return {};
  CaseEnd end{status, summary.value("reason", ""), !good(status), true, 0, 0, 0};
  end.wall_s = summary.value("wall_s", 0.0);
  end.peak_memory_mb = summary.value("peak_memory_mb", 0.0);
  return end;
} catch (const Json::exception&) {
  return {};
}

/// End of a case by its mark; empty without one, or if it is damaged.
std::optional<CaseEnd> marked_end(const Json& mark) try {
  if (!mark.is_object()) return {};
  return CaseEnd{mark.at("status"),
                 mark.value("reason", ""),
                 mark.value("failed", true),
                 mark.value("figures", false),
                 mark.value("wall_s", 0.0),
                 mark.value("cpu_s", 0.0),
                 mark.value("peak_memory_mb", 0.0)};
} catch (const Json::exception&) {
  return {};
}

/// A place that could not be read or written: may not come again.
bool of_the_environment(const std::string& log) {
  return log.find("liesl: cannot ") != std::string::npos;
}

/// The words of a process that failed.
CaseEnd failure(const WorkerEnd& end, const Worker::Limits& limits, const std::string& log) {
  CaseEnd out;
  out.failed = true;
  out.reason = log.empty() ? fmt::format("exit code {}", end.exit_code) : log;
  const bool memory = log.find("out of memory") != std::string::npos ||
                      log.find("failed to map") != std::string::npos;
  if (end.out_of_time) {
    out.status = "time-out";
    out.reason = fmt::format("stopped after limits.time = {} s", *limits.time);
  } else if (end.signal == SIGKILL) {
    out.status = "killed";
    out.reason = "by signal 9 from outside: the system was out of memory, or someone stopped it";
  } else if (memory) {
    out.status = limits.memory ? "out of memory" : "no memory";
    if (limits.memory)
      out.reason = fmt::format("needs more than limits.memory = {} MB", *limits.memory);
  } else if (end.signal != 0) {
    out.status = "crashed";
    out.reason = fmt::format("signal {}: {}", end.signal, ::strsignal(end.signal));
  } else {
    const bool full = log.find("the disk is full") != std::string::npos;
    out.status = end.exit_code == 2        ? "refused"
                 : end.exit_code == 127    ? "not started"
                 : full                    ? "disk full"
                 : of_the_environment(log) ? "not written"
                                           : "failed";
  }
  return out;
}

}  // namespace

CaseFolder::CaseFolder(const fs::path& batch, const std::string& name)
    : path_(batch / "cases" / name), log_(batch / "cases" / ("." + name + ".log")) {}

std::optional<CaseEnd> CaseFolder::end() const {
  std::optional<CaseEnd> end = marked_end(read_json(mark_path()));
  if (end && end->figures && !end_of(summary())) return {};  // lost since: it is run again
  return end;
}

nlohmann::json CaseFolder::summary() const { return read_json(path_ / "summary.json"); }

bool CaseFolder::has_checkpoint() const { return fs::exists(path_ / "checkpoint.json"); }

std::string CaseFolder::log() const {
  constexpr std::size_t kMost = 2000;
  std::string text = output::read_file(log_);
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text.size() > kMost ? text.substr(text.size() - kMost) : text;
}

std::optional<CaseEnd> CaseFolder::settle() const {
  std::optional<CaseEnd> found = end_of(summary());
  if (found) mark(*found);
  return found;
}

CaseEnd CaseFolder::judge(const WorkerEnd& end, const Worker::Limits& limits) const {
  const std::optional<CaseEnd> reached =
      end.exit_code == 0 || end.exit_code == 1 ? end_of(summary()) : std::nullopt;
  CaseEnd out = reached ? *reached : failure(end, limits, log());
  out.wall_s = end.wall_s;
  out.cpu_s = end.cpu_s;
  out.peak_memory_mb = end.peak_memory_mb;
  return out;
}

void CaseFolder::mark(const CaseEnd& end) const {
  output::remove_leftovers(path_);
  std::error_code error;
  fs::create_directories(path_, error);
  output::remove_parts(path_);
  output::mark_files(path_, {"done.json", "log.txt"});
  if (fs::file_size(log_, error) > 0 && !error) fs::rename(log_, path_ / "log.txt", error);
  const nlohmann::ordered_json json = {{"case", path_.filename().string()},
                                       {"status", end.status},
                                       {"reason", end.reason},
                                       {"failed", end.failed},
                                       {"figures", end.figures},
                                       {"wall_s", end.wall_s},
                                       {"cpu_s", end.cpu_s},
                                       {"peak_memory_mb", end.peak_memory_mb}};
  output::replace_file(mark_path(),
                       json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  remove_log();
}

void CaseFolder::remove_log() const {
  std::error_code error;
  fs::remove(log_, error);
}

void CaseFolder::remove_left_log() const {
  std::error_code error;
  if (!fs::exists(log_, error)) return;
  if (const CaseLock lock(*this); lock.held()) remove_log();
}

CaseLock::CaseLock(const CaseFolder& folder) {
  std::error_code error;
  fs::create_directories(folder.log_.parent_path(), error);
  file_ = ::open(folder.log_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file_ < 0) throw output::IoError("write", folder.log_, std::strerror(errno));
  struct stat mine = {}, there = {};
  // A file system without locks takes none: then the marks alone keep cases apart.
  const bool locked = ::flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
  // Another process may have taken the file away between the two lines above.
  const bool same = ::fstat(file_, &mine) == 0 && ::stat(folder.log_.c_str(), &there) == 0 &&
                    mine.st_ino == there.st_ino;
  if (!locked || !same) {
    ::close(file_);
    file_ = -1;
  } else if (::ftruncate(file_, 0) != 0) {
    throw output::IoError("write", folder.log_, std::strerror(errno));
  }
}

CaseLock::~CaseLock() {
  if (file_ >= 0) ::close(file_);
}

}  // namespace liesl
