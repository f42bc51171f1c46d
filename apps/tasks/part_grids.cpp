#include "apps/tasks/part_grids.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "apps/input/problem.hpp"
#include "apps/scene/part_reader.hpp"

namespace liesl {
namespace {

/// Cells in each direction; empty where the scene gives none.
std::vector<long> cells_of(const SceneText& text, const std::string& body, int dim) {
  std::vector<long> cells;
  try {
    for (int i = 0; i < dim; ++i) {
      const std::string key = fmt::format("bodies.{}.solid.mesh.cells.{}", body, i);
      cells.push_back(static_cast<long>(number_at(text, key).value));
    }
  } catch (const InputError&) {
    cells.clear();
  }
  return cells;
}

}  // namespace

bool PartGrid::has_room() const {
  double count = 1;
  for (const long n : cells) count *= 2 * static_cast<double>(n);
  return count <= kMostCells;
}

std::vector<PartGrid> part_grids(const SceneText& text, const Mechanism& mechanism) {
  std::vector<PartGrid> grids;
  for (const BodySpec& body : mechanism.bodies)
    if (const auto* solid = std::get_if<SolidSpec>(&body.kind))
      grids.push_back({body.name, cells_of(text, body.name, solid->mesh().dim),
                       solid->outline.features.empty() ? 2 : 1});
  return grids;
}

std::vector<std::string> grid_changes(const std::vector<PartGrid>& grids, double factor) {
  std::vector<std::string> changes;
  for (const PartGrid& grid : grids) {
    if (grid.cells.empty()) continue;
    std::vector<long> cells;
    for (const long n : grid.cells) {
      if (factor < 1 && n % 2 != 0) return {};
      cells.push_back(static_cast<long>(factor * static_cast<double>(n)));
    }
    changes.push_back(
        fmt::format("bodies.{}.solid.mesh.cells=[{}]", grid.name, fmt::join(cells, ", ")));
  }
  return changes;
}

}  // namespace liesl
