#include "apps/mesh/matrix_market.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "apps/input/problem.hpp"

namespace liesl {
namespace {

constexpr std::string_view kBanner = "%%matrixmarket";

/// The lines of a file that hold something, as words.
class Lines {
 public:
  Lines(const std::string& file, std::string_view text) : file_(file), text_(text) {}

  [[noreturn]] void fail(std::string what, std::string expected) const {
    throw InputError({{file_, line_, 1, std::move(what), std::move(expected), ""}});
  }

  /// Words of the next line; comments are passed over but for the banner in line 1.
  std::vector<std::string_view> next() {
    while (at_ < text_.size()) {
      const auto end = std::min(text_.find('\n', at_), text_.size());
      const std::string_view line = text_.substr(at_, end - at_);
      at_ = end + 1;
      ++line_;
      auto words = split(line);
      if (!words.empty() && (words[0][0] != '%' || line_ == 1)) return words;
    }
    fail("the file ends early", "more numbers");
  }
  std::vector<std::string_view> next(std::size_t words, const char* expected) {
    const auto found = next();
    if (found.size() != words) fail(fmt::format("a line of {} words", found.size()), expected);
    return found;
  }

  template <class Number>
  Number number(std::string_view word) const {
    if (word.starts_with('+')) word.remove_prefix(1);
    Number x{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), x);
    if (error != std::errc() || end != word.data() + word.size())
      fail(fmt::format("'{}' is not a number", word), "a number");
    return x;
  }
  double finite(std::string_view word) const {
    const double x = number<double>(word);
    if (!std::isfinite(x)) fail(fmt::format("'{}' is not finite", word), "a finite number");
    return x;
  }
  int size(std::string_view word, int least) const {
    const int n = number<int>(word);
    if (n < least) fail(fmt::format("{} cannot be a size", n), fmt::format("at least {}", least));
    return n;
  }

 private:
  static std::vector<std::string_view> split(std::string_view line) {
    std::vector<std::string_view> words;
    while (true) {
      const auto from = line.find_first_not_of(" \t\r");
      if (from == std::string_view::npos) return words;
      line.remove_prefix(from);
      const auto to = std::min(line.find_first_of(" \t\r"), line.size());
      words.push_back(line.substr(0, to));
      line.remove_prefix(to);
    }
  }

  const std::string& file_;
  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 0;
};

/// "%%MatrixMarket matrix coordinate real symmetric": whether it is symmetric.
bool read_banner(Lines& lines, const std::string& format, const std::string& expected) {
  std::vector<std::string> words;
  for (const std::string_view word : lines.next()) {
    words.emplace_back(word);
    for (char& c : words.back()) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  if (words[0] != kBanner) lines.fail("this is not a MatrixMarket file", expected);
  const bool fits = words.size() == 5 && words[1] == "matrix" && words[2] == format &&
                    (words[3] == "real" || words[3] == "double" || words[3] == "integer") &&
                    (words[4] == "general" || (words[4] == "symmetric" && format == "coordinate"));
  if (!fits) lines.fail("a matrix of another format", expected);
  return words[4] == "symmetric";
}

std::string banner(const std::string& format, const std::string& comment) {
  return "%%MatrixMarket matrix " + format + "\n% " + comment + "\n";
}

}  // namespace

Eigen::SparseMatrix<double> read_sparse(const std::string& file, std::string_view text) {
  Lines lines(file, text);
  const bool symmetric =
      read_banner(lines, "coordinate", "%%MatrixMarket matrix coordinate real symmetric");
  const auto head = lines.next(3, "rows, columns, entries");
  const int rows = lines.size(head[0], 1), columns = lines.size(head[1], 1),
            count = lines.size(head[2], 0);
  if (symmetric && rows != columns)
    lines.fail(fmt::format("a symmetric matrix of {} x {}", rows, columns), "a square one");
  std::vector<Eigen::Triplet<double>> entries;
  for (int k = 0; k < count; ++k) {
    const auto words = lines.next(3, "row, column, value");
    const int i = lines.size(words[0], 1) - 1, j = lines.size(words[1], 1) - 1;
    if (i >= rows || j >= columns)
      lines.fail(fmt::format("an entry at ({}, {})", i + 1, j + 1),
                 fmt::format("one in {} x {}", rows, columns));
    if (symmetric && j > i)
      lines.fail(fmt::format("an entry at ({}, {}) of a symmetric matrix", i + 1, j + 1),
                 "its lower triangle");
    const double value = lines.finite(words[2]);
    entries.emplace_back(i, j, value);
    if (symmetric && i != j) entries.emplace_back(j, i, value);
  }
  Eigen::SparseMatrix<double> A(rows, columns);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

Eigen::MatrixXd read_dense(const std::string& file, std::string_view text) {
  Lines lines(file, text);
  read_banner(lines, "array", "%%MatrixMarket matrix array real general");
  const auto head = lines.next(2, "rows, columns");
  const int rows = lines.size(head[0], 1), columns = lines.size(head[1], 1);
  if (static_cast<double>(rows) * columns > static_cast<double>(text.size()))
    lines.fail(fmt::format("{} x {} numbers", rows, columns), "a size that fits the file");
  Eigen::MatrixXd A(rows, columns);
  for (double& x : A.reshaped()) x = lines.finite(lines.next(1, "one number")[0]);
  return A;
}

std::string symmetric_text(const Eigen::SparseMatrix<double>& lower, const std::string& comment) {
  std::string text = banner("coordinate real symmetric", comment);
  std::string entries;
  int count = 0;
  for (int j = 0; j < lower.outerSize(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator a(lower, j); a; ++a) {
      if (a.value() == 0 || a.row() < j) continue;
      entries += fmt::format("{} {} {}\n", a.row() + 1, j + 1, a.value());
      ++count;
    }
  return text + fmt::format("{} {} {}\n", lower.rows(), lower.cols(), count) + entries;
}

std::string dense_text(const Eigen::MatrixXd& matrix, const std::string& comment) {
  std::string text = banner("array real general", comment);
  text += fmt::format("{} {}\n", matrix.rows(), matrix.cols());
  for (const double x : matrix.reshaped()) text += fmt::format("{}\n", x);
  return text;
}

}  // namespace liesl
