#include "apps/output/data_tree.hpp"

#include <algorithm>

namespace liesl::output {
namespace {

using Block = std::vector<double>;
using Shape = std::vector<std::size_t>;

/// Makes a tree, set by set.
class Tree {
 public:
  void group(const std::string& name) { tree_.groups.push_back({name, {}}); }
  void attribute(const std::string& key, const std::string& text) {
    tree_.groups.back().attributes.emplace_back(key, text);
  }
  /// A data set of the results, unless nothing was recorded.
  void put(const std::string& name, const Block& block, Shape shape, const std::string& unit) {
    if (!block.empty()) tree_.sets.push_back({name, std::span(block), std::move(shape), unit});
  }
  /// One that is made of them.
  void make(const std::string& name, Block block, Shape shape, const std::string& unit) {
    const auto made = std::make_shared<const Block>(std::move(block));
    put(name, *made, std::move(shape), unit);
    if (!made->empty()) tree_.sets.back().made = made;
  }
  void put(const std::string& name, std::vector<int> values, Shape shape) {
    tree_.sets.push_back({name, std::move(values), std::move(shape), ""});
  }
  void put(const std::string& name, const std::vector<std::string>& texts) {
    tree_.sets.push_back({name, texts, {texts.size()}, ""});
  }
  DataTree take() { return std::move(tree_); }

 private:
  DataTree tree_;
};

/// Section forces at the nodes [n, N, 6], from those at both ends of the elements: the mean where
/// two elements meet.
Block at_nodes(const BodyResult& body, std::size_t n) {
  const std::size_t N = static_cast<std::size_t>(body.nodes);
  if (body.section_forces.empty()) return {};
  std::vector<int> ends(N, 0);
  for (const auto& element : body.elements)
    for (const int node : element) ++ends[static_cast<std::size_t>(node)];
  Block out(n * N * 6, 0.0);
  const double* force = body.section_forces.data();
  for (std::size_t record = 0; record < n; ++record)
    for (const auto& element : body.elements)
      for (const int end : element) {
        const auto node = static_cast<std::size_t>(end);
        double* const at = out.data() + 6 * (N * record + node);
        for (int i = 0; i < 6; ++i) at[i] += *force++ / ends[node];
      }
  return out;
}

std::string group_of(const BodyResult& body) { return "/bodies/" + hdf5_name(body.name); }

/// The group of a body, with its series of n records.
void add_series(Tree& tree, const BodyResult& body, std::size_t n) {
  const std::string group = group_of(body);
  const std::size_t N = static_cast<std::size_t>(body.nodes);
  const std::size_t E = body.elements.size();
  tree.group(group);
  tree.attribute("kind", body.kind);
  tree.put(group + "/position", body.positions, {n, N, 3}, "m");
  tree.put(group + "/rotation", body.rotations, {n, N, 9}, "-");
  tree.put(group + "/velocity", body.velocities, {n, N, 6}, "m/s, rad/s");
  tree.put(group + "/strain", body.strains, {n, E, 6}, "-, 1/m");
  tree.put(group + "/section_force", body.section_forces, {n, E, 12}, "N, N m");
  tree.make(group + "/node_force", at_nodes(body, n), {n, N, 6}, "N, N m");
  tree.put(group + "/stress", body.stresses, {n, E, 2}, "Pa");
}

/// What a body is at rest.
void add_rest(Tree& tree, const BodyResult& body) {
  const std::string group = group_of(body);
  const std::size_t N = static_cast<std::size_t>(body.nodes);
  const std::size_t E = body.elements.size();
  tree.put(group + "/reference_position", body.reference_positions, {N, 3}, "m");
  tree.put(group + "/reference_rotation", body.reference_rotations, {N, 9}, "-");
  tree.put(group + "/dimension", body.dimensions, {E, kMostDimensions}, "m");
  tree.put(group + "/point", body.points, {body.points.size() / 3, 3}, "m");
  if (!body.shapes.empty()) tree.put(group + "/shape", body.shapes);
  std::vector<int> elements;
  for (const auto& element : body.elements) {
    elements.insert(elements.end(), element.begin(), element.end());
  }
  if (E > 0) tree.put(group + "/elements", elements, {E, 2});
}

/// A mesh at rest, and how it moves with its amplitudes.
void add_coordinates(Tree& tree, const MeshResult& mesh, const std::string& group) {
  const std::size_t N = mesh.reference.size() / 3;
  if (N == 0) return;
  const std::size_t k = mesh.basis.size() / (3 * N);
  tree.put(group + "/reference", mesh.reference, {N, 3}, "m");
  tree.put(group + "/level", mesh.level, {N}, "m");
  tree.put(group + "/interface", mesh.interfaces, {mesh.interfaces.size() / 3, 3}, "m");
  tree.make(group + "/thickness", {mesh.thickness}, {1}, "m");
  tree.put(group + "/basis", mesh.basis, {k, N, 3}, "-");
  const std::size_t M = mesh.cells.size() / static_cast<std::size_t>(mesh.corners);
  if (k > 0)
    tree.put(group + "/stress_basis", mesh.stress_basis,
             {k, M, mesh.stress_basis.size() / std::max<std::size_t>(k * M, 1)}, "Pa");
  if (k > 0) tree.put(group + "/amplitude", mesh.amplitudes, {mesh.amplitudes.size() / k, k}, "-");
}

void add_mesh(Tree& tree, const MeshResult& mesh) {
  const std::string group = "/meshes/" + hdf5_name(mesh.name);
  const std::size_t C = static_cast<std::size_t>(mesh.corners), r = mesh.records.size();
  tree.group(group);
  tree.attribute("cell", std::string(cell_kind(mesh.dim(), mesh.corners).name));
  tree.put(group + "/cells", mesh.cells, {mesh.cells.size() / C, C});
  tree.put(group + "/fraction", mesh.fractions, {mesh.fractions.size()}, "-");
  add_coordinates(tree, mesh, group);
  tree.put(group + "/record", mesh.records, {r});
  if (r == 0) return;
  const Shape shape = {r, mesh.positions.size() / r / 3, 3};
  tree.put(group + "/position", mesh.positions, shape, "m");
  tree.put(group + "/displacement", mesh.displacements, shape, "m");
}

void add_joint(Tree& tree, const JointResult& joint, std::size_t n) {
  const std::string group = "/joints/" + hdf5_name(joint.name);
  std::string units;
  for (const auto& unit : joint.units) units += (units.empty() ? "" : ", ") + unit;
  tree.group(group);
  tree.attribute("type", joint.type);
  tree.put(group + "/coordinate", joint.coordinates, {n, joint.units.size()}, units);
  tree.put(group + "/force", joint.forces, {n, 6}, "N, N m");
  if (joint.places.empty()) return;
  tree.attribute("a", joint.bodies[0]);
  tree.attribute("b", joint.bodies[1]);
  tree.put(group + "/node", std::vector<int>(joint.nodes.begin(), joint.nodes.end()), {2});
  tree.put(group + "/place", joint.places, {2, 3}, "m");
  tree.put(group + "/axis", joint.axis, {3}, "-");
}

void add_energies(Tree& tree, const Energies& energies, std::size_t n) {
  tree.group("/energies");
  tree.put("/energies/kinetic", energies.kinetic, {n}, "J");
  tree.put("/energies/elastic", energies.elastic, {n}, "J");
  tree.put("/energies/potential", energies.potential, {n}, "J");
  tree.put("/energies/dissipated", energies.dissipated, {n}, "J");
  tree.put("/energies/total", energies.total, {n}, "J");
}

}  // namespace

std::string hdf5_name(std::string name) {
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

DataTree series_tree(const std::vector<BodyResult>& bodies, std::size_t n) {
  Tree tree;
  tree.group("/bodies");
  for (const auto& body : bodies) add_series(tree, body, n);
  return tree.take();
}

DataTree data_tree(const Results& results) {
  check_shapes(results);
  const std::size_t n = results.times.size();
  Tree tree;
  tree.group("/");
  tree.attribute("program", "liesl");
  tree.attribute("scene", results.name);
  tree.attribute("space", results.space);
  tree.attribute("abscissa", results.abscissa);
  tree.put("/time", results.times, {n}, results.abscissa_unit);
  const bool with_series = results.kept.empty();
  if (with_series) tree.group("/bodies");
  for (const auto& body : results.bodies) {
    if (with_series) add_series(tree, body, n);
    add_rest(tree, body);
  }
  if (!results.meshes.empty()) tree.group("/meshes");
  for (const auto& mesh : results.meshes) add_mesh(tree, mesh);
  tree.group("/joints");
  for (const auto& joint : results.joints) add_joint(tree, joint, n);
  add_energies(tree, results.energies, n);
  tree.put("/constraint_residual", results.constraint_residual, {n}, "m, rad");
  tree.group("/responses");
  for (const auto& response : results.responses)
    tree.put("/responses/" + hdf5_name(response.name), response.values,
             {n, static_cast<std::size_t>(response.components)}, response.unit);
  return tree.take();
}

}  // namespace liesl::output
