#pragma once
/// @file
/// The folder of a case: results of `liesl run` or `liesl optimize`, and the mark that it is done.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "apps/batch/worker.hpp"

namespace liesl {

/// How a case ended, as its mark `done.json` has it.
struct CaseEnd {
  std::string status;  ///< that of the command, or "time-out", "out of memory", "crashed", ...
  std::string reason;
  bool failed = false;   ///< anything but "done", "converged" and "optimal"
  bool figures = false;  ///< its summary.json is that of a run that reached an end
  double wall_s = 0, cpu_s = 0, peak_memory_mb = 0;

  /// True if the case may end otherwise on the same input: the next command tries it again.
  bool tried_again() const {
    return status == "disk full" || status == "not written" || status == "not started" ||
           status == "killed" || status == "no memory";
  }
};

/// `<batch>/cases/<name>`, and the log of the running process beside it, which is its lock.
class CaseFolder {
 public:
  CaseFolder(const std::filesystem::path& batch, const std::string& name);

  const std::filesystem::path& path() const { return path_; }
  /// What the mark says; empty if there is none.
  std::optional<CaseEnd> end() const;
  /// Marks a case that reached its end before its mark could be written, if this is one.
  /// @throws output::IoError
  std::optional<CaseEnd> settle() const;
  /// Its summary.json; null if there is none.
  nlohmann::json summary() const;
  /// True if it was begun and can go on from a checkpoint.
  bool has_checkpoint() const;
  /// What the process has printed, at most the last lines.
  std::string log() const;

  /// Judges how the process ended.
  CaseEnd judge(const WorkerEnd& end, const Worker::Limits& limits) const;
  /// Puts the log into the folder and writes the mark, in one step. @throws output::IoError
  void mark(const CaseEnd& end) const;
  /// Removes the log that taking the lock has made; only who holds the lock may.
  void remove_log() const;
  /// Removes that of a pool that was killed once the mark was written.
  void remove_left_log() const;

 private:
  std::filesystem::path mark_path() const { return path_ / "done.json"; }
  std::filesystem::path path_, log_;
  friend class CaseLock;
};

/// Holds a case for this process and the one that runs it, on all machines that share the folder.
class CaseLock {
 public:
  explicit CaseLock(const CaseFolder& folder);
  ~CaseLock();
  CaseLock(CaseLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  CaseLock& operator=(CaseLock&&) = delete;
  bool held() const { return file_ >= 0; }
  int file() const { return file_; }  ///< the log

 private:
  int file_ = -1;
};

}  // namespace liesl
