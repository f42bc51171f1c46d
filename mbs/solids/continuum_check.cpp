#include "mbs/solids/continuum_check.hpp"

#include <numeric>
#include <set>
#include <vector>

#include "mbs/solids/solid_model.hpp"

namespace liesl {
namespace {

constexpr double kIncompressible = 0.4999;  // what the stiffness of cells does not resolve

/// Pieces of a mesh that share no node; a node of no cell is one.
int pieces(const SolidMesh& mesh) {
  std::vector<int> root(static_cast<std::size_t>(mesh.node_count()));
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&root](int i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (int e = 0; e < mesh.cell_count(); ++e)
    for (int c = 1; c < mesh.cells.rows(); ++c)
      root[find(mesh.cells(c, e))] = find(mesh.cells(0, e));
  int count = 0;
  for (int i = 0; i < mesh.node_count(); ++i) count += find(i) == i;
  return count;
}

}  // namespace

std::optional<ContinuumProblem> continuum_problem(const SolidSpec& spec) {
  if (spec.mesh().cell_count() == 0)
    return ContinuumProblem{"matrices", "is known by its matrices alone, which are linear",
                            "a 'mesh', or as = \"reduced\""};
  if (const Material& m = spec.model->material(); m.nu >= kIncompressible)
    return ContinuumProblem{"material", "is incompressible: nu = " + std::to_string(m.nu),
                            "nu < 0.4999"};
  if (!spec.outline.features.empty())
    return ContinuumProblem{"outline", "has an outline, which cuts cells",
                            "a mesh that is all material, or as = \"reduced\""};
  std::set<int> held;
  for (const Interface& f : spec.interfaces())
    if (f.tie == Tie::Rigid) held.insert(f.nodes.begin(), f.nodes.end());
  if (static_cast<int>(held.size()) == spec.mesh().node_count())
    return ContinuumProblem{"interfaces", "has no free node: interfaces hold its whole mesh",
                            "nodes between the interfaces, or a rigid body"};
  if (const int count = pieces(spec.mesh()); count > 1)
    return ContinuumProblem{
        "mesh", "has a mesh of " + std::to_string(count) + " pieces without a node in common",
        "a mesh that is connected, and no node without a cell"};
  return {};
}

}  // namespace liesl
