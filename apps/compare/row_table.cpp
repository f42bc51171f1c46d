#include "apps/compare/row_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <span>

#include "apps/batch/case_table.hpp"
#include "apps/output/csv_writer.hpp"
#include "apps/output/file.hpp"

namespace liesl {

namespace {

struct Figure {
  const char *name, *unit;  ///< unit "*": of the response
};
using Figures = std::span<const Figure>;
constexpr Figure kOfScenes[] = {
    {"status", ""},
    {"error", "*"},
    {"cpu_s", "s"},
    {"cpu_spread", "-"},
    {"steps", ""},
    {"newton_iterations", ""},
    {"tangent_refreshes", ""},
    {"rejected_steps", ""},
    {"factorizations", ""},
    {"energy_drift", "J"},
    {"momentum_drift", "N s"},
    {"angular_momentum_drift", "N m s"},
    {"constraint_residual", "m or rad"},
    {"floor", "*"},
    {"reason", ""},
};
constexpr Figure kOfStudies[] = {
    {"status", ""}, {"simulations", ""}, {"sensitivities", ""}, {"cpu_s", "s"},
    {"mass", "kg"}, {"violation", "-"},  {"kkt", "-"},          {"reason", ""},
};
constexpr std::size_t kStatus = 0;

Figures figures_of(bool of_study) { return of_study ? Figures(kOfStudies) : Figures(kOfScenes); }

std::string cell(const std::optional<double>& x) { return x ? fmt::format("{}", *x) : ""; }

}  // namespace

std::string plain(const std::string& text) {
  const bool quoted =
      text.size() >= 2 && text.front() == text.back() && (text[0] == '\'' || text[0] == '"');
  return quoted ? text.substr(1, text.size() - 2) : text;
}

bool is_figure(const std::string& column, bool of_study) {
  const Figures figures = figures_of(of_study);
  return column == "run" || std::any_of(figures.begin(), figures.end(),
                                        [&](const Figure& f) { return column == f.name; });
}

std::vector<std::string> cells_of(const Measured& m, std::optional<double> error,
                                  std::optional<double> floor) {
  const bool timed = m.ending != Ending::Stopped;
  const auto when_timed = [&](double x) { return timed ? fmt::format("{}", x) : ""; };
  const Report& r = m.report;
  return {name_of(m.ending),
          cell(error),
          when_timed(m.cpu_s),
          when_timed(m.cpu_spread),
          fmt::format("{}", r.steps),
          fmt::format("{}", r.newton_iterations),
          fmt::format("{}", r.tangent_refreshes),
          fmt::format("{}", r.rejected_steps),
          fmt::format("{}", std::accumulate(r.factorizations.begin(), r.factorizations.end(), 0L)),
          cell(m.drift.energy),
          cell(m.drift.momentum),
          cell(m.drift.angular_momentum),
          fmt::format("{}", r.max_constraint_residual),
          cell(floor),
          m.reason};
}

std::vector<std::string> cells_of(const MeasuredMethod& m) {
  return {m.status,
          fmt::format("{}", m.simulations),
          fmt::format("{}", m.sensitivities),
          fmt::format("{}", m.cpu_s),
          cell(m.mass),
          cell(m.violation),
          cell(m.kkt),
          m.reason};
}

std::optional<double> RowTable::figure(const std::string& run, const std::string& column) const {
  const auto row = rows_.find(run);
  const Figures figures = figures_of(runs_.optimize);
  const auto at = std::find_if(figures.begin(), figures.end(),
                               [&](const Figure& f) { return column == f.name; });
  if (row == rows_.end() || at == figures.end()) return std::nullopt;
  const std::string& text = row->second[static_cast<std::size_t>(at - figures.begin())];
  return text.empty() ? std::nullopt : std::optional(std::strtod(text.c_str(), nullptr));
}

std::map<std::string, int> RowTable::endings() const {
  std::map<std::string, int> counts;
  for (const auto& [name, cells] : rows_) ++counts[cells[kStatus]];
  return counts;
}

void RowTable::read(const std::filesystem::path& path) {
  Problems problems(path.string());
  const auto rows = read_csv(output::read_file(path), path.string(), problems);
  const std::size_t before = 1 + runs_.cases.columns.size(),
                    width = before + figures_of(runs_.optimize).size();
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].size() != width) continue;
    auto& cells = rows_[rows[i][0].text];
    cells.clear();
    for (std::size_t c = before; c < width; ++c) cells.push_back(rows[i][c].text);
  }
}

void RowTable::write(const std::filesystem::path& path) const {
  std::vector<output::TextColumn> columns{{"run", "", {}}};
  for (const CaseColumn& column : runs_.cases.columns)
    columns.push_back({column.name, unit_of(runs_, column), {}});
  for (const Figure& figure : figures_of(runs_.optimize))
    columns.push_back({figure.name, figure.unit[0] == '*' ? unit_ : figure.unit, {}});
  for (const CaseList::Row& run : runs_.cases.rows) {
    const auto row = rows_.find(run.name);
    if (row == rows_.end()) continue;
    auto column = columns.begin();
    (column++)->cells.push_back(run.name);
    for (const CaseValue& value : run.values) (column++)->cells.push_back(plain(value.text));
    for (const std::string& text : row->second) (column++)->cells.push_back(text);
  }
  output::replace_file(path, output::columns_csv(columns));
}

}  // namespace liesl
