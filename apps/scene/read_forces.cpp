/// @file
/// Springs, dampers, torques; loads on bodies.
#include <fmt/format.h>

#include "apps/scene/read_functions.hpp"

namespace liesl {

namespace {

/// The force of a law, under either of its names.
void read_push(Reader& reader, const toml::table& table, ForceSpec& force) {
  const toml::node *push = table.get("force"), *turn = table.get("torque");
  if (push && turn)
    reader.problems.add(*turn, fmt::format("force '{}' has both 'force' and 'torque'", force.name),
                        "one of them", "they are two names of the same");
  if (push || turn) force.force = read_function(reader, push ? *push : *turn);
  const bool nothing = force.stiffness == 0 && force.damping == 0 && !force.curve && !push && !turn;
  if (nothing)
    reader.problems.add(table, fmt::format("force '{}' has no force law", force.name),
                        "stiffness, spring, damping, force or torque");
}

/// Force over elongation.
void read_spring(Reader& reader, const toml::table& table, ForceSpec& force) {
  const toml::table* spring = table["spring"].as_table();
  if (!spring) return;
  std::vector<double> x, f;
  for (const toml::node& row : *spring->get("table")->as_array()) {
    const auto values = numbers(row);
    if (!x.empty() && values[0] <= x.back()) {
      reader.problems.add(row, fmt::format("x = {:g} follows x = {:g}", values[0], x.back()),
                          "rows [x, f] with increasing x");
      return;
    }
    x.push_back(values[0]);
    f.push_back(values[1]);
  }
  force.curve.emplace(std::move(x), std::move(f),
                      interpolation_named(text(*spring, "interpolation")));
}

/// Ports of a law between two points, and the distance at which its spring is relaxed.
bool read_points(Reader& reader, const toml::table& table, ForceSpec& force) {
  const toml::array& pair = *table.get("between")->as_array();
  const auto a = reader.port(pair[0]), b = reader.port(pair[1]);
  if (!a || !b) return false;
  force.a = *a;
  force.b = *b;
  const Mechanism& mechanism = reader.scene.mechanism;
  const bool ground = a->body < 0 && b->body < 0;
  if (ground ||
      (a->body == b->body && std::holds_alternative<RigidSpec>(
                                 mechanism.bodies[static_cast<std::size_t>(a->body)].kind))) {
    reader.problems.add(
        pair,
        fmt::format("force '{}' acts between two points of {}, which keep their distance",
                    force.name,
                    ground ? std::string("the ground")
                           : fmt::format("the rigid body '{}'",
                                         mechanism.bodies[static_cast<std::size_t>(a->body)].name)),
        "ports of two bodies, or of a flexible one");
    return false;
  }
  const double distance = (mechanism.frame(*b).x - mechanism.frame(*a).x).norm();
  if (distance < 1e-12) {
    reader.problems.add(
        pair, fmt::format("force '{}' acts between two ports at the same place", force.name),
        "ports that are apart", "use on = \"joint\" for a spring in a joint");
    return false;
  }
  if (!table.contains("rest")) force.rest = distance;
  if (table.contains("torque"))
    reader.problems.add(*table.get("torque"),
                        fmt::format("force '{}' acts on a distance", force.name),
                        "'force' instead of 'torque'");
  return true;
}

}  // namespace

void read_forces(Reader& reader) {
  for (const Entry& entry : entries(reader, "forces")) {
    const toml::table& table = *entry.table;
    ForceSpec force;
    force.name = entry.name;
    force.stiffness = number(table, "stiffness");
    force.damping = number(table, "damping");
    force.rest = number(table, "rest");
    read_spring(reader, table, force);
    read_push(reader, table, force);
    if (const toml::node* on = table.get("on")) {
      const auto coordinate = reader.coordinate(*on);
      if (!coordinate) continue;
      force.joint = coordinate->joint;
      force.coordinate = coordinate->coordinate;
    } else if (!read_points(reader, table, force)) {
      continue;
    }
    reader.scene.mechanism.forces.push_back(std::move(force));
  }
}

void read_loads(Reader& reader) {
  for (const Entry& entry : entries(reader, "loads")) {
    const toml::table& table = *entry.table;
    LoadSpec load;
    load.name = entry.name;
    load.follower = boolean(table, "follower");
    load.force = vec3(table, "force");
    load.moment = vec3(table, "moment");
    load.scale = read_function(reader, *table.get("scale"));
    if (load.force.norm() == 0 && load.moment.norm() == 0)
      reader.problems.add(table, fmt::format("load '{}' is zero", load.name),
                          "a force or a moment");
    if (const toml::node* at = table.get("at")) {
      const auto port = reader.port(*at);
      if (!port) continue;
      if (port->body < 0)
        reader.problems.add(*at, fmt::format("load '{}' acts on the ground", load.name),
                            "a port of a body");
      load.port = *port;
    } else {
      const auto beam = reader.beam(*table.get("over"));
      if (!beam) continue;
      load.spread = true;
      load.port.body = *beam;
    }
    reader.scene.mechanism.loads.push_back(std::move(load));
  }
}

}  // namespace liesl
