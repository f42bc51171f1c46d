#include "apps/batch/grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace liesl {

namespace {

std::vector<std::string> keys_of(const toml::node& node) {
  std::vector<std::string> keys;
  if (const toml::array* list = node.as_array())
    for (const toml::node& item : *list) keys.push_back(*item.value<std::string>());
  else
    keys.push_back(*node.value<std::string>());
  return keys;
}

}  // namespace

InputPlace place_of(const toml::node& node) {
  const toml::source_region& at = node.source();
  if (!at.path || at.path->starts_with("--set")) return {at.path ? *at.path : "", 0, 0};
  return {*at.path, static_cast<int>(at.begin.line), static_cast<int>(at.begin.column)};
}

std::string toml_text(const toml::node& node) {
  if (const toml::array* list = node.as_array()) {
    std::string text;
    for (const toml::node& item : *list) text += (text.empty() ? "" : ", ") + toml_text(item);
    return "[" + text + "]";
  }
  if (const toml::table* table = node.as_table()) {
    std::string text;
    for (const auto& [key, item] : *table)
      text += (text.empty() ? "" : ", ") + toml_text(toml::value<std::string>(key.str())) + " = " +
              toml_text(item);
    return "{" + text + "}";
  }
  if (node.is_floating_point()) return fmt::format("{}", *node.value<double>());
  std::ostringstream out;
  node.visit([&out](const auto& value) { out << value; });
  return out.str();
}

std::vector<Axis> read_axes(const toml::table& grid) {
  std::vector<Axis> axes;
  for (const auto& [name, node] : grid) {
    const toml::table& table = *node.as_table();
    const toml::node& key = *table.get("key");
    Axis axis{{std::string(name.str()), keys_of(key), place_of(key)}, {}};
    for (const toml::node& value : *table["values"].as_array())
      axis.values.push_back({toml_text(value), place_of(value)});
    axes.push_back(std::move(axis));
  }
  // The parser sorts by name; the file's order is by place.
  std::stable_sort(axes.begin(), axes.end(), [](const Axis& a, const Axis& b) {
    return std::tie(a.column.place.line, a.column.place.column) <
           std::tie(b.column.place.line, b.column.place.column);
  });
  return axes;
}

std::size_t combinations(const std::vector<Axis>& axes) {
  std::size_t count = axes.empty() ? 0 : 1;
  for (const Axis& axis : axes) count = std::min(kMostCases + 1, count * axis.values.size());
  return count;
}

CaseList expand(const std::vector<Axis>& axes) {
  CaseList list;
  for (const Axis& axis : axes) list.columns.push_back(axis.column);
  const std::size_t count = combinations(axes);
  const std::size_t digits = fmt::formatted_size("{}", count);
  for (std::size_t k = 0; k < count; ++k) {
    CaseList::Row row{fmt::format("{:0{}}", k + 1, digits), std::vector<CaseValue>(axes.size())};
    std::size_t rest = k;
    for (std::size_t a = axes.size(); a-- > 0; rest /= axes[a].values.size())
      row.values[a] = axes[a].values[rest % axes[a].values.size()];
    list.rows.push_back(std::move(row));
  }
  return list;
}

}  // namespace liesl
