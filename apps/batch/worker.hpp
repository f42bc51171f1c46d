#pragma once
/// @file
/// One process of the pool: a program with its output in a log, limits and an end that is known.

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace liesl {

/// How a process ended.
struct WorkerEnd {
  int exit_code = -1;  ///< if no signal ended it
  int signal = 0;
  bool out_of_time = false;  ///< it was stopped because of its limit
  double wall_s = 0, cpu_s = 0;
  double peak_memory_mb = 0;
};

/// A running process. It dies with this one, whatever kills this one.
class Worker {
 public:
  struct Limits {
    std::optional<double> time;    ///< s, wall time
    std::optional<double> memory;  ///< MB, address space
  };

  /// Starts a program; its output goes to the open file `log`.
  /// @throws output::IoError if there can be no further process
  Worker(const std::vector<std::string>& command, int log, const Limits& limits);

  /// Its end, if it has ended. Stops it when its time is over.
  std::optional<WorkerEnd> poll();
  /// Asks it to stop at the next good place, like Ctrl-C.
  void interrupt() const;

 private:
  using Clock = std::chrono::steady_clock;
  pid_t pid_ = 0;
  Limits limits_;
  Clock::time_point start_ = Clock::now();
  bool stopped_ = false;
};

/// Blocks SIGCHLD while it lives, so that `wait` returns as soon as a child ends.
class ChildSignal {
 public:
  ChildSignal();
  ~ChildSignal();
  ChildSignal(const ChildSignal&) = delete;
  ChildSignal& operator=(const ChildSignal&) = delete;
  /// Until a child ends, any other signal comes, or `seconds` have passed.
  void wait(double seconds) const;
};

}  // namespace liesl
