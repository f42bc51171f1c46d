#pragma once
/// @file
/// What a simulation hands to the writers: plain numbers in space, in SI units. Planar runs are
/// embedded in space before. Blocks are contiguous, last index fastest; the first index is always
/// the record. An empty block means "not recorded", and is not written.

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace liesl::output {

/// Numbers that describe the shape of a section, at most.
inline constexpr int kMostDimensions = 4;

/// n records, N nodes, E elements.
struct BodyResult {
  std::string name;
  std::string kind;                          ///< "beam", "rigid", ...
  int nodes = 0;                             ///< N
  std::vector<std::array<int, 2>> elements;  ///< E pairs of nodes
  std::vector<double> positions;             ///< n x N x 3, inertial, m
  std::vector<double> rotations;             ///< n x N x 9, R (local to inertial), by rows
  std::vector<double> velocities;            ///< n x N x 6, [u; w] in the local frame, m/s, rad/s
  std::vector<double> strains;  ///< n x E x 6, [eps_x, gam_y, gam_z, kap_x, kap_y, kap_z]
  /// n x E x 12, [N, V_y, V_z, M_x, M_y, M_z] at the first node of the element and at its last, in
  /// the axes of that node, N, N m.
  std::vector<double> section_forces;
  /// n x E x 2, largest von Mises stress of the section at both ends of the element, Pa.
  std::vector<double> stresses = {};
  std::vector<double> reference_positions = {};  ///< N x 3, at rest, inertial, m
  std::vector<double> reference_rotations = {};  ///< N x 9, at rest
  std::vector<std::string> shapes = {};          ///< E, kind of section: "circle", "box", ...
  std::vector<double> dimensions = {};           ///< E x 4, of the shape in its order, then 0; m
  /// P x 3, of a rigid body: centre of mass and named points, in body axes from its origin, m.
  std::vector<double> points = {};
  double largest_stress = 0;  ///< of all records, Pa; 0: none is recorded
  /// Of a body of one node: its places at spread_records(n, kPathPoints), 3 each, m.
  std::vector<double> path = {};
};

/// Blocks of a body whose first index is the record.
inline constexpr std::array kBodySeries = {&BodyResult::positions,      &BodyResult::rotations,
                                           &BodyResult::velocities,     &BodyResult::strains,
                                           &BodyResult::section_forces, &BodyResult::stresses};

/// Takes the series of bodies by blocks of records as they are made, so that nobody keeps them all.
class BodySink {
 public:
  virtual ~BodySink() = default;
  /// @param bodies with their series at the records [first, first + count) of n; a block that is
  /// empty is so in every call
  virtual void put(const std::vector<BodyResult>& bodies, std::size_t first, std::size_t count,
                   std::size_t n) = 0;
};

/// A meshed part of N nodes and M cells, at r of the records.
struct MeshResult {
  std::string name;
  int corners = 4;                ///< C nodes of a cell
  std::vector<int> cells;         ///< M x C, in the order of VTK
  std::vector<double> fractions;  ///< M, of material
  std::vector<int> records;       ///< r, growing
  std::vector<double> positions;  ///< r x N x 3, deformed, inertial, m
  /// r x N x 3, what of it is deformation, seen from the first interface; inertial axes, m.
  std::vector<double> displacements;
  std::vector<double> reference = {};  ///< N x 3, at rest, in the axes of the first interface, m
  std::vector<double> level = {};  ///< N, level set of the outline, > 0: material; empty: all is
  std::vector<double> basis = {};  ///< k x N x 3, displacement by amplitude, axes of the above
  /// k x M x 3 (6 in space), stress at the centres of the cells by amplitude: normal stresses, then
  /// xy (xy, yz, zx), of the full material, axes of the above, Pa.
  std::vector<double> stress_basis = {};
  std::vector<double> amplitudes = {};  ///< n x k; position = x_0 + R_0 (reference + basis)
  std::vector<double> interfaces = {};  ///< I x 3, at rest, as `reference`
  double thickness = 0;                 ///< of a planar mesh, m; 0: it is in space

  int dim() const { return thickness > 0 ? 2 : 3; }
};

/// K coordinates.
struct JointResult {
  std::string name;
  std::string type;                      ///< "revolute", ...
  std::vector<std::string> units;        ///< K, "m" or "rad"
  std::vector<double> coordinates;       ///< n x K; angles count beyond pi
  std::vector<double> forces;            ///< n x 6, [F; M] on port b, in b's axes, N, N m
  std::vector<std::string> bodies = {};  ///< 2, of ports a and b; "ground"
  std::array<int, 2> nodes = {};         ///< of these bodies that the ports hold on to
  std::vector<double> places = {};       ///< 2 x 3, of the ports in the axes of those nodes, m
  std::vector<double> axis = {};         ///< 3, in the axes of the node of port b; empty: has none
};

/// n numbers each, in J.
struct Energies {
  std::vector<double> kinetic, elastic, potential;
  std::vector<double> dissipated;  ///< by the integrator, since the start
  std::vector<double> total;       ///< kinetic + elastic + potential
  /// Over every accepted step, recorded or not: largest kinetic + elastic, largest |potential|, and
  /// the `dissipated` that is largest in size.
  double turned_over = 0, largest_potential = 0, lost = 0;
  /// Kinetic energy of all masses if they went once across the mechanism in the time simulated.
  double crossing = 0;
};

/// Largest |value|, the norm for vectors, and where on the abscissa that is.
struct Peak {
  double size = 0, at = 0;
  /// Of a motion: by how much the largest value between the steps is larger, as the parabolas
  /// through the steps beside each peak say; 0 where that is at the first or the last one.
  double missed = 0;
  double between = 0;  ///< the same between the nodes of a beam, ResponseValues::above_the_nodes
};

/// A named quantity over the records.
struct ResponseResult {
  std::string name;
  std::string unit;
  int components = 1;          ///< C: 1, 2 or 3
  std::vector<double> values;  ///< n x C
  std::string axes = {};  ///< C letters that tell the components apart; empty: x, y, z, or none
  std::optional<Peak> peak = {};  ///< over every accepted step; none: of the records

  /// "bend.y", or the name alone where there is one component without a letter.
  std::string column(std::size_t component) const;
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
  /// Records that the series of bodies hold where a BodySink took them: those of frames.csv. Empty:
  /// all n.
  std::vector<int> kept = {};
  /// Records nearest to the largest values of responses and to the worst limit, for the pictures.
  std::vector<int> peaks = {};

  /// The one that is nearest on the abscissa. @pre there is one
  int record_near(double at) const;
  /// Where the series of bodies hold a record. @throws std::out_of_range if they do not
  std::size_t row(int record) const;
};

/// Compares every block with its documented shape.
/// @throws std::invalid_argument naming the block, what was expected and what was found
void check_shapes(const Results& results);
/// Of a body with series of n records.
void check_shapes(const BodyResult& body, std::size_t n);

/// Records that pictures show: more make ParaView slow.
inline constexpr int kShownRecords = 250;
/// What tables for pictures of modes are numbered by where the mechanism is at rest: no frequency.
inline constexpr const char* kAtRest = "0";
/// Instants of frames.csv, and of those the ones that pictures show.
inline constexpr int kFrames = 13, kPictured = 5;
/// Responses whose largest values are among the instants of frames.csv.
inline constexpr std::size_t kPeaks = 3;
/// Points of the path of a body of one node.
inline constexpr int kPathPoints = 200;
/// Bytes of deformed meshes up to which results.h5 keeps them; `liesl export` makes them of the
/// basis else.
inline constexpr double kMeshBytes = 6e6;

/// At most `count` record numbers, evenly spread over [0, n), first and last among them.
std::vector<int> spread_records(int n, int count);
/// Records of frames.csv: `count` of them evenly spread, and the peaks; in order.
std::vector<int> frame_records(const Results& results, int count);

}  // namespace liesl::output
