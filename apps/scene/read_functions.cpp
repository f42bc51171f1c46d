/// @file
/// Functions of time.
#include "apps/scene/read_functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace liesl {

namespace {

/// Is the function finite over the simulated time? Says where it is not.
TimeFunction finite(Reader& reader, const toml::node& node, TimeFunction function) {
  constexpr int kSamples = 64;
  const double end = reader.scene.simulation.duration;
  for (int i = 0; i <= kSamples; ++i) {
    const double t = end * i / kSamples;
    if (std::isfinite(function(t))) continue;
    reader.problems.add(node,
                        fmt::format("the expression is {} at t = {:g}",
                                    std::isnan(function(t)) ? "not a number" : "infinite", t),
                        "a finite number during the simulation");
    return TimeFunction();
  }
  return function;
}

}  // namespace

TimeFunction read_expression(Reader& reader, const toml::node& node) {
  try {
    return finite(reader, node, TimeFunction::expression(node.value_or(std::string())));
  } catch (const std::invalid_argument& error) {
    reader.problems.add(node, error.what(), "an expression of t",
                        "as in \"sin(2*pi*t)\"; t in s, powers are t^2");
    return TimeFunction();
  }
}

TimeFunction::Interpolation interpolation_named(const std::string& name) {
  using enum TimeFunction::Interpolation;
  return name == "cubic" ? Cubic : name == "quintic" ? Quintic : Linear;
}

TimeFunction read_table(Reader& reader, const toml::node& node, const std::string& interpolation) {
  std::vector<double> t, f;
  const toml::array& rows = *node.as_array();
  for (const toml::node& row : rows) {
    const auto values = numbers(row);
    if (!t.empty() && values[0] <= t.back()) {
      reader.problems.add(row, fmt::format("t = {:g} follows t = {:g}", values[0], t.back()),
                          "rows [t, f] with increasing t");
      return TimeFunction();
    }
    t.push_back(values[0]);
    f.push_back(values[1]);
  }
  return TimeFunction::table(std::move(t), std::move(f), interpolation_named(interpolation));
}

TimeFunction read_function(Reader& reader, const toml::node& node) {
  if (node.is_string()) return read_expression(reader, node);
  const toml::table* table = node.as_table();
  if (!table) return TimeFunction::constant(node.value_or(0.0));
  if (const toml::node* expression = table->get("expression")) {
    if (const toml::node* kind = table->get("interpolation"); kind && written(*kind))
      reader.problems.add(*kind, "a function with 'interpolation' but no 'table'",
                          "'interpolation' with 'table' only", "leave it out");
    return read_expression(reader, *expression);
  }
  return read_table(reader, *table->get("table"), text(*table, "interpolation"));
}

}  // namespace liesl
