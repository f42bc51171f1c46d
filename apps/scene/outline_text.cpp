#include "apps/scene/outline_text.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "apps/input/schema.hpp"

namespace liesl {

namespace {

using levelset::FeatureKind;
using levelset::FeatureSpec;

std::string quoted(const std::string& text) {
  std::ostringstream out;
  out << toml::toml_formatter(
      toml::value<std::string>(text),
      toml::toml_formatter::default_flags & ~toml::format_flags::allow_literal_strings);
  return out.str();
}

/// A name as a key: quoted where it has to be.
std::string key_text(const std::string& name) {
  const bool bare = !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '-';
  });
  return bare ? name : quoted(name);
}

std::string number_text(double value) { return fmt::format("{}", value); }

std::string list_text(const double* values, std::size_t count) {
  std::string text = "[";
  for (std::size_t i = 0; i < count; ++i) text += (i ? ", " : "") + number_text(values[i]);
  return text + "]";
}

std::string operands_text(const FeatureSpec& f) {
  std::string text;
  for (const std::string& operand : f.operands)
    text += (text.empty() ? "" : ", ") + quoted(operand);
  return "[" + text + "]";
}

/// Points and weights of a curve, which follow its placement.
std::string curve_text(FeatureKind kind, const double* values, std::size_t count) {
  const std::size_t points = count / (kind == FeatureKind::Nurbs ? 3 : 2);
  std::string text = ", points = [";
  for (std::size_t i = 0; i < points; ++i) text += (i ? ", " : "") + list_text(values + 2 * i, 2);
  text += "]";
  if (kind == FeatureKind::Nurbs) text += ", weights = " + list_text(values + 2 * points, points);
  return text;
}

/// Placements at zero are left out.
std::string feature_text(const FeatureSpec& f, int dim) {
  std::string text =
      fmt::format("{{ type = \"{}\"", feature_words()[static_cast<std::size_t>(f.kind)]);
  if (is_operation(f.kind)) {
    text += ", of = " + operands_text(f);
    if (f.kind != FeatureKind::Mirror) {  // which has a placement, as features do
      if (!f.values.empty()) text += ", radius = " + number_text(f.values[0]);
      return text + " }";
    }
  }
  const auto parameters = levelset::feature_parameters(f.kind, dim);
  const std::size_t placement = dim == 2 ? 3 : 6;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (i >= placement || f.values[i] != 0)
      text += fmt::format(", {} = {}", parameters[i].name, number_text(f.values[i]));
  if (is_curve(f.kind))
    text += curve_text(f.kind, f.values.data() + placement, f.values.size() - placement);
  return text + " }";
}

}  // namespace

const std::vector<std::string>& feature_words() {
  static const auto kinds =
      words(find_key(FileKind::Scene, "bodies.*.solid.outline.*.type")->options);
  return kinds;
}

std::string outline_text(const std::string& part, const levelset::ShapeSpec& outline) {
  std::string text = fmt::format("[bodies.{}.solid.outline]\n", key_text(part));
  for (const FeatureSpec& f : outline.features)
    text += key_text(f.name) + " = " + feature_text(f, outline.dim) + "\n";
  return text;
}

}  // namespace liesl
