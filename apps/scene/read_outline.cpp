/// @file
/// Outlines of meshed parts: features and operations.

#include <algorithm>

#include "apps/scene/outline_text.hpp"
#include "apps/scene/part_reader.hpp"
#include "mbs/solids/volume_fraction.hpp"

namespace liesl {

namespace {

using levelset::FeatureKind;
using levelset::FeatureSpec;

/// In the order of FeatureKind.
FeatureKind kind_of_feature(const toml::table& table) {
  const auto& kinds = feature_words();
  const auto found = std::find(kinds.begin(), kinds.end(), text(table, "type"));
  return static_cast<FeatureKind>(found - kinds.begin());
}

std::optional<FeatureSpec> read_feature(PartReader& part, const Entry& entry) {
  const toml::table& table = *entry.table;
  FeatureSpec f{entry.name, kind_of_feature(table), {}, {}};
  if (is_operation(f.kind)) {
    for (const toml::node* node : strings(table, "of"))
      f.operands.push_back(node->value_or(std::string()));
    if (table.contains("radius")) f.values.push_back(number(table, "radius"));
    if (f.kind != FeatureKind::Mirror) return f;
  }
  for (const char* key : {"z", "rx", "ry", "rz", "angle"})
    if (const toml::node* node = table.get(key);
        node && (part.dim() == 2) != (std::string_view(key) == "angle")) {
      part.refuse(*node,
                  fmt::format("has '{}' in a feature of a {} mesh", key,
                              part.dim() == 2 ? "planar" : "spatial"),
                  part.dim() == 2 ? "x, y and angle" : "x, y, z and rx, ry, rz");
      return {};
    }
  for (const auto& parameter : levelset::feature_parameters(f.kind, part.dim()))
    f.values.push_back(number(table, parameter.name));
  if (const toml::node* points = table.get("points"))
    for (const toml::node& row : *points->as_array())
      for (const double x : numbers(row)) f.values.push_back(x);
  if (const toml::node* weights = table.get("weights")) {
    const auto w = numbers(*weights);
    if (w.size() != table.get("points")->as_array()->size()) {
      part.refuse(*weights, fmt::format("has {} weights in '{}'", w.size(), f.name),
                  fmt::format("{}, one a point", table.get("points")->as_array()->size()));
      return {};
    }
    f.values.insert(f.values.end(), w.begin(), w.end());
  }
  return f;
}

}  // namespace

void read_outline(PartReader& part) {
  if (!part.table.contains("outline")) return;
  toml::table& all = part.table_of("outline");
  if (!takes_outline(part.mesh))
    return part.refuse(
        key_of(part.table, "outline"),
        fmt::format("has an outline in a mesh of a kind of cell that it does not cut: {}",
                    part.mesh.kind().name),
        "4-node quadrilaterals or 8-node hexahedra",
        "without an outline all of the mesh is material");
  part.solid.outline.dim = part.dim();
  for (const Entry& entry : entries_of(all)) {
    if (const auto feature = read_feature(part, entry))
      part.solid.outline.features.push_back(*feature);
    else
      part.ok = false;
  }
  if (all.empty()) part.refuse(all, "has an outline without features", "at least one feature");
  if (!part.ok) return;
  for (const auto& error : shape_errors(part.solid.outline))
    part.refuse(key_of(all, error.feature),
                fmt::format("has an outline whose feature '{}' {}", error.feature, error.text),
                error.text.starts_with("makes no shape") ? "numbers that make a shape"
                                                         : "one tree of features and operations");
  if (!part.ok) return;
  for (const FeatureSpec& f : part.solid.outline.features)
    if (!is_operation(f.kind) &&
        volume_fractions(part.mesh, *make_feature(f, part.dim())).value.maxCoeff() == 0)
      part.refuse(
          key_of(all, f.name),
          fmt::format("has a feature '{}' that is wholly outside of the mesh", f.name),
          "a feature that fills some of a cell",
          "it may also be much smaller than a cell; positions are in the coordinates of the "
          "mesh");
}

}  // namespace liesl
