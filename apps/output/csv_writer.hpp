#pragma once
/// @file
/// Tables for people, spreadsheets and the drawing program. The first line names the columns as
/// `name [unit]`; numbers have as many digits as their doubles need, no more. RFC 4180.

#include <filesystem>
#include <string>
#include <vector>

#include "apps/output/results.hpp"

namespace liesl::output {

/// A field as it is, or in quotes where it has commas, quotes or line ends.
std::string field(const std::string& text);
/// "name [unit]" as a field.
std::string heading(const std::string& name, const std::string& unit);

/// `<abscissa>`, then a column a response, or `<name>.x`, `.y`, `.z` where it has components
/// (`.y`, `.z` where it has two). @throws IoError (all below)
void write_responses_csv(const std::filesystem::path& path, const Results& results);

/// `<abscissa>, kinetic, elastic, potential, dissipated, total [J], constraint_residual`.
void write_energies_csv(const std::filesystem::path& path, const Results& results);

/// `<abscissa>`, then for each joint its coordinates `<name>.q0 ...`, force `<name>.Fx ...` and
/// moment `<name>.Mx ...`.
void write_joints_csv(const std::filesystem::path& path, const Results& results);

/// Positions of all nodes at `instants` records, evenly spread, and where responses are largest:
/// `<abscissa>, body, kind, node, x [m], y [m], z [m], bending x [m], bending y [m], bending z
/// [m]`, the latter what is drawn larger (enlarged.hpp); of modes first where they are at rest.
void write_frames_csv(const std::filesystem::path& path, const Results& results, int instants = 13);

/// Places of bodies of one node along the motion, at most 200: `<abscissa>, body, x [m], y [m],
/// z [m]`. No file without such paths.
void write_rigid_paths_csv(const std::filesystem::path& path, const Results& results);

/// A column of texts, one a row.
struct TextColumn {
  std::string name, unit;  ///< unit "": none is written
  std::vector<std::string> cells;
};

/// The number as a cell; empty where there is none.
std::string cell(double x);

/// Columns of the same length as the text of a table.
std::string columns_csv(const std::vector<TextColumn>& columns);

/// One stretch of a beam that one design variable sizes.
struct DesignRow {
  std::string variable;  ///< "rod_diameters[0]"
  std::string body;
  int element = 0;
  double s0 = 0, s1 = 0;  ///< m, along the undeformed axis
  double initial = 0, final = 0, lower = 0, upper = 0;
  std::string unit = "m";
  std::string dimensions = {};  ///< of the section that it is: "diameter", "width+height", ...
};

/// `variable, body, element, s0 [m], s1 [m], initial, final, lower, upper, unit, dimension`.
void write_design_csv(const std::filesystem::path& path, const std::vector<DesignRow>& rows);

}  // namespace liesl::output
