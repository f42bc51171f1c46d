#include "apps/report/loads.hpp"

#include <cmath>
#include <functional>

#include "apps/output/io_error.hpp"
#include "apps/report/table.hpp"

namespace liesl::report {

namespace {

/// What a row says: cycle, scenario, body, instant, node, load, and of meshed parts its place.
enum Column : std::size_t { kCycle, kScenario, kBody, kTime, kNode, kLoad, kPlace = 11, kEnd = 14 };

std::vector<std::vector<double>> numbers_of(const Table& table) {
  std::vector<std::vector<double>> values(kEnd);
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    if (c != kScenario && c != kBody)  // only meshed parts have places
      values[c] =
          c < kPlace ? table.numbers(table.columns[c]) : table.numbers_and_gaps(table.columns[c]);
  return values;
}

/// The last cycle, and as many before it, evenly spread, as there is room for.
std::function<bool(double)> kept_cycles(const std::vector<double>& cycle) {
  if (cycle.size() <= kMostLoads) return [](double) { return true; };
  const double every = std::ceil(static_cast<double>(cycle.size()) / kMostLoads);
  return [every, last = cycle.back()](double c) { return std::fmod(last - c, every) == 0; };
}

using Range = std::pair<std::size_t, std::size_t>;

/// Values of these rows and columns, by rows.
void append_rows(const std::vector<std::vector<double>>& values, Range rows, Range columns,
                 std::vector<double>& out) {
  for (std::size_t row = rows.first; row < rows.second; ++row)
    for (std::size_t c = columns.first; c < columns.second; ++c) out.push_back(values[c][row]);
}

}  // namespace

Json cycle_loads(const std::filesystem::path& folder, Blob& blob) {
  const std::filesystem::path path = folder / "cycle_loads.csv";
  Json cases = Json::array();
  std::vector<double> loads;
  const Table table = std::filesystem::exists(path) ? read_table(path) : Table();
  if (!table.columns.empty() && table.columns.size() != kEnd)
    throw output::IoError("report", path, "it has other columns; run it again");
  const auto values = numbers_of(table);
  const auto text = [&](std::size_t c, std::size_t row) {
    return std::string(table.columns[c].cells[row]);
  };
  const auto kept = kept_cycles(values[kCycle]);
  bool thinned = false;
  for (std::size_t row = 0, first = 0; row < table.rows(); first = row) {
    while (row < table.rows() && values[kNode][row] == static_cast<double>(row - first)) ++row;
    if (row == first)
      throw output::IoError("report", path, "nodes are missing in it; run it again");
    thinned = thinned || !kept(values[kCycle][first]);
    if (!kept(values[kCycle][first])) continue;
    cases.push_back({{"cycle", values[kCycle][first]},
                     {"scenario", text(kScenario, first)},
                     {"body", text(kBody, first)},
                     {"at", values[kTime][first]},
                     {"nodes", row - first}});
    append_rows(values, {first, row}, {kLoad, kPlace}, loads);
    if (table.columns[kPlace].cells[first].empty()) continue;
    std::vector<double> places;
    append_rows(values, {first, row}, {kPlace, kEnd}, places);
    cases.back()["places"] = blob.f32(places);
  }
  return {{"cases", std::move(cases)},
          {"thinned", thinned},
          {"load", blob.components(loads, kPlace - kLoad, Blob::Digits::Seven)}};
}

}  // namespace liesl::report
