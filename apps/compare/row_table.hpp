#pragma once
/// @file
/// rows.csv of a comparison: what was varied, then the figures. Columns: docs/outputs.md.

#include <filesystem>
#include <map>
#include <optional>

#include "apps/batch/batch.hpp"
#include "apps/compare/measure.hpp"

namespace liesl {

/// Is this a column that every table of simulations, or of optimisations, has?
bool is_figure(const std::string& column, bool of_study);

/// A value of a row without the quotes of TOML.
std::string plain(const std::string& text);

/// One optimisation as figures.
struct MeasuredMethod {
  std::string status, reason;
  int simulations = 0;    ///< designs simulated, times the scenarios
  int sensitivities = 0;  ///< motions that were differentiated
  double cpu_s = 0;       ///< of all threads
  std::optional<double> mass, violation, kkt;
};

/// Cells of a row, one a figure. @param error,floor empty without a reference or an end
std::vector<std::string> cells_of(const Measured& measured, std::optional<double> error,
                                  std::optional<double> floor);
std::vector<std::string> cells_of(const MeasuredMethod& measured);

/// Rows by the name of the run. Cells are texts, so that rows read again stay as they were written.
class RowTable {
 public:
  /// @param unit of the response
  RowTable(const Batch& runs, std::string unit) : runs_(runs), unit_(std::move(unit)) {}

  bool has(const std::string& run) const { return rows_.contains(run); }
  std::size_t size() const { return rows_.size(); }
  /// @param cells of `cells_of`
  void add(const CaseList::Row& run, std::vector<std::string> cells) {
    rows_[run.name] = std::move(cells);
  }
  /// A number of a row; empty if the row is not there or has none. @pre is_figure(column,
  /// runs.optimize)
  std::optional<double> figure(const std::string& run, const std::string& column) const;
  /// How many rows ended how.
  std::map<std::string, int> endings() const;

  /// Rows of an earlier command; only those that are whole. @throws output::IoError
  void read(const std::filesystem::path& path);
  /// Replaces the file in one step, rows in the order of the runs. @throws output::IoError
  void write(const std::filesystem::path& path) const;

 private:
  const Batch& runs_;
  std::string unit_;
  std::map<std::string, std::vector<std::string>> rows_;
};

}  // namespace liesl
