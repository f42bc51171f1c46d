#pragma once
/// @file
/// Meshes from input files of Abaqus and CalculiX.

#include <string>
#include <string_view>

#include "mbs/solids/mesh.hpp"

namespace liesl {

/// Reads the text of a flat `.inp` file (one without *INSTANCE); `file` names it in messages. Nodes
/// are those of *NODE, cells *ELEMENT of one of the types of `CellKind`, CPS3 to CPS8 (also as CPE)
/// in z = 0 or C3D4 to C3D20, each also with R, I or M at its end: the order of nodes is that of
/// SolidMesh. *NSET (also GENERATE, and sets of sets) and NSET= at *NODE become sets of nodes.
/// Elements of springs, masses, beams and shells, materials, steps and what else the file holds are
/// passed over; nodes without a cell are left out. Lengths are taken as m: the format knows no
/// units.
/// @throws InputError with every problem and its line: solid elements of other kinds or of several,
/// inverted or flat cells, nodes or sets that do not exist; *INCLUDE, *NGEN, *ELGEN, *SYSTEM and
/// what else makes nodes without listing them
SolidMesh read_abaqus(const std::string& file, std::string_view text);

}  // namespace liesl
