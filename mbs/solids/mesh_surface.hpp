#pragma once
/// @file
/// The surface of a mesh, and how large its cells are.

#include <vector>

#include "mbs/solids/mesh.hpp"

namespace liesl {

/// The sides that belong to one cell only, as `side_nodes` gives them.
std::vector<CellSide> outer_sides(const SolidMesh& mesh);

/// Side of a square (cube) of the mean size of the cells, m.
double mean_cell_length(const SolidMesh& mesh);

}  // namespace liesl
