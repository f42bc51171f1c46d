/// @file
/// The parts of a scene in their order, and what only shows when all are read.

#include <fmt/format.h>

#include <algorithm>

#include "apps/input/title.hpp"
#include "apps/scene/reader.hpp"

namespace liesl {

namespace {

/// Part of the distance of two ports that the joint does not allow.
Vec3 gap_of(const Mechanism& mechanism, const JointSpec& joint) {
  const Vec3 d = mechanism.frame(joint.b).x - mechanism.frame(joint.a).x;
  return d - kind_of(joint.type).free_part(joint.axis, d);
}

bool has_velocity(const BodySpec& body) {
  return body.velocity.norm() > 0 || body.angular_velocity.norm() > 0;
}

bool given(const Reader& reader, const char* group) {
  const toml::table* table = reader.root[group].as_table();
  return table && !table->empty();
}

/// A table of the file, or the file itself if the table is not written there.
const toml::node& table_or_file(const Reader& reader, const char* name) {
  const toml::node* table = reader.root.get(name);
  return table && written(*table) ? *table : reader.root;
}

}  // namespace

void check_gap(Reader& reader, const toml::node& at, const JointSpec& joint) {
  const double gap = gap_of(reader.scene.mechanism, joint).norm();
  if (gap <= 1e-3 * reader.scene.mechanism.size()) return;
  reader.problems.add(at, fmt::format("the ends of joint '{}' are {:.4g} m apart", joint.name, gap),
                      "ports at the same place",
                      "check the positions of the bodies and the names of the ports");
}

/// Statics and modes are at one instant.
void read_gravity(Reader& reader) {
  Mechanism& mechanism = reader.scene.mechanism;
  mechanism.gravity = vec3(reader.root, "gravity");
  const toml::node* scale = reader.root.get("gravity_scale");
  if (!scale || reader.broken.contains("gravity_scale")) return;
  const TimeFunction factor = read_function(reader, *scale);
  const SimulationOptions& o = reader.scene.simulation;
  if (o.type == SimulationType::Dynamic)
    mechanism.gravity_scale = factor;
  else
    mechanism.gravity *= factor(o.at);
  if (written(*scale) && vec3(reader.root, "gravity").norm() == 0)
    reader.problems.add(*scale, "'gravity_scale' without gravity", "'gravity' as well",
                        "gravity = [0, -9.81, 0]");
}

void read_ground(Reader& reader) {
  toml::table* ground = reader.root["ground"].as_table();
  if (!ground || reader.broken.contains("ground")) return;
  if (const toml::table* points = (*ground)["points"].as_table())
    for (auto&& [name, place] : *points)
      reader.scene.mechanism.ground_points[std::string(name.str())] = vec3(place);
}

void check_movers(Reader& reader) {
  const Mechanism& m = reader.scene.mechanism;
  const SimulationType type = reader.scene.simulation.type;
  if (type == SimulationType::Modes || reader.fixed_loads) return;
  for (const char* group : {"bodies", "joints", "simulation"})
    if (reader.broken.contains(group)) return;  // what is refused may be what moves it
  const bool dynamic = type == SimulationType::Dynamic;
  const bool started = dynamic && std::any_of(m.bodies.begin(), m.bodies.end(), has_velocity);
  if (m.gravity.norm() > 0 || given(reader, "loads") || given(reader, "forces") ||
      !m.drives.empty() || started)
    return;
  const toml::node& at = table_or_file(reader, "simulation");
  if (dynamic)
    reader.problems.add(at, "the scene has no way to move: nothing drives, loads or pushes it",
                        "gravity, a drive, a load, a force or an initial velocity",
                        "as in gravity = [0, -9.81, 0]");
  else
    reader.problems.add(at, "the scene has no load", "gravity, a drive, a load or a force",
                        "as in [loads] tip = { at = \"beam.end\", force = [0, -1, 0] }");
}

void read_parts(Reader& reader) {
  reader.scene.mechanism.name = title(reader.root, reader.scene.file);
  reader.trusses = expand_trusses(reader.root, reader.broken, reader.problems);
  read_simulation(reader);
  read_gravity(reader);
  read_ground(reader);
  read_materials(reader);
  read_bodies(reader);
  check_names(reader);
  read_joints(reader);
  read_gears(reader);
  read_forces(reader);
  read_loads(reader);
  read_orders(reader);
  read_responses(reader);
  check_movers(reader);
  check_plane(reader);
  check_update(reader);
  check_segments(reader);
  check_motion(reader);
  const auto units = unit_warnings(reader);
  reader.scene.warnings.insert(reader.scene.warnings.end(), units.begin(), units.end());
}

}  // namespace liesl
