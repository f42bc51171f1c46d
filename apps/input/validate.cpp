#include "apps/input/validate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "apps/input/check_value.hpp"

namespace liesl {

namespace {

/// Does the condition `when` of a key hold in this table? The sibling key must be readable.
enum class Applies { Yes, No, Unknown };
Applies applies(FileKind kind, const Key& key, const toml::table& table) {
  if (key.when.empty()) return Applies::Yes;
  const auto equals = key.when.find('=');
  const auto name = key.when.substr(0, equals);
  auto chosen = table[name].value<std::string>();
  const Key* choice = find_key(kind, fmt::format("{}.{}", key.parent(), name));
  if (choice && !table.contains(name) && choice->preset.starts_with('"'))
    chosen = choice->preset.substr(1, choice->preset.size() - 2);  // left out: its default
  const auto options = choice ? words(choice->options) : std::vector<std::string>{};
  if (!chosen || !std::count(options.begin(), options.end(), *chosen)) return Applies::Unknown;
  const auto allowed = words(key.when.substr(equals + 1));
  return std::count(allowed.begin(), allowed.end(), *chosen) ? Applies::Yes : Applies::No;
}

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
    bool undecided = false;
    bool known = false;
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
    const std::vector<std::string> all = candidates;
    const std::string choice = known ? " of this kind of entry" : "";
    std::erase_if(candidates, [&in](const std::string& key) { return in.contains(key); });
    if (const std::string meant = nearest(name.str(), candidates); !meant.empty())
      misspelt_.insert(join(path, meant));
    else
      candidates = all;
    const std::string where = path.empty() ? "the file" : path;
    problems_.add(name, what + choice,
                  fmt::format("a key of {}{}", where, for_what(keys, name.str())),
                  suggestion(name.str(), candidates));
  }

  /// "; 'gap' is for constraints = penalty, augmented": where else than here keys of a name are
  /// known.
  static std::string for_what(const std::vector<const Key*>& keys, std::string_view leaf) {
    std::vector<std::pair<std::string_view, std::vector<std::string>>> known;  // key, its values
    for (const Key* key : keys) {
      const auto equals = key->when.find('=');
      if (key->leaf() != leaf || equals == std::string_view::npos) continue;
      const std::string_view of = key->when.substr(0, equals);
      if (known.empty() || known.back().first != of) known.push_back({of, {}});
      for (const auto& value : words(key->when.substr(equals + 1)))
        if (auto& all = known.back().second; std::find(all.begin(), all.end(), value) == all.end())
          all.emplace_back(value);
    }
    std::string text;
    for (const auto& [of, values] : known)
      text += fmt::format("{}{} = {}", text.empty() ? fmt::format("; '{}' is for ", leaf) : " or ",
                          of, fmt::join(values, ", "));
    return text;
  }

  void named(const Key& key, const toml::key& name, toml::node& value, const std::string& path) {
    const int before = problems_.count();
    const std::string full = join(path, name.str());
    if (key.type != Type::Any &&
        (name.str().empty() || name.str().find_first_of(". \t\"'") != std::string_view::npos))
      problems_.add(name, fmt::format("'{}' is not a name", name.str()),
                    "a name without dots, blanks and quotes");
    else if (key.type != Type::Any)
      check_name_length(name, name.str(), full, problems_);
    check(key, value, full);
    if (problems_.count() > before) broken_.insert(full);
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
    for (const auto key : all)
      if (given.empty() && misspelt_.contains(join(path, key))) return;
    const std::string expected = fmt::format("exactly one of {}", fmt::join(all, ", "));
    if (given.empty()) {
      problems_.add(table, fmt::format("missing key in {}", place(path)), expected, "");
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
      if (misspelt_.contains(join(path, key.leaf()))) return;
      problems_.add(table, fmt::format("missing key '{}'", join(path, key.leaf())),
                    expectation(key), std::string(key.doc));
      return;
    }
    toml::table preset = toml::parse(fmt::format("v = {}", key.preset));
    preset.get("v")->visit(
        [&](auto& value) { table.insert_or_assign(key.leaf(), std::move(value)); });
  }

  void check(const Key& key, toml::node& value, const std::string& path) {
    switch (key.type) {
      case Type::Function:
        return function(key, value, path);
      case Type::Table:
      case Type::Named:
        return subtable(key, value, path);
      case Type::TableOrList:
        return tables(key, value, path);
      default:
        return check_value(key, value, path, problems_);
    }
  }

  void function(const Key& key, toml::node& value, const std::string& path) {
    if (toml::table* inner = value.as_table()) return table(*inner, "(function)", path);
    if (value.is_string()) return;
    check_value(key, value, path, problems_);
  }

  void subtable(const Key& key, toml::node& value, const std::string& path) {
    const int before = problems_.count();
    if (toml::table* inner = value.as_table())
      table(*inner, key.path, path);
    else
      wrong_type(key, value, path, problems_);
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
  std::set<std::string> misspelt_;  ///< paths that an unknown key stands for: not missing as well
};

}  // namespace

Broken validate(toml::table& root, FileKind kind, Problems& problems) {
  Broken broken;
  Validator(kind, problems, broken).table(root, "", "");
  return broken;
}

}  // namespace liesl
