#include "apps/output/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace liesl::output {
namespace {

void check_block(const std::vector<double>& block, std::size_t expected, const std::string& what) {
  if (block.empty() || block.size() == expected) return;
  throw std::invalid_argument(
      fmt::format("results: {} has {} numbers, expected {}", what, block.size(), expected));
}

void check_mesh(const MeshResult& mesh, std::size_t n) {
  const std::size_t C = static_cast<std::size_t>(mesh.corners), M = mesh.cells.size() / C;
  check_block(mesh.fractions, M, mesh.name + ".fractions");
  int nodes = mesh.cells.empty() ? static_cast<int>(mesh.reference.size() / 3) : 0;
  for (const int node : mesh.cells) nodes = std::max(nodes, node + 1);
  const std::size_t vectors = mesh.records.size() * static_cast<std::size_t>(nodes) * 3;
  check_block(mesh.positions, vectors, mesh.name + ".positions");
  check_block(mesh.displacements, vectors, mesh.name + ".displacements");
  const std::size_t N = static_cast<std::size_t>(nodes);
  check_block(mesh.reference, N * 3, mesh.name + ".reference");
  check_block(mesh.level, N, mesh.name + ".level");
  if (mesh.reference.empty()) return;
  check_block(mesh.amplitudes, n * (mesh.basis.size() / (N * 3)), mesh.name + ".amplitudes");
}

}  // namespace

void check_shapes(const BodyResult& body, std::size_t n) {
  const auto N = static_cast<std::size_t>(body.nodes);
  const std::size_t E = body.elements.size();
  check_block(body.positions, n * N * 3, body.name + ".positions");
  check_block(body.rotations, n * N * 9, body.name + ".rotations");
  check_block(body.velocities, n * N * 6, body.name + ".velocities");
  check_block(body.strains, n * E * 6, body.name + ".strains");
  check_block(body.section_forces, n * E * 12, body.name + ".section_forces");
  check_block(body.stresses, n * E * 2, body.name + ".stresses");
  check_block(body.reference_positions, N * 3, body.name + ".reference_positions");
  check_block(body.reference_rotations, N * 9, body.name + ".reference_rotations");
  check_block(body.dimensions, E * kMostDimensions, body.name + ".dimensions");
  for (const auto& element : body.elements) {
    for (const int node : element) {
      if (node < 0 || node >= body.nodes) {
        throw std::invalid_argument(fmt::format("results: an element of {} names node {} of {}",
                                                body.name, node, body.nodes));
      }
    }
  }
}

void check_shapes(const Results& results) {
  const std::size_t n = results.times.size();
  for (const auto& body : results.bodies)
    check_shapes(body, results.kept.empty() ? n : results.kept.size());
  for (const auto& mesh : results.meshes) check_mesh(mesh, n);
  for (const auto& joint : results.joints) {
    check_block(joint.coordinates, n * joint.units.size(), joint.name + ".coordinates");
    check_block(joint.forces, n * 6, joint.name + ".forces");
  }
  const Energies& e = results.energies;
  for (const auto* block : {&e.kinetic, &e.elastic, &e.potential, &e.dissipated, &e.total}) {
    check_block(*block, n, "an energy");
  }
  check_block(results.constraint_residual, n, "constraint_residual");
  for (const auto& response : results.responses) {
    check_block(response.values, n * static_cast<std::size_t>(response.components), response.name);
  }
}

std::vector<int> spread_records(int n, int count) {
  std::vector<int> records;
  if (n <= count) {
    for (int i = 0; i < n; ++i) records.push_back(i);
    return records;
  }
  for (int i = 0; i < count; ++i) {
    const long last = n - 1;
    records.push_back(count > 1 ? static_cast<int>((i * last + (count - 1) / 2) / (count - 1)) : 0);
  }
  return records;
}

std::vector<int> frame_records(const Results& results, int count) {
  std::vector<int> records = spread_records(static_cast<int>(results.times.size()), count);
  records.insert(records.end(), results.peaks.begin(), results.peaks.end());
  std::sort(records.begin(), records.end());
  records.erase(std::unique(records.begin(), records.end()), records.end());
  return records;
}

int Results::record_near(double at) const {  // load factors may fall again
  const auto nearer = [at](double a, double b) { return std::abs(a - at) < std::abs(b - at); };
  return static_cast<int>(std::min_element(times.begin(), times.end(), nearer) - times.begin());
}

std::size_t Results::row(int record) const {
  if (kept.empty()) return static_cast<std::size_t>(record);
  const auto at = std::lower_bound(kept.begin(), kept.end(), record);
  if (at == kept.end() || *at != record)
    throw std::out_of_range(fmt::format("results: record {} is not kept", record));
  return static_cast<std::size_t>(at - kept.begin());
}

std::string ResponseResult::column(std::size_t component) const {
  if (!axes.empty()) return name + "." + axes.at(component);
  return components == 1 ? name : name + "." + "xyz"[component];
}

}  // namespace liesl::output
