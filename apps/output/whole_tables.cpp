#include "apps/output/whole_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "apps/output/file.hpp"
#include "apps/output/hdf5_input.hpp"
#include "apps/output/io_error.hpp"

namespace fs = std::filesystem;

namespace liesl::output {
namespace {

constexpr const char* kAdvice = "half a result; copy the whole folder, or run it again";

/// Lines below the heading; line ends in quotes are none.
std::size_t rows_of(std::string_view text) {
  std::size_t lines = 0;
  bool quoted = false;
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (c == '\n' && !quoted) ++lines;
  }
  return lines > 0 ? lines - 1 : 0;
}

/// First cell of the last line; NaN if it is no number.
double last_abscissa(std::string_view text) {
  const std::size_t before = text.size() > 1 ? text.rfind('\n', text.size() - 2) : text.npos;
  double x = std::nan("");
  if (before != text.npos) std::from_chars(text.data() + before + 1, text.data() + text.size(), x);
  return x;
}

/// The text of a table that ends with a line; empty where there is none.
std::string table_of(const fs::path& path) {
  std::string text = fs::exists(path) ? read_file(path) : "";
  return text.ends_with('\n') ? text : "";
}

void check_rows(const fs::path& path, std::size_t expected, const std::string& whose,
                const std::string& verb) {
  const std::string text = table_of(path);
  if (text.empty() || rows_of(text) >= expected) return;
  throw IoError(
      verb, path,
      fmt::format("it has {} rows, and {} {}: {}", rows_of(text), whose, expected, kAdvice));
}

void check_records(const fs::path& folder, const std::string& verb) {
  const Hdf5Input file(folder / "results.h5");
  const std::vector<double> times = file.numbers("/time").values;
  for (const char* name : {"responses.csv", "energies.csv", "joints.csv"})
    check_rows(folder / name, times.size(), "the records of results.h5 are", verb);
  const fs::path limits = folder / "responses_final.csv";  // of every step, recorded or not
  const std::string text = table_of(limits);
  if (text.empty() || times.empty()) return;
  constexpr double kEndsAlike = 1e-9;
  if (const double end = last_abscissa(text);
      end < times.back() - kEndsAlike * std::abs(times.back()))
    throw IoError(
        verb, limits,
        fmt::format("it ends at {:.6g}, and results.h5 at {:.6g}: {}", end, times.back(), kAdvice));
}

}  // namespace

void check_tables(const fs::path& folder, const nlohmann::ordered_json& summary,
                  const std::string& verb) {
  const std::string command = summary.value("command", "");
  const auto ended = summary.value("done", std::size_t{0});
  if (command == "batch" || command == "compare")
    return check_rows(folder / (command == "batch" ? "results.csv" : "rows.csv"), ended,
                      "summary.json tells of", verb);
  if (fs::exists(folder / "results.h5")) check_records(folder, verb);
}

}  // namespace liesl::output
