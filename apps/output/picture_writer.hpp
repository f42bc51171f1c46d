#pragma once
/// @file
/// Tables that the drawing program needs for a mechanism as it looks: how thick beams are, and the
/// lines of meshed parts.

#include <filesystem>

#include "apps/output/results.hpp"

namespace liesl::output {

/// How thick the elements of beams look along the axes of the scene, at rest:
/// `body, element, along x [m], along y [m], along z [m]`. Across an axis that a beam points along
/// its larger thickness, 0 of a section without a shape. Bodies without any shape are left out; no
/// file without others.
/// @throws IoError (both)
void write_sections_csv(const std::filesystem::path& path, const Results& results);

/// Lines of deformed meshed parts and of rigid bodies at the instants that pictures show: of a
/// rigid body from its centre of mass to its points and joints; of a planar part its
/// outline, material on the left, of a part in space the edges where its surface turns by more than
/// 30 degrees: `<abscissa>, body, line, x [m], y [m], z [m], bending x [m], bending y [m], bending
/// z [m]`, the latter what of a place is drawn larger: in statics and of modes its displacement
/// from rest, of a motion the deformation about the chord, the line from the first interface to the
/// farthest, or the ends of a beam; of modes meshed parts at rest, too. Rods and cylinders, joints
/// without mass, are a line from port to port. No file without such lines.
void write_part_lines_csv(const std::filesystem::path& path, const Results& results);

}  // namespace liesl::output
