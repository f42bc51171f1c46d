#include "apps/scene/reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "apps/scene/numbering.hpp"

namespace liesl {

namespace {

std::string as_text(const toml::node& node) { return node.value_or(std::string()); }

std::optional<Port> ground_point(Reader& reader, const toml::node& node, const std::string& text) {
  const Mechanism& mechanism = reader.scene.mechanism;
  if (const auto port = mechanism.port(text)) return port;
  if (reader.broken.contains("ground")) return {};
  std::vector<std::string> names;
  for (const auto& [name, place] : mechanism.ground_points) names.push_back(name);
  const std::string name = text.substr(text.find('.') + 1);
  reader.problems.add(node, fmt::format("the ground has no point '{}'", name),
                      "'ground', or a point of [ground.points]",
                      suggestion(name, names, "the scene has no [ground.points]"));
  return {};
}

}  // namespace

std::vector<std::string> Reader::names(std::string_view group) const {
  std::vector<std::string> list;
  for (const Entry& entry : entries_at(root, group)) list.push_back(entry.name);
  return list;
}

bool Reader::known(const toml::node& at, std::string_view group, std::string_view kind,
                   const std::string& name) {
  const toml::table* table = root[group].as_table();
  if (table && table->contains(name)) return true;
  problems.add(at, fmt::format("there is no {} '{}'", kind, name), fmt::format("a {}", kind),
               suggestion(name, names(group), fmt::format("the scene has no [{}]", group)));
  return false;
}

std::optional<int> Reader::body(const toml::node& node) {
  const std::string name = as_text(node);
  if (const auto truss = trusses.bars.find(name); truss != trusses.bars.end()) {
    problems.add(node, fmt::format("'{}' is of {} bars", name, truss->second.size()), "one body",
                 fmt::format("a bar, as '{}'", truss->second.front()));
    return {};
  }
  if (!known(node, "bodies", "body", name)) return {};
  const int index = scene.mechanism.body(name);
  if (index < 0) return {};  // broken, said before
  return index;
}

std::vector<int> Reader::bodies_of(const toml::node& node) {
  const auto truss = trusses.bars.find(as_text(node));
  if (truss == trusses.bars.end()) {
    const auto one = body(node);
    return one ? std::vector<int>{*one} : std::vector<int>();
  }
  std::vector<int> out;
  for (const std::string& bar : truss->second)
    if (const int index = scene.mechanism.body(bar); index >= 0) out.push_back(index);
  return out;
}

std::optional<int> Reader::beam(const toml::node& node) {
  const auto index = body(node);
  if (!index) return {};
  const BodySpec& spec = scene.mechanism.bodies[static_cast<std::size_t>(*index)];
  if (std::holds_alternative<BeamSpec>(spec.kind)) return index;
  const bool rigid = std::holds_alternative<RigidSpec>(spec.kind);
  problems.add(node, fmt::format("body '{}' is {}", spec.name, rigid ? "rigid" : "a meshed part"),
               "a beam");
  return {};
}

std::optional<int> Reader::joint(const toml::node& node) { return joint(node, as_text(node)); }

std::optional<int> Reader::joint(const toml::node& at, const std::string& name) {
  if (!known(at, "joints", "joint", name)) return {};
  const auto& joints = scene.mechanism.joints;
  const auto found = std::find_if(joints.begin(), joints.end(),
                                  [&](const JointSpec& joint) { return joint.name == name; });
  if (found == joints.end()) return {};
  return static_cast<int>(found - joints.begin());
}

std::optional<Reader::Coordinate> Reader::coordinate(const toml::node& node) {
  const std::string given = as_text(node);
  const auto dot = given.find('.');
  const std::string name = given.substr(0, dot);
  const auto index = joint(node, name);
  if (!index) return {};
  Coordinate result{*index, 0};
  if (dot != std::string::npos) {
    const char *first = given.data() + dot + 1, *last = given.data() + given.size();
    const auto [end, error] = std::from_chars(first, last, result.coordinate);
    if (error != std::errc{} || end != last) result.coordinate = -1;
  }
  const JointKind& kind = kind_of(scene.mechanism.joints[static_cast<std::size_t>(*index)].type);
  const int count = kind.coordinate_count();
  if (result.coordinate >= 0 && result.coordinate < count) return result;
  problems.add(node, fmt::format("'{}' is no coordinate of {} joint '{}'", given, kind.name, name),
               "a joint coordinate",
               count == 0 ? fmt::format("{} joints have none", kind.name)
                          : fmt::format("coordinates are 0 to {}", count - 1));
  return {};
}

std::optional<Port> Reader::port(const toml::node& node) {
  const std::string given = as_text(node);
  if (given == "ground") return Port{};
  const auto dot = given.find('.');
  const std::string name = given.substr(0, dot);
  if (name == "ground") return ground_point(*this, node, given);
  if (const auto at = trusses.nodes.find(given); at != trusses.nodes.end())
    return scene.mechanism.port(at->second);
  if (trusses.bars.contains(name)) {
    std::vector<std::string> nodes;
    for (const auto& [node_name, port] : trusses.nodes)
      if (node_name.starts_with(name + ".")) nodes.push_back(node_name);
    problems.add(node, fmt::format("truss '{}' has no node '{}'", name, given),
                 "a node of the truss", suggestion(given, nodes));
    return {};
  }
  if (!known(node, "bodies", "body", name)) return {};
  const int index = scene.mechanism.body(name);
  if (index < 0) return {};
  if (dot != std::string::npos)
    if (const auto found =
            scene.mechanism.port(name + "." + Numbering(root, name).port(given.substr(dot + 1))))
      return found;
  const auto ports = scene.mechanism.port_names(index);
  std::vector<std::string> local;  // without the name of the body
  for (const std::string& port : ports)
    local.push_back(port.starts_with(name + ".") ? port.substr(name.size() + 1) : port);
  const std::string port = dot == std::string::npos ? "" : given.substr(dot + 1);
  const auto* beam =
      std::get_if<BeamSpec>(&scene.mechanism.bodies[static_cast<std::size_t>(index)].kind);
  const bool odd = beam && port == "mid";
  problems.add(node,
               port.empty() ? fmt::format("'{}' is a body, not a port", given)
                            : fmt::format("body '{}' has no port '{}'", name, port),
               fmt::format("a port of '{}'", name),
               odd ? fmt::format("'mid' needs an even number of elements, there are {}",
                                 beam->sections.size())
                   : suggestion(port, local));
  return {};
}

std::vector<Entry> entries(const Reader& reader, std::string_view group) {
  return entries(reader.root, reader.broken, group);
}

Vec3 direction(Reader& reader, const toml::table& table, std::string_view key) {
  const Vec3 given = vec3(table, key);
  const double length = given.norm();
  if (length > 0) return given / length;
  const toml::node* node = table.get(key);
  reader.problems.add(node ? *node : table, fmt::format("'{}' is a zero vector", key),
                      "a direction of any length", "as in [0, 0, 1]");
  return Vec3::UnitZ();
}

Vec3 orientation(Reader& reader, const toml::table& table) {
  const Vec3 given = vec3(table, "orientation");
  const double angle = given.norm();
  if (angle > 2 * M_PI)
    reader.problems.add(
        *table.get("orientation"),
        fmt::format("'orientation' turns by {:.4g} rad, more than a whole turn", angle),
        "a rotation vector in rad, of at most 2 pi",
        fmt::format("{:g} degrees are {:.6g} rad", angle, angle * M_PI / 180));
  return given;
}

}  // namespace liesl
