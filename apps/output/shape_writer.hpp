#pragma once
/// @file
/// Outlines and meshes as files for other programs.

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "mbs/levelset/zero_level.hpp"
#include "mbs/solids/mesh.hpp"

namespace liesl::output {

/// Filled outline, holes left out, y upwards; one user unit is 1 mm. @throws IoError
void write_svg(const std::filesystem::path& path, const std::vector<levelset::Polyline>& lines);

/// Closed LWPOLYLINEs on layer "outline" in mm, DXF R2000 (AC1015) reduced to its entities, as CAD
/// programs import it. @throws IoError
void write_dxf(const std::filesystem::path& path, const std::vector<levelset::Polyline>& lines);

/// Binary STL in mm, normals outward, without the triangles that are empty in its single precision;
/// as closed as the surface. @throws IoError
void write_stl(const std::filesystem::path& path, const levelset::Surface& surface);

/// Cell and node fields of a mesh, 1 or 3 numbers each, by columns.
using MeshField = std::pair<std::string, Eigen::MatrixXd>;
/// ParaView's .vtu (VTK XML, ASCII), lengths in m. @throws IoError, std::invalid_argument if the
/// size of a field does not fit
void write_vtu(const std::filesystem::path& path, const SolidMesh& mesh,
               const std::vector<MeshField>& cell_fields,
               const std::vector<MeshField>& node_fields = {});

}  // namespace liesl::output
