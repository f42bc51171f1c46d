#include "apps/batch/pool.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <list>
#include <set>
#include <utility>

#include "apps/batch/case_folder.hpp"
#include "apps/output/installation.hpp"
#include "apps/output/interrupt.hpp"
#include "apps/output/progress.hpp"

namespace liesl {

namespace {

namespace fs = std::filesystem;

/// The command that runs a case; a user may give it by hand.
std::vector<std::string> command_of(const Batch& batch, std::size_t row, const CaseFolder& folder,
                                    const PoolOptions& options) {
  const bool go_on = batch.optimize && folder.has_checkpoint();
  std::vector<std::string> words = {output::program_path().string(),
                                    batch.optimize ? "optimize" : "run",
                                    batch.of.string(),
                                    "-o",
                                    folder.path().string(),
                                    go_on ? "--resume" : "--force",
                                    "--quiet",
                                    "--threads",
                                    std::to_string(options.threads)};
  if (!options.reports) words.push_back("--no-report");
  if (batch.optimize && !options.verified) words.push_back("--no-verify");
  for (const std::string& change : batch.changes(row)) {
    words.push_back("--set");
    words.push_back(change);
  }
  return words;
}

/// A case that is running.
struct Running {
  CaseFolder folder;
  CaseLock lock;
  Worker worker;
};

class Pool {
  static constexpr double kTick = 0.1;  ///< s, for time limits and the live line

 public:
  Pool(const Batch& batch, const fs::path& folder, const PoolOptions& options)
      : batch_(batch),
        folder_(folder),
        options_(options),
        limits_{batch.time, batch.memory},
        waiting_(cases_to_run()),
        line_("cases", static_cast<double>(waiting_.size()), "cases", options.quiet) {
    // A process a core: the linear algebra of each keeps to its threads, or fewer.
    for (const char* name : {"OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"}) {
      const char* text = std::getenv(name);
      const long given = text ? std::strtol(text, nullptr, 10) : 0;
      if (given < 1 || given > options.threads)
        ::setenv(name, std::to_string(options.threads).c_str(), 1);
    }
  }

  PoolReport run() {
    const ChildSignal children;
    bool waited = false;  // for those that are asked for again
    for (std::size_t next = 0; next < waiting_.size() || !running_.empty();) {
      stop_if_asked();
      if (report_.interrupted && running_.empty()) break;
      while (!report_.interrupted && next < waiting_.size() && free()) {
        if (put_off_.contains(waiting_[next]) && running_.empty() && !std::exchange(waited, true))
          children.wait(kTick);
        start(waiting_[next++]);
      }
      collect();
      tell();
      line_.update(report_.ran, report_.failed ? fmt::format("{} failed", report_.failed) : "");
      if (!free() || (next >= waiting_.size() && !running_.empty())) children.wait(kTick);
    }
    return report_;
  }

 private:
  bool free() const { return running_.size() < static_cast<std::size_t>(options_.jobs); }

  static bool ended(const CaseFolder& folder) {
    const auto end = folder.end();
    return end && !end->tried_again();
  }

  std::vector<std::size_t> cases_to_run() {
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < batch_.cases.rows.size(); ++row) {
      if (!options_.shard.has(row)) continue;
      const CaseFolder folder(folder_, batch_.cases.rows[row].name);
      if (!ended(folder)) {
        rows.push_back(row);
        continue;
      }
      folder.remove_left_log();
      ++report_.before;
    }
    return rows;
  }

  void stop_if_asked() {
    if (report_.interrupted || !output::interrupted()) return;
    report_.interrupted = true;
    for (const Running& r : running_) r.worker.interrupt();
  }

  /// A case that runs elsewhere is asked for once more after the others: the pool that runs it may
  /// have been killed, and the process be about to end.
  void start(std::size_t row) {
    CaseFolder folder(folder_, batch_.cases.rows[row].name);
    CaseLock lock(folder);
    if (!lock.held()) {
      if (put_off_.insert(row).second)
        waiting_.push_back(row);
      else
        ++report_.elsewhere;
      return;
    }
    if (ended(folder)) {  // another pool has done it in the meantime
      folder.remove_log();
      ++report_.before;
      return;
    }
    if (const auto end = folder.settle()) return count(folder, *end);
    Worker worker(command_of(batch_, row, folder, options_), lock.file(), limits_);
    running_.push_back({std::move(folder), std::move(lock), std::move(worker)});
  }

  void collect() {
    for (auto it = running_.begin(); it != running_.end();) {
      const auto ended = it->worker.poll();
      if (!ended) {
        ++it;
        continue;
      }
      const CaseEnd end = it->folder.judge(*ended, limits_);
      // What was stopped with the pool is not done: it goes on next time.
      if (!report_.interrupted || end.figures) {
        it->folder.mark(end);
        count(it->folder, end);
      }
      it = running_.erase(it);
    }
  }

  void tell() {
    if (report_.ran > told_ && options_.on_end) options_.on_end(report_);
    told_ = report_.ran;
  }

  void count(const CaseFolder& folder, const CaseEnd& end) {
    ++report_.ran;
    report_.failed += end.failed;
    if (end.failed)
      line_.say(fmt::format("case {}: {} ({})", folder.path().filename().string(), end.status,
                            end.reason));
  }

  const Batch& batch_;
  const fs::path& folder_;
  PoolOptions options_;
  Worker::Limits limits_;
  PoolReport report_;
  int told_ = 0;  ///< of the cases that have ended
  std::vector<std::size_t> waiting_;
  std::set<std::size_t> put_off_;  ///< of these, those that ran elsewhere
  output::Progress line_;
  std::list<Running> running_;
};

}  // namespace

PoolReport run_cases(const Batch& batch, const fs::path& folder, const PoolOptions& options) {
  return Pool(batch, folder, options).run();
}

}  // namespace liesl
