#pragma once
/// @file
/// Tables (CSV) of a results folder, read back.

#include <deque>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace liesl::report {

/// Columns "name [unit]" of texts, as the file has them.
struct Table {
  struct Column {
    std::string name, unit;
    std::vector<std::string_view> cells;  ///< of `texts`
  };
  std::filesystem::path file;
  std::vector<Column> columns;
  /// The file, and the cells that stand in quotes there.
  std::shared_ptr<const std::deque<std::string>> texts;

  std::size_t rows() const { return columns.empty() ? 0 : columns.front().cells.size(); }
  bool empty() const { return rows() == 0; }
  /// Null if there is none of that name.
  const Column* column(const std::string& name) const;
  /// @throws output::IoError with line and column of a cell that is no finite number
  std::vector<double> numbers(const Column& column) const;
  /// NaN where a cell is empty. @throws output::IoError with line and column of one that is a text
  std::vector<double> numbers_and_gaps(const Column& column) const;

 private:
  [[noreturn]] void refuse(const Column& column, std::size_t row, const char* what) const;
};

/// @throws output::IoError for a file that is no table, or ends within a line
Table read_table(const std::filesystem::path& path);

/// NaN where a cell is no number, for columns that may be of texts.
std::vector<double> numbers_or_nan(const Table::Column& column);

}  // namespace liesl::report
