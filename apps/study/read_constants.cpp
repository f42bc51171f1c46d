/// @file
/// Constants that a study may change: of springs and dampers, masses of rigid bodies.
#include <fmt/format.h>

#include <algorithm>

#include "apps/study/study_reader.hpp"
#include "mbs/system/response_value.hpp"

namespace liesl {
namespace {

int force_named(const Mechanism& mechanism, const std::string& name) {
  for (std::size_t f = 0; f < mechanism.forces.size(); ++f)
    if (mechanism.forces[f].name == name) return static_cast<int>(f);
  return -1;
}

const RigidSpec* rigid_named(const Mechanism& mechanism, const std::string& name) {
  const int body = mechanism.body(name);
  if (body < 0) return nullptr;
  return std::get_if<RigidSpec>(&mechanism.bodies[static_cast<std::size_t>(body)].kind);
}

bool of_angle(const ForceSpec& force, const Mechanism& mechanism) {
  if (force.joint < 0) return false;
  ResponseSpec coordinate;
  coordinate.kind = ResponseKind::Coordinate;
  coordinate.joint = force.joint;
  coordinate.coordinate = force.coordinate;
  return std::string(unit(coordinate, mechanism)) == "rad";
}

/// Which quantity a word means; said if it is none.
bool read_quantity(StudyReader& reader, const toml::node& node, ConstantSpec& c) {
  const std::string word = node.value_or(std::string());
  const std::vector<std::string> known =
      c.force >= 0 ? words("stiffness damping rest") : words("mass");
  const auto found = std::find(known.begin(), known.end(), word);
  if (found == known.end()) {
    reader.scene.problems.add(node, fmt::format("'{}' is no constant of '{}'", word, c.name),
                              "stiffness, damping or rest of a force, mass of a rigid body",
                              suggestion(word, known));
    return false;
  }
  c.quantity =
      c.force < 0 ? ConstantQuantity::Mass : static_cast<ConstantQuantity>(found - known.begin());
  return true;
}

/// Bounds and start, said if they contradict each other.
bool read_range(StudyReader& reader, const toml::table& table, ConstantSpec& c) {
  Problems& problems = reader.scene.problems;
  const auto bounds = numbers(*table.get("bounds"));
  c.lower = bounds[0];
  c.upper = bounds[1];
  const int before = problems.count();
  const toml::node& at = *table.get("bounds");
  if (c.lower >= c.upper)
    problems.add(at, fmt::format("the bounds of '{}' are [{:g}, {:g}]", c.name, c.lower, c.upper),
                 "[least, largest] with least < largest");
  if (c.quantity != ConstantQuantity::Rest && !(c.lower > 0))
    problems.add(at, fmt::format("the least value of '{}' is out of range: {:g}", c.name, c.lower),
                 "numbers > 0");
  if (const toml::node* start = table.get("start")) c.start = numbers(*start).front();
  const double x = c.start.value_or(constant_of(c, reader.scene.scene.mechanism));
  if (problems.count() == before && !(x >= c.lower && x <= c.upper))
    problems.add(c.start ? *table.get("start") : at,
                 fmt::format("the start {:g} of '{}' is outside the bounds", x, c.name),
                 fmt::format("a value in [{:g}, {:g}]", c.lower, c.upper),
                 c.start ? "" : "give a 'start', or change the scene or the bounds");
  return problems.count() == before;
}

}  // namespace

bool names_constant(const StudyReader& reader, const toml::table& table) {
  const auto names = strings(table, "of"), properties = strings(table, "property");
  if (names.size() != 1 || properties.size() != 1) return false;
  const Mechanism& mechanism = reader.scene.scene.mechanism;
  const std::string name = names.front()->value_or(std::string());
  if (names_motion(reader, table)) return true;
  return force_named(mechanism, name) >= 0 ||
         (rigid_named(mechanism, name) && properties.front()->value_or(std::string()) == "mass");
}

void read_constant(StudyReader& reader, const Entry& entry) {
  const toml::table& table = *entry.table;
  if (names_motion(reader, table)) return read_motion_variable(reader, entry);
  const Mechanism& mechanism = reader.scene.scene.mechanism;
  ConstantSpec c;
  c.name = entry.name;
  const std::string of = strings(table, "of").front()->value_or(std::string());
  c.force = force_named(mechanism, of);
  if (c.force < 0)
    c.body = mechanism.body(of);
  else
    c.turns = of_angle(mechanism.forces[static_cast<std::size_t>(c.force)], mechanism);
  const toml::node& property = *strings(table, "property").front();
  if (c.force >= 0 && !reader.scene.root["forces"][of].is_table())
    return reader.scene.problems.add(
        *strings(table, "of").front(),
        fmt::format("'{}' belongs to a joint, whose stiffness and damping do not vary", of),
        "an entry of [forces]");
  if (!read_quantity(reader, property, c) || !read_range(reader, table, c)) return;
  for (const ConstantSpec& other : reader.spec.constants)
    if (other.force == c.force && other.body == c.body && other.quantity == c.quantity)
      return reader.scene.problems.add(
          property, fmt::format("this is already varied by '{}'", other.name), "each number once");
  c.values = read_values(reader, entry, c.lower, c.upper);
  reader.spec.constants.push_back(c);
}

}  // namespace liesl
