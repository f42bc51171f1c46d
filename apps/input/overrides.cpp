/// @file
/// Changes to a scene or study by key path: `--set key.path=value` and the table `set` of studies.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "apps/input/document.hpp"

namespace liesl {

namespace {

std::vector<std::string> split(std::string_view path) {
  std::vector<std::string> parts(1);
  for (const char c : path) {
    if (c == '.')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

std::vector<std::string> keys_of(const toml::table& table) {
  std::vector<std::string> names;
  for (const auto& [key, value] : table) names.emplace_back(key.str());
  return names;
}

std::vector<std::string> leaves(FileKind kind, std::string_view pattern) {
  std::vector<std::string> names;
  for (const Key* key : children(kind, pattern))
    if (key->leaf() != "*") names.emplace_back(key->leaf());
  return names;
}

/// A place in a document on the way down a key path, with the pattern of the schema there.
struct Cursor {
  toml::node* node;
  std::string pattern;
};

/// Index of a list, -1 if the text is not one.
int index_of(const std::string& text, std::size_t size) {
  int index = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  return whole && index >= 0 && static_cast<std::size_t>(index) < size ? index : -1;
}

/// Walks a key path and puts a value at its end.
class Setter {
 public:
  Setter(FileKind kind, std::string path, Problems& problems)
      : kind_(kind), path_(std::move(path)), problems_(problems) {}

  void set(toml::table& root, toml::node&& value) {
    const auto parts = split(path_);
    Cursor at{&root, ""};
    for (std::size_t i = 0; i + 1 < parts.size(); ++i)
      if (!step(at, parts[i], value)) return;
    finish(at, parts.back(), std::move(value));
  }

 private:
  void complain(const toml::node& value, const std::string& what, const std::string& hint) {
    problems_.add(value, what, "a key of the " + std::string(name_of(kind_)), hint);
  }

  bool step(Cursor& at, const std::string& part, const toml::node& value) {
    if (toml::array* list = at.node->as_array()) {
      const int index = index_of(part, list->size());
      if (index < 0) return no_entry(*list, part, value);
      at.node = list->get(static_cast<std::size_t>(index));
      return true;
    }
    toml::table* table = at.node->as_table();
    const std::string below = table ? resolve(at, part, value) : "";
    if (!table) complain(value, fmt::format("'{}' is below a value", path_), "");
    if (below.empty()) return false;
    const bool named = below.ends_with('*');
    if (!table->contains(part) && named) {
      complain(value, fmt::format("there is no '{}' in '{}'", part, at.pattern),
               suggestion(part, keys_of(*table)));
      return false;
    }
    if (!table->contains(part)) table->insert(part, toml::table{});
    at = {table->get(part), below};
    return true;
  }

  void finish(Cursor& at, const std::string& part, toml::node&& value) {
    if (toml::array* list = at.node->as_array()) {
      const int index = index_of(part, list->size());
      if (index < 0) {
        no_entry(*list, part, value);
        return;
      }
      value.visit([&](auto& typed) { list->replace(list->cbegin() + index, std::move(typed)); });
      return;
    }
    toml::table* table = at.node->as_table();
    if (!table) return complain(value, fmt::format("'{}' is below a value", path_), "");
    if (resolve(at, part, value).empty()) return;
    value.visit([&](auto& typed) { table->insert_or_assign(part, std::move(typed)); });
  }

  /// Pattern of the schema for a step down a table; complains if there is none.
  std::string resolve(const Cursor& at, const std::string& part, const toml::node& value) {
    const Key* key = find_key(kind_, at.pattern);
    const std::string from = key && key->type == Type::Function ? "(function)" : at.pattern;
    std::string below = pattern_below(kind_, from, part);
    if (below.empty())
      complain(value, fmt::format("unknown key '{}'", path_),
               suggestion(part, leaves(kind_, from)));
    return below;
  }

  bool no_entry(const toml::array& list, const std::string& part, const toml::node& value) {
    complain(value, fmt::format("'{}' has no entry '{}'", path_, part),
             fmt::format("entries are 0 to {}", static_cast<int>(list.size()) - 1));
    return false;
  }

  FileKind kind_;
  std::string path_;
  Problems& problems_;
};

/// Value of "v = text", or the text itself as a string. Its source path is the override.
toml::table parse_value(const std::string& text, const std::string& source) {
  try {
    return toml::parse("v = " + text, source);
  } catch (const toml::parse_error&) {
    std::string quoted;
    for (const char c : text) {
      if (c == '"' || c == '\\') quoted += '\\';
      quoted += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return toml::parse("v = \"" + quoted + "\"", source);
  }
}

void flatten(toml::table& set, const std::string& prefix, toml::table& scene, Problems& problems) {
  for (auto&& [key, value] : set) {
    const std::string path = prefix + std::string(key.str());
    if (toml::table* inner = value.as_table())
      flatten(*inner, path + ".", scene, problems);
    else
      Setter(FileKind::Scene, path, problems).set(scene, std::move(value));
  }
}

}  // namespace

void apply_overrides(toml::table& root, FileKind kind, const std::vector<std::string>& overrides,
                     Problems& problems) {
  for (const std::string& text : overrides) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
      problems.add({"--set " + text, 0, 0, "not a change", "key.path=value", ""});
      continue;
    }
    toml::table parsed;
    try {
      parsed = parse_value(text.substr(equals + 1), "--set " + text);
    } catch (const toml::parse_error& error) {
      problems.add({"--set " + text, 0, 0, std::string(error.description()), "a TOML value", ""});
      continue;
    }
    std::string path = text.substr(0, equals);
    path.erase(std::remove(path.begin(), path.end(), ' '), path.end());
    if (kind == FileKind::Scene) path = without_scene(path);
    Setter(kind, path, problems).set(root, std::move(*parsed.get("v")));
  }
}

std::string without_scene(const std::string& text) {
  constexpr std::string_view kPrefix = "scene.";
  return text.starts_with(kPrefix) ? text.substr(kPrefix.size()) : text;
}

SplitOverrides split_overrides(const std::vector<std::string>& overrides) {
  SplitOverrides parts;
  for (const std::string& text : overrides) {
    const std::string path = text.substr(0, text.find('='));
    const std::string top = path.substr(0, path.find('.'));
    if (without_scene(path) != path ||
        (!find_key(FileKind::Study, top) && find_key(FileKind::Scene, top)))
      parts.scene.push_back(text);
    else
      parts.study.push_back(text);
  }
  return parts;
}

void apply_set(toml::table& set, toml::table& scene, Problems& problems) {
  flatten(set, "", scene, problems);
}

}  // namespace liesl
