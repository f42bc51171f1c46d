#pragma once
/// @file
/// Starts of outlines that no gradient describes: edges that lie on lines of the grid.

#include <string>
#include <vector>

#include "optim/design/part_shape.hpp"

namespace liesl {

/// Variables whose fractions of cells have another derivative on one side of the start than on the
/// other. An edge on a grid line fills the cells of one side as it moves that way, those of the
/// other side as it moves back.
std::vector<std::string> start_kinks(const PartShape& part);

/// A sentence that names them; none if there are none.
std::vector<std::string> start_warnings(const std::string& name, const PartShape& part);

}  // namespace liesl
