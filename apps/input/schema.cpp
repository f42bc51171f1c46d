#include "apps/input/schema.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <sstream>

namespace liesl {

bool Range::contains(double x) const {
  return (open_lower ? x > lower : x >= lower) && (open_upper ? x < upper : x <= upper);
}

std::string Range::text() const {
  const bool below = std::isfinite(lower), above = std::isfinite(upper);
  if (below && above)
    return fmt::format("in {}{:g}, {:g}{}", open_lower ? '(' : '[', lower, upper,
                       open_upper ? ')' : ']');
  if (below) return fmt::format("{} {:g}", open_lower ? ">" : ">=", lower);
  if (above) return fmt::format("{} {:g}", open_upper ? "<" : "<=", upper);
  return "";
}

std::string_view Key::parent() const {
  const auto dot = path.rfind('.');
  return dot == std::string::npos ? std::string_view{} : std::string_view(path).substr(0, dot);
}

std::string_view Key::leaf() const {
  const auto dot = path.rfind('.');
  return dot == std::string::npos ? std::string_view(path) : std::string_view(path).substr(dot + 1);
}

const std::vector<Key>& schema(FileKind kind) {
  static const std::vector<Key> scene = scene_keys();
  static const std::vector<Key> study = study_keys();
  static const std::vector<Key> batch = batch_keys();
  static const std::vector<Key> comparison = compare_keys();
  static const std::vector<Key> sensitivity = sensitivity_keys();
  switch (kind) {
    case FileKind::Scene:
      return scene;
    case FileKind::Study:
      return study;
    case FileKind::Batch:
      return batch;
    case FileKind::Comparison:
      return comparison;
    case FileKind::Sensitivity:
      break;
  }
  return sensitivity;
}

std::string_view name_of(FileKind kind) {
  constexpr std::string_view kNames[] = {"scene", "study", "batch", "comparison", "sensitivity"};
  return kNames[static_cast<int>(kind)];
}

std::vector<const Key*> children(FileKind kind, std::string_view parent) {
  std::vector<const Key*> found;
  for (const Key& key : schema(kind))
    if (key.parent() == parent) found.push_back(&key);
  return found;
}

const Key* find_key(FileKind kind, std::string_view pattern) {
  for (const Key& key : schema(kind))
    if (key.path == pattern) return &key;
  return nullptr;
}

std::string pattern_below(FileKind kind, const std::string& pattern, const std::string& part) {
  const std::string prefix = pattern.empty() ? "" : pattern + ".";
  if (find_key(kind, prefix + part)) return prefix + part;
  if (find_key(kind, prefix + "*")) return prefix + "*";
  return "";
}

std::string_view unit_at(FileKind kind, const std::string& path) {
  std::istringstream parts(path);
  std::string pattern;
  for (std::string part; std::getline(parts, part, '.');) {
    pattern = pattern_below(kind, pattern, part);
    if (pattern.empty()) return {};
  }
  return find_key(kind, pattern)->unit;
}

std::vector<std::string> words(std::string_view text) {
  std::istringstream stream{std::string(text)};
  std::vector<std::string> list;
  for (std::string word; stream >> word;) list.push_back(word);
  return list;
}

namespace {

std::string kind_of_value(const Key& key) {
  const int n = key.size;
  switch (key.type) {
    case Type::Text:
      return "a string";
    case Type::Choice:
      return fmt::format("one of \"{}\"", fmt::join(words(key.options), "\", \""));
    case Type::Boolean:
      return "true or false";
    case Type::Integer:
      return "an integer";
    case Type::Number:
      return "a number";
    case Type::Vector:
      return fmt::format("a list of {} numbers", n);
    case Type::NumberOrList:
      return n > 0 ? fmt::format("a number or a list of {} numbers", n)
                   : "a number or a list of numbers";
    case Type::Rows:
      return fmt::format("a list of two or more rows of {} numbers", n);
    case Type::NumberOrMatrix:
      return fmt::format("a number{1}, {0} numbers{1} (diagonal) or {0} rows of {0}", n,
                         key.range.text().empty() ? "" : " " + key.range.text());
    case Type::Matrix:
      return n == 3 ? "3 numbers (diagonal), 6 numbers [xx, yy, zz, xy, xz, yz] or 3 rows of 3"
                    : fmt::format("{0} numbers (diagonal) or {0} rows of {0}", n);
    case Type::Texts:
      return "a string or a list of strings";
    case Type::Pair:
      return "a list of two strings";
    case Type::Function:
      return "a number, an expression of t, or a table {table = [[t, f], ...]}";
    case Type::Table:
      return "a table";
    case Type::TableOrList:
      return "a table or a list of tables";
    case Type::Named:
      return "a table of named entries";
    case Type::List:
      return "a list of values, one or more";
    case Type::Any:
      return "a value";
    case Type::Point:
      return "a list of 2 or 3 numbers";
  }
  return "a value";
}

}  // namespace

std::string expectation(const Key& key) {
  std::string text = kind_of_value(key);
  const std::string range = key.range.text();
  if (!range.empty() && key.type != Type::NumberOrMatrix) text += " " + range;
  if (!key.unit.empty()) text += fmt::format(" ({})", key.unit);
  return text;
}

}  // namespace liesl
