#include "apps/input/check_value.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace liesl {

namespace {

constexpr double kLargest = 1e9;    ///< integer, which an int holds
constexpr double kSquared = 1e100;  ///< number whose square and cube are numbers, too

std::string_view type_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or time";
  }
}

class ValueCheck {
 public:
  explicit ValueCheck(Problems& problems) : problems_(problems) {}

  void check(const Key& key, toml::node& value, const std::string& path) {
    switch (key.type) {
      case Type::Text:
      case Type::Choice:
        return text(key, value, path);
      case Type::Boolean:
        return value.is_boolean() ? void() : wrong_type(key, value, path, problems_);
      case Type::Integer:
      case Type::Number:
      case Type::Function:  // given as a number
        return number(key, value, path);
      case Type::Vector:
        return numbers(key, value, path, {key.size});
      case Type::Point:
        return numbers(key, value, path, {2, 3});
      case Type::NumberOrList:
        return value.is_array() ? numbers(key, value, path, {key.size}) : number(key, value, path);
      case Type::Rows:
        return rows(key, value, path);
      case Type::NumberOrMatrix:
        return value.is_array() ? matrix(key, value, path) : number(key, value, path);
      case Type::Matrix:
        return matrix(key, value, path);
      case Type::Texts:
        return texts(key, value, path, 1);
      case Type::Pair:
        return texts(key, value, path, 2);
      case Type::List:
        return list(key, value, path);
      default:
        return;  // tables are the validator's
    }
  }

 private:
  void text(const Key& key, const toml::node& value, const std::string& path) {
    const auto given = value.value<std::string>();
    if (!given) return wrong_type(key, value, path, problems_);
    whole_text(value, *given, path);
    if (key.path == "name") check_name_length(value, *given, path, problems_);
    if (key.type != Type::Choice) return;
    const auto options = words(key.options);
    if (!std::count(options.begin(), options.end(), *given))
      problems_.add(value, fmt::format("'{}' is \"{}\"", path, *given), expectation(key),
                    suggestion(*given, options));
  }

  /// Names, files and messages end at a NUL elsewhere.
  void whole_text(const toml::node& value, const std::string& given, const std::string& path) {
    if (given.find('\0') != std::string::npos)
      problems_.add(value, fmt::format("'{}' holds a NUL character", path), "a text without it");
  }

  void number(const Key& key, const toml::node& value, const std::string& path) {
    const bool whole = key.type == Type::Integer;
    if (!value.is_number()) return wrong_type(key, value, path, problems_);
    const double x = *value.value<double>();
    if (whole && std::abs(x) > kLargest && std::floor(x) == x)
      problems_.add(value, fmt::format("'{}' is out of range: {:g}", path, x),
                    fmt::format("{}, at most {:g}", expectation(key), kLargest),
                    std::string(key.doc));
    else if (whole && !value.is_integer())
      problems_.add(
          value, fmt::format("'{}' is a number", path), expectation(key),
          std::floor(x) == x ? "without point and exponent, as in 1000" : std::string(key.doc));
    else if (!std::isfinite(x))
      problems_.add(value, fmt::format("'{}' is {}", path, x), "a finite number");
    else if (std::abs(x) > kSquared)
      problems_.add(value, fmt::format("'{}' is out of range: {:g}", path, x),
                    fmt::format("a number of at most {:g} in size", kSquared),
                    std::string(key.doc));
    else if (!key.range.contains(x))
      problems_.add(value, fmt::format("'{}' is out of range: {:g}", path, x), expectation(key),
                    std::string(key.doc));
  }

  void numbers(const Key& key, toml::node& value, const std::string& path,
               const std::vector<int>& sizes) {
    toml::array* list = value.as_array();
    if (!list) return wrong_type(key, value, path, problems_);
    const int n = static_cast<int>(list->size());
    const bool any = sizes.front() == 0 && n > 0;
    if (!any && !std::count(sizes.begin(), sizes.end(), n)) {
      problems_.add(value, fmt::format("'{}' has {} entries", path, n), expectation(key));
      return;
    }
    Key single = key;
    single.type = Type::Number;
    for (int i = 0; i < n; ++i)
      number(single, (*list)[static_cast<std::size_t>(i)], fmt::format("{}.{}", path, i));
  }

  void rows(const Key& key, toml::node& value, const std::string& path) {
    toml::array* list = value.as_array();
    if (!list) return wrong_type(key, value, path, problems_);
    if (list->size() < 2 && key.type == Type::Rows) {
      problems_.add(value, fmt::format("'{}' has {} rows", path, list->size()), expectation(key));
      return;
    }
    int i = 0;
    for (toml::node& row : *list) numbers(key, row, fmt::format("{}.{}", path, i++), {key.size});
  }

  void matrix(const Key& key, toml::node& value, const std::string& path) {
    const toml::array* list = value.as_array();
    if (!list) return wrong_type(key, value, path, problems_);
    const bool square = !list->empty() && (*list)[0].is_array();
    if (!square) return numbers(key, value, path, {key.size, 6});
    if (static_cast<int>(list->size()) != key.size) {
      problems_.add(value, fmt::format("'{}' has {} rows", path, list->size()), expectation(key));
      return;
    }
    Key entries = key;
    entries.range = Range{};  // that of the key is of a diagonal alone
    rows(entries, value, path);
  }

  void list(const Key& key, const toml::node& value, const std::string& path) {
    const toml::array* values = value.as_array();
    if (!values) return wrong_type(key, value, path, problems_);
    if (values->empty())
      problems_.add(value, fmt::format("'{}' is empty", path), expectation(key),
                    std::string(key.doc));
    for (const toml::node& item : *values)
      if (item.is_table())
        problems_.add(item, fmt::format("'{}' holds a table", path),
                      "numbers, strings, true or false, or lists of them");
  }

  /// @param count 1: a string or a list of them, 2: a list of two
  void texts(const Key& key, const toml::node& value, const std::string& path, int count) {
    if (value.is_string() && count == 1)
      return whole_text(value, *value.value<std::string>(), path);
    const toml::array* list = value.as_array();
    if (!list) return wrong_type(key, value, path, problems_);
    if (list->empty() || (count == 2 && list->size() != 2))
      problems_.add(value, fmt::format("'{}' has {} entries", path, list->size()),
                    expectation(key));
    for (const toml::node& item : *list)
      if (const auto given = item.value<std::string>(); given && item.is_string())
        whole_text(item, *given, path);
      else
        wrong_type(key, item, path, problems_);
  }

  Problems& problems_;
};

}  // namespace

void check_value(const Key& key, toml::node& value, const std::string& path, Problems& problems) {
  ValueCheck(problems).check(key, value, path);
}

void wrong_type(const Key& key, const toml::node& value, const std::string& path,
                Problems& problems) {
  problems.add(value, fmt::format("'{}' is {}", path, type_name(value)), expectation(key),
               std::string(key.doc));
}

}  // namespace liesl
