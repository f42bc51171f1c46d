#include "apps/output/hdf5_writer.hpp"

#include <algorithm>

#include "apps/output/hdf5_file.hpp"

namespace liesl::output {
namespace {

using Block = std::vector<double>;

/// Writes a data set with its unit, unless nothing was recorded.
void put(const Hdf5File& file, const std::string& name, const Block& block,
         const Hdf5File::Shape& shape, const std::string& unit) {
  if (block.empty()) return;
  file.write(name, block, shape);
  file.attribute(name, "unit", unit);
}

/// Section forces at the nodes [n, N, 6], from those at both ends of the elements: the mean where
/// two elements meet.
Block at_nodes(const BodyResult& body, hsize_t n) {
  const std::size_t N = static_cast<std::size_t>(body.nodes), E = body.elements.size();
  if (body.section_forces.empty()) return {};
  std::vector<int> ends(N, 0);
  for (const auto& element : body.elements)
    for (const int node : element) ++ends[static_cast<std::size_t>(node)];
  Block out(n * N * 6, 0.0);
  for (std::size_t i = 0; i < n * E * 12; ++i) {
    const std::size_t record = i / (12 * E), element = i / 12 % E, end = i / 6 % 2;
    const auto node = static_cast<std::size_t>(body.elements[element][end]);
    out[6 * (N * record + node) + i % 6] += body.section_forces[i] / ends[node];
  }
  return out;
}

void write_body(const Hdf5File& file, const BodyResult& body, hsize_t n) {
  const std::string group = "/bodies/" + hdf5_name(body.name);
  const hsize_t N = static_cast<hsize_t>(body.nodes);
  const hsize_t E = body.elements.size();
  file.group(group);
  file.attribute(group, "kind", body.kind);
  put(file, group + "/position", body.positions, {n, N, 3}, "m");
  put(file, group + "/rotation", body.rotations, {n, N, 9}, "-");
  put(file, group + "/velocity", body.velocities, {n, N, 6}, "m/s, rad/s");
  put(file, group + "/strain", body.strains, {n, E, 6}, "-, 1/m");
  put(file, group + "/section_force", body.section_forces, {n, E, 12}, "N, N m");
  put(file, group + "/node_force", at_nodes(body, n), {n, N, 6}, "N, N m");
  put(file, group + "/stress", body.stresses, {n, E, 2}, "Pa");
  put(file, group + "/reference_position", body.reference_positions, {N, 3}, "m");
  put(file, group + "/reference_rotation", body.reference_rotations, {N, 9}, "-");
  put(file, group + "/dimension", body.dimensions, {E, kMostDimensions}, "m");
  put(file, group + "/point", body.points, {body.points.size() / 3, 3}, "m");
  if (!body.shapes.empty()) file.write(group + "/shape", body.shapes);
  std::vector<int> elements;
  for (const auto& element : body.elements) {
    elements.insert(elements.end(), element.begin(), element.end());
  }
  if (E > 0) file.write(group + "/elements", elements, {E, 2});
}

/// A mesh at rest, and how it moves with its amplitudes.
void write_coordinates(const Hdf5File& file, const MeshResult& mesh, const std::string& group) {
  const hsize_t N = mesh.reference.size() / 3;
  if (N == 0) return;
  const hsize_t k = mesh.basis.size() / (3 * N);
  put(file, group + "/reference", mesh.reference, {N, 3}, "m");
  put(file, group + "/level", mesh.level, {N}, "m");
  put(file, group + "/interface", mesh.interfaces, {mesh.interfaces.size() / 3, 3}, "m");
  put(file, group + "/thickness", {mesh.thickness}, {1}, "m");
  put(file, group + "/basis", mesh.basis, {k, N, 3}, "-");
  const hsize_t M = mesh.cells.size() / static_cast<hsize_t>(mesh.corners);
  if (k > 0)
    put(file, group + "/stress_basis", mesh.stress_basis,
        {k, M, mesh.stress_basis.size() / std::max<hsize_t>(k * M, 1)}, "Pa");
  if (k > 0) put(file, group + "/amplitude", mesh.amplitudes, {mesh.amplitudes.size() / k, k}, "-");
}

void write_mesh(const Hdf5File& file, const MeshResult& mesh) {
  const std::string group = "/meshes/" + hdf5_name(mesh.name);
  const hsize_t C = static_cast<hsize_t>(mesh.corners), r = mesh.records.size();
  file.group(group);
  file.write(group + "/cells", mesh.cells, {mesh.cells.size() / C, C});
  put(file, group + "/fraction", mesh.fractions, {mesh.fractions.size()}, "-");
  write_coordinates(file, mesh, group);
  file.write(group + "/record", mesh.records, {r});
  if (r == 0) return;
  const Hdf5File::Shape shape = {r, mesh.positions.size() / r / 3, 3};
  put(file, group + "/position", mesh.positions, shape, "m");
  put(file, group + "/displacement", mesh.displacements, shape, "m");
}

void write_joint(const Hdf5File& file, const JointResult& joint, hsize_t n) {
  const std::string group = "/joints/" + hdf5_name(joint.name);
  std::string units;
  for (const auto& unit : joint.units) units += (units.empty() ? "" : ", ") + unit;
  file.group(group);
  file.attribute(group, "type", joint.type);
  put(file, group + "/coordinate", joint.coordinates, {n, joint.units.size()}, units);
  put(file, group + "/force", joint.forces, {n, 6}, "N, N m");
  if (joint.places.empty()) return;
  file.attribute(group, "a", joint.bodies[0]);
  file.attribute(group, "b", joint.bodies[1]);
  file.write(group + "/node", std::vector<int>(joint.nodes.begin(), joint.nodes.end()), {2});
  put(file, group + "/place", joint.places, {2, 3}, "m");
  put(file, group + "/axis", joint.axis, {3}, "-");
}

void write_energies(const Hdf5File& file, const Energies& energies, hsize_t n) {
  file.group("/energies");
  put(file, "/energies/kinetic", energies.kinetic, {n}, "J");
  put(file, "/energies/elastic", energies.elastic, {n}, "J");
  put(file, "/energies/potential", energies.potential, {n}, "J");
  put(file, "/energies/dissipated", energies.dissipated, {n}, "J");
  put(file, "/energies/total", energies.total, {n}, "J");
}

}  // namespace

std::string hdf5_name(std::string name) {
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

void write_hdf5(const std::filesystem::path& path, const Results& results) {
  check_shapes(results);
  const hsize_t n = results.times.size();
  Hdf5File file(path);
  file.attribute("/", "program", "liesl");
  file.attribute("/", "scene", results.name);
  file.attribute("/", "space", results.space);
  file.attribute("/", "abscissa", results.abscissa);
  put(file, "/time", results.times, {n}, results.abscissa_unit);
  file.group("/bodies");
  for (const auto& body : results.bodies) write_body(file, body, n);
  if (!results.meshes.empty()) file.group("/meshes");
  for (const auto& mesh : results.meshes) write_mesh(file, mesh);
  file.group("/joints");
  for (const auto& joint : results.joints) write_joint(file, joint, n);
  write_energies(file, results.energies, n);
  put(file, "/constraint_residual", results.constraint_residual, {n}, "m, rad");
  file.group("/responses");
  for (const auto& response : results.responses) {
    const hsize_t C = static_cast<hsize_t>(response.components);
    put(file, "/responses/" + hdf5_name(response.name), response.values, {n, C}, response.unit);
  }
  file.close();
}

}  // namespace liesl::output
