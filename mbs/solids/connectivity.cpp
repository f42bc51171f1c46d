#include "mbs/solids/connectivity.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <vector>

namespace liesl {
namespace {

/// Disjoint sets of cells.
struct Groups {
  std::vector<int> parent;
  explicit Groups(int n) : parent(n) { std::iota(parent.begin(), parent.end(), 0); }
  int find(int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  }
  void join(int i, int j) { parent[find(i)] = find(j); }
};

/// Joins cells that share a side. @param all cells that are asked for
template <class Cells>
void join_by_sides(const SolidMesh& mesh, const Cells& all, Groups& groups) {
  std::map<CellSide, int> open;
  for (int e = 0; e < mesh.cell_count(); ++e) {
    if (!all(e)) continue;
    for (CellSide side : side_nodes(mesh, e)) {
      std::sort(side.begin(), side.end());  // both neighbours name it alike
      const auto [it, fresh] = open.try_emplace(side, e);
      if (!fresh) groups.join(e, it->second);
    }
  }
}

}  // namespace

int pieces_by_sides(const SolidMesh& mesh) {
  Groups groups(mesh.cell_count());
  join_by_sides(
      mesh, [](int) { return true; }, groups);
  int count = 0;
  for (int e = 0; e < mesh.cell_count(); ++e) count += groups.find(e) == e;
  return count;
}

std::optional<ConnectivityProblem> cut_interface(const SolidModel& model, const Eigen::VectorXd& v,
                                                 double threshold) {
  const SolidMesh& mesh = model.mesh();
  if (mesh.cell_count() == 0) return std::nullopt;  // a part of matrices: its modes tell
  Groups groups(mesh.cell_count());
  const auto solid = [&](int e) { return v[e] >= threshold; };
  join_by_sides(mesh, solid, groups);
  std::vector<std::vector<int>> at_node(mesh.node_count());
  for (int e = 0; e < mesh.cell_count(); ++e)
    for (int c = 0; solid(e) && c < mesh.nodes_per_cell(); ++c)
      at_node[mesh.cells(c, e)].push_back(e);
  std::vector<int> main;  // groups that the interfaces so far have in common
  for (int k = 0; k < model.ports(); ++k) {
    const Interface& f = model.interfaces()[k];
    std::vector<int> own;
    for (int node : f.nodes)
      for (int e : at_node[node]) own.push_back(groups.find(e));
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
    if (own.empty())
      return ConnectivityProblem{f.name, "no material is left at interface '" + f.name + "'"};
    if (k == 0) {
      main = own;
      continue;
    }
    std::vector<int> both;
    std::set_intersection(main.begin(), main.end(), own.begin(), own.end(),
                          std::back_inserter(both));
    if (both.empty())
      return ConnectivityProblem{f.name, "interface '" + f.name +
                                             "' is cut off: no material joins it to interface '" +
                                             model.interfaces()[0].name + "'"};
    main = both;
  }
  return std::nullopt;
}

}  // namespace liesl
