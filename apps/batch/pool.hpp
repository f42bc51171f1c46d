#pragma once
/// @file
/// Runs the cases of a batch, each as a process of its own (Ipopt's linear solver is not safe among
/// threads, and a process that crashes takes nothing with it).

#include <functional>

#include "apps/batch/batch.hpp"

namespace liesl {

struct PoolReport {
  int ran = 0;        ///< cases that reached an end here
  int failed = 0;     ///< of those
  int before = 0;     ///< cases of the shard that were done before
  int elsewhere = 0;  ///< cases of the shard that another pool is running
  bool interrupted = false;
};

struct PoolOptions {
  int jobs = 1;     ///< processes at once
  int threads = 1;  ///< of each process
  Shard shard;
  bool quiet = false;
  bool reports = true;                            ///< each case writes its report.html
  bool verified = true;                           ///< cases of a study have errors of their limits
  std::function<void(const PoolReport&)> on_end;  ///< after cases have ended
};

/// Runs all cases of the shard that have no mark in `folder`. Other pools may work there at the
/// same time. Ctrl-C stops the cases at their next checkpoint and returns.
/// @throws output::IoError
PoolReport run_cases(const Batch& batch, const std::filesystem::path& folder,
                     const PoolOptions& options);

}  // namespace liesl
