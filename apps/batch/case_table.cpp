#include "apps/batch/case_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace liesl {

namespace {

void add(Problems& problems, const InputPlace& at, std::string what, std::string expected,
         std::string hint = "") {
  problems.add(
      {at.file, at.line, at.column, std::move(what), std::move(expected), std::move(hint)});
}

/// Walks a text and keeps the place.
class CsvScanner {
 public:
  CsvScanner(const std::string& text, const std::string& file) : text_(text), at_{file, 1, 1} {
    if (text_.starts_with("\xEF\xBB\xBF")) i_ = 3;  // mark of UTF-8, as spreadsheets write it
  }
  bool end() const { return i_ >= text_.size(); }
  bool at_line_end() const { return end() || text_[i_] == '\n' || text_[i_] == '\r'; }
  const InputPlace& place() const { return at_; }

  char take() {
    const char c = text_[i_++];
    ++at_.column;
    if (c == '\n') at_ = {at_.file, at_.line + 1, 1};
    return c;
  }
  void take_line_end() {
    if (!end() && text_[i_] == '\r') take();
    if (!end() && text_[i_] == '\n') take();
  }
  /// A field without its comma; false if its quote is not closed.
  bool field(std::string& out) {
    if (!end() && text_[i_] == '"') {
      take();
      for (;;) {
        if (end()) return false;
        const char c = take();
        if (c != '"') {
          out += c;
        } else if (!end() && text_[i_] == '"') {
          out += take();
        } else {
          break;
        }
      }
    }
    while (!at_line_end() && text_[i_] != ',') out += take();
    return true;
  }
  bool comma() { return !end() && text_[i_] == ',' && take(); }

 private:
  const std::string& text_;
  std::size_t i_ = 0;
  InputPlace at_;
};

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

bool folder_name(const std::string& name) {
  return !name.empty() && name[0] != '.' && name.size() <= 100 &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) {
           return std::isalnum(c) || c == '.' || c == '_' || c == '-' || c == '+';
         });
}

/// Columns of the header; `names` is set to the number of the column `case`, or stays.
void read_header(const CsvRow& header, CaseList& list, std::size_t& names, Problems& problems) {
  std::set<std::string> seen;
  for (std::size_t c = 0; c < header.size(); ++c) {
    const std::string& key = header[c].text;
    const InputPlace& place = header[c].place;
    if (key.empty()) add(problems, place, "a column without a key", "a key of the study or scene");
    if (!seen.insert(key).second)
      add(problems, place, fmt::format("column '{}' is there twice", key), "every key once");
    if (key == "case" && names == header.size())
      names = c;
    else
      list.columns.push_back({key, {key}, place});
  }
  if (list.columns.empty())
    add(problems, header.front().place, "the table changes no key",
        "a column with a key of the study or scene", "as in joints.motor.drive.rate");
}

}  // namespace

bool reserved(const std::string& column) {
  return column == "case" || column == "status" || column == "reason";
}

std::vector<CsvRow> read_csv(const std::string& text, const std::string& file, Problems& problems) {
  std::vector<CsvRow> rows;
  CsvScanner scan(text, file);
  while (!scan.end()) {
    CsvRow row;
    if (!scan.at_line_end()) {
      do {
        row.push_back({"", scan.place()});
        if (!scan.field(row.back().text)) {
          add(problems, row.back().place, "a quote that is not closed", "\"...\"");
          return rows;
        }
        row.back().text = trimmed(row.back().text);
      } while (scan.comma());
      rows.push_back(std::move(row));
    }
    scan.take_line_end();
  }
  return rows;
}

CaseList read_cases(const std::string& text, const std::string& file, Problems& problems) {
  CaseList list;
  if (text.find('\0') != std::string::npos) {
    add(problems, {file, 0, 0}, "not a table: the file is binary", "a CSV file of the cases");
    return list;
  }
  std::vector<CsvRow> rows = read_csv(text, file, problems);
  const std::string expected = "a line of keys and a line a case";
  if (rows.size() < 2 || rows.size() > kMostCases + 1) {
    add(problems, {file, 0, 0},
        fmt::format("the table has {} cases", std::max<std::size_t>(1, rows.size()) - 1),
        rows.size() < 2 ? expected : fmt::format("at most {}", kMostCases));
    return list;
  }
  const std::size_t width = rows[0].size();
  std::size_t names = width;
  read_header(rows[0], list, names, problems);
  std::set<std::string> seen;
  const std::size_t digits = fmt::formatted_size("{}", rows.size() - 1);
  for (std::size_t r = 1; r < rows.size(); ++r) {
    if (rows[r].size() != width) {
      add(problems, rows[r][0].place, fmt::format("a row of {} fields", rows[r].size()),
          fmt::format("{}, as in the first line", width));
      continue;
    }
    CaseList::Row row{fmt::format("{:0{}}", r, digits), {}};
    for (std::size_t c = 0; c < width; ++c) {
      const CaseValue& value = rows[r][c];
      if (value.text.empty()) add(problems, value.place, "an empty field", "a value");
      if (c != names) {
        row.values.push_back(value);
        continue;
      }
      row.name = value.text;
      if (!value.text.empty() && !folder_name(row.name))
        add(problems, value.place, fmt::format("'{}' is no name of a case", row.name),
            "letters, digits, '.', '_', '-', '+', not beginning with a dot");
      if (!seen.insert(row.name).second)
        add(problems, value.place, fmt::format("case '{}' is there twice", row.name),
            "every name once");
    }
    list.rows.push_back(std::move(row));
  }
  return list;
}

}  // namespace liesl
