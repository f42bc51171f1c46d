#include "apps/report/table.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <utility>

#include "apps/output/file.hpp"
#include "apps/output/io_error.hpp"

namespace liesl::report {
namespace {

/// Cells of one line (RFC 4180: quotes where a cell holds commas, quotes or line breaks); `at` goes
/// to the start of the next one.
std::vector<std::string> line(const std::string& text, std::size_t& at) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (!quoted && cells.back().empty() && c != '"') {  // most cells: nothing is quoted
      const std::size_t end = std::min(text.find_first_of(",\n\r\"", at), text.size());
      cells.back().assign(text, at, end - at);
      if (end > at) {
        at = end - 1;
        continue;
      }
    }
    if (quoted && c == '"' && at + 1 < text.size() && text[at + 1] == '"') {
      cells.back() += text[++at];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (quoted || (c != ',' && c != '\n' && c != '\r')) {
      cells.back() += c;
    } else if (c == ',') {
      cells.emplace_back();
    } else if (c == '\n') {
      ++at;
      break;
    }
  }
  return cells;
}

/// "bend [m]" -> "bend", "m".
Table::Column heading(const std::string& cell) {
  const std::size_t bracket = cell.rfind(" [");
  if (bracket == std::string::npos || cell.back() != ']') return {cell, "", {}};
  return {cell.substr(0, bracket), cell.substr(bracket + 2, cell.size() - bracket - 3), {}};
}

}  // namespace

const Table::Column* Table::column(const std::string& name) const {
  const auto at =
      std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.name == name; });
  return at == columns.end() ? nullptr : &*at;
}

Table read_table(const std::filesystem::path& path) {
  const std::string text = output::read_file(path);
  if (text.empty() || text.back() != '\n')
    throw output::IoError("read", path, "it ends within a line: half a result; run it again");
  Table table;
  std::size_t at = 0;
  for (const std::string& cell : line(text, at)) table.columns.push_back(heading(cell));
  for (std::size_t row = 2; at < text.size(); ++row) {
    auto cells = line(text, at);
    if (cells.size() != table.columns.size())
      throw output::IoError("read", path,
                            "line " + std::to_string(row) + " has " + std::to_string(cells.size()) +
                                " cells, the heading " + std::to_string(table.columns.size()));
    for (std::size_t c = 0; c < cells.size(); ++c)
      table.columns[c].cells.push_back(std::move(cells[c]));
  }
  return table;
}

std::vector<double> numbers(const Table::Column& column) {
  std::vector<double> out;
  for (const std::string& cell : column.cells) {
    double x = 0;
    const char* end = cell.data() + cell.size();
    const auto [stop, error] = std::from_chars(cell.data(), end, x);
    const bool number = error == std::errc() && stop == end;
    out.push_back(number ? x : std::numeric_limits<double>::quiet_NaN());
  }
  return out;
}

}  // namespace liesl::report
