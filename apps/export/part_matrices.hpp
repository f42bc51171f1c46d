#pragma once
/// @file
/// A meshed part as matrices between its nodes, for other programs and for `solid.matrices`.

#include <map>
#include <string>

#include "mbs/solids/solid_spec.hpp"

namespace liesl {

/// Names and texts of the files: NAME_stiffness.mtx, NAME_mass.mtx, NAME_nodes.mtx (MatrixMarket)
/// and NAME.toml, the part of a scene that reads them.
/// @throws std::invalid_argument for a part that is given by matrices itself
std::map<std::string, std::string> matrix_files(const std::string& name, const SolidSpec& solid);

}  // namespace liesl
