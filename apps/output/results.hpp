#pragma once
/// @file
/// What a simulation hands to the writers: plain numbers in space, in SI units. Planar runs are
/// embedded in space before. Blocks are contiguous, last index fastest; the first index is always
/// the record. An empty block means "not recorded", and is not written.

#include <array>
#include <string>
#include <vector>

namespace liesl::output {

/// n records, N nodes, E elements.
struct BodyResult {
  std::string name;
  std::string kind;                          ///< "beam", "rigid", ...
  int nodes = 0;                             ///< N
  std::vector<std::array<int, 2>> elements;  ///< E pairs of nodes
  std::vector<double> positions;             ///< n x N x 3, inertial, m
  std::vector<double> rotations;             ///< n x N x 9, R (local to inertial), by rows
  std::vector<double> velocities;            ///< n x N x 6, [u; w] in the local frame, m/s, rad/s
  std::vector<double> strains;         ///< n x E x 6, [eps_x, gam_y, gam_z, kap_x, kap_y, kap_z]
  std::vector<double> section_forces;  ///< n x E x 6, [N, V_y, V_z, M_x, M_y, M_z], N, N m
};

/// A meshed part of N nodes and M cells, at r of the records.
struct MeshResult {
  std::string name;
  int corners = 4;                ///< C of a cell: 4 or 8
  std::vector<int> cells;         ///< M x C, in the order of VTK
  std::vector<double> fractions;  ///< M, of material
  std::vector<int> records;       ///< r, growing
  std::vector<double> positions;  ///< r x N x 3, deformed, inertial, m
  /// r x N x 3, what of it is deformation, seen from the first interface; inertial axes, m.
  std::vector<double> displacements;
};

/// K coordinates.
struct JointResult {
  std::string name;
  std::string type;                 ///< "revolute", ...
  std::vector<std::string> units;   ///< K, "m" or "rad"
  std::vector<double> coordinates;  ///< n x K; angles count beyond pi
  std::vector<double> forces;       ///< n x 6, [F; M] on port b, in b's axes, N, N m
};

/// n numbers each, in J.
struct Energies {
  std::vector<double> kinetic, elastic, potential;
  std::vector<double> dissipated;  ///< by the integrator, since the start
  std::vector<double> total;       ///< kinetic + elastic + potential
};

/// A named quantity over the records.
struct ResponseResult {
  std::string name;
  std::string unit;
  int components = 1;          ///< C: 1, 2 or 3
  std::vector<double> values;  ///< n x C
};

struct Results {
  std::string name;               ///< of the scene
  std::string space;              ///< "planar" or "spatial": where it was computed
  std::string abscissa = "time";  ///< what the records are numbered by: "time", "load_factor", ...
  std::string abscissa_unit = "s";  ///< "-" for a number
  std::vector<double> times;        ///< n, the abscissa
  std::vector<BodyResult> bodies;
  std::vector<MeshResult> meshes;
  std::vector<JointResult> joints;
  Energies energies;
  std::vector<double> constraint_residual;  ///< n, largest, m or rad
  std::vector<ResponseResult> responses;
};

/// Compares every block with its documented shape.
/// @throws std::invalid_argument naming the block, what was expected and what was found
void check_shapes(const Results& results);

/// Records that pictures show: more make ParaView slow.
inline constexpr int kShownRecords = 250;

/// At most `count` record numbers, evenly spread over [0, n), first and last among them.
std::vector<int> spread_records(int n, int count);

}  // namespace liesl::output
