#include "apps/input/values.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace liesl {

namespace {

/// Sorted by place; entries without one (defaults, overrides) come last, by name.
bool earlier(const Entry& a, const Entry& b) {
  const auto place = [](const Entry& e) {
    const auto begin = e.key->source().begin;
    return begin.line == 0 ? std::make_pair(~0u, ~0u) : std::make_pair(begin.line, begin.column);
  };
  return place(a) < place(b);
}

}  // namespace

std::vector<Entry> entries_of(toml::table& table) {
  std::vector<Entry> list;
  for (auto&& [key, value] : table)
    list.push_back({std::string(key.str()), &key, value.as_table()});
  std::stable_sort(list.begin(), list.end(), earlier);
  return list;
}

std::vector<Entry> entries_at(toml::table& root, std::string_view group) {
  toml::table* table = root[group].as_table();
  return table ? entries_of(*table) : std::vector<Entry>{};
}

std::vector<Entry> entries(toml::table& root, const Broken& broken, std::string_view group) {
  auto list = entries_at(root, group);
  std::erase_if(list, [&](const Entry& entry) {
    return !entry.table || broken.contains(fmt::format("{}.{}", group, entry.name));
  });
  return list;
}

std::string text(const toml::table& table, std::string_view key) {
  return table[key].value_or(std::string());
}
double number(const toml::table& table, std::string_view key) { return table[key].value_or(0.0); }
int integer(const toml::table& table, std::string_view key) { return table[key].value_or(0); }
bool boolean(const toml::table& table, std::string_view key) { return table[key].value_or(false); }

std::vector<double> numbers(const toml::node& node) {
  std::vector<double> values;
  const toml::array* list = node.as_array();
  if (!list) return {node.value_or(0.0)};
  for (const toml::node& item : *list) values.push_back(item.value_or(0.0));
  return values;
}

Vec3 vec3(const toml::node& list) {
  const auto values = numbers(list);
  return values.size() == 3 ? Vec3(values[0], values[1], values[2]) : Vec3::Zero();
}

Vec3 vec3(const toml::table& table, std::string_view key) {
  const toml::node* node = table.get(key);
  return node ? vec3(*node) : Vec3::Zero();
}

std::vector<const toml::node*> strings(const toml::table& table, std::string_view key) {
  const toml::node* node = table.get(key);
  if (!node) return {};
  if (node->is_string()) return {node};
  std::vector<const toml::node*> list;
  for (const toml::node& item : *node->as_array()) list.push_back(&item);
  return list;
}

Eigen::MatrixXd matrix(const toml::node& node, int n) {
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(n, n);
  const toml::array& list = *node.as_array();
  if (list[0].is_array()) {
    for (int i = 0; i < n; ++i) {
      const auto row = numbers(list[static_cast<std::size_t>(i)]);
      for (int j = 0; j < n; ++j) M(i, j) = row[static_cast<std::size_t>(j)];
    }
    return M;
  }
  const auto values = numbers(node);
  for (int i = 0; i < n; ++i) M(i, i) = values[static_cast<std::size_t>(i)];
  if (n == 3 && values.size() == 6) {
    M(0, 1) = M(1, 0) = values[3];
    M(0, 2) = M(2, 0) = values[4];
    M(1, 2) = M(2, 1) = values[5];
  }
  return M;
}

}  // namespace liesl
