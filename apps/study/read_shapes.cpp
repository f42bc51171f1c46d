/// @file
/// What a study says of meshed parts: shape variables, walls, limits, fixed loads.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "apps/study/study_reader.hpp"
#include "mbs/solids/solid_model.hpp"
#include "optim/study/part_quantity.hpp"
#ifdef LIESL_OPTIM
#include "optim/problems/solid_task.hpp"
#endif

namespace liesl {

namespace {

const SolidSpec* solid_of(const StudyReader& reader, int body) {
  return std::get_if<SolidSpec>(
      &reader.scene.scene.mechanism.bodies[static_cast<std::size_t>(body)].kind);
}

/// Body of a meshed part named by a string; empty (and said) if it is none.
std::optional<int> part(StudyReader& reader, const toml::node& name, bool with_outline) {
  const auto body = reader.scene.body(name);
  if (!body) return {};
  const SolidSpec* solid = solid_of(reader, *body);
  if (solid && solid->as == SolidMotion::Continuum) {
    reader.scene.problems.add(
        name,
        fmt::format("part '{}' is a continuum, whose outline and own limits no study takes",
                    name.value_or(std::string())),
        fmt::format("bodies.{}.solid.as = \"reduced\"", name.value_or(std::string())));
    return {};
  }
  if (solid && !(with_outline && solid->outline.features.empty())) return body;
  reader.scene.problems.add(name,
                            fmt::format("'{}' is no meshed part{}", name.value_or(std::string()),
                                        solid ? " with an outline" : ""),
                            "a body with 'solid'",
                            solid ? "features are in bodies.NAME.solid.outline" : "");
  return {};
}

std::vector<std::string> parameter_names(const SolidSpec& solid) {
  std::vector<std::string> names;
  const auto shape = make_shape(solid.outline);
  for (const auto& p : shape->parameters()) names.push_back(p.name);
  return names;
}

/// "plate.x_max" as a part and the rest; empty (and said) if there is no such part.
std::optional<std::pair<int, std::string>> place(StudyReader& reader, const toml::node& node) {
  const auto text = node.value_or(std::string());
  const auto point = text.find('.');
  const int body = reader.scene.scene.mechanism.body(text.substr(0, point));
  if (point != std::string::npos && body >= 0 && solid_of(reader, body))
    return std::pair{body, text.substr(point + 1)};
  reader.scene.problems.add(node, fmt::format("'{}' is no place of a meshed part", text),
                            "part.interface, or part.set");
  return {};
}

void read_walls(StudyReader& reader) {
  for (const Entry& entry : entries(reader.root, reader.broken, "walls")) {
    const auto body = part(reader, *entry.table->get("of"), true);
    if (!body) continue;
    if (text(*entry.table, "feature") == text(*entry.table, "to"))
      reader.scene.problems.add(
          *entry.table->get("to"),
          fmt::format("wall '{}' is between '{}' and itself", entry.name, text(*entry.table, "to")),
          "another feature, or an interface");
    reader.spec.shapes[*body].walls.push_back({entry.name, text(*entry.table, "feature"),
                                               text(*entry.table, "to"),
                                               number(*entry.table, "least")});
  }
}

void read_limits(StudyReader& reader) {
  for (const Entry& entry : entries(reader.root, reader.broken, "part_limits")) {
    const auto body = part(reader, *entry.table->get("of"), false);
    if (!body) continue;
    const SolidResponse quantity = part_quantity(text(*entry.table, "quantity"));
    PartLimitSpec limit{entry.name, *body, quantity, number(*entry.table, "limit"), 1};
    const SolidSpec* solid = solid_of(reader, *body);
    if (quantity == SolidResponse::Stress && solid && solid->model)
      note_stress_limit(reader, "part_limits." + entry.name, limit.limit,
                        solid->model->material().E);
    if (quantity == SolidResponse::Frequency) limit.count = integer(*entry.table, "count");
    reader.spec.part_limits.push_back(limit);
  }
}

void read_fixed_load(StudyReader& reader, const Entry& entry) {
  const bool on = entry.table->contains("on");
  const toml::node& node = *entry.table->get(on ? "on" : "at");
  const auto at = place(reader, node);
  if (!at) return;
  const SolidSpec& solid = *solid_of(reader, at->first);
  FixedLoad load;
  load.name = entry.name;
  load.place = at->second;
  load.load_case = text(*entry.table, "case");
  load.body = at->first;
  load.force = vec3(*entry.table, "force");
  load.moment = vec3(*entry.table, "moment");
  load.traction = vec3(*entry.table, "traction");
  std::vector<std::string> known;
  if (on) {
    for (const auto& [name, nodes] : solid.mesh().sets) {
      if (!nodes.empty()) known.push_back(name);
      if (name == at->second) load.nodes = nodes;
    }
  } else {
    for (std::size_t k = 0; k < solid.interfaces().size(); ++k) {
      known.push_back(solid.interfaces()[k].name);
      if (known.back() == at->second) load.interface = static_cast<int>(k);
    }
  }
  if (on ? load.nodes.empty() : load.interface < 0)
    reader.scene.problems.add(
        node,
        on && solid.mesh().sets.contains(at->second)
            ? fmt::format("the set '{}' of the part has no node of a cell", at->second)
            : fmt::format("the part has no {} '{}'", on ? "set of nodes" : "interface", at->second),
        on ? "a side of the grid, a physical group or an *NSET, with nodes of cells"
           : "an interface",
        suggestion(at->second, known, "it has none"));
  else if ((on ? load.traction : Vec3(load.force.cwiseAbs() + load.moment.cwiseAbs())).isZero(0))
    reader.scene.problems.add(node, fmt::format("load '{}' is zero", entry.name),
                              on ? "a 'traction'" : "a 'force' or a 'moment'");
  else
    reader.spec.loads.push_back(std::move(load));
}

bool changes(const StudySpec& spec, int body) {
  return spec.shapes.contains(body) ||
         std::any_of(spec.design.begin(), spec.design.end(), [body](const DesignSpec& design) {
           return std::count(design.bodies.begin(), design.bodies.end(), body) > 0;
         });
}

/// What a study of a motion cannot do with a meshed part.
void check_motion(StudyReader& reader) {
  const StudySpec& spec = reader.spec;
  Problems& problems = reader.scene.problems;
  for (const PartLimitSpec& l : spec.part_limits) {
    const toml::table& table = *reader.root["part_limits"][l.name].as_table();
    if (!spec.shapes.contains(l.body))
      problems.add(
          *table.get("of"),
          fmt::format("part limit '{}' is of a part whose outline does not change", l.name),
          "a part of [design]");
  }
  for (const ConstraintSpec& c : spec.constraints) {
    const int body = deformed_body(c.response);
    if (!c.has_image || changes(spec, body) || (spec.shapes.empty() && !solid_of(reader, body)))
      continue;
    problems.add(
        *reader.root["constraints"][c.response.name].node(),
        fmt::format("constraint '{}' is of '{}', which no variable changes", c.response.name,
                    reader.scene.scene.mechanism.bodies[std::size_t(body)].name),
        "a response of a body in [design]");
  }
}

/// Limits and terms of the objective under fixed loads are of the part that changes.
void check_fixed_loads(StudyReader& reader) {
  for (const ConstraintSpec& c : reader.spec.constraints) {
    const int body = deformed_body(c.response);
    if (!c.has_image || body < 0 || reader.spec.shapes.contains(body)) continue;
    const toml::node* at = c.weight > 0 ? reader.root["objective"]["largest"].node()
                                        : reader.root["constraints"][c.response.name].node();
    reader.scene.problems.add(
        *at,
        fmt::format("'{}' is of '{}', which no variable changes", c.response.name,
                    reader.scene.scene.mechanism.bodies[static_cast<std::size_t>(body)].name),
        "a response of the part in [design]");
  }
}

}  // namespace

void read_shape_variable(StudyReader& reader, const Entry& entry) {
  const toml::table& table = *entry.table;
  Problems& problems = reader.scene.problems;
  const auto names = strings(table, "of");
  if (names.size() != 1) {
    problems.add(*table.get("of"), fmt::format("'{}' is of {} parts", entry.name, names.size()),
                 "one meshed part");
    return;
  }
  const auto body = part(reader, *names.front(), true);
  if (!body) return;
  if (const toml::node* groups = table.get("groups"); written(*groups))
    problems.add(*groups, fmt::format("'{}' moves an outline, which has no groups", entry.name),
                 "'groups' for dimensions of the sections of a beam", "leave it out");
  const auto known = parameter_names(*solid_of(reader, *body));
  const auto bounds = numbers(*table.get("bounds"));
  ShapeVariableSpec v{entry.name, {}, bounds[0], bounds[1], {}};
  std::vector<double> factors;
  if (const toml::node* node = table.get("factors")) factors = numbers(*node);
  for (const toml::node* node : strings(table, "parameters")) {
    const auto name = node->value_or(std::string());
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      problems.add(*node, fmt::format("the outline has no parameter '{}'", name),
                   "feature.parameter", suggestion(name, known));
      return;
    }
    const auto k = v.drives.size();
    v.drives.push_back({name, k < factors.size() ? factors[k] : 1});
  }
  if (!factors.empty() && (factors.size() != v.drives.size() || factors[0] != 1)) {
    problems.add(*table.get("factors"),
                 fmt::format("{} factors for {} parameters", factors.size(), v.drives.size()),
                 "one each, the first 1");
    return;
  }
  if (const toml::node* node = table.get("start")) v.start = numbers(*node)[0];
  v.values = read_values(reader, entry, v.lower, v.upper);
  reader.spec.shapes[*body].variables.push_back(std::move(v));
}

void note_stress_limit(StudyReader& reader, const std::string& key, double limit, double E) {
  constexpr double kLeastStrain = 5e-8;  // bars of plastics at 100 Pa; steel at 10 kPa
  if (!(limit < kLeastStrain * E)) return;
  const std::string text = fmt::format(
      "{0}.limit = {1:g} Pa is far below what materials bear, {2:.2g} of E: {1:g} MPa is {3:g} Pa",
      key, limit, limit / E, 1e6 * limit);
  auto& warnings = reader.scene.scene.warnings;
  if (warnings.empty() || warnings.back() != text) warnings.push_back(text);  // once for a truss
}

void read_parts_of_study(StudyReader& reader) {
  read_walls(reader);
  read_limits(reader);
  for (const Entry& entry : entries(reader.root, reader.broken, "loads"))
    read_fixed_load(reader, entry);
  if (const toml::table* table = reader.root["stress"].as_table();
      table && !reader.broken.contains("stress"))
    reader.spec.stress = {number(*table, "p"), number(*table, "relaxation")};
}

#ifdef LIESL_OPTIM
namespace {

/// Errors of a part, a line each below a headline: each at the entry of the study that it names in
/// quotes first, or at [design].
void add_at_their_places(StudyReader& reader, const std::string& errors) {
  const char* const expected = "variables, walls, supports and loads that fit the part";
  std::istringstream lines(errors);
  std::string headline, line;
  std::getline(lines, headline);
  bool any = false;
  for (; std::getline(lines, line); any = true) {
    line.erase(0, line.find_first_not_of(' '));
    const toml::node* at = reader.root.get("design");
    if (line.starts_with('\''))
      for (const char* table : {"walls", "design"})
        if (const toml::node* found =
                reader.root[table][line.substr(1, line.find('\'', 1) - 1)].node())
          at = found;
    reader.scene.problems.add(*at, line, expected);
  }
  if (!any) reader.scene.problems.add(*reader.root.get("design"), headline, expected);
}

}  // namespace
#endif

void check_shapes(StudyReader& reader) {
  Problems& problems = reader.scene.problems;
  if (problems.count() > 0) return;
  const StudySpec& spec = reader.spec;
  if (!spec.loads.empty() && (spec.shapes.size() != 1 || !spec.design.empty()))
    problems.add(*reader.root.get("loads"), "fixed loads are for the outline of one meshed part",
                 "shape variables of one part",
                 "fixed loads do not couple parts: a study for each");
  if (spec.loads.empty())
    check_motion(reader);
  else
    check_fixed_loads(reader);
  if (spec.loads.empty() && spec.objective != SolidResponse::Mass)
    problems.add(*reader.root.get("objective"),
                 "compliance and stress are minimised under fixed loads",
                 "'mass', or fixed [loads]");
#ifdef LIESL_OPTIM
  for (const auto& [body, shape] : spec.shapes) try {
      PartShape made(reader.scene.scene.mechanism, body, shape);
      solid_task(spec, made);
    } catch (const std::invalid_argument& error) {
      add_at_their_places(reader, error.what());
    }
#endif
}

}  // namespace liesl
