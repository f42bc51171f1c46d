/// @file
/// Objective, constraints, supports and options of a study.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "apps/scene/numbering.hpp"
#include "apps/study/study_reader.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/system/plane.hpp"
#include "mbs/system/response_value.hpp"
#include "optim/study/part_quantity.hpp"
#include "optim/study/without_mechanism_statics.hpp"

namespace liesl {

namespace {

const BodySpec& body_of(const StudyReader& reader, int index) {
  return reader.scene.scene.mechanism.bodies[static_cast<std::size_t>(index)];
}

/// Response of a constraint: the table's own, or one of the scene by name.
std::optional<ResponseSpec> response_of(StudyReader& reader, const Entry& entry) {
  const toml::node* use = entry.table->get("use");
  if (!use) return read_response(reader.scene, entry.name, *entry.table);
  const auto name = use->value_or(std::string());
  if (!reader.scene.known(*use, "responses", "response", name)) return {};
  for (ResponseSpec response : reader.scene.scene.responses) {
    if (response.name != name) continue;
    response.name = entry.name;
    return response;
  }
  return {};  // broken, said before
}

/// Is a response a size, 0 or larger (docs/responses.md)?
bool never_negative(const ResponseSpec& r) {
  using enum ResponseKind;
  return r.kind == Stress || r.kind == Compliance || r.kind == Buckling ||
         r.kind == LocalBuckling || (r.kind == JointForce && !r.axis);
}

/// The stress or compliance of a meshed part?
bool is_of_mesh(const StudyReader& reader, const ResponseSpec& r) {
  return (r.kind == ResponseKind::Stress || r.kind == ResponseKind::Compliance) &&
         std::holds_alternative<SolidSpec>(body_of(reader, r.body).kind);
}

/// The side of a signed response that a limit holds; a vector has none.
Side read_side(StudyReader& reader, const Entry& entry, const ResponseSpec& response) {
  const std::string chosen = text(*entry.table, "side");
  if (chosen == "both") return Side::Both;
  const Mechanism& mechanism = reader.scene.scene.mechanism;
  const bool planar = response.kind == ResponseKind::Deflection &&
                      reader.scene.scene.simulation.space != SpaceChoice::Spatial &&
                      find_plane(mechanism).plane;
  if (components(response, planar) != 1 || response.everywhere)
    reader.scene.problems.add(
        *entry.table->get("side"),
        fmt::format("constraint '{}' is of a vector, which has no sides", entry.name),
        "a response with one component", "'axis' takes one component");
  if (chosen == "down" && never_negative(response)) {
    reader.scene.problems.add(
        *entry.table->get("side"),
        fmt::format("constraint '{}' is of a size, which is never below zero: the limit would hold "
                    "nothing",
                    entry.name),
        "\"both\" or \"up\"", "limits of one side are for signed responses");
    return Side::Both;
  }
  return chosen == "up" ? Side::Up : Side::Down;
}

/// Why a limit needs the sensitivities of a motion, and this study has none; empty: it has.
std::string without_sensitivities(const StudyReader& reader) {
  if (reader.root.contains("loads")) return "fixed loads have no motion";
  if (reader.spec.cycle.method == CycleMethod::Esl)
    return "the method \"esl\" uses static problems only";
  return "";
}

/// In the order of Treatment.
Treatment read_treatment(const std::string& name) {
  const auto names = words("auto all maxima neighbours worst functional p_norm ks");
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? Treatment::Auto : static_cast<Treatment>(found - names.begin());
}

/// Number of directions that "node:xyz,rx" holds, -1 if it is not of that form.
int held(const std::string& text) {
  const auto colon = text.find(':');
  if (colon == std::string::npos) return 6;
  std::istringstream list(text.substr(colon + 1));
  int count = 0;
  for (std::string part; std::getline(list, part, ',');) {
    const bool turn = part.starts_with('r');
    const std::string axes = turn ? part.substr(1) : part;
    const bool known = axes.find_first_not_of("xyz") == std::string::npos;
    const bool twice = std::any_of(axes.begin(), axes.end(), [&](char c) {
      return std::count(axes.begin(), axes.end(), c) > 1;
    });
    if (axes.empty() || !known || twice) return -1;
    count += static_cast<int>(axes.size());
  }
  return count > 0 ? count : -1;
}

/// One support of a beam; returns the directions that it holds, 0 if it is wrong (and said).
int read_support(StudyReader& reader, const std::string& body, const toml::node& node) {
  const auto given = node.value_or(std::string());
  const auto text = Numbering(reader.scene.root, body).support(given);
  if (text == "inertia_relief") return 6;
  const std::string place = text.substr(0, text.find(':'));
  if (!reader.scene.scene.mechanism.port(body + "." + place)) {
    const std::string named = given.substr(0, given.find(':'));
    reader.scene.problems.add(node, fmt::format("beam '{}' has no node '{}'", body, named),
                              "start, mid, nodeK, end, or \"inertia_relief\"",
                              suggestion(named, {"start", "mid", "end", "inertia_relief"}));
    return 0;
  }
  const int count = held(text);
  if (count > 0) return count;
  reader.scene.problems.add(node, fmt::format("'{}' is no support", given),
                            "a node and directions, as in \"start:xyz,rx\"");
  return 0;
}

}  // namespace

namespace {

/// Says so if what is limited or minimised is of a rigid body: it is 0 for every design. Scenarios
/// after the first are asked when all is read.
bool is_of_rigid_body(StudyReader& reader, const toml::node& at, const char* what,
                      const ResponseSpec& response) {
  const int index = deformed_body(response);
  if (index < 0) return false;
  const Mechanism& mechanism = reader.scene.scene.mechanism;
  const BodySpec& body = body_of(reader, index);
  const bool fixed = reader.root.contains("loads") && std::holds_alternative<SolidSpec>(body.kind);
  if (fixed || !moves_rigidly(body, mechanism.formalism)) return false;
  reader.scene.problems.add(
      at, fmt::format("{} '{}' is always 0: '{}' is rigid", what, response.name, body.name),
      "a response that does not need deformation, or a flexible body",
      "bodies.*.beam.as, modes and simulation.formalism say what a body is simulated as");
  return true;
}

/// Largest values in the objective, as constraints with a weight.
void read_largest(StudyReader& reader, const toml::table& table, const toml::table* weights) {
  const toml::node* given = weights ? weights->get("largest") : nullptr;
  const auto names = strings(table, "largest");
  std::vector<double> weight = given ? numbers(*given) : std::vector<double>();
  if (weight.size() == 1) weight.assign(names.size(), weight.front());
  if (weight.size() != names.size())
    return reader.scene.problems.add(
        given ? *given : *table.get("largest"),
        fmt::format("{} responses in 'largest' and {} weights", names.size(), weight.size()),
        "weights.largest: one for all, or one each");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name = names[i]->value_or(std::string());
    if (!reader.scene.known(*names[i], "responses", "response", name)) continue;
    if (!(weight[i] > 0)) {
      reader.scene.problems.add(*given, fmt::format("the weight of '{}' is zero", name),
                                "a weight > 0");
      continue;
    }
    for (const ResponseSpec& response : reader.scene.scene.responses) {
      if (response.name != name || is_of_rigid_body(reader, *names[i], "response", response))
        continue;
      const bool fixed = reader.root.contains("loads"),
                 image = has_static_image(response, reader.scene.scene.mechanism);
      if (fixed && !image)
        reader.scene.problems.add(
            *names[i],
            fmt::format(
                "'{}' is not on the deformation of the part, and fixed loads have no motion", name),
            "a displacement or elongation of the meshed part",
            "weights.stress and weights.compliance are of its load cases");
      ConstraintSpec term{response, 1, fixed};
      term.response.name = name;
      term.weight = weight[i];
      reader.spec.constraints.push_back(std::move(term));
      reader.spec.motion_objective.extremes = true;
    }
  }
}

/// The beam whose own frequencies are meant; -1: the whole mechanism, or it is none (and said).
int read_vibrating(StudyReader& reader, const toml::node* of) {
  if (!of) return -1;
  const auto name = of->value_or(std::string());
  if (!reader.scene.known(*of, "bodies", "body", name)) return -1;
  const Mechanism& mechanism = reader.scene.scene.mechanism;
  const int body = mechanism.body(name);
  if (body < 0) return -1;  // broken, said before
  const auto* beam = std::get_if<BeamSpec>(&body_of(reader, body).kind);
  if (beam && model_of(*beam, mechanism.formalism) != BeamModel::Rigid) return body;
  reader.scene.problems.add(*of, fmt::format("'{}' is no flexible beam", name),
                            "a beam that is not rigid",
                            "of a meshed part: [part_limits] with quantity = \"frequency\"");
  return -1;
}

/// A quantity of the one meshed part under fixed loads in the objective.
void add_part_term(StudyReader& reader, const char* name, SolidResponse quantity, double weight,
                   int count = 1) {
  if (reader.spec.shapes.empty()) return;  // said by check_shapes
  PartLimitSpec term{name, reader.spec.shapes.begin()->first, quantity, 1, count};
  term.weight = weight;
  reader.spec.part_limits.push_back(std::move(term));
  reader.spec.motion_objective.extremes = true;
}

void read_part_terms(StudyReader& reader, const toml::table* weights) {
  const auto read = [&](const char* key, const char* name, SolidResponse quantity) {
    const double weight = weights ? (*weights)[key].value_or(0.0) : 0;
    if (!(weight > 0)) return;
    if (reader.root.contains("loads")) return add_part_term(reader, name, quantity, weight);
    reader.scene.problems.add(*weights->get(key),
                              fmt::format("'{}' is that of a meshed part under fixed [loads]", key),
                              "weights.largest and a response");
  };
  read("compliance", "largest compliance", SolidResponse::Compliance);
  read("stress", "largest stress", SolidResponse::Stress);
}

void read_frequency_term(StudyReader& reader, const toml::table& table, double weight) {
  const auto refuse_written = [&](const char* key, const char* what, const char* expected) {
    const toml::node* node = table.get(key);
    if (node && written(*node))
      reader.scene.problems.add(*node, fmt::format("'{}' is {}", key, what), expected);
  };
  const bool fixed = reader.root.contains("loads");
  for (const char* key : {"count", "at", "frequency_of"}) {
    if (!(weight > 0))
      refuse_written(key, "of a frequency in the objective", "weights.frequency > 0");
    else if (fixed && key != std::string("count"))
      refuse_written(key, "of a mechanism, and under fixed loads the part is free", "'count'");
  }
  if (!(weight > 0)) return;
  if (fixed)
    return add_part_term(reader, "lowest frequency", SolidResponse::Frequency, weight,
                         integer(table, "count"));
  FrequencyLimitSpec term{"lowest frequency", 1, integer(table, "count"), number(table, "at")};
  term.weight = weight;
  term.body = read_vibrating(reader, table.get("frequency_of"));
  reader.spec.frequencies.push_back(term);
  reader.spec.motion_objective.extremes = true;
}

}  // namespace

/// Weights of an objective that is not the mass alone.
void read_motion_objective(StudyReader& reader, const toml::table& table) {
  MotionObjective& objective = reader.spec.motion_objective;
  Problems& problems = reader.scene.problems;
  if (text(table, "minimize") != "weighted") {
    for (const char* key : {"weights", "effort", "largest"})
      if (const toml::node* node = table.get(key))
        problems.add(*node, fmt::format("'{}', but the objective is not \"weighted\"", key),
                     "objective.minimize = \"weighted\"");
    return;
  }
  const toml::table* weights = table["weights"].as_table();
  const auto weight = [&](const char* key) { return weights ? (*weights)[key].value_or(0.0) : 0; };
  objective.mass = weight("mass");
  objective.duration = weight("duration");
  objective.effort = weight("effort");
  read_largest(reader, table, weights);
  read_frequency_term(reader, table, weight("frequency"));
  read_part_terms(reader, weights);
  for (const toml::node* node : strings(table, "effort")) {
    const std::string name = node->value_or(std::string());
    if (!reader.scene.known(*node, "responses", "response", name)) continue;
    for (const ResponseSpec& response : reader.scene.scene.responses)
      if (response.name == name && !is_of_rigid_body(reader, *node, "response", response))
        objective.responses.push_back(response);
  }
  const toml::node& at = weights ? static_cast<const toml::node&>(*weights) : table;
  if (!(objective.mass > 0 || objective.duration > 0 || objective.effort > 0 || objective.extremes))
    problems.add(
        at, "all weights are zero",
        "a weight > 0 of mass, largest, frequency, duration or effort; under fixed [loads] "
        "of mass, largest, frequency, compliance or stress");
  if ((objective.effort > 0) != !objective.responses.empty())
    problems.add(at,
                 objective.effort > 0 ? "effort has a weight, but no responses"
                                      : "responses of the effort, but no weight",
                 "weights.effort > 0 and effort = [responses]");
  const auto& constants = reader.spec.constants;
  if (objective.duration > 0 && std::none_of(constants.begin(), constants.end(), [](const auto& c) {
        return c.quantity == ConstantQuantity::Duration;
      }))
    problems.add(
        at, "no variable changes the duration", "a variable of the duration, or no weight",
        "as in time = { of = \"simulation\", property = \"duration\", bounds = [0.2, 1] }");
}

namespace {

/// Does a variable change the mass of this body?
bool varies(const StudySpec& spec, int body) {
  if (spec.shapes.contains(body)) return true;
  for (const DesignSpec& design : spec.design)
    if (std::count(design.bodies.begin(), design.bodies.end(), body)) return true;
  for (const ConstantSpec& c : spec.constants)
    if (c.body == body) return true;
  return false;
}

/// Have all entries of [design] been understood?
bool design_is_read(const StudyReader& reader) {
  const toml::table* design = reader.root["design"].as_table();
  std::size_t entries_read = 0;
  each_entry(reader.spec, [&entries_read](const auto&) { ++entries_read; });
  return design && design->size() == entries_read;
}

}  // namespace

void read_objective(StudyReader& reader) {
  const toml::table* table = reader.root["objective"].as_table();
  if (!table || reader.broken.contains("objective")) return;
  bool varied = false, complete = true;
  for (const toml::node* node : strings(*table, "of")) {
    const auto bodies = reader.scene.bodies_of(*node);
    complete = complete && !bodies.empty();
    for (const int body : bodies) {
      auto& counted = reader.spec.mass_of;
      if (std::find(counted.begin(), counted.end(), body) != counted.end()) {
        reader.scene.problems.add(*node, "this body is named twice", "each body once");
        break;
      }
      counted.push_back(body);
      varied = varied || varies(reader.spec, body);
    }
  }
  read_motion_objective(reader, *table);
  reader.spec.objective = part_quantity(text(*table, "minimize"));

  if (!varied && complete && design_is_read(reader) && reader.spec.motion_objective.only_mass())
    reader.scene.problems.add(*table->get("of"), "no design variable changes the objective",
                              "a body of [design]");
}

namespace {

/// The mass of some bodies.
void read_mass_limit(StudyReader& reader, const Entry& entry) {
  MassLimitSpec limit{entry.name, {}, number(*entry.table, "limit")};
  Problems& problems = reader.scene.problems;
  for (const toml::node* node : strings(*entry.table, "mass"))
    for (const int body : reader.scene.bodies_of(*node)) {
      if (std::find(limit.bodies.begin(), limit.bodies.end(), body) != limit.bodies.end()) {
        problems.add(*node, "a body is named twice", "each body once");
        break;
      }
      limit.bodies.push_back(body);
    }
  const bool varied = std::any_of(limit.bodies.begin(), limit.bodies.end(),
                                  [&](int body) { return varies(reader.spec, body); });
  if (!limit.bodies.empty() && !varied && design_is_read(reader))
    problems.add(*entry.table->get("mass"),
                 fmt::format("no design variable changes the mass of limit '{}'", limit.name),
                 "a body of [design]");
  for (const char* key : {"side", "treatment", "surrogate", "approximation"})
    if (const toml::node* node = entry.table->get(key); node && written(*node))
      problems.add(*node, fmt::format("a mass has no '{}'", key), "'mass' and 'limit'");
  if (reader.root.contains("loads"))
    problems.add(*entry.table->get("mass"), "a mass in a study under fixed loads",
                 "[part_limits] with quantity = \"mass\"");
  reader.spec.mass_limits.push_back(std::move(limit));
}

/// A constraint on each bar of a truss, of which there is one entry.
std::vector<Entry> for_each_bar(StudyReader& reader, const Entry& entry,
                                std::vector<toml::table>& tables) {
  const std::string of = text(*entry.table, "of");
  const auto truss = reader.scene.trusses.bars.find(of);
  const std::string kind = text(*entry.table, "response");
  const bool member = kind == "axial_stress" || kind == "buckling" || kind == "local_buckling";
  if (truss == reader.scene.trusses.bars.end() || !member) return {entry};
  std::vector<Entry> out;
  for (const std::string& bar : truss->second) {
    toml::table& table = tables.emplace_back(*entry.table);
    table.insert_or_assign("of", bar);
    out.push_back({entry.name + " " + bar, entry.key, nullptr});
  }
  return out;
}

/// A limit on the stress of a beam or part. @param name of the entry, for a bar of a truss with its
/// bar
void check_stress_limit(StudyReader& reader, const std::string& name, const ConstraintSpec& limit) {
  const ResponseSpec& r = limit.response;
  if (r.body < 0 || (r.kind != ResponseKind::Stress && r.kind != ResponseKind::AxialStress)) return;
  const BodySpec& body = body_of(reader, r.body);
  const auto* beam = std::get_if<BeamSpec>(&body.kind);
  const double E = beam ? beam->material.E : std::get<SolidSpec>(body.kind).model->material().E;
  const bool whole = reader.root["constraints"].as_table()->contains(name);
  note_stress_limit(reader, "constraints." + (whole ? name : name.substr(0, name.rfind(' '))),
                    limit.limit, E);
}

Approximation read_approximation(const toml::table& table) {
  const auto names = words("auto power linear mma additive");  // in the order of Approximation
  const auto found = std::find(names.begin(), names.end(), text(table, "approximation"));
  return found == names.end() ? Approximation::Auto
                              : static_cast<Approximation>(found - names.begin());
}

void read_constraint(StudyReader& reader, const Entry& entry) {
  auto response = response_of(reader, entry);
  if (!response) return;
  if (is_of_rigid_body(reader, *entry.table, "limit", *response)) return;
  response->side = read_side(reader, entry, *response);
  const bool image = has_static_image(*response, reader.scene.scene.mechanism);
  ConstraintSpec limit{std::move(*response), number(*entry.table, "limit"), image};
  limit.treatment = read_treatment(text(*entry.table, "treatment"));
  if (limit.treatment == Treatment::PNorm) limit.p = number(*entry.table, "p");
  const std::string surrogate = text(*entry.table, "surrogate");
  limit.surrogate = surrogate == "mechanism" ? SurrogateKind::Mechanism
                    : surrogate == "motion"  ? SurrogateKind::Motion
                                             : SurrogateKind::Auto;
  limit.approximation = read_approximation(*entry.table);
  check_stress_limit(reader, entry.name, limit);
  reader.spec.constraints.push_back(std::move(limit));
}

}  // namespace

void read_constraints(StudyReader& reader) {
  for (const Entry& entry : entries(reader.root, reader.broken, "constraints")) {
    if (entry.table->contains("mass")) {
      read_mass_limit(reader, entry);
      continue;
    }
    std::vector<toml::table> tables;
    std::vector<Entry> each = for_each_bar(reader, entry, tables);
    for (std::size_t i = 0; i < each.size(); ++i) {
      if (!each[i].table) each[i].table = &tables[i];
      read_constraint(reader, each[i]);
    }
  }
  for (const char* group : {"constraints", "part_limits", "walls", "frequencies"})
    if (const toml::table* table = reader.root[group].as_table(); table && !table->empty()) return;
  const toml::node* table = reader.root.get("constraints");
  reader.scene.problems.add(table ? *table : reader.root, "the study has no constraints",
                            "an entry in [constraints], [part_limits], [walls] or [frequencies]");
}

void read_frequencies(StudyReader& reader) {
  const auto limits = entries(reader.root, reader.broken, "frequencies");
  for (const Entry& entry : limits) {
    FrequencyLimitSpec limit{entry.name, number(*entry.table, "least"),
                             integer(*entry.table, "count"), number(*entry.table, "at")};
    const toml::node* of = entry.table->get("of");
    limit.body = read_vibrating(reader, of);
    if (const toml::node* at = entry.table->get("at"); of && written(*at))
      reader.scene.problems.add(*at, "'at' is a pose of the mechanism, and one beam has none",
                                "'of' or 'at'");
    reader.spec.frequencies.push_back(std::move(limit));
  }
  if (reader.spec.frequencies.empty()) return;
  const auto refuse = [&](const std::string& what, const char* expected) {
    reader.scene.problems.add(*reader.root.get(limits.empty() ? "objective" : "frequencies"), what,
                              expected);
  };
  const Mechanism& mechanism = reader.scene.scene.mechanism;
  std::vector<bool> vibrates(mechanism.bodies.size(), false);
  bool whole = false;
  for (const FrequencyLimitSpec& f : reader.spec.frequencies) {
    if (f.body >= 0) vibrates[static_cast<std::size_t>(f.body)] = true;
    whole = whole || f.body < 0;
  }
  if (whole && limits.empty() && (!reader.spec.drives.empty() || reader.spec.duration > 0))
    refuse("a frequency in a pose, and variables of the motion itself", "one or the other");
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const BodySpec& body = mechanism.bodies[b];
    const auto* beam = std::get_if<BeamSpec>(&body.kind);
    if (beam && (whole || vibrates[b]) &&
        model_of(*beam, mechanism.formalism) == BeamModel::Segments)
      return refuse("frequencies are those in space, and '" + body.name +
                        "' is a chain of segments, which has no torsion",
                    "a beam of another formalism");
  }
  if (reader.root.contains("loads"))
    refuse("frequencies of a mechanism in a study under fixed loads", "a study of a motion");
  if (!whole) return;
  for (const BodySpec& body : mechanism.bodies)
    if (const auto* solid = std::get_if<SolidSpec>(&body.kind); solid && solid->mesh().dim == 2)
      return refuse("frequencies are those in space, and '" + body.name + "' is meshed in a plane",
                    "[part_limits] with quantity = \"frequency\"");
  if (!reader.spec.shapes.empty())
    refuse("frequencies of a mechanism whose outlines change", "design variables of sections");
  if (mechanism.formalism == Formalism::Rigid)
    refuse("no part of a rigid mechanism vibrates", "another simulation.formalism");
}

void read_supports(StudyReader& reader) {
  toml::table* table = reader.root["supports"].as_table();
  if (!table) return;
  for (auto&& [key, value] : *table) {
    const std::string name(key.str());
    if (reader.broken.contains("supports." + name)) continue;
    if (!reader.scene.known(value, "bodies", "body", name)) continue;
    const int body = reader.scene.scene.mechanism.body(name);
    if (body < 0) continue;
    if (std::holds_alternative<SolidSpec>(body_of(reader, body).kind)) {
      for (const toml::node* node : strings(*table, key.str()))
        reader.spec.supports[body].push_back(node->value_or(std::string()));
      continue;  // tried out by check_shapes
    }
    if (!std::holds_alternative<BeamSpec>(body_of(reader, body).kind)) {
      reader.scene.problems.add(value, fmt::format("body '{}' is rigid and needs no support", name),
                                "a beam");
      continue;
    }
    int count = 0;
    bool ok = true;
    for (const toml::node* node : strings(*table, key.str())) {
      const int directions = read_support(reader, name, *node);
      ok = ok && directions > 0;
      count += directions;
      reader.spec.supports[body].push_back(
          Numbering(reader.scene.root, name).support(node->value_or(std::string())));
    }
    if (ok && count != 6 && count != 3)
      reader.scene.problems.add(value,
                                fmt::format("the supports of '{}' hold {} directions", name, count),
                                "6 directions (3 in a plane), statically determinate",
                                "as in [\"start:xyz,rx\", \"end:yz\"]");
  }
}

void read_cycle(StudyReader& reader) {
  toml::table* table = reader.root["cycle"].as_table();
  if (!table || reader.broken.contains("cycle")) return;
  CycleOptions& o = reader.spec.cycle;
  o.max = integer(*table, "max");
  o.tolerance = number(*table, "tolerance");
  o.objective_tolerance = number(*table, "objective_tolerance");
  o.feasibility = number(*table, "feasibility");
  o.move_limit = number(*table, "move_limit");
  o.screening = number(*table, "screening");
  o.min_cases = integer(*table, "min_cases");
  o.gap = number(*table, "gap");
  o.max_designs = integer(*table, "max_designs");
  o.restarts = integer(*table, "restarts");
  o.continuation = integer(*table, "continuation");
  const std::string optimizer = text(*table, "optimizer");
  const auto names = words("ipopt mma ccsaq slsqp");  // in the order of Optimizer
  const auto found = std::find(names.begin(), names.end(), optimizer);
  if (found != names.end()) o.optimizer = static_cast<Optimizer>(found - names.begin());
  o.model = text(*table, "model") == "separable" ? NlpModel::Separable : NlpModel::Exact;
  const std::string method = text(*table, "method");
  o.method = method == "esl"      ? CycleMethod::Esl
             : method == "esl1"   ? CycleMethod::Esl1
             : method == "full"   ? CycleMethod::Full
             : method == "direct" ? CycleMethod::Direct
                                  : CycleMethod::Auto;
  o.approximation = read_approximation(*table);
  const std::string check = text(*table, "optimality");
  o.optimality = check == "always"  ? OptimalityCheck::Always
                 : check == "never" ? OptimalityCheck::Never
                                    : OptimalityCheck::Auto;
}

/// What varies of a motion only.
void check_statics(StudyReader& reader) {
  if (reader.scene.scene.simulation.type == SimulationType::Dynamic) return;
  if (reader.scene.scene.simulation.arc_length)
    reader.scene.problems.add(
        reader.root, "simulation.arc_length, whose load factors follow the design",
        "simulation.arc_length = false", "limits hold at the same load factors for every design");
  for (const ConstantSpec& c : reader.spec.constants)
    if (c.quantity == ConstantQuantity::Damping || c.quantity >= ConstantQuantity::DriveValue)
      reader.scene.problems.add(
          *reader.root["design"][c.name].node(),
          fmt::format("'{}' changes a constant of a motion, and statics has none", c.name),
          "dimensions of sections, stiffness or rest value of a spring");
  if (reader.spec.motion_objective.effort > 0)
    reader.scene.problems.add(*reader.root["objective"].as_table()->get("effort"),
                              "an effort over time, and statics has none", "weights.largest");
}

/// The table of a constraint; "limit bar" is one of a limit of a truss.
const toml::table& constraint_table(const StudyReader& reader, const std::string& name) {
  const toml::table& limits = *reader.root["constraints"].as_table();
  return *limits.get(limits.contains(name) ? name : name.substr(0, name.rfind(' ')))->as_table();
}

/// The optimiser of the motion itself has as many constraints at every design.
void check_direct(StudyReader& reader) {
  if (reader.spec.cycle.method != CycleMethod::Direct) return;
  const auto refuse = [&](const toml::node& at, const std::string& what, const char* expected) {
    reader.scene.problems.add(at, what + ", and cycle.method is \"direct\"", expected,
                              "\"full\" approximates the same responses");
  };
  if (const toml::node* loads = reader.root.get("loads"))
    refuse(*loads, "fixed loads have no motion", "a study of a motion");
  if (reader.spec.motion_objective.extremes)
    refuse(*reader.root["objective"].as_table()->get("minimize"),
           "largest values or lowest frequencies have kinks", "the mass, efforts, the duration");
  for (const PartLimitSpec& l : reader.spec.part_limits)
    if (follows_loads(l.quantity) && reader.root.contains("part_limits"))
      refuse(*reader.root["part_limits"].as_table()->get(l.name),
             "the load cases of a part's stress or compliance change with the design",
             "limits on mass or frequency");
  for (const ConstraintSpec& c : reader.spec.constraints)
    if (c.treatment == Treatment::Maxima || c.treatment == Treatment::Neighbours ||
        c.treatment == Treatment::Ks)
      refuse(*constraint_table(reader, c.response.name).get("treatment"),
             "the number of maxima changes with the design",
             "\"auto\", \"all\", \"worst\", \"functional\" or \"p_norm\"");
}

/// Static problems of the whole mechanism, of motions whose variables are sections.
void check_surrogates(StudyReader& reader) {
  for (const ConstraintSpec& c : reader.spec.constraints) {
    if (c.surrogate != SurrogateKind::Mechanism) continue;
    auto none = without_mechanism_statics(reader.spec, c, reader.scene.scene.mechanism);
    if (reader.root.contains("loads"))
      none = NoMechanismStatics{"fixed loads have no mechanism", "a study of a motion"};
    if (none)
      reader.scene.problems.add(*constraint_table(reader, c.response.name).get("surrogate"),
                                fmt::format("constraint '{}': {}", c.response.name, none->why),
                                none->expected, "surrogate = \"auto\" takes all of them");
  }
}

/// Other speeds, of a motion that has them.
void check_continuation(StudyReader& reader) {
  if (reader.spec.cycle.continuation == 0) return;
  const Scene& scene = reader.scene.scene;
  const std::string why = reader.root.contains("loads")
                              ? "fixed loads have no speed"
                              : without_speed(reader.spec, scene.mechanism, scene.simulation);
  if (!why.empty())
    reader.scene.problems.add(*reader.root["cycle"].as_table()->get("continuation"), why,
                              "a motion with drives, whose values and duration are given",
                              "cycle.restarts begins again from other designs");
}

void check_images(StudyReader& reader) {
  check_statics(reader);
  check_direct(reader);
  check_surrogates(reader);
  check_continuation(reader);
  const std::string why = without_sensitivities(reader);
  if (why.empty()) return;
  const MotionObjective& objective = reader.spec.motion_objective;
  const bool of_motion = reader.root.contains("loads")
                             ? objective.duration > 0 || objective.effort > 0
                             : !objective.only_mass();
  if (of_motion)
    reader.scene.problems.add(*reader.root["objective"].as_table()->get("minimize"),
                              "the objective is of the motion, and " + why, "\"mass\"",
                              "\"weighted\" needs cycle.method \"esl1\" or \"full\"");
  for (const ConstantSpec& c : reader.spec.constants)
    reader.scene.problems.add(
        *reader.root["design"][c.name].node(),
        fmt::format("'{}' changes a constant of the motion, and {}", c.name, why),
        "dimensions of sections or parameters of an outline",
        "constants need a motion and cycle.method \"esl1\" or \"full\"");
  const bool fixed = reader.root.contains("loads");
  for (const ConstraintSpec& c : reader.spec.constraints)
    if (c.weight == 0 &&
        (!c.has_image || by_motion_alone(c) || (fixed && c.treatment != Treatment::Auto))) {
      const toml::table& table = constraint_table(reader, c.response.name);
      const toml::node* use = table.get("use");
      const bool treated = c.has_image, of_mesh = is_of_mesh(reader, c.response);
      reader.scene.problems.add(
          treated ? *table.get(c.treatment != Treatment::Auto ? "treatment" : "surrogate")
          : c.response.side != Side::Both ? *table.get("side")
          : use                           ? *use
                                          : *table.get("response"),
          fmt::format("constraint '{}' {}, and {}", c.response.name,
                      by_motion_alone(c)              ? "is told by the motion's own gradients"
                      : treated                       ? "has a treatment over time"
                      : c.response.side != Side::Both ? "holds one side"
                      : of_mesh                       ? "is of a meshed part in its motion"
                                                      : "is not on the deformation of a part",
                      why),
          treated   ? "\"auto\""
          : of_mesh ? "an entry in [part_limits]"
                    : "a displacement, deflection, elongation, stress or compliance of a beam, a "
                      "displacement or elongation of a meshed part",
          "limits on any response need a motion and cycle.method \"esl1\" or \"full\"");
    }
}

}  // namespace liesl
