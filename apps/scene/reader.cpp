#include "apps/scene/reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace liesl {

namespace {

std::string as_text(const toml::node& node) { return node.value_or(std::string()); }

/// Sorted by place; entries without one (defaults, overrides) come last, by name.
bool earlier(const Entry& a, const Entry& b) {
  const auto place = [](const Entry& e) {
    const auto begin = e.key->source().begin;
    return begin.line == 0 ? std::make_pair(~0u, ~0u) : std::make_pair(begin.line, begin.column);
  };
  return place(a) < place(b);
}

std::vector<Entry> all_entries(toml::table& root, std::string_view group) {
  toml::table* table = root[group].as_table();
  return table ? entries_of(*table) : std::vector<Entry>{};
}

}  // namespace

std::vector<std::string> Reader::names(std::string_view group) const {
  std::vector<std::string> list;
  for (const Entry& entry : all_entries(root, group)) list.push_back(entry.name);
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
  if (!known(node, "bodies", "body", name)) return {};
  const int index = scene.mechanism.body(name);
  if (index < 0) return {};  // broken, said before
  return index;
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
  const JointType type = scene.mechanism.joints[static_cast<std::size_t>(*index)].type;
  const int count = coordinates(type);
  if (result.coordinate >= 0 && result.coordinate < count) return result;
  problems.add(node,
               fmt::format("'{}' is no coordinate of {} joint '{}'", given, name_of(type), name),
               "a joint coordinate",
               count == 0 ? fmt::format("{} joints have none", name_of(type))
                          : fmt::format("coordinates are 0 to {}", count - 1));
  return {};
}

std::optional<Port> Reader::port(const toml::node& node) {
  const std::string given = as_text(node);
  if (given == "ground") return Port{};
  const auto dot = given.find('.');
  const std::string name = given.substr(0, dot);
  if (!known(node, "bodies", "body", name)) return {};
  const int index = scene.mechanism.body(name);
  if (index < 0) return {};
  if (const auto found = scene.mechanism.port(given); found && dot != std::string::npos)
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

int coordinates(JointType type) {
  switch (type) {
    case JointType::Revolute:
    case JointType::Prismatic:
      return 1;
    case JointType::Cylindrical:
    case JointType::Universal:
      return 2;
    case JointType::Planar:
      return 3;
    default:
      return 0;
  }
}

std::string_view name_of(JointType type) {
  switch (type) {
    case JointType::Fixed:
      return "fixed";
    case JointType::Revolute:
      return "revolute";
    case JointType::Prismatic:
      return "prismatic";
    case JointType::Cylindrical:
      return "cylindrical";
    case JointType::Spherical:
      return "spherical";
    case JointType::Universal:
      return "universal";
    case JointType::Planar:
      return "planar";
  }
  return "";
}

std::vector<Entry> entries_of(toml::table& table) {
  std::vector<Entry> list;
  for (auto&& [key, value] : table)
    list.push_back({std::string(key.str()), &key, value.as_table()});
  std::stable_sort(list.begin(), list.end(), earlier);
  return list;
}

std::vector<Entry> entries(toml::table& root, const Broken& broken, std::string_view group) {
  auto list = all_entries(root, group);
  std::erase_if(list, [&](const Entry& entry) {
    return !entry.table || broken.contains(fmt::format("{}.{}", group, entry.name));
  });
  return list;
}

std::vector<Entry> entries(const Reader& reader, std::string_view group) {
  return entries(reader.root, reader.broken, group);
}

std::string text(const toml::table& table, std::string_view key) {
  return table[key].value_or(std::string());
}
double number(const toml::table& table, std::string_view key) { return table[key].value_or(0.0); }
int integer(const toml::table& table, std::string_view key) { return table[key].value_or(0); }
bool boolean(const toml::table& table, std::string_view key) { return table[key].value_or(false); }

std::vector<double> numbers(const toml::node& node) {
  std::vector<double> values;
  const toml::array* list = node.as_array();
  if (!list) return {node.value_or(0.0)};
  for (const toml::node& item : *list) values.push_back(item.value_or(0.0));
  return values;
}

Vec3 vec3(const toml::node& list) {
  const auto values = numbers(list);
  return values.size() == 3 ? Vec3(values[0], values[1], values[2]) : Vec3::Zero();
}

Vec3 vec3(const toml::table& table, std::string_view key) {
  const toml::node* node = table.get(key);
  return node ? vec3(*node) : Vec3::Zero();
}

std::vector<const toml::node*> strings(const toml::table& table, std::string_view key) {
  const toml::node* node = table.get(key);
  if (!node) return {};
  if (node->is_string()) return {node};
  std::vector<const toml::node*> list;
  for (const toml::node& item : *node->as_array()) list.push_back(&item);
  return list;
}

Eigen::MatrixXd matrix(const toml::node& node, int n) {
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(n, n);
  const toml::array& list = *node.as_array();
  if (list[0].is_array()) {
    for (int i = 0; i < n; ++i) {
      const auto row = numbers(list[static_cast<std::size_t>(i)]);
      for (int j = 0; j < n; ++j) M(i, j) = row[static_cast<std::size_t>(j)];
    }
    return M;
  }
  const auto values = numbers(node);
  for (int i = 0; i < n; ++i) M(i, i) = values[static_cast<std::size_t>(i)];
  if (n == 3 && values.size() == 6) {
    M(0, 1) = M(1, 0) = values[3];
    M(0, 2) = M(2, 0) = values[4];
    M(1, 2) = M(2, 1) = values[5];
  }
  return M;
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

}  // namespace liesl
