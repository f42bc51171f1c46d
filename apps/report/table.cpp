#include "apps/report/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "apps/output/file.hpp"
#include "apps/output/io_error.hpp"

namespace liesl::report {
namespace {

/// The cell that begins at `at` (RFC 4180: quotes where it holds commas, quotes or line breaks);
/// one in quotes is put into `texts`. `at` goes to what ends it.
std::string_view cell(std::string_view text, std::size_t& at, std::deque<std::string>& texts) {
  const std::size_t start = at;
  const auto plain = [](char c) { return c != ',' && c != '\n' && c != '\r' && c != '"'; };
  while (at < text.size() && plain(text[at])) ++at;
  const std::string_view first = text.substr(start, at - start);
  if (at == text.size() || text[at] == ',' || text[at] == '\n') return first;
  std::string& whole = texts.emplace_back(first);
  for (bool quoted = false; at < text.size(); ++at) {
    const char c = text[at];
    if (quoted && c == '"' && at + 1 < text.size() && text[at + 1] == '"')
      whole += text[++at];
    else if (c == '"')
      quoted = !quoted;
    else if (!quoted && (c == ',' || c == '\n'))
      break;
    else if (quoted || c != '\r')
      whole += c;
  }
  return whole;
}

/// Cells of one line; `at` goes to the start of the next one.
void read_line(std::string_view text, std::size_t& at, std::deque<std::string>& texts,
               std::vector<std::string_view>& cells) {
  cells.clear();
  for (bool more = true; more; ++at) {
    cells.push_back(cell(text, at, texts));
    more = at < text.size() && text[at] == ',';
  }
}

/// "bend [m]" -> "bend", "m".
Table::Column heading(std::string_view text) {
  const std::size_t bracket = text.rfind(" [");
  if (bracket == text.npos || text.back() != ']') return {std::string(text), "", {}};
  return {std::string(text.substr(0, bracket)),
          std::string(text.substr(bracket + 2, text.size() - bracket - 3)),
          {}};
}

}  // namespace

const Table::Column* Table::column(const std::string& name) const {
  const auto at =
      std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.name == name; });
  return at == columns.end() ? nullptr : &*at;
}

Table read_table(const std::filesystem::path& path) {
  const auto texts = std::make_shared<std::deque<std::string>>();
  const std::string& text = texts->emplace_back(output::read_file(path));
  if (text.empty() || text.back() != '\n')
    throw output::IoError("read", path, "it ends within a line: half a result; run it again");
  Table table;
  table.file = path;
  table.texts = texts;
  std::vector<std::string_view> cells;
  std::size_t at = 0;
  read_line(text, at, *texts, cells);
  for (const std::string_view name : cells) table.columns.push_back(heading(name));
  for (std::size_t row = 2; at < text.size(); ++row) {
    read_line(text, at, *texts, cells);
    if (cells.size() != table.columns.size())
      throw output::IoError("read", path,
                            "line " + std::to_string(row) + " has " + std::to_string(cells.size()) +
                                " cells, the heading " + std::to_string(table.columns.size()));
    for (std::size_t c = 0; c < cells.size(); ++c) table.columns[c].cells.push_back(cells[c]);
  }
  return table;
}

std::vector<double> Table::numbers(const Column& column) const {
  std::vector<double> out = numbers_or_nan(column);
  for (std::size_t row = 0; row < out.size(); ++row)
    if (!std::isfinite(out[row])) refuse(column, row, "no finite number");
  return out;
}

std::vector<double> Table::numbers_and_gaps(const Column& column) const {
  std::vector<double> out = numbers_or_nan(column);
  for (std::size_t row = 0; row < out.size(); ++row)
    if (const auto cell = column.cells[row];
        std::isnan(out[row]) && !cell.empty() && cell != "nan" && cell != "-nan")
      refuse(column, row, "no number");
  return out;
}

void Table::refuse(const Column& column, std::size_t row, const char* what) const {
  throw output::IoError("read", file,
                        fmt::format("'{}' of column '{}' in line {} is {}: run it again",
                                    column.cells[row], column.name, row + 2, what));
}

std::vector<double> numbers_or_nan(const Table::Column& column) {
  std::vector<double> out;
  out.reserve(column.cells.size());
  for (const std::string_view text : column.cells) {
    double x = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, x);
    const bool number = error == std::errc() && stop == end;
    out.push_back(number ? x : std::numeric_limits<double>::quiet_NaN());
  }
  return out;
}

}  // namespace liesl::report
