#include "apps/batch/batch.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <thread>

#include "apps/batch/case_folder.hpp"
#include "apps/batch/pool.hpp"
#include "apps/batch/results.hpp"
#include "apps/cli/command.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/output/file.hpp"
#include "apps/output/io_error.hpp"
#include "apps/output/own_files.hpp"
#include "apps/output/summary.hpp"

namespace liesl {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// One pool at a time makes the folder or collects; the last one to collect sees the marks of all.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder)
      : file_(::open((folder / kName).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    if (file_ < 0) throw output::IoError("write to", folder, std::strerror(errno));
    while (::flock(file_, LOCK_EX) != 0 && errno == EINTR) continue;  // other errors: no locks here
  }
  ~FolderLock() { ::close(file_); }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  static constexpr const char* kName = ".lock";

 private:
  int file_;
};

/// Makes the folder. One that holds something else than a batch is left alone.
void make_folder(const fs::path& folder) {
  std::error_code error;
  const bool ours = fs::exists(folder / FolderLock::kName, error) || !fs::exists(folder, error) ||
                    (fs::is_directory(folder, error) && fs::is_empty(folder, error));
  // Another pool may have made it, and its lock, in between.
  if (!ours && !fs::exists(folder / FolderLock::kName, error))
    throw output::IoError("write to", folder,
                          (fs::is_directory(folder, error)
                               ? "it holds " + output::content_of(folder) + ", but no batch"
                               : std::string("it is a file")) +
                              "; choose another");
  fs::create_directories(folder, error);
  if (error) throw output::IoError("write to", folder, error.message());
}

/// Makes sure that the folder is of this batch: new, or of an earlier command with the same input,
/// which goes on.
void prepare(const fs::path& folder, const Batch& batch, const std::string& hash, bool force) {
  make_folder(folder);
  const FolderLock lock(folder);
  const fs::path plan = folder / "batch.json";
  if (force && fs::exists(plan)) {
    output::check_own(folder);
    output::remove_own(folder, FolderLock::kName);
  }
  if (fs::exists(plan)) {
    const Json earlier = Json::parse(output::read_file(plan), nullptr, false);
    const bool known = earlier.is_object() && earlier.contains("input_sha256");
    if (known && earlier.at("input_sha256") == hash) return;
    throw InputError({{folder.string(), 0, 0, "the folder belongs to another batch",
                       "a new folder, or one of the same study, scene and cases",
                       "choose another folder; --force begins again in this one"}});
  }
  for (const auto& entry : fs::directory_iterator(folder))
    if (const auto name = entry.path().filename();
        name != FolderLock::kName && name != output::kMark)
      throw output::IoError("write to", folder,
                            "it holds '" + name.string() + "', but no batch; choose another");
  Json json = {{"name", batch.name}, {"of", batch.of.string()}, {"input_sha256", hash}};
  json["cases"] = Json::object();
  for (std::size_t row = 0; row < batch.cases.rows.size(); ++row)
    json["cases"][batch.cases.rows[row].name] = batch.changes(row);
  output::mark_files(folder, {FolderLock::kName, "batch.json", "cases", "results.csv", "results.h5",
                              "summary.json", "report.html"});
  output::replace_file(plan, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::string counted(const std::map<std::string, int>& statuses) {
  std::string text;
  for (const auto& [status, count] : statuses)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, status);
  return text;
}

/// @param running more cases may end
void describe(output::BatchSummary& summary, const Batch& batch, const BatchTable& table,
              const PoolReport& report, bool running) {
  summary.name = batch.name;
  summary.cases = static_cast<int>(batch.cases.rows.size());
  summary.done = static_cast<int>(table.rows());
  summary.failed = table.failed;
  summary.ended.assign(table.statuses.begin(), table.statuses.end());
  summary.cpu_s = table.cpu_s;
  const bool whole = summary.done == summary.cases;
  summary.status = running              ? "running"
                   : report.interrupted ? "interrupted"
                   : !whole             ? "incomplete"
                   : table.failed       ? "some failed"
                                        : "done";
  summary.reason = fmt::format("{} of {} cases have ended{}", summary.done, summary.cases,
                               running ? " so far" : "");
  if (summary.done > 0) summary.reason += ": " + counted(table.statuses);
  if (running) summary.reason += "; the same command goes on with the rest";
  if (report.elsewhere > 0)
    summary.warnings.push_back(fmt::format("{} cases were running elsewhere", report.elsewhere));
}

/// Tables of all cases that have ended here or elsewhere; results.h5 when all have.
/// @param running more cases may end
output::BatchSummary write_batch(const fs::path& folder, const Batch& batch,
                                 const PoolReport& report, output::BatchSummary summary,
                                 const Stopwatch& clock, bool running = false) {
  const FolderLock lock(folder);
  if (!running) output::remove_parts(folder);  // another computer may draw here
  const BatchTable table = collect_cases(batch, folder);
  describe(summary, batch, table, report, running);
  write_batch_csv(folder, table);
  const bool news = report.ran > 0 || !fs::exists(folder / "results.h5");
  if (!running && summary.done == summary.cases && news) write_batch_hdf5(folder, table);
  summary.wall_s = clock.seconds();
  output::replace_file(
      folder / "summary.json",
      output::to_json(summary).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  return summary;
}

/// The tables while the batch runs, so that they are there if it is killed: at its beginning, when
/// the first case ends, then so that they take at most a twentieth of its time.
class RunningTables {
 public:
  RunningTables(const fs::path& folder, const Batch& batch, const output::BatchSummary& known,
                const Stopwatch& clock)
      : folder_(folder), batch_(batch), known_(known), clock_(clock) {}

  void write(const PoolReport& so_far) {
    constexpr double kShare = 1. / 20;
    const double begin = clock_.seconds();
    if (begin < next_) return;
    try {
      write_batch(folder_, batch_, so_far, known_, clock_, true);
    } catch (const std::exception&) {  // at the end the same is written, and said
    }
    if (so_far.ran > 0) next_ = begin + (clock_.seconds() - begin) / kShare;
  }

 private:
  const fs::path& folder_;
  const Batch& batch_;
  const output::BatchSummary& known_;
  const Stopwatch& clock_;
  double next_ = 0;  ///< s, when they are written again
};

/// Did a case of this shard fail, now or before?
bool any_failed(const Batch& batch, const fs::path& folder, const Shard& shard) {
  for (std::size_t row = 0; row < batch.cases.rows.size(); ++row)
    if (shard.has(row))
      if (const auto end = CaseFolder(folder, batch.cases.rows[row].name).end())
        if (end->failed) return true;
  return false;
}

void print_result(const output::BatchSummary& s, const PoolReport& report, const Batch& batch,
                  const std::string& folder) {
  fmt::print("{}: {} ({})\n", s.name, s.status, s.reason);
  fmt::print("  {} case{} now, {} before, {} at once, {:.3g} s\n", report.ran,
             report.ran == 1 ? "" : "s", report.before, s.jobs, s.wall_s);
  for (const auto& w : s.warnings) fmt::print("  note: {}\n", w);
  print_folder(folder, fmt::format(" --x {} --y {}", shell_word(batch.cases.columns.front().name),
                                   batch.optimize ? "mass_final" : "steps"));
}

/// Batches of more cases leave their pages out: half a megabyte each.
constexpr std::size_t kMostReports = 100;

}  // namespace

int batch_command(const CommandOptions& options) {
  const Stopwatch clock;
  PoolOptions pool;
  pool.shard = read_shard(options.shard);
  if (options.force && pool.shard.of > 1)
    throw InputError({{"--force", 0, 0, "a shard may not replace the results of the others",
                       "--force or --shard", "remove the folder before the first shard"}});
  const Batch batch = load_batch(options.file, options.set);
  pool.jobs = options.jobs > 0 ? options.jobs
                               : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  pool.threads = std::max(1, options.threads);
  pool.quiet = options.quiet;
  pool.verified = !options.no_verify;
  pool.reports = !options.no_report && batch.cases.rows.size() <= kMostReports;
  const fs::path folder = fs::absolute(options.out).lexically_normal();
  output::BatchSummary summary;
  summary.overrides = options.set;
  summary.input = options.file;
  summary.input_sha256 = output::sha256(batch.input);
  summary.jobs = pool.jobs;
  summary.shard = options.shard;
  for (const CaseColumn& column : batch.cases.columns)
    if (std::string unit = unit_of(batch, column); !unit.empty())
      summary.input_units.emplace_back(column.name, std::move(unit));
  prepare(folder, batch, summary.input_sha256, options.force);
  RunningTables tables(folder, batch, summary, clock);
  tables.write({});
  pool.on_end = [&tables](const PoolReport& so_far) { tables.write(so_far); };
  const PoolReport report = run_cases(batch, folder, pool);
  summary = write_batch(folder, batch, report, summary, clock);
  add_report(folder, options);
  if (!options.quiet) print_result(summary, report, batch, options.out);
  return report.interrupted || any_failed(batch, folder, pool.shard) ? 1 : 0;
}

}  // namespace liesl
