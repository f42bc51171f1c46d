#include "apps/input/validate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace liesl {

namespace {

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

/// Does the condition `when` of a key hold in this table? The sibling key must be readable.
enum class Applies { Yes, No, Unknown };
Applies applies(FileKind kind, const Key& key, const toml::table& table) {
  if (key.when.empty()) return Applies::Yes;
  const auto equals = key.when.find('=');
  const auto chosen = table[key.when.substr(0, equals)].value<std::string>();
  const Key* choice =
      find_key(kind, fmt::format("{}.{}", key.parent(), key.when.substr(0, equals)));
  const auto options = choice ? words(choice->options) : std::vector<std::string>{};
  if (!chosen || !std::count(options.begin(), options.end(), *chosen)) return Applies::Unknown;
  const auto allowed = words(key.when.substr(equals + 1));
  return std::count(allowed.begin(), allowed.end(), *chosen) ? Applies::Yes : Applies::No;
}

constexpr double kLargest = 1e9;           ///< integer, which an int holds
constexpr std::size_t kLongestName = 255;  // HDF5 takes more, file systems do not

class Validator {
 public:
  Validator(FileKind kind, Problems& problems, Broken& broken)
      : kind_(kind), problems_(problems), broken_(broken) {}

  /// @param pattern of the schema, @param path as the user wrote it; both "" for the file
  void table(toml::table& table, const std::string& pattern, const std::string& path) {
    const auto keys = children(kind_, pattern);
    for (auto&& [name, value] : table) entry(table, keys, name, value, path);
    alternatives(table, keys, path);
    for (const Key* key : keys) absent(table, *key, path);
  }

 private:
  static std::string join(const std::string& path, std::string_view leaf) {
    return path.empty() ? std::string(leaf) : fmt::format("{}.{}", path, leaf);
  }

  static std::string place(const std::string& path) {
    return path.empty() ? "the file" : fmt::format("'{}'", path);
  }

  void entry(toml::table& in, const std::vector<const Key*>& keys, const toml::key& name,
             toml::node& value, const std::string& path) {
    bool known = false, undecided = false;
    for (const Key* key : keys) {
      if (key->leaf() == "*") return named(*key, name, value, path);
      if (key->leaf() != name.str()) continue;
      known = true;
      const Applies how = applies(kind_, *key, in);
      undecided = undecided || how == Applies::Unknown;
      if (how == Applies::Yes) return check(*key, value, join(path, name.str()));
    }
    if (undecided) return;
    const std::string what = fmt::format("unknown key '{}'", join(path, name.str()));
    std::vector<std::string> candidates;
    for (const Key* key : keys)
      if (applies(kind_, *key, in) == Applies::Yes) candidates.emplace_back(key->leaf());
    const std::string choice = known ? " of this kind of entry" : "";
    problems_.add(name, what + choice, path.empty() ? "a key of the file" : "a key of " + path,
                  suggestion(name.str(), candidates));
  }

  void named(const Key& key, const toml::key& name, toml::node& value, const std::string& path) {
    const int before = problems_.count();
    const std::string full = join(path, name.str());
    if (key.type != Type::Any &&
        (name.str().empty() || name.str().find_first_of(". \t\"'") != std::string_view::npos))
      problems_.add(name, fmt::format("'{}' is not a name", name.str()),
                    "a name without dots, blanks and quotes");
    else if (key.type != Type::Any)
      check_length(name, name.str(), full);
    check(key, value, full);
    if (problems_.count() > before) broken_.insert(full);
  }

  /// Names become names of data sets and attributes in results.h5.
  template <class Place>
  void check_length(const Place& at, std::string_view text, const std::string& path) {
    if (text.size() > kLongestName)
      problems_.add(at, fmt::format("'{}' is a name of {} characters", path, text.size()),
                    fmt::format("at most {} characters", kLongestName));
  }

  /// Exactly one of the keys marked kOneOf.
  void alternatives(const toml::table& table, const std::vector<const Key*>& keys,
                    const std::string& path) {
    std::vector<std::string_view> all, given;
    for (const Key* key : keys) {
      if (key->preset != kOneOf) continue;
      all.push_back(key->leaf());
      if (table.contains(key->leaf())) given.push_back(key->leaf());
    }
    if (all.empty() || given.size() == 1) return;
    const std::string expected = fmt::format("exactly one of {}", fmt::join(all, ", "));
    if (given.empty()) {
      std::vector<std::string> candidates(all.begin(), all.end());
      std::string hint;
      for (auto&& [name, value] : table)
        if (hint.empty() &&
            !find_key(kind_, fmt::format("{}.{}", keys.front()->parent(), name.str())))
          if (const auto near = nearest(name.str(), candidates); !near.empty())
            hint = fmt::format("did you mean '{}'?", near);
      problems_.add(table, fmt::format("missing key in {}", place(path)), expected, hint);
    } else {
      problems_.add(*table.get(given[1]),
                    fmt::format("{} has both '{}' and '{}'", place(path), given[0], given[1]),
                    expected, "leave out all but one");
    }
  }

  void absent(toml::table& table, const Key& key, const std::string& path) {
    if (key.leaf() == "*" || table.contains(key.leaf())) return;
    if (key.preset == kOptional || key.preset == kOneOf) return;
    if (applies(kind_, key, table) != Applies::Yes) return;
    if (key.preset == kRequired) {
      problems_.add(table, fmt::format("missing key '{}'", join(path, key.leaf())),
                    expectation(key), std::string(key.doc));
      return;
    }
    toml::table preset = toml::parse(fmt::format("v = {}", key.preset));
    preset.get("v")->visit(
        [&](auto& value) { table.insert_or_assign(key.leaf(), std::move(value)); });
  }

  void wrong(const Key& key, const toml::node& value, const std::string& path) {
    problems_.add(value, fmt::format("'{}' is {}", path, type_name(value)), expectation(key),
                  std::string(key.doc));
  }

  void check(const Key& key, toml::node& value, const std::string& path) {
    switch (key.type) {
      case Type::Text:
      case Type::Choice:
        return text(key, value, path);
      case Type::Boolean:
        return value.is_boolean() ? void() : wrong(key, value, path);
      case Type::Integer:
      case Type::Number:
        return number(key, value, path);
      case Type::Vector:
        return numbers(key, value, path, {key.size});
      case Type::Point:
        return numbers(key, value, path, {2, 3});
      case Type::NumberOrList:
        return value.is_array() ? numbers(key, value, path, {key.size}) : number(key, value, path);
      case Type::Rows:
        return rows(key, value, path);
      case Type::Matrix:
        return matrix(key, value, path);
      case Type::Texts:
        return texts(key, value, path, 1);
      case Type::Pair:
        return texts(key, value, path, 2);
      case Type::Function:
        return function(key, value, path);
      case Type::Table:
      case Type::Named:
        return subtable(key, value, path);
      case Type::TableOrList:
        return tables(key, value, path);
      case Type::List:
        return list(key, value, path);
      case Type::Any:
        return;
    }
  }

  void text(const Key& key, const toml::node& value, const std::string& path) {
    const auto given = value.value<std::string>();
    if (!given) return wrong(key, value, path);
    if (key.path == "name") check_length(value, *given, path);
    if (key.type != Type::Choice) return;
    const auto options = words(key.options);
    if (!std::count(options.begin(), options.end(), *given))
      problems_.add(value, fmt::format("'{}' is \"{}\"", path, *given), expectation(key),
                    suggestion(*given, options));
  }

  void number(const Key& key, const toml::node& value, const std::string& path) {
    const bool whole = key.type == Type::Integer;
    if (!value.is_number()) return wrong(key, value, path);
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
    else if (!key.range.contains(x))
      problems_.add(value, fmt::format("'{}' is out of range: {:g}", path, x), expectation(key),
                    std::string(key.doc));
  }

  void numbers(const Key& key, toml::node& value, const std::string& path,
               const std::vector<int>& sizes) {
    toml::array* list = value.as_array();
    if (!list) return wrong(key, value, path);
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
    if (!list) return wrong(key, value, path);
    if (list->size() < 2 && key.type == Type::Rows) {
      problems_.add(value, fmt::format("'{}' has {} rows", path, list->size()), expectation(key));
      return;
    }
    int i = 0;
    for (toml::node& row : *list) numbers(key, row, fmt::format("{}.{}", path, i++), {key.size});
  }

  void matrix(const Key& key, toml::node& value, const std::string& path) {
    const toml::array* list = value.as_array();
    if (!list) return wrong(key, value, path);
    const bool square = !list->empty() && (*list)[0].is_array();
    if (!square) return numbers(key, value, path, {key.size, 6});
    if (static_cast<int>(list->size()) != key.size) {
      problems_.add(value, fmt::format("'{}' has {} rows", path, list->size()), expectation(key));
      return;
    }
    rows(key, value, path);
  }

  void list(const Key& key, const toml::node& value, const std::string& path) {
    const toml::array* values = value.as_array();
    if (!values) return wrong(key, value, path);
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
    if (value.is_string() && count == 1) return;
    const toml::array* list = value.as_array();
    if (!list) return wrong(key, value, path);
    if (list->empty() || (count == 2 && list->size() != 2))
      problems_.add(value, fmt::format("'{}' has {} entries", path, list->size()),
                    expectation(key));
    for (const toml::node& item : *list)
      if (!item.is_string()) wrong(key, item, path);
  }

  void function(const Key& key, toml::node& value, const std::string& path) {
    if (toml::table* inner = value.as_table()) return table(*inner, "(function)", path);
    if (value.is_string()) return;
    if (!value.is_number()) return wrong(key, value, path);
    number(key, value, path);
  }

  void subtable(const Key& key, toml::node& value, const std::string& path) {
    const int before = problems_.count();
    if (toml::table* inner = value.as_table())
      table(*inner, key.path, path);
    else
      wrong(key, value, path);
    if (problems_.count() > before) broken_.insert(path);
  }

  void tables(const Key& key, toml::node& value, const std::string& path) {
    toml::array* list = value.as_array();
    if (!list) return subtable(key, value, path);
    if (list->empty())
      problems_.add(value, fmt::format("'{}' is empty", path), "a table or a list of tables",
                    "leave the key out, or say what it holds: " + std::string(key.doc));
    int i = 0;
    for (toml::node& item : *list) subtable(key, item, fmt::format("{}.{}", path, i++));
  }

  FileKind kind_;
  Problems& problems_;
  Broken& broken_;
};

}  // namespace

Broken validate(toml::table& root, FileKind kind, Problems& problems) {
  Broken broken;
  Validator(kind, problems, broken).table(root, "", "");
  return broken;
}

}  // namespace liesl
