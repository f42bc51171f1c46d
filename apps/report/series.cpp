#include "apps/report/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include "apps/output/io_error.hpp"
#include "apps/report/table.hpp"

namespace fs = std::filesystem;

namespace liesl::report {
namespace {

/// Where lines of charts go, and how many points each may have.
struct Lines {
  Blob& blob;
  std::size_t points;
};

/// Records that a line of a chart keeps: all, or smallest and largest of each stretch.
std::vector<std::size_t> kept(const std::vector<double>& y, std::size_t points) {
  std::vector<std::size_t> out;
  const std::size_t n = y.size(), stretches = points / 2;
  if (n <= points) {
    for (std::size_t i = 0; i < n; ++i) out.push_back(i);
    return out;
  }
  std::set<std::size_t> chosen = {0, n - 1};
  for (std::size_t s = 0; s < stretches; ++s) {
    const auto from = y.begin() + static_cast<long>(s * n / stretches),
               to = y.begin() + static_cast<long>((s + 1) * n / stretches);
    const auto [low, high] = std::minmax_element(from, to);
    chosen.insert(static_cast<std::size_t>(low - y.begin()));
    chosen.insert(static_cast<std::size_t>(high - y.begin()));
  }
  return {chosen.begin(), chosen.end()};
}

Json line(const std::string& label, const std::vector<double>& x, const std::vector<double>& y,
          const Lines& lines) {
  std::vector<double> xs, ys;
  for (const std::size_t i : kept(y, lines.points)) {
    xs.push_back(x[i]);
    ys.push_back(y[i]);
  }
  return {{"label", label}, {"x", lines.blob.f32(xs)}, {"y", lines.blob.f32(ys)}};
}

Json chart(const std::string& title, const std::string& unit, const Table::Column& abscissa) {
  return {{"title", title},
          {"unit", unit},
          {"abscissa", abscissa.name},
          {"abscissa_unit", abscissa.unit},
          {"lines", Json::array()}};
}

constexpr const char* kResponses = "responses.csv";
constexpr const char* kEnergies = "energies.csv";
/// With scenarios each once, "responses_final_fast.csv".
constexpr const char *kInitial = "responses_initial", *kFinal = "responses_final";

/// What scenarios add to the names of files with limits: "_fast"; of a single motion "".
std::vector<std::string> scenarios_in(const fs::path& folder) {
  const std::string start = kFinal, end = ".csv";
  std::vector<std::string> out;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(start) && name.ends_with(end))
      out.push_back(name.substr(start.size(), name.size() - start.size() - end.size()));
  }
  std::sort(out.begin(), out.end());
  return out;
}

/// By the names of their files.
using Tables = std::map<std::string, Table>;

/// What charts are drawn of: limits before and after, or else responses, and energies.
Tables tables_of(const fs::path& folder, const std::vector<std::string>& scenarios) {
  std::vector<std::string> files;
  for (const char* file : {scenarios.empty() ? kResponses : "", kEnergies})
    if (*file && fs::exists(folder / file)) files.push_back(file);
  for (const std::string& scenario : scenarios)
    for (const char* design : {kInitial, kFinal}) files.push_back(design + scenario + ".csv");
  Tables tables;
  for (const std::string& file : files) tables[file] = read_table(folder / file);
  return tables;
}

/// As many points a line as all lines have room for.
std::size_t points_a_line(const Tables& tables) {
  std::size_t lines = 1;
  for (const auto& [file, table] : tables) lines += table.columns.size() - 1;
  return std::clamp(kMostChartPoints / lines, kFewestPoints, kMostPoints);
}

/// The error of the largest value, where it is known: in all, or that by mesh and that by step.
void add_error(const Json& figure, Json& chart) {
  if (!figure.contains("error")) return;
  if (const auto& total = figure["error"].value("total", Json()); total.is_number()) {
    chart["error"] = total;
    return;
  }
  double sum = 0;
  for (const char* by : {"mesh", "step"})
    if (const auto& error = figure["error"].value(by, Json()); error.is_number())
      sum += error.get<double>();
  chart["error"] = sum;
}

/// A limit before and after, a chart each. @param scenario "_fast"; "" of a single motion
void add_limit_charts(const Tables& tables, const std::string& scenario, const Json& summary,
                      const Lines& lines, Json& list) {
  const Table &initial = tables.at(kInitial + scenario + ".csv"),
              &final = tables.at(kFinal + scenario + ".csv");
  for (std::size_t c = 1; c < final.columns.size(); ++c) {
    const Table::Column& after = final.columns[c];
    const std::string name =
        scenario.empty() ? after.name : after.name + " (" + scenario.substr(1) + ")";
    Json one = chart(name, after.unit, final.columns[0]);
    if (const auto* before = initial.column(after.name); before && !initial.empty())
      one["lines"].push_back(
          line("initial", initial.numbers(initial.columns[0]), initial.numbers(*before), lines));
    one["lines"].push_back(
        line("final", final.numbers(final.columns[0]), final.numbers(after), lines));
    const Json& limits = summary.value("constraints", Json::object());
    if (limits.contains(name)) {
      one["limit"] = limits[name]["limit"];
      one["at"] = limits[name]["at_time"];
      add_error(limits[name], one);
    }
    list.push_back(std::move(one));
  }
}

/// The response that a column is of: "tip.x" of "tip".
std::string owner(const std::string& column, const Json& responses) {
  if (responses.contains(column)) return column;
  const std::size_t dot = column.rfind('.');
  return dot != std::string::npos && responses.contains(column.substr(0, dot))
             ? column.substr(0, dot)
             : column;
}

Json response_charts(const Table& table, const Json& summary, const Lines& lines) {
  const std::vector<double> x = table.numbers(table.columns.at(0));
  const Json responses = summary.value("responses", Json::object());
  Json list = Json::array();
  for (std::size_t c = 1; c < table.columns.size(); ++c) {
    const Table::Column& column = table.columns[c];
    const std::string title = owner(column.name, responses);
    if (list.empty() || list.back()["title"] != title) {
      list.push_back(chart(title, column.unit, table.columns[0]));
      if (responses.contains(title)) add_error(responses[title], list.back());
    }
    list.back()["lines"].push_back(line(column.name, x, table.numbers(column), lines));
  }
  return list;
}

Json energy_chart(const Table& table, const Lines& lines) {
  const std::vector<double> x = table.numbers(table.columns.at(0));
  Json one = chart("energies", "J", table.columns[0]);
  for (std::size_t c = 1; c < table.columns.size(); ++c)
    if (table.columns[c].unit == "J")
      one["lines"].push_back(line(
          table.columns[c].name + (table.columns[c].name == "dissipated" ? " (numerical)" : ""), x,
          table.numbers(table.columns[c]), lines));
  return one;
}

/// Lines of the steps that are kept: evenly spread, first and last among them.
Json outline_steps(const Table& table, Blob& blob) {
  const auto step = table.numbers(table.columns.at(0)), which = table.numbers(table.columns.at(1)),
             x = table.numbers(table.columns.at(2)), y = table.numbers(table.columns.at(3));
  const double last = step.back();
  const double every = std::max(1.0, (last - 1) / static_cast<double>(kMostOutlines - 1));
  Json steps = Json::array();
  double next = 1;
  for (std::size_t i = 0; i < step.size();) {
    const double now = step[i];
    const bool keep = now >= next - 0.5 || now == last;
    if (keep) {
      while (next <= now + 0.5) next += every;
      steps.push_back({{"step", now}, {"lines", Json::array()}});
    }
    while (i < step.size() && step[i] == now) {
      const double here = which[i];
      std::vector<double> points;
      for (; i < step.size() && step[i] == now && which[i] == here; ++i)
        points.insert(points.end(), {x[i], y[i]});
      if (keep) steps.back()["lines"].push_back(blob.i16(points));
    }
  }
  return steps;
}

/// Corners [M, 4, 2] and stresses [M] of the cells that are at least half material.
void add_cells(const fs::path& file, Json& part, Blob& blob) {
  const Table table = read_table(file);
  const auto* fraction = table.column("fraction");
  const auto* stress = table.column("stress");
  if (!fraction || !stress || table.columns.size() < 8) return;
  std::vector<std::vector<double>> corners;
  for (std::size_t c = 0; c < 8; ++c) corners.push_back(table.numbers(table.columns[c]));
  const auto share = table.numbers(*fraction), all = table.numbers(*stress);
  std::vector<double> places, values;
  for (std::size_t e = 0; e < share.size(); ++e) {
    if (share[e] <= 0) continue;
    for (const auto& column : corners) places.push_back(column[e]);
    values.push_back(all[e]);
  }
  part["cells"] = blob.i16(places);
  part["stress"] = blob.i16(values);
}

}  // namespace

Json charts(const fs::path& folder, const Json& summary, Blob& blob) {
  Json list = Json::array();
  const std::vector<std::string> scenarios = scenarios_in(folder);
  const Tables tables = tables_of(folder, scenarios);
  const Lines lines{blob, points_a_line(tables)};
  for (const std::string& scenario : scenarios)
    add_limit_charts(tables, scenario, summary, lines, list);
  if (tables.contains(kResponses)) list = response_charts(tables.at(kResponses), summary, lines);
  if (tables.contains(kEnergies)) list.push_back(energy_chart(tables.at(kEnergies), lines));
  return list;
}

Json sized_elements(const fs::path& folder) {
  Json list = Json::array();
  if (!fs::exists(folder / "design.csv")) return list;
  const Table table = read_table(folder / "design.csv");
  const auto *variable = table.column("variable"), *body = table.column("body"),
             *element = table.column("element"), *dimension = table.column("dimension");
  if (!variable || !body || !element || !dimension) return list;
  const auto numbered = table.numbers(*element);
  for (std::size_t i = 0; i < table.rows(); ++i)
    list.push_back({{"variable", std::string(variable->cells[i])},
                    {"body", std::string(body->cells[i])},
                    {"element", static_cast<int>(numbered[i])},
                    {"dimensions", std::string(dimension->cells[i])}});
  return list;
}

Json outlines(const fs::path& folder, Blob& blob) {
  constexpr std::string_view kEnd = "_outlines.csv";
  std::vector<std::string> parts;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(kEnd)) parts.push_back(name.substr(0, name.size() - kEnd.size()));
  }
  std::sort(parts.begin(), parts.end());
  Json list = Json::array();
  for (const std::string& name : parts) {
    const Table table = read_table(folder / (name + std::string(kEnd)));
    if (table.empty()) continue;
    Json part = {{"part", name}, {"steps", outline_steps(table, blob)}};
    if (const fs::path cells = folder / (name + "_cells.csv"); fs::exists(cells))
      add_cells(cells, part, blob);
    list.push_back(std::move(part));
  }
  return list;
}

Json cases(const fs::path& file, std::size_t least) {
  const Table table = read_table(file);
  if (table.rows() < least)
    throw output::IoError(
        "read", file,
        fmt::format("it has {} rows, and summary.json tells of {}: half a result; "
                    "run it again",
                    table.rows(), least));
  Json columns = Json::array();
  bool figures = !table.column("status");  // behind the status there are numbers and the reason
  for (const Table::Column& column : table.columns) {
    const auto values = figures && column.name != "reason" ? table.numbers_and_gaps(column)
                                                           : numbers_or_nan(column);
    figures = figures || column.name == "status";
    const bool number =
        std::all_of(column.cells.begin(), column.cells.end(),
                    [&, i = std::size_t{0}](std::string_view cell) mutable {
                      return !std::isnan(values[i++]) || cell.empty();
                    }) &&
        std::any_of(values.begin(), values.end(), [](double x) { return !std::isnan(x); });
    Json cells = Json::array();
    for (std::size_t i = 0; i < values.size(); ++i)
      cells.push_back(!number                 ? Json(std::string(column.cells[i]))
                      : std::isnan(values[i]) ? Json(nullptr)
                                              : Json(values[i]));
    columns.push_back({{"name", column.name},
                       {"unit", column.unit},
                       {"number", number},
                       {"cells", std::move(cells)}});
  }
  return {{"columns", std::move(columns)}};
}

}  // namespace liesl::report
