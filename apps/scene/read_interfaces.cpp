/// @file
/// Interfaces of meshed parts: which nodes, held how.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "apps/scene/part_reader.hpp"
#include "mbs/solids/interface_map.hpp"

namespace liesl {

namespace {

constexpr double kSlack = 1e-9;  // of a region's size: nodes on its edge are inside

std::string width_of_cells(const PartReader& part) {
  if (part.mesh.cell_count() == 0) return "";
  return fmt::format("the cells are about {:.3g} m wide",
                     std::pow(part.mesh.cell_size(0), 1.0 / part.dim()));
}

/// Numbers of nodes from 1, as files number them.
bool listed(PartReader& part, const toml::node& list, Interface& interface) {
  for (const double number : numbers(list)) {
    if (number != std::floor(number) || number > part.mesh.node_count()) {
      part.refuse(list, fmt::format("has no node {}", number),
                  fmt::format("whole numbers from 1 to {}", part.mesh.node_count()));
      return false;
    }
    interface.nodes.push_back(static_cast<int>(number) - 1);
  }
  std::sort(interface.nodes.begin(), interface.nodes.end());
  return true;
}

void put_at_mean(const SolidMesh& mesh, Interface& interface) {
  for (const int node : interface.nodes)
    interface.point += mesh.nodes.col(node) / static_cast<double>(interface.nodes.size());
}

bool in_circle(PartReader& part, const toml::table& circle, Interface& interface) {
  const auto centre = part.point(circle, "centre", part.dim());
  if (!centre) return false;
  const double radius = number(circle, "radius"), inner = number(circle, "inner");
  if (inner >= radius) {
    part.refuse(*circle.get("inner"), "has an empty ring", "'inner' below 'radius'");
    return false;
  }
  if (part.dim() == 2 && written(*circle.get("axis"))) {
    part.refuse(*circle.get("axis"), "has an 'axis' of a circle in a planar mesh", "no 'axis'");
    return false;
  }
  const Vec3 axis = part.dim() == 2 ? Vec3(Vec3::UnitZ()) : direction(part.reader, circle, "axis");
  interface.nodes = nodes_where(part.mesh, [&](const Vec3& x) {
    const double r = axis.cross(x - *centre).norm();
    return r <= radius * (1 + kSlack) && r >= inner * (1 - kSlack);
  });
  interface.point = *centre;
  return true;
}

bool in_box(PartReader& part, const toml::table& box, Interface& interface) {
  const auto from = part.point(box, "from", part.dim()), to = part.point(box, "to", part.dim());
  if (!from || !to) return false;
  const Vec3 low = from->cwiseMin(*to), high = from->cwiseMax(*to);
  const double slack = kSlack * (high - low).norm();
  interface.nodes = nodes_where(part.mesh, [&](const Vec3& x) {
    return (x - low).minCoeff() >= -slack && (high - x).minCoeff() >= -slack;
  });
  interface.point = 0.5 * (low + high);
  return true;
}

/// What sets of nodes are, with the file that has them.
std::string kinds_of_sets(const PartReader& part) {
  const toml::node* file =
      part.table.contains("mesh") ? part.table["mesh"]["file"].node() : nullptr;
  if (!file)
    return part.table.contains("matrices") ? "a set of the file of nodes" : "a side of the grid";
  const std::string name = file->value_or(std::string());
  const bool abaqus = name.ends_with(".inp") || name.ends_with(".INP");
  return fmt::format("{} of '{}'", abaqus ? "an *NSET" : "a physical group", name);
}

bool in_set(PartReader& part, const toml::node& set, Interface& interface) {
  const std::string name = set.value_or(std::string());
  const auto found = part.mesh.sets.find(name);
  if (found != part.mesh.sets.end() && !found->second.empty()) {
    interface.nodes = found->second;
    return true;
  }
  std::vector<std::string> known;
  for (const auto& [other, nodes] : part.mesh.sets)
    if (!nodes.empty()) known.push_back(other);
  if (found != part.mesh.sets.end())
    part.refuse(set, fmt::format("has the set '{}', which has no node of a cell", name),
                kinds_of_sets(part) + " with nodes of cells",
                suggestion(name, known, "it has none"));
  else
    part.refuse(set, fmt::format("has no set of nodes '{}'", name), kinds_of_sets(part),
                suggestion(name, known, "it has none"));
  return false;
}

/// Fills in nodes and point; the value that says which, nothing if something is wrong.
const toml::node* find_nodes(PartReader& part, const toml::table& table, Interface& interface) {
  const SolidMesh& mesh = part.mesh;
  if (const toml::node* set = table.get("set")) {
    if (!in_set(part, *set, interface)) return nullptr;
    put_at_mean(mesh, interface);
    return set;
  }
  if (const toml::node* list = table.get("nodes")) {
    if (!listed(part, *list, interface)) return nullptr;
    put_at_mean(mesh, interface);
    return list;
  }
  const bool round = table.contains("circle");
  const toml::node& node = *table.get(round ? "circle" : "box");
  return (round ? in_circle(part, *node.as_table(), interface)
                : in_box(part, *node.as_table(), interface))
             ? &node
             : nullptr;
}

}  // namespace

std::optional<Vec3> PartReader::point(const toml::table& in, const char* key, int dim) {
  const auto given = numbers(*in.get(key));
  if (static_cast<int>(given.size()) == dim)
    return Vec3(given[0], given[1], dim == 3 ? given[2] : 0);
  refuse(*in.get(key), fmt::format("has {} numbers in '{}'", given.size(), key),
         dim == 2 ? "[x, y]: the mesh is planar" : "[x, y, z]: the mesh is in space");
  return {};
}

void read_interfaces(PartReader& part) {
  toml::table& all = part.table_of("interfaces");
  const int freedoms = part.matrices ? freedoms_of_a_node(part.mesh, *part.matrices) : part.dim();
  for (const Entry& entry : entries_of(all)) {
    Interface interface;
    interface.name = entry.name;
    interface.tie = text(*entry.table, "tie") == "rigid" ? Tie::Rigid : Tie::Averaged;
    const toml::node* region = find_nodes(part, *entry.table, interface);
    if (!region) continue;
    if (entry.table->contains("point"))
      if (const auto at = part.point(*entry.table, "point", part.dim())) interface.point = *at;
    part.interfaces.push_back(interface);
    try {
      interface_map(part.mesh, freedoms, part.interfaces);
    } catch (const std::invalid_argument& error) {
      part.interfaces.pop_back();
      const std::string set = (*entry.table)["set"].value_or(std::string());
      part.refuse(*region,
                  fmt::format("cannot be held{}: {}", set.empty() ? "" : " by set '" + set + "'",
                              error.what()),
                  freedoms > part.dim() ? "a node, or enough of them to average, that no other has"
                  : part.dim() == 2
                      ? "two nodes or more that no other interface has"
                      : "three nodes or more, not in a line, that no other interface has",
                  width_of_cells(part));
    }
  }
  if (all.empty()) part.refuse(all, "has no interfaces", "at least one");
}

}  // namespace liesl
