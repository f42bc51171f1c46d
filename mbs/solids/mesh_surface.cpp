#include "mbs/solids/mesh_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace liesl {

std::vector<CellSide> outer_sides(const SolidMesh& mesh) {
  std::map<CellSide, std::pair<int, CellSide>> sides;  // by sorted nodes
  for (int e = 0; e < mesh.cell_count(); ++e)
    for (const auto& side : side_nodes(mesh, e)) {
      auto sorted = side;
      std::sort(sorted.begin(), sorted.end());
      auto& [count, own] = sides[sorted];
      ++count;
      own = side;
    }
  std::vector<CellSide> outer;
  for (const auto& [sorted, counted] : sides)
    if (counted.first == 1) outer.push_back(counted.second);
  return outer;
}

double mean_cell_length(const SolidMesh& mesh) {
  double size = 0;
  for (int e = 0; e < mesh.cell_count(); ++e) size += mesh.cell_size(e);
  return std::pow(size / mesh.cell_count(), 1.0 / mesh.dim);
}

}  // namespace liesl
