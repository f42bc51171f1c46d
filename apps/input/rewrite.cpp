#include "apps/input/rewrite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "apps/input/document.hpp"
#include "apps/input/ordered_text.hpp"

namespace liesl {

namespace {

/// A stretch of the text, by bytes, and what comes there.
struct Edit {
  std::size_t begin, end;
  std::string text;
};

/// Byte of a place; columns count characters.
std::size_t byte_of(const std::string& text, toml::source_position at) {
  std::size_t byte = 0;
  for (toml::source_index line = 1; line < at.line; ++line) byte = text.find('\n', byte) + 1;
  const auto goes_on = [&text](std::size_t i) {
    return i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0u) == 0x80u;
  };
  for (toml::source_index column = 1; column < at.column && byte < text.size(); ++column) do
      ++byte;
    while (goes_on(byte));
  return byte;
}

std::string text_of(const toml::node& value) {
  std::ostringstream out;
  out << toml::toml_formatter(value, kQuoted);
  return out.str();
}

const toml::node* child(const toml::node& node, const std::string& part) {
  if (const toml::table* table = node.as_table()) return table->get(part);
  const toml::array* list = node.as_array();
  return list ? list->get(static_cast<std::size_t>(std::stoul(part))) : nullptr;
}

/// Value of the table that ends last in the text, nullptr if none is written in it.
const toml::node* last_of(const toml::table& table) {
  const toml::node* last = nullptr;
  for (const auto& [key, value] : table) {
    const toml::table* inner = value.as_table();
    if (!written(value) || (inner && !inner->is_inline())) continue;
    const auto end = value.source().end;
    if (!last || last->source().end < end) last = &value;
  }
  return last;
}

/// The edit that makes the text agree with the table `wanted` at a path; empty if there is none.
std::optional<Edit> edit_at(const std::string& text, const toml::table& is,
                            const toml::table& wanted, const std::vector<std::string>& path) {
  const toml::node *here = &is, *there = &wanted;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const toml::node* next = child(*here, path[i]);
    there = child(*there, path[i]);
    if (!next) {
      const toml::table* table = here->as_table();
      const toml::node* last = table && i + 1 == path.size() ? last_of(*table) : nullptr;
      if (!last) return {};
      const std::size_t at = byte_of(text, last->source().end);
      const std::size_t line_end = std::min(text.find('\n', at), text.size());
      const std::string entry = path[i] + " = " + text_of(*there);
      return table->is_inline() ? Edit{at, at, ", " + entry}
                                : Edit{line_end, line_end, "\n" + entry};
    }
    here = next;
  }
  const auto place = here->source();
  return Edit{byte_of(text, place.begin), byte_of(text, place.end), text_of(*there)};
}

std::vector<std::string> parts_of(const std::string& change) {
  std::vector<std::string> parts;
  std::istringstream path(change.substr(0, change.find('=')));
  for (std::string part; std::getline(path, part, '.');) {
    part.erase(std::remove(part.begin(), part.end(), ' '), part.end());
    parts.push_back(part);
  }
  return parts;
}

toml::table changed(const std::string& text, const std::string& change) {
  Document document = parse_document(text, "the scene");
  Problems problems(document.file);
  apply_overrides(document.root, FileKind::Scene, {change}, problems);
  problems.throw_if_any();
  return std::move(document.root);
}

/// One change in place, or the file anew.
std::string rewrite(const std::string& text, const std::string& change) {
  const toml::table wanted = changed(text, change);
  const Document document = parse_document(text, "the scene");
  if (const auto edit = edit_at(text, document.root, wanted, parts_of(change))) {
    std::string result = text;
    result.replace(edit->begin, edit->end - edit->begin, edit->text);
    try {
      if (parse_document(result, "the scene").root == wanted) return result;
    } catch (const InputError&) {  // the edit hit something else: anew
    }
  }
  return ordered_text(wanted);
}

}  // namespace

std::string rewrite_scene(const std::string& text, const std::vector<std::string>& changes) {
  std::string result = without_schema_line(text);
  for (const auto& change : changes) result = rewrite(result, change);
  return result;
}

std::string without_schema_line(const std::string& text) {
  if (!text.starts_with("#:schema ")) return text;
  const auto end = text.find('\n');
  return end == std::string::npos ? std::string() : text.substr(end + 1);
}

}  // namespace liesl
