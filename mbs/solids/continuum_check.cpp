#include "mbs/solids/continuum_check.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <vector>

#include "mbs/solids/connectivity.hpp"
#include "mbs/solids/volume_fraction.hpp"

namespace liesl {
namespace {

constexpr double kIncompressible = 0.4999;  // what the stiffness of cells does not resolve

/// Nodes of cells with material.
std::vector<bool> nodes_in_material(const SolidMesh& mesh, const Eigen::VectorXd& v) {
  std::vector<bool> out(static_cast<std::size_t>(mesh.node_count()), false);
  for (int e = 0; e < mesh.cell_count(); ++e)
    if (v[e] >= kLeastFraction)
      for (const int i : mesh.cells.col(e)) out[static_cast<std::size_t>(i)] = true;
  return out;
}

/// Pieces of the cells with material that share neither a node nor an interface.
int pieces(const SolidMesh& mesh, const Eigen::VectorXd& v,
           const std::vector<Interface>& interfaces) {
  std::vector<int> root(static_cast<std::size_t>(mesh.node_count()));
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&root](int i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (int e = 0; e < mesh.cell_count(); ++e)
    if (v[e] >= kLeastFraction)
      for (int c = 1; c < mesh.cells.rows(); ++c)
        root[find(mesh.cells(c, e))] = find(mesh.cells(0, e));
  const auto in_material = nodes_in_material(mesh, v);
  for (const Interface& f : interfaces) {
    int first = -1;
    for (const int i : f.nodes)
      if (in_material[static_cast<std::size_t>(i)]) {
        if (first < 0) first = i;
        root[find(i)] = find(first);
      }
  }
  int count = 0;
  for (int i = 0; i < mesh.node_count(); ++i)
    count += find(i) == i && in_material[static_cast<std::size_t>(i)];
  return count;
}

/// Nodes of no cell, each a piece of its own.
int loose_nodes(const SolidMesh& mesh) {
  const auto in_cells = nodes_in_material(mesh, Eigen::VectorXd::Ones(mesh.cell_count()));
  return static_cast<int>(std::count(in_cells.begin(), in_cells.end(), false));
}

/// Material that an outline leaves without what holds it.
std::optional<ContinuumProblem> outline_problem(const SolidSpec& spec) {
  const Eigen::VectorXd v = solid_fractions(spec).value;
  if (const auto cut = cut_interface(*spec.model, v))
    return ContinuumProblem{"interfaces." + cut->interface, "is not connected: " + cut->text,
                            "material between all interfaces"};
  if (const int count = pieces(spec.mesh(), v, spec.interfaces()); count > 1)
    return ContinuumProblem{"outline",
                            "is cut into " + std::to_string(count) + " pieces by its outline",
                            "material in one piece, or as = \"reduced\""};
  const auto in_material = nodes_in_material(spec.mesh(), v);
  for (const Interface& f : spec.interfaces())
    if (f.tie == Tie::Averaged &&
        !std::ranges::all_of(f.nodes, [&](int i) { return bool(in_material[std::size_t(i)]); }))
      return ContinuumProblem{
          "interfaces." + f.name,
          "spreads the force of the averaged interface '" + f.name + "' over nodes in the void",
          "nodes of its material alone, or tie = \"rigid\""};
  return {};
}

}  // namespace

std::optional<ContinuumProblem> continuum_problem(const SolidSpec& spec) {
  if (spec.mesh().cell_count() == 0)
    return ContinuumProblem{"matrices", "is known by its matrices alone, which are linear",
                            "a 'mesh', or as = \"reduced\""};
  if (const Material& m = spec.model->material(); m.nu >= kIncompressible)
    return ContinuumProblem{"material", "is incompressible: nu = " + std::to_string(m.nu),
                            "nu < 0.4999",
                            "for rubber 0.49, with cells that are small enough: `--verify`"};
  std::set<int> held;
  for (const Interface& f : spec.interfaces())
    if (f.tie == Tie::Rigid) held.insert(f.nodes.begin(), f.nodes.end());
  if (static_cast<int>(held.size()) == spec.mesh().node_count())
    return ContinuumProblem{"interfaces", "has no free node: interfaces hold its whole mesh",
                            "nodes between the interfaces, or a rigid body"};
  const Eigen::VectorXd all = Eigen::VectorXd::Ones(spec.mesh().cell_count());
  const int count = pieces(spec.mesh(), all, {}) + loose_nodes(spec.mesh());
  const std::string whole = "a mesh that is connected, and no node without a cell",
                    unite = "'Coherence' and 'Coherence Mesh' of Gmsh unite what touches";
  if (count > 1)
    return ContinuumProblem{
        "mesh", "has a mesh of " + std::to_string(count) + " pieces without a node in common",
        whole, unite};
  if (const int hinged = pieces_by_sides(spec.mesh()); hinged > 1)
    return ContinuumProblem{"mesh",
                            "has a mesh of " + std::to_string(hinged) +
                                " pieces that share no side of a cell: they turn about the nodes "
                                "that they have in common",
                            whole, unite};
  if (!spec.outline.features.empty()) return outline_problem(spec);
  return {};
}

}  // namespace liesl
