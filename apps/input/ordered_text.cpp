#include "apps/input/ordered_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "apps/input/values.hpp"

namespace liesl {

namespace {

/// The shortest number that is read as the same.
std::string value_text(const toml::node& value) {
  if (const auto* number = value.as_floating_point()) {
    const std::string shortest = fmt::format("{}", number->get());
    return shortest.find_first_of(".en") == std::string::npos ? shortest + ".0" : shortest;
  }
  std::ostringstream text;
  text << toml::toml_formatter(value, kQuoted);
  return text.str();
}

std::string key_text(const std::string& key) {
  const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '-';
  });
  return bare ? key : value_text(toml::value<std::string>(key));
}

void write_value(std::ostream& out, toml::node& node);

void write_inline(std::ostream& out, toml::table& table) {
  const char* separator = " ";
  out << "{";
  for (const Entry& entry : entries_of(table)) {
    out << separator << key_text(entry.name) << " = ";
    write_value(out, *table.get(entry.name));
    separator = ", ";
  }
  out << " }";
}

void write_value(std::ostream& out, toml::node& node) {
  if (auto* table = node.as_table()) return write_inline(out, *table);
  if (auto* array = node.as_array()) {
    out << "[";
    for (std::size_t i = 0; i < array->size(); ++i) {
      if (i > 0) out << ", ";
      write_value(out, *array->get(i));
    }
    out << "]";
    return;
  }
  out << value_text(node);
}

/// Values and inline tables, then the tables with a head of their own; also inline ones that come
/// behind one of those in the order.
void write_table(std::ostream& out, const std::string& path, toml::table& table) {
  const auto entries = entries_of(table);
  const auto headed = std::find_if(entries.begin(), entries.end(), [](const Entry& entry) {
    return entry.table && !entry.table->is_inline();
  });
  const auto below = [headed](auto entry) { return entry->table && entry >= headed; };
  bool head = path.empty();
  const auto write_head = [&] {
    if (!head) out << "\n[" << path << "]\n";
    head = true;
  };
  if (entries.empty()) write_head();
  for (auto entry = entries.begin(); entry != entries.end(); ++entry) {
    if (below(entry)) continue;
    write_head();
    out << key_text(entry->name) << " = ";
    write_value(out, *table.get(entry->name));
    out << "\n";
  }
  for (auto entry = headed; entry != entries.end(); ++entry)
    if (below(entry))
      write_table(out, (path.empty() ? "" : path + ".") + key_text(entry->name), *entry->table);
}

}  // namespace

std::string ordered_text(toml::table table) {
  std::ostringstream text;
  write_table(text, "", table);
  return text.str();
}

}  // namespace liesl
