#include "apps/batch/results.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "apps/batch/case_folder.hpp"
#include "apps/output/data_tree.hpp"
#include "apps/output/file.hpp"
#include "apps/output/hdf5_file.hpp"
#include "apps/output/io_error.hpp"

namespace liesl {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Columns by name, each as long as the number of rows before it is used.
class Figures {
 public:
  explicit Figures(BatchTable& table) : table_(table) {}

  void add(const std::string& name, const std::string& unit, double value) {
    if (!std::isfinite(value)) return;
    const auto [at, fresh] = index_.try_emplace(name, table_.figures.size());
    if (fresh) table_.figures.push_back({name, unit, {}});
    auto& cells = table_.figures[at->second].cells;
    cells.resize(table_.rows());
    cells.back() = fmt::format("{}", value);
  }
  /// A number; nothing of null, lists and what is missing.
  void add(const std::string& name, const std::string& unit, const Json& value) {
    if (value.is_number()) add(name, unit, value.get<double>());
  }
  void finish() {
    for (auto& column : table_.figures) column.cells.resize(table_.rows());
  }

 private:
  BatchTable& table_;
  std::map<std::string, std::size_t> index_;
};

const Json& member(const Json& object, const std::string& key) {
  static const Json none;
  return object.is_object() && object.contains(key) ? object.at(key) : none;
}

/// The scalar figures of a summary and their units, in the order of the table.
constexpr std::pair<const char*, const char*> kScalars[] = {
    {"mass_initial", "kg"},
    {"mass_final", "kg"},
    {"worst_constraint", "-"},
    {"worst_constraint_error", "-"},
    {"kkt_residual", "-"},
    {"load_change", "-"},
    {"cycles", "-"},
    {"steps", "-"},
    {"newton_iterations", "-"},
    {"rejected_steps", "-"},
    {"stepping_s", "s"},
};

void add_figures(Figures& figures, const Json& summary) {
  for (const auto& [name, unit] : kScalars) figures.add(name, unit, member(summary, name));
  for (const auto& [name, value] : member(summary, "design").items())
    figures.add(name,
                member(member(member(summary, "design_range"), name), "unit").get<std::string>(),
                value);
  for (const auto& [name, limit] : member(summary, "constraints").items()) {
    figures.add(name + ".max_abs", limit.at("unit"), limit.at("max_abs_final"));
    figures.add(name + ".violation", "-", limit.at("violation"));
  }
  for (const auto& [name, response] : member(summary, "responses").items()) {
    const std::string unit = response.at("unit");
    figures.add(name + ".max_abs", unit, response.at("max_abs"));
    const Json& last = response.at("final");
    figures.add(name + ".final", unit, last);
    const std::string axes = response.value("axes", last.is_array() ? "xyz" : "");
    for (std::size_t c = 0; c < axes.size() && (last.is_number() || c < last.size()); ++c)
      figures.add(name + ".final." + axes[c], unit, last.is_array() ? last[c] : last);
  }
  const Json& frequencies = member(summary, "frequencies_hz");
  for (std::size_t m = 0; m < frequencies.size(); ++m)
    figures.add(fmt::format("frequency[{}]", m), "Hz", frequencies[m]);
}

void add_summary(Figures& figures, const CaseFolder& folder) try {
  add_figures(figures, folder.summary());
} catch (const Json::exception& error) {
  throw output::IoError("read", folder.path() / "summary.json",
                        fmt::format("it is no summary of liesl ({}); remove the folder of the case "
                                    "and run the batch again",
                                    error.what()));
}

/// All cells as numbers, NaN for an empty one (a case without the figure); empty if one is a word.
std::optional<std::vector<double>> numbers(const std::vector<std::string>& cells) {
  std::vector<double> values;
  for (const std::string& cell : cells) {
    double x = std::nan("");
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), x);
    if (!cell.empty() && (error != std::errc{} || end != cell.data() + cell.size())) return {};
    values.push_back(x);
  }
  return values;
}

void write_column(const output::Hdf5File& file, const std::string& group,
                  const output::TextColumn& column) {
  const std::string name = group + "/" + output::hdf5_name(column.name);
  if (const auto values = numbers(column.cells))
    file.write(name, *values, {values->size()});
  else
    file.write(name, column.cells);
  if (!column.unit.empty()) file.attribute(name, "unit", column.unit);
}

}  // namespace

BatchTable collect_cases(const Batch& batch, const fs::path& folder) {
  BatchTable table;
  for (const CaseColumn& column : batch.cases.columns)
    table.inputs.push_back({column.name, unit_of(batch, column), {}});
  Figures figures(table);
  for (const CaseList::Row& row : batch.cases.rows) {
    const CaseFolder place(folder, row.name);
    const auto end = place.end();
    if (!end) continue;
    table.cases.cells.push_back(row.name);
    table.status.cells.push_back(end->status);
    table.reason.cells.push_back(end->reason);
    for (std::size_t c = 0; c < row.values.size(); ++c)
      table.inputs[c].cells.push_back(row.values[c].text);
    ++table.statuses[end->status];
    table.failed += end->failed;
    table.cpu_s += end->cpu_s;
    if (end->figures) add_summary(figures, place);
    figures.add("wall_s", "s", end->wall_s);
    figures.add("cpu_s", "s", end->cpu_s);
    figures.add("peak_memory_mb", "MB", end->peak_memory_mb);
  }
  figures.finish();
  return table;
}

void write_batch_csv(const fs::path& folder, const BatchTable& table) {
  std::vector<output::TextColumn> columns{table.cases};
  for (const auto& input : table.inputs) columns.push_back({input.name, "", input.cells});
  columns.insert(columns.end(), {table.status, table.reason});
  columns.insert(columns.end(), table.figures.begin(), table.figures.end());
  output::replace_file(folder / "results.csv", output::columns_csv(columns));
}

void write_batch_hdf5(const fs::path& folder, const BatchTable& table) {
  const fs::path part = folder / ".results.h5.part";
  output::Hdf5File file(part);
  for (const auto* column : {&table.cases, &table.status, &table.reason})
    file.write("/" + column->name, column->cells);
  file.group("/inputs");
  for (const auto& column : table.inputs) write_column(file, "/inputs", column);
  file.group("/figures");
  for (const auto& column : table.figures) write_column(file, "/figures", column);
  file.group("/cases");
  for (const std::string& name : table.cases.cells)
    if (const fs::path results = folder / "cases" / name / "results.h5"; fs::exists(results))
      file.copy(results, "/cases/" + name);
  file.close();
  fs::rename(part, folder / "results.h5");
}

}  // namespace liesl
