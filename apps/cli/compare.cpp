#include "apps/tasks/compare.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/cli/command.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/compare/ratios.hpp"
#include "apps/output/file.hpp"
#include "apps/output/interrupt.hpp"
#include "apps/output/io_error.hpp"
#include "apps/output/own_files.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/study/load_study.hpp"

namespace liesl {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The references of a comparison, one for each motion; computed when first asked for, kept in
/// files.
class References {
 public:
  References(const Comparison& comparison, const ReadScene& read, fs::path folder,
             output::CompareSummary& summary)
      : comparison_(comparison), read_(read), folder_(std::move(folder)), summary_(summary) {}

  /// Null if the comparison has none.
  const Reference* of(std::size_t row) {
    if (!comparison_.reference) return nullptr;
    const std::vector<std::string> physics = comparison_.physics(row);
    const auto [place, fresh] = known_.try_emplace(fmt::format("{}", fmt::join(physics, "\n")));
    Reference& reference = place->second;
    if (!fresh) return &reference;
    const fs::path path = folder_ / fmt::format("reference_{}.csv", known_.size());
    output::mark_files(folder_, {path.filename().string()});
    if (!fs::exists(path))
      write_series(path, reference_side(comparison_, row, 0, read_),
                   reference_side(comparison_, row, 1, read_));
    const auto [a, b] = output::read_series(path);
    reference = reference_of(a, b, comparison_.norm);
    summary_.references.push_back({physics, comparison_.reference->formalisms, reference.floor,
                                   size_of(reference.mean, comparison_.norm)});
    const double size = summary_.references.back().size;
    if (reference.floor > kTrusted * size)
      summary_.warnings.push_back(
          fmt::format("the two sides of reference {} differ by {:.2g} of their size; use a finer "
                      "reference",
                      known_.size(), reference.floor / size));
    return &reference;
  }

 private:
  static constexpr double kTrusted = 1e-2;  ///< a difference of the sides that goes without saying

  const Comparison& comparison_;
  const ReadScene& read_;
  fs::path folder_;
  output::CompareSummary& summary_;
  std::map<std::string, Reference> known_;
};

/// Makes the folder, or resumes in one that an earlier command with the same input has left.
void prepare(const fs::path& folder, const std::string& hash, bool force) {
  fs::create_directories(folder);
  if (fs::is_empty(folder)) return;
  if (!output::is_result(folder))
    throw output::IoError(
        "write to", folder,
        "it holds " + output::content_of(folder) + " and is not a result of liesl; choose another");
  const Json earlier = Json::parse(output::read_file(folder / "summary.json"), nullptr, false);
  if (force) {
    output::check_own(folder);
    output::remove_own(folder);
  } else if (!earlier.is_object() || earlier.value("command", "") != "compare" ||
             earlier.value("input_sha256", "") != hash) {
    throw InputError({{folder.string(), 0, 0, "the folder belongs to another command",
                       "a new folder, or one of the same comparison and scene",
                       "choose another folder; --force begins again in this one"}});
  }
}

class Run {
 public:
  Run(const Comparison& comparison, const CommandOptions& options)
      : comparison_(comparison),
        options_(options),
        folder_(fs::absolute(options.out).lexically_normal()),
        table_(comparison.rows, response_unit(comparison, read_)),
        references_(comparison, read_, folder_, summary_) {
    const auto& rows = comparison.rows;
    summary_.name = rows.name;
    summary_.response = comparison.response;
    summary_.unit = response_unit(comparison, read_);
    summary_.norm = rows.optimize ? "" : name_of(comparison.norm);
    summary_.rows = static_cast<int>(rows.cases.rows.size());
    summary_.overrides = options.set;
    summary_.input = options.file;
    summary_.input_sha256 = output::sha256(rows.input);
    fresh_ = !fs::exists(folder_);
    prepare(folder_, summary_.input_sha256, options.force);
    if (fs::exists(folder_ / "rows.csv")) table_.read(folder_ / "rows.csv");
    before_ = table_.size();
    save("running");
    output::mark_files(folder_, {"rows.csv", "summary.json", "report.html"});
  }

  int operator()() {
    try {
      rows();
      save("done");
    } catch (const output::Interrupted&) {
      save("interrupted");
    } catch (const std::exception& error) {
      refused(error.what());
      throw;
    }
    add_report(folder_, options_);
    if (!options_.quiet) print();
    return summary_.status == "done" ? 0 : 1;
  }

 private:
  void rows() {
    const CaseList& cases = comparison_.rows.cases;
    output::Progress line("comparing", summary_.rows, "rows", options_.quiet);
    for (std::size_t row = 0; row < cases.rows.size(); ++row) {
      const CaseList::Row& run = cases.rows[row];
      line.update(static_cast<double>(table_.size()), "row " + run.name);
      if (comparison_.rows.optimize) {
        if (!table_.has(run.name)) {
          const Study study = load_study(comparison_.rows.of, comparison_.rows.changes(row));
          table_.add(run, cells_of(measure_method(comparison_, study)));
        }
        save("running");
        continue;
      }
      const Reference* reference = references_.of(row);
      if (table_.has(run.name)) continue;
      const Measured m = measure_row(comparison_, read_(comparison_.rows.changes(row)));
      std::optional<double> error, floor;
      if (reference) floor = reference->floor;
      if (reference && m.ending != Ending::Stopped)
        error = distance(m.series, reference->mean, comparison_.norm);
      table_.add(run, cells_of(m, error, floor));
      save("running");
    }
  }

  /// Keeps the rows there are; without any the folder goes, if it was made here.
  void refused(const std::string& why) {
    if (table_.size() > 0 || !fresh_) {
      summary_.warnings.push_back(why);
      return save("refused");
    }
    output::remove_own(folder_);
    std::error_code left;
    fs::remove(folder_, left);
  }

  void save(const std::string& status) {
    summary_.status = status;
    summary_.done = static_cast<int>(table_.size());
    const auto endings = table_.endings();
    summary_.ended.assign(endings.begin(), endings.end());
    summary_.reason = fmt::format("{} of {} rows", summary_.done, summary_.rows);
    for (const auto& [ending, count] : endings)
      summary_.reason += fmt::format(", {} {}", count, ending);
    summary_.ratios = formalism_ratios(comparison_.rows.cases, table_);
    summary_.wall_s = clock_.seconds();
    table_.write(folder_ / "rows.csv");
    output::replace_file(
        folder_ / "summary.json",
        output::to_json(summary_).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  }

  void print() const {
    fmt::print("{}: {} ({}), {} before, {:.3g} s\n", summary_.name, summary_.status,
               summary_.reason, before_, summary_.wall_s);
    for (const auto& r : summary_.references)
      fmt::print("  floor of {}{}: {} and {} differ by {:.3g} {}, {:.3g} of its size\n",
                 summary_.response,
                 r.changes.empty() ? "" : fmt::format(" ({})", fmt::join(r.changes, ", ")),
                 r.formalisms[0], r.formalisms[1], r.floor, summary_.unit,
                 r.size > 0 ? r.floor / r.size : 0.0);
    for (const auto& r : summary_.ratios) print(r);
    for (const auto& w : summary_.warnings) fmt::print("  note: {}\n", w);
    print_folder(options_.out);
  }

  static void print(const output::FormalismRatio& r) {
    const auto times = [](const std::optional<double>& x) {
      return x ? fmt::format("{:.2g} x", *x) : "-";
    };
    fmt::print("  {} against {}, medians of {} pairs of rows: error {}, time {}\n", r.formalism,
               r.to, r.pairs, times(r.error), times(r.time));
  }

  const Stopwatch clock_;
  const Comparison& comparison_;
  const ReadScene read_ = [this](const std::vector<std::string>& changes) {
    return load_scene(comparison_.rows.of, changes);
  };
  const CommandOptions& options_;
  fs::path folder_;
  output::CompareSummary summary_;
  RowTable table_;
  References references_;
  std::size_t before_ = 0;
  bool fresh_ = false;  ///< the folder was made here
};

}  // namespace

int compare_command(const CommandOptions& options) {
  const Comparison comparison = load_comparison(options.file, options.set);
  return Run(comparison, options)();
}

}  // namespace liesl
