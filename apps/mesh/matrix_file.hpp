#pragma once
/// @file
/// A part as matrices between its nodes, as one HDF5 file.

#include <filesystem>

#include "mbs/solids/nodal_matrices.hpp"

namespace liesl {

/// Nodes and their sets (a mesh without cells), stiffness and mass.
struct PartMatrices {
  SolidMesh nodes;
  NodalMatrices matrices;
};

/// Data sets: `nodes` [N, 2 or 3] m; `stiffness` (N/m) and `mass` (kg) as groups of `row`, `column`
/// and `value`, freedoms dim * node + component and nodes from 0, of the lower triangle or both;
/// lists of nodes in the group `sets`.
/// @throws InputError that names the data set: one that is missing, or of another shape, numbers
/// outside of the matrix; a file that is no HDF5 file
PartMatrices read_matrix_file(const std::filesystem::path& path);
/// @param part lower triangles  @throws output::IoError
void write_matrix_file(const std::filesystem::path& path, const PartMatrices& part);

}  // namespace liesl
