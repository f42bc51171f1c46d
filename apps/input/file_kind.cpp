/// @file
/// Which kind of file a table is.
#include <fmt/format.h>

#include "apps/input/document.hpp"

namespace liesl {
namespace {

/// Axes of a comparison are lists, those of a batch have a key.
bool has_lists(const toml::table* grid) {
  if (!grid) return false;
  for (const auto& [name, axis] : *grid)
    if (axis.is_array()) return true;
  return false;
}

}  // namespace

FileKind kind_of(const toml::table& root) {
  const auto has = [&root](const char* key) { return root.contains(key); };
  if (has("bodies")) return FileKind::Scene;
  if (has("by")) return FileKind::Sensitivity;
  if (has("quantity") || has("reference") || has_lists(root["grid"].as_table()))
    return FileKind::Comparison;
  if (has("grid") || has("table") || has("study") || has("limits")) return FileKind::Batch;
  for (const char* key : {"scene", "design", "objective", "constraints", "cycle"})
    if (has(key)) return FileKind::Study;
  return FileKind::Scene;
}

void expect_kind(const toml::table& root, FileKind wanted, Problems& problems) {
  const FileKind kind = kind_of(root);
  if (kind == wanted || (kind == FileKind::Scene && !root.contains("bodies"))) return;
  constexpr std::string_view kKeys[] = {"[bodies]", "'scene' and [design]", "[grid] or 'table'",
                                        "[grid] of lists", "'scene' and 'by'"};
  problems.add(root, fmt::format("this is a {}, not a {}", name_of(kind), name_of(wanted)),
               fmt::format("a {}, with {}", name_of(wanted), kKeys[static_cast<int>(wanted)]),
               fmt::format("give a {}, or use a command for a {}", name_of(wanted), name_of(kind)));
  problems.throw_if_any();
}

}  // namespace liesl
