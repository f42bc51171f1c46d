#pragma once
/// @file
/// Meshes from Gmsh.

#include <string>
#include <string_view>

#include "mbs/solids/mesh.hpp"

namespace liesl {

/// Reads the text of a Gmsh file, format 4.1, ASCII (`gmsh part.geo -2 -format msh41`); `file`
/// names it in messages. Cells are of one of the kinds of `CellKind`, planar ones in z = 0; named
/// physical groups of points, lines (and faces, in space) become sets of nodes. Nodes that belong
/// to no cell are left out.
/// @throws InputError with every problem and its line: another format or version, binary, cells of
/// other kinds, cells that are inverted or flat, nodes that do not exist, a file that ends early
SolidMesh read_gmsh(const std::string& file, std::string_view text);

}  // namespace liesl
