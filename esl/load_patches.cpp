#include "esl/load_patches.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace liesl {
namespace {

/// Free nodes by cell of the grid.
std::map<int, std::vector<int>> grouped_nodes(const SolidModel& model) {
  const SolidMesh& mesh = model.mesh();
  const Eigen::Vector3d low = mesh.nodes.rowwise().minCoeff();
  Eigen::Vector3d extent = mesh.nodes.rowwise().maxCoeff() - low;
  extent = extent.cwiseMax(1e-3 * extent.maxCoeff());  // nodes of matrices may lie in a line
  const double side = std::pow(extent.head(mesh.dim).prod() / kLoadPatches, 1.0 / mesh.dim);
  const auto number = [&](double x, int c) {
    const int count = std::max(1, static_cast<int>(std::lround(extent[c] / side)));
    return std::pair{std::min(count - 1, static_cast<int>(x / extent[c] * count)), count};
  };
  std::map<int, std::vector<int>> groups;
  for (int i = 0; i < mesh.node_count(); ++i) {
    bool free = false;  // averaged interfaces take single components
    for (int c = 0; c < mesh.dim; ++c) free = free || model.coordinate(i, c);
    if (!free) continue;
    int cell = 0;
    for (int c = mesh.dim - 1; c >= 0; --c) {
      const auto [at, count] = number(mesh.nodes(c, i) - low[c], c);
      cell = cell * count + at;
    }
    groups[cell].push_back(i);
  }
  return groups;
}

}  // namespace

Eigen::Matrix<double, 6, Eigen::Dynamic> LoadPatches::of(const Eigen::VectorXd& f) const {
  const Eigen::VectorXd wrenches = resultant * f;
  return wrenches.reshaped(6, places.cols());
}

LoadPatches load_patches(const SolidModel& model) {
  const SolidMesh& mesh = model.mesh();
  const auto groups = grouped_nodes(model);
  LoadPatches patches;
  patches.places.setZero(3, static_cast<Eigen::Index>(groups.size()));
  std::vector<Eigen::Triplet<double>> entries;
  int p = 0;
  for (const auto& [cell, nodes] : groups) {
    for (const int i : nodes)
      patches.places.col(p) += mesh.nodes.col(i) / static_cast<double>(nodes.size());
    for (const int i : nodes)
      for (int c = 0; c < mesh.dim; ++c) {
        const auto q = model.coordinate(i, c);
        if (!q) continue;
        entries.emplace_back(6 * p + c, *q, 1.0);
        const Eigen::Vector3d arm = mesh.nodes.col(i) - patches.places.col(p);
        const Eigen::Vector3d moment = arm.cross(Eigen::Vector3d::Unit(c));
        for (int k = 0; k < 3; ++k)
          if (moment[k] != 0) entries.emplace_back(6 * p + 3 + k, *q, moment[k]);
      }
    ++p;
  }
  patches.resultant.resize(6 * p, model.size());
  patches.resultant.setFromTriplets(entries.begin(), entries.end());
  return patches;
}

}  // namespace liesl
