#pragma once
/// @file
/// A meshed part as matrices between its nodes, for other programs and for `solid.matrices`.

#include <filesystem>
#include <string>

#include "mbs/solids/solid_spec.hpp"

namespace liesl {

/// Writes into a folder NAME_stiffness.mtx, NAME_mass.mtx and NAME_nodes.mtx (MatrixMarket), the
/// same as NAME.h5 with the nodes of the interfaces as sets, and NAME.toml, the part of a scene
/// that reads the former.
/// @throws std::invalid_argument for a part that is given by matrices itself, output::IoError
void write_part_matrices(const std::filesystem::path& folder, const std::string& name,
                         const SolidSpec& solid);

}  // namespace liesl
