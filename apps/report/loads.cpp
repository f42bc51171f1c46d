#include "apps/report/loads.hpp"

#include "apps/output/io_error.hpp"
#include "apps/report/table.hpp"

namespace liesl::report {

Json cycle_loads(const std::filesystem::path& folder, Blob& blob) {
  constexpr std::size_t kScenario = 1, kBody = 2, kTime = 3, kNode = 4, kFirst = 5, kComponents = 6,
                        kPlace = 11;
  const std::filesystem::path path = folder / "cycle_loads.csv";
  Json list = Json::array();
  if (!std::filesystem::exists(path)) return list;
  const Table table = read_table(path);
  if (table.columns.size() != kPlace + 3)
    throw output::IoError("report", path, "it has other columns; run it again");
  std::vector<std::vector<double>> values;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const Table::Column& column = table.columns[c];
    const bool text = c == kScenario || c == kBody;  // and only meshed parts have places
    values.push_back(text         ? std::vector<double>()
                     : c < kPlace ? table.numbers(column)
                                  : table.numbers_and_gaps(column));
  }
  const auto text = [&](std::size_t c, std::size_t row) {
    return std::string(table.columns[c].cells[row]);
  };
  for (std::size_t row = 0; row < table.rows();) {
    const std::size_t first = row;
    std::vector<double> load, places;
    for (; row < table.rows() && values[kNode][row] == static_cast<double>(row - first); ++row) {
      for (std::size_t c = 0; c < kComponents; ++c) load.push_back(values[kFirst + c][row]);
      for (std::size_t c = kPlace; c < kPlace + 3 && !table.columns[kPlace].cells[row].empty(); ++c)
        places.push_back(values[c][row]);
    }
    if (row == first)
      throw output::IoError("report", path, "nodes are missing in it; run it again");
    list.push_back({{"cycle", values[0][first]},
                    {"scenario", text(kScenario, first)},
                    {"body", text(kBody, first)},
                    {"at", values[kTime][first]},
                    {"nodes", row - first},
                    {"load", blob.f32(load)}});
    if (!places.empty()) list.back()["places"] = blob.f32(places);
  }
  return list;
}

}  // namespace liesl::report
