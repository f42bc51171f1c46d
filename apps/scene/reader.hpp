#pragma once
/// @file
/// What the readers of the parts of a scene share. They run on validated tables: types are right,
/// defaults are in, entries with problems are skipped (`broken`).

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "apps/input/problem.hpp"
#include "apps/input/validate.hpp"
#include "apps/input/values.hpp"
#include "apps/scene/scene.hpp"
#include "apps/scene/trusses.hpp"

namespace liesl {

/// State of reading one scene.
struct Reader {
  toml::table& root;
  const Broken& broken;
  Problems& problems;
  Scene& scene;
  std::map<std::string, Section> sections;
  std::map<std::string, Material> materials;
  bool fixed_loads = false;  ///< a study brings the loads; nothing has to move
  TrussNames trusses = {};

  /// Names in a top-level table, in the order of the file.
  std::vector<std::string> names(std::string_view group) const;
  /// Does a top-level table have this entry? If not, it is reported at `at` ("no body 'rdo'").
  bool known(const toml::node& at, std::string_view group, std::string_view kind,
             const std::string& name);

  /// Index of a body named by a string; empty (and reported) if there is none.
  std::optional<int> body(const toml::node& name);
  /// The same for a beam.
  std::optional<int> beam(const toml::node& name);
  /// The same for a body, or for all bars of a truss or of a group of them.
  std::vector<int> bodies_of(const toml::node& name);
  std::optional<int> joint(const toml::node& name);
  std::optional<int> joint(const toml::node& at, const std::string& name);
  /// A joint and its coordinate, "joint" or "joint.1".
  struct Coordinate {
    int joint = 0;
    int coordinate = 0;
  };
  std::optional<Coordinate> coordinate(const toml::node& text);
  std::optional<Port> port(const toml::node& text);
};

/// Unbroken entries of a top-level table.
std::vector<Entry> entries(const Reader& reader, std::string_view group);

/// Direction of unit length; a zero vector is reported.
Vec3 direction(Reader& reader, const toml::table& table, std::string_view key);

/// Rotation vector "orientation", rad; more than a turn is reported: it looks like degrees.
Vec3 orientation(Reader& reader, const toml::table& table);

/// Number, expression or table.
TimeFunction read_function(Reader& reader, const toml::node& node);

/// All parts of a scene.
void read_parts(Reader& reader);

// Parts of a scene, in this order.
void read_simulation(Reader& reader);
void read_gravity(Reader& reader);
void read_ground(Reader& reader);
void read_materials(Reader& reader);
void read_bodies(Reader& reader);
/// A meshed part from its table; empty (and reported) if something is wrong with it.
std::optional<SolidSpec> read_solid(Reader& reader, const std::string& name, toml::table& table);
void check_names(Reader& reader);
void read_joints(Reader& reader);
void read_gears(Reader& reader);
void read_forces(Reader& reader);
void read_loads(Reader& reader);
/// The order of the elements of beams: as given, else the default. An order 4 that a beam or a load
/// over it cannot have is refused.
void read_orders(Reader& reader);
void read_responses(Reader& reader);
/// One response from its table; empty (and reported) if something is wrong with it.
std::optional<ResponseSpec> read_response(Reader& reader, const std::string& name,
                                          const toml::table& table);
/// Are the ends of a joint where they belong? Gaps up to a thousandth of the mechanism are left to
/// the assembly of the initial state.
void check_gap(Reader& reader, const toml::node& at, const JointSpec& joint);
/// A simulation of something that nothing moves is refused.
void check_movers(Reader& reader);
/// A planar mesh needs a planar scene.
void check_plane(Reader& reader);
/// A motion with drives that jump is refused; warns of what steps, damping or tolerance spoil.
void check_motion(Reader& reader);
/// An update that some body cannot take is refused.
void check_update(Reader& reader);
/// What chains of segments cannot do is refused.
void check_segments(Reader& reader);
/// What is possible but looks like another unit: E in GPa, a diameter in mm.
std::vector<std::string> unit_warnings(const Reader& reader);

}  // namespace liesl
