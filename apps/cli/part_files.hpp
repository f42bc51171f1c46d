#pragma once
/// @file
/// Files of a meshed part whose outline a study changed.

#include <filesystem>

#include "apps/tasks/part_fields.hpp"

namespace liesl {

/// NAME.vtu, the outline as NAME.svg and NAME.dxf or NAME.stl and as NAME_outline.toml (the tree of
/// features, for a scene), and for pictures of planar parts NAME_outlines.csv (of the designs
/// `history`) and NAME_cells.csv (fraction, the stress in the load case of the largest, and what a
/// hole would gain). @throws output::IoError
void write_part(const std::filesystem::path& folder, const PartOutcome& part);

}  // namespace liesl
