#include "apps/compare/models.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "apps/input/schema.hpp"
#include "apps/input/values.hpp"

namespace liesl {

namespace {

std::vector<std::string> changes_of(const toml::table& set) {
  std::vector<std::string> changes;
  for (const auto& [key, value] : set)
    changes.push_back(fmt::format("{}={}", key.str(), toml_text(value)));
  return changes;
}

Axis* axis_of(std::vector<Axis>& axes, const char* name) {
  const auto at = std::find_if(axes.begin(), axes.end(),
                               [name](const Axis& axis) { return axis.column.name == name; });
  return at == axes.end() ? nullptr : &*at;
}

/// The meshes of a model: changes of its own keys.
std::vector<CaseValue> meshes_of(const toml::table& elements) {
  std::vector<CaseValue> values;
  for (const toml::node& value : *elements["values"].as_array()) {
    CaseValue mesh{toml_text(value), place_of(value), std::vector<std::string>()};
    for (const toml::node* key : strings(elements, "key"))
      mesh.instead->push_back(*key->value<std::string>() + "=" + mesh.text);
    values.push_back(std::move(mesh));
  }
  return values;
}

void append(const toml::table& model, std::string name, std::vector<Axis> axes, CaseList& cases,
            Problems& problems) {
  const Key& known = *find_key(FileKind::Scene, "simulation.formalism");
  const auto formalisms = words(known.options);
  Axis *formalism = axis_of(axes, "formalism"), *elements = axis_of(axes, "elements");
  if (std::count(formalisms.begin(), formalisms.end(), name))
    problems.add(model, fmt::format("'{}' is the name of a formalism", name), "another name");
  if (!formalism)
    problems.add(model, "the grid has no formalism, in whose place the model stands",
                 "grid.formalism", "as in formalism = [\"se3\"]");
  if (model.contains("elements") && !elements)
    problems.add(*model.get("elements"), "the grid has no elements, in whose place these stand",
                 "grid.elements");
  if (!formalism || (model.contains("elements") && !elements)) return;
  formalism->values = {{std::move(name), place_of(model), changes_of(*model["set"].as_table())}};
  if (const toml::table* own = model["elements"].as_table()) elements->values = meshes_of(*own);
  const auto first = static_cast<std::size_t>(formalism - axes.data());
  for (CaseList::Row& row : expand(axes).rows) {
    auto& changes = *row.values[first].instead;  // those of the mesh are made to the model
    for (std::size_t c = 0; c < row.values.size(); ++c)
      if (auto& own = row.values[c].instead; own && c != first) {
        changes.insert(changes.end(), own->begin(), own->end());
        own->clear();
      }
    cases.rows.push_back(std::move(row));
  }
}

}  // namespace

void add_models(const toml::table& models, const std::vector<Axis>& axes, CaseList& cases,
                Problems& problems) {
  for (const auto& [name, node] : models)
    append(*node.as_table(), std::string(name.str()), axes, cases, problems);
  const std::size_t count = cases.rows.size(), digits = fmt::formatted_size("{}", count);
  for (std::size_t k = 0; k < count; ++k) cases.rows[k].name = fmt::format("{:0{}}", k + 1, digits);
}

}  // namespace liesl
