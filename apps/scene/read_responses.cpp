/// @file
/// Responses: quantities that a scene names and a study limits.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "apps/scene/numbering.hpp"
#include "apps/scene/reader.hpp"
#include "mbs/sections/buckling.hpp"
#include "mbs/system/response_value.hpp"

namespace liesl {

namespace {

/// Place on a beam by node, "start", "mid", "node3", "end", or "max".
bool read_place(Reader& reader, const toml::table& table, ResponseSpec& response) {
  const toml::node& node = *table.get("at");
  const auto place = node.value_or(std::string());
  response.everywhere = place == "max";
  const BodySpec& body = reader.scene.mechanism.bodies[static_cast<std::size_t>(response.body)];
  const int n = static_cast<int>(std::get<BeamSpec>(body.kind).sections.size());
  const toml::node& said = written(node) ? node : static_cast<const toml::node&>(table);
  if (response.everywhere && n > 1) return true;
  if (response.everywhere) {
    reader.problems.add(said,
                        fmt::format("beam '{}' has no node between its ends: its deflection is 0 "
                                    "by definition",
                                    body.name),
                        "a beam of several elements");
    return false;
  }
  const auto port =
      reader.scene.mechanism.port(body.name + "." + Numbering(reader.root, body.name).port(place));
  if (port && port->body == response.body && port->node > 0 && port->node < n) {
    response.s = static_cast<double>(port->node) / n;
    return true;
  }
  if (port && port->body == response.body) {
    reader.problems.add(
        said,
        fmt::format("the deflection of '{}' at its {} is 0 by definition: it is measured from the "
                    "chord between the ends",
                    body.name, place),
        n > 1 ? fmt::format("mid, node1 to node{}, or max", n - 1) : "a beam of several elements",
        "how far the tip moves is response = \"displacement\", at = \"" + body.name + ".end\"");
    return false;
  }
  if (place == "mid") {
    reader.problems.add(
        said, fmt::format("beam '{}' has no node 'mid': it has {} elements", body.name, n),
        "an even number of elements", "or at = \"max\" for the largest over all nodes");
    return false;
  }
  std::vector<std::string> places{"mid", "max"};
  for (int k = 1; k < n; ++k) places.push_back(fmt::format("node{}", k));
  reader.problems.add(said, fmt::format("beam '{}' has no node '{}'", body.name, place),
                      fmt::format("mid, node1 to node{}, or max", n - 1),
                      suggestion(place, places));
  return false;
}

/// Interface of a part between its first and its last one, or "max" if none is called that.
bool read_place_of_part(Reader& reader, const toml::table& table, ResponseSpec& response) {
  const toml::node& node = *table.get("at");
  const auto place = node.value_or(std::string());
  const BodySpec& body = reader.scene.mechanism.bodies[static_cast<std::size_t>(response.body)];
  const auto& interfaces = std::get<SolidSpec>(body.kind).interfaces();
  const int last = static_cast<int>(interfaces.size()) - 1;
  std::vector<std::string> places;
  for (int k = 1; k < last; ++k) places.push_back(interfaces[static_cast<std::size_t>(k)].name);
  const auto found = std::find(places.begin(), places.end(), place);
  if (found != places.end()) {
    response.s = static_cast<double>(found - places.begin() + 1) / last;
    return true;
  }
  response.everywhere = place == "max";
  if (response.everywhere && !places.empty()) return true;
  const std::string expected = places.empty()
                                   ? "a part with an interface between its first and its last one"
                                   : fmt::format("one of {}, or max", fmt::join(places, ", "));
  reader.problems.add(
      written(node) ? node : static_cast<const toml::node&>(table),
      fmt::format("part '{}' has no interface '{}' between its first and its last one", body.name,
                  place),
      expected, "the deflection is measured from the chord between these two");
  return false;
}

/// A beam or part that is simulated as a rigid body has no deformation and no internal forces.
void warn_of_rigid(Reader& reader, int body, const ResponseSpec& response) {
  const Mechanism& mechanism = reader.scene.mechanism;
  const BodySpec& spec = mechanism.bodies[static_cast<std::size_t>(body)];
  if (moves_rigidly(spec, mechanism.formalism))
    reader.scene.warnings.push_back(
        fmt::format("response '{}' is 0 by definition: '{}' is simulated as a rigid body",
                    response.name, spec.name));
}

bool is_rigid(const BodySpec& body) { return std::holds_alternative<RigidSpec>(body.kind); }

/// A node between the ends of a chain of segments has a position alone.
bool is_point(const Reader& reader, const Port& port) {
  const Mechanism& m = reader.scene.mechanism;
  const auto* beam = std::get_if<BeamSpec>(&m.bodies[static_cast<std::size_t>(port.body)].kind);
  return beam && model_of(*beam, m.formalism) == BeamModel::Segments && port.node > 0 &&
         port.node + 1 < static_cast<int>(beam->nodes.size());
}

bool read_port_response(Reader& reader, const toml::table& table, ResponseSpec& response) {
  const toml::node& at = *table.get("at");
  const auto port = reader.port(at);
  if (table.contains("axis")) response.axis = direction(reader, table, "axis");
  if (!port) return false;
  response.at = *port;
  if (port->body < 0) {
    reader.problems.add(at, fmt::format("response '{}' is of the ground", response.name),
                        "a port of a body");
    return false;
  }
  if (response.kind == ResponseKind::Position || response.kind == ResponseKind::Translation)
    return true;
  response.in = text(table, "in") == "body" ? Axes::Body : Axes::Inertial;
  const bool accelerates = response.kind == ResponseKind::Acceleration ||
                           response.kind == ResponseKind::AngularAcceleration;
  if (accelerates && is_point(reader, *port)) {
    reader.problems.add(at,
                        fmt::format("response '{}' is of a node of a chain of segments that is a "
                                    "point without axes",
                                    response.name),
                        "a node at an end, or formalism \"se3\"");
    return false;
  }
  if (response.kind != ResponseKind::Displacement) return true;
  const auto& bodies = reader.scene.mechanism.bodies;
  const BodySpec& body = bodies[static_cast<std::size_t>(port->body)];
  const bool rigid = is_rigid(body);
  if (!rigid && port->node > 0) {
    warn_of_rigid(reader, port->body, response);
    return true;
  }
  reader.problems.add(
      at,
      fmt::format("the displacement of '{}' is 0 by definition: {}", at.value_or(std::string()),
                  rigid ? "its body is rigid" : "it is seen from the first node of its body"),
      "a point of a flexible body, not its first node",
      "how far it moves in space is response = \"position\"");
  return false;
}

/// The ends of a beam, or two ports.
bool read_elongation(Reader& reader, const toml::table& table, ResponseSpec& response) {
  const toml::node *of = table.get("of"), *between = table.get("between");
  if (!of == !between) {
    reader.problems.add(table,
                        fmt::format("response '{}' has {} 'of' {} 'between'", response.name,
                                    of ? "both" : "neither", of ? "and" : "nor"),
                        "a beam, or two ports", "of = \"rod\" or between = [\"rod.a\", \"rod.b\"]");
    return false;
  }
  if (of) {
    const auto beam = reader.beam(*of);
    if (!beam) return false;
    response.body = *beam;
    warn_of_rigid(reader, *beam, response);
    const auto& bodies = reader.scene.mechanism.bodies;
    const auto& spec = std::get<BeamSpec>(bodies[static_cast<std::size_t>(*beam)].kind);
    response.at = {*beam, 0, SE3::identity()};
    response.to = {*beam, static_cast<int>(spec.sections.size()), SE3::identity()};
    return true;
  }
  const toml::array& pair = *between->as_array();
  const auto a = reader.port(pair[0]), b = reader.port(pair[1]);
  if (!a || !b) return false;
  response.at = *a;
  response.to = *b;
  if (a->body == b->body) response.body = a->body;
  if (a->body >= 0 && a->body == b->body &&
      (a->node == b->node ||
       is_rigid(reader.scene.mechanism.bodies[static_cast<std::size_t>(a->body)]))) {
    reader.problems.add(pair,
                        fmt::format("the elongation '{}' is 0 by definition: both ports are of one "
                                    "rigid piece",
                                    response.name),
                        "two ports that move apart");
    return false;
  }
  if (a->body >= 0 || b->body >= 0) return true;
  reader.problems.add(pair, fmt::format("response '{}' is of the ground", response.name),
                      "a port of a body");
  return false;
}

/// Of a meshed part: deflection, stress of its cells, compliance.
bool read_part_response(Reader& reader, const toml::table& table, ResponseSpec& response) {
  const toml::node& of = *table.get("of");
  const BodySpec& body = reader.scene.mechanism.bodies[static_cast<std::size_t>(response.body)];
  if (response.kind == ResponseKind::Deflection) {
    if (!read_place_of_part(reader, table, response)) return false;
  } else if (response.kind != ResponseKind::Stress && response.kind != ResponseKind::Compliance) {
    reader.problems.add(of,
                        fmt::format("body '{}' is a meshed part, which has no {}", body.name,
                                    name_of(response.kind)),
                        "a beam", "of meshed parts there are deflection, stress and compliance");
    return false;
  }
  if (response.kind == ResponseKind::Stress &&
      std::get<SolidSpec>(body.kind).mesh().cell_count() == 0) {
    reader.problems.add(
        of, fmt::format("part '{}' is known by its matrices, which tell no stress", body.name),
        "a part with a 'mesh'", "response = \"compliance\" takes no cells");
    return false;
  }
  warn_of_rigid(reader, response.body, response);
  return true;
}

/// Component and element of a force of `response.body`, by the numbers of the scene.
bool read_section_force(Reader& reader, const toml::table& table, ResponseSpec& response) {
  const auto names = words("N Vy Vz Mx My Mz");
  response.component = static_cast<int>(
      std::find(names.begin(), names.end(), text(table, "component")) - names.begin());
  const std::string place = text(table, "at");
  response.place = place == "start" ? ElementPlace::First
                   : place == "mid" ? ElementPlace::Middle
                                    : ElementPlace::Last;
  const BodySpec& body = reader.scene.mechanism.bodies[static_cast<std::size_t>(response.body)];
  const int n = static_cast<int>(std::get<BeamSpec>(body.kind).sections.size()),
            named = integer(table, "element");
  const auto element = Numbering(reader.root, body.name).element(named, response.place);
  response.element = element.value_or(0);
  if (element && *element < n) return true;
  reader.problems.add(*table.get("element"),
                      element ? fmt::format("there is no element {}", named)
                              : fmt::format("element {} of the numbering of '{}' ends, or has its "
                                            "middle, where no element of the beam does",
                                            named, body.name),
                      fmt::format("0 to {}", Numbering(reader.root, body.name).elements(n) - 1),
                      "elements count from 0");
  return false;
}

bool read_beam_response(Reader& reader, const toml::table& table, ResponseSpec& response) {
  const auto body = reader.body(*table.get("of"));
  if (!body) return false;
  const BodySpec& of = reader.scene.mechanism.bodies[static_cast<std::size_t>(*body)];
  if (std::holds_alternative<SolidSpec>(of.kind)) {
    response.body = *body;
    return read_part_response(reader, table, response);
  }
  const auto beam = reader.beam(*table.get("of"));
  if (!beam) return false;
  response.body = *beam;
  const auto& spec =
      std::get<BeamSpec>(reader.scene.mechanism.bodies[static_cast<std::size_t>(*beam)].kind);
  warn_of_rigid(reader, *beam, response);
  if (response.kind == ResponseKind::Deflection) return read_place(reader, table, response);
  if (response.kind == ResponseKind::Buckling) response.factor = number(table, "factor");
  if (response.kind == ResponseKind::LocalBuckling) {
    response.factor = number(table, "factor");
    for (const Section& s : spec.sections)
      if (!has_walls(s.shape)) {
        reader.problems.add(*table.get("of"),
                            fmt::format("section '{}' has no wall whose buckling is known in "
                                        "closed form",
                                        s.name),
                            "a beam whose sections are tubes, boxes or I");
        return false;
      }
  }
  if (response.kind == ResponseKind::Stress || response.kind == ResponseKind::AxialStress) {
    const bool full = std::any_of(spec.sections.begin(), spec.sections.end(), [](const Section& s) {
      return std::holds_alternative<FullSection>(s.shape);
    });
    if (full)
      reader.problems.add(*table.get("of"), "'full' sections have no stresses",
                          "a beam whose sections have a shape");
    return !full;
  }
  return response.kind != ResponseKind::SectionForce || read_section_force(reader, table, response);
}

/// In statics a state does not know the time of a force that is given over time.
bool has_joint_force(Reader& reader, const toml::table& table, const ResponseSpec& response) {
  const Mechanism& mechanism = reader.scene.mechanism;
  const JointSpec& joint = mechanism.joints[static_cast<std::size_t>(response.joint)];
  if (reader.scene.simulation.type == SimulationType::Dynamic || !kind_of(joint.type).elastic)
    return true;
  for (const ForceSpec& force : mechanism.forces)
    if (force.joint == response.joint && !(force.force.is_constant() && force.force(0) == 0)) {
      reader.problems.add(*table.get("of"),
                          fmt::format("{} '{}' has a force of its own, which is known beforehand",
                                      kind_of(joint.type).name, joint.name),
                          "in statics, the force of constraints, drives and springs",
                          "response = \"coordinate\" tells how far it gives");
      return false;
    }
  return true;
}

bool read_joint_response(Reader& reader, const toml::table& table, ResponseSpec& response) {
  const auto joint = reader.joint(*table.get("of"));
  if (!joint) return false;
  response.joint = *joint;
  if (response.kind == ResponseKind::JointForce) {
    if (table.contains("axis")) response.axis = direction(reader, table, "axis");
    response.in = text(table, "in") == "body" ? Axes::Body : Axes::Inertial;
    if (const toml::node& in = *table.get("in"); !response.axis && written(in)) {
      reader.problems.add(in, "the norm of a force is the same in all axes",
                          "'axis' and 'in', or neither", "axis = [1, 0, 0]");
      return false;
    }
    return has_joint_force(reader, table, response);
  }
  response.coordinate = integer(table, "coordinate");
  const JointSpec& spec = reader.scene.mechanism.joints[static_cast<std::size_t>(*joint)];
  const JointKind& kind = kind_of(spec.type);
  const int count = kind.coordinate_count();
  const auto& drives = reader.scene.mechanism.drives;
  const bool driven = std::any_of(drives.begin(), drives.end(), [&](const DriveSpec& d) {
    return d.joint == response.joint && d.coordinate == response.coordinate;
  });
  if (response.coordinate < count && response.kind == ResponseKind::DriveForce && !driven) {
    reader.problems.add(
        *table.get("of"),
        fmt::format("coordinate {} of joint '{}' has no drive", response.coordinate, spec.name),
        "a joint with a drive");
    return false;
  }
  if (response.coordinate < count) return true;
  const toml::node& given = *table.get("coordinate");
  reader.problems.add(
      written(given) ? given : static_cast<const toml::node&>(table),
      fmt::format("{} joint '{}' has no coordinate {}", kind.name, spec.name, response.coordinate),
      "a joint coordinate", count == 0 ? "" : fmt::format("coordinates are 0 to {}", count - 1));
  return false;
}

}  // namespace

std::optional<ResponseSpec> read_response(Reader& reader, const std::string& name,
                                          const toml::table& table) {
  // In the order of ResponseKind.
  static const auto kinds = words(
      "position velocity angular_velocity rotation displacement deflection elongation coordinate "
      "joint_force drive_force section_force stress energy compliance axial_stress buckling "
      "local_buckling translation acceleration angular_acceleration");
  ResponseSpec response;
  response.name = name;
  const auto found = std::find(kinds.begin(), kinds.end(), text(table, "response"));
  response.kind = static_cast<ResponseKind>(found - kinds.begin());
  bool ok = true;
  switch (response.kind) {
    case ResponseKind::Position:
    case ResponseKind::Velocity:
    case ResponseKind::AngularVelocity:
    case ResponseKind::Rotation:
    case ResponseKind::Displacement:
    case ResponseKind::Translation:
    case ResponseKind::Acceleration:
    case ResponseKind::AngularAcceleration:
      ok = read_port_response(reader, table, response);
      break;
    case ResponseKind::Elongation:
      ok = read_elongation(reader, table, response);
      break;
    case ResponseKind::Deflection:
    case ResponseKind::SectionForce:
    case ResponseKind::Stress:
    case ResponseKind::Compliance:
    case ResponseKind::AxialStress:
    case ResponseKind::Buckling:
    case ResponseKind::LocalBuckling:
      ok = read_beam_response(reader, table, response);
      break;
    case ResponseKind::Coordinate:
    case ResponseKind::JointForce:
    case ResponseKind::DriveForce:
      ok = read_joint_response(reader, table, response);
      break;
    case ResponseKind::Energy:
      break;
  }
  return ok ? std::optional(response) : std::nullopt;
}

void read_responses(Reader& reader) {
  for (const Entry& entry : entries(reader, "responses"))
    if (auto response = read_response(reader, entry.name, *entry.table))
      reader.scene.responses.push_back(std::move(*response));
}

}  // namespace liesl
