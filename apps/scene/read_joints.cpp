/// @file
/// Joints and the drives on them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "apps/scene/read_functions.hpp"
#include "apps/scene/reader.hpp"
#include "mbs/model/coupled_springs.hpp"

namespace liesl {

namespace {

bool same_place(const Port& a, const Port& b) {
  return a.body == b.body && a.node == b.node && (a.offset.x - b.offset.x).norm() == 0;
}

/// Keys that the chosen kind of motion does not have.
void check_motion(Reader& reader, const toml::table& drive) {
  constexpr std::pair<const char*, const char*> kBelongs[] = {{"interpolation", "table"},
                                                              {"ramp", "rate"}};
  for (const auto& [key, owner] : kBelongs)
    if (const toml::node* node = drive.get(key); node && written(*node) && !drive.contains(owner))
      reader.problems.add(*node, fmt::format("a drive with '{}' but no '{}'", key, owner),
                          fmt::format("'{}' with '{}' only", key, owner), "leave it out");
}

TimeFunction motion_of(Reader& reader, const toml::table& drive) {
  check_motion(reader, drive);
  if (const toml::node* expression = drive.get("expression"))
    return read_expression(reader, *expression);
  if (const toml::node* table = drive.get("table"))
    return read_table(reader, *table, text(drive, "interpolation"));
  return TimeFunction::rate(number(drive, "rate"), number(drive, "ramp"));
}

void read_drive(Reader& reader, const toml::table& table, int joint) {
  const auto& spec = reader.scene.mechanism.joints[static_cast<std::size_t>(joint)];
  DriveSpec drive{joint, integer(table, "coordinate"), motion_of(reader, table)};
  const toml::node* chosen = table.get("coordinate");
  const toml::node& at = chosen && written(*chosen) ? *chosen : table;
  const JointKind& kind = kind_of(spec.type);
  const int count = kind.coordinate_count();
  if (drive.coordinate >= count)
    reader.problems.add(
        at,
        fmt::format("{} joint '{}' has no coordinate {}", kind.name, spec.name, drive.coordinate),
        "a joint coordinate",
        count == 0 ? "drive a revolute, prismatic or other joint with coordinates"
                   : fmt::format("coordinates are 0 to {}", count - 1));
  auto& drives = reader.scene.mechanism.drives;
  for (const DriveSpec& other : drives)
    if (other.joint == joint && other.coordinate == drive.coordinate)
      reader.problems.add(
          at, fmt::format("two drives on coordinate {} of joint '{}'", drive.coordinate, spec.name),
          "one drive a coordinate");
  drives.push_back(std::move(drive));
}

void read_drives(Reader& reader, const toml::table& table, int joint) {
  const toml::node* node = table.get("drive");
  if (!node) return;
  if (const toml::table* one = node->as_table()) return read_drive(reader, *one, joint);
  for (const toml::node& item : *node->as_array()) read_drive(reader, *item.as_table(), joint);
}

void read_axes(Reader& reader, const toml::table& table, JointSpec& joint) {
  const int axes = kind_of(joint.type).axes;
  if (axes > 0) joint.axis = direction(reader, table, "axis");
  if (const toml::node* second = table.get("axis2"); axes < 2 && second && written(*second))
    reader.problems.add(
        *second,
        fmt::format("{} joint '{}' has no second axis", kind_of(joint.type).name, joint.name),
        "'axis2' for a universal joint or a bushing only", "leave it out");
  if (axes < 2) return;
  joint.axis2 = direction(reader, table, "axis2");
  const double cosine = joint.axis.dot(joint.axis2);
  if (std::abs(cosine) > 1e-6)
    reader.problems.add(
        *table.get("axis2"),
        fmt::format("the axes of {} joint '{}' are at {:.4g} degrees", kind_of(joint.type).name,
                    joint.name, std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / M_PI),
        "axes at right angles");
  joint.axis2 = (joint.axis2 - cosine * joint.axis).normalized();
}

void read_pitch(Reader& reader, const toml::table& table, JointSpec& joint) {
  const JointKind& kind = kind_of(joint.type);
  const toml::node* node = table.get("pitch");
  if (node && !kind.pitch)
    return reader.problems.add(*node,
                               fmt::format("{} joint '{}' has no pitch", kind.name, joint.name),
                               "'pitch' for a screw joint only");
  if (!kind.pitch) return;
  if (node) joint.pitch = number(table, "pitch");
  if (joint.pitch == 0)
    reader.problems.add(
        node ? *node : table,
        fmt::format("{} joint '{}' has {} pitch", kind.name, joint.name, node ? "zero" : "no"),
        "a displacement a turn (m), not 0",
        "pitch = 0.005 for 5 mm; without displacement it is a revolute joint");
}

/// The ground's side of a joint is where the body's side is, unless a point of it is named.
void place_ground(const Mechanism& mechanism, const toml::array& pair, JointSpec& joint) {
  if (kind_of(joint.type).acts_on_distance()) return;
  const auto plain = [&pair](std::size_t side) {
    return pair[side].value_or(std::string()) == "ground";
  };
  if (plain(0)) joint.a.offset = SE3(Mat3::Identity(), mechanism.frame(joint.b).x);
  if (plain(1)) joint.b.offset = SE3(Mat3::Identity(), mechanism.frame(joint.a).x);
}

/// Rods and cylinders act along the line between their ports.
void check_distance(Reader& reader, const toml::array& pair, const JointSpec& joint) {
  const Mechanism& mechanism = reader.scene.mechanism;
  const double distance = (mechanism.frame(joint.b).x - mechanism.frame(joint.a).x).norm();
  if (!kind_of(joint.type).acts_on_distance() || distance > 1e-12) return;
  reader.problems.add(pair,
                      fmt::format("{} '{}' joins two ports at the same place",
                                  kind_of(joint.type).name, joint.name),
                      "ports that are apart", "its direction is that from one to the other");
}

/// Stiffness or damping of the coordinates of a joint as a matrix; empty if it is none.
Eigen::MatrixXd matrix_of(Reader& reader, const toml::table& table, const char* key,
                          int coordinates) {
  const toml::node* node = table.get(key);
  if (!node) return {};
  const toml::array* list = node->as_array();
  const bool square = list && (*list)[0].is_array();
  const std::size_t given = square ? list->size() : numbers(*node).size();
  if (static_cast<int>(given) != coordinates) {
    reader.problems.add(
        *node,
        fmt::format("'{}' has {} {} for {} coordinate{}", key, given, square ? "rows" : "numbers",
                    coordinates, coordinates == 1 ? "" : "s"),
        coordinates == 1 ? "one number"
                         : fmt::format("{0} numbers or {0} rows of {0}", coordinates));
    return {};
  }
  if (!list) return Eigen::MatrixXd::Constant(1, 1, number(table, key));
  return matrix(*node, coordinates);
}

/// The matrix as springs; none if it is not there or cannot be.
std::vector<CoupledSpring> springs_of(Reader& reader, const toml::table& table, const char* key,
                                      int coordinates) {
  const Eigen::MatrixXd K = matrix_of(reader, table, key, coordinates);
  if (K.size() == 0) return {};
  const auto refuse = [&](const std::string& why) {
    reader.problems.add(*table.get(key), fmt::format("'{}' {}", key, why),
                        "a symmetric matrix without negative eigenvalues",
                        "rows and columns in the order of the coordinates: 3 displacements (m), 3 "
                        "angles (rad)");
    return std::vector<CoupledSpring>();
  };
  const Eigen::VectorXd size = K.diagonal().cwiseAbs().cwiseSqrt();
  const Eigen::MatrixXd allowed = 1e-9 * size * size.transpose();
  if (((K - K.transpose()).cwiseAbs() - allowed).maxCoeff() > 0) return refuse("is not symmetric");
  try {
    return coupled_springs(K);
  } catch (const std::invalid_argument& error) {
    return refuse(
        fmt::format("has a negative eigenvalue ({}): it would push by itself", error.what()));
  }
}

/// The spring of a coordinate, none if there is none.
CoupledSpring take(const std::vector<CoupledSpring>& springs, int coordinate) {
  for (const CoupledSpring& spring : springs)
    if (spring.coordinate == coordinate) return spring;
  return {coordinate, 0, {}};
}

/// Springs, dampers and force of a cylinder or bushing, as forces on its coordinates: a spring and
/// a damper of one coordinate are one force.
void read_elastic(Reader& reader, const toml::table& table, const JointSpec& joint, int index) {
  const JointKind& kind = kind_of(joint.type);
  const toml::node* push = table.get("force");
  if (!kind.elastic) {
    for (const char* key : {"stiffness", "damping", "force"})
      if (const toml::node* node = table.get(key))
        reader.problems.add(*node,
                            fmt::format("{} joint '{}' has no '{}'", kind.name, joint.name, key),
                            "a cylinder or bushing",
                            fmt::format("an entry of [forces] with on = \"{}\"", joint.name));
    return;
  }
  const int count = kind.coordinate_count();
  if (push && count > 1)
    reader.problems.add(*push, fmt::format("bushing '{}' has no 'force'", joint.name),
                        "'force' of a cylinder",
                        fmt::format("an entry of [forces] with on = \"{}.2\"", joint.name));
  if (count > 1 && !table.contains("stiffness") && !table.contains("damping"))
    reader.problems.add(table, fmt::format("bushing '{}' has no force law", joint.name),
                        "'stiffness' or 'damping': 6 numbers, or 6 rows of 6");
  const auto springs = springs_of(reader, table, "stiffness", count),
             dampers = springs_of(reader, table, "damping", count);
  auto& forces = reader.scene.mechanism.forces;
  for (int i = 0; i < count; ++i) {
    const CoupledSpring spring = take(springs, i), damper = take(dampers, i);
    ForceSpec force;
    force.name = count == 1 ? joint.name : fmt::format("{}.{}", joint.name, i);
    force.joint = index;
    force.coordinate = i;
    if (push && count == 1) force.force = read_function(reader, *push);
    ForceSpec slow = force;
    force.stiffness = spring.stiffness;
    force.shares = spring.shares;
    const bool together = spring.shares.empty() && damper.shares.empty();
    if (together) force.damping = damper.stiffness;
    if (force.stiffness != 0 || force.damping != 0 || (push && count == 1))
      forces.push_back(std::move(force));
    if (together || damper.stiffness == 0) continue;
    slow.name += ".damping";
    slow.damping = damper.stiffness;
    slow.shares = damper.shares;
    forces.push_back(std::move(slow));
  }
}

void read_joint(Reader& reader, const Entry& entry) {
  JointSpec joint;
  joint.name = entry.name;
  const toml::array* pair = nullptr;
  for (const JointKind& kind : joint_kinds())
    if (const toml::node* node = entry.table->get(kind.name)) {
      joint.type = kind.type;
      pair = node->as_array();
    }
  read_axes(reader, *entry.table, joint);
  read_pitch(reader, *entry.table, joint);
  const auto a = reader.port((*pair)[0]), b = reader.port((*pair)[1]);
  if (a && b) {
    joint.a = *a;
    joint.b = *b;
    if (a->body < 0 && b->body < 0)
      reader.problems.add(*pair, fmt::format("joint '{}' joins the ground to itself", joint.name),
                          "a body on at least one side");
    else if (same_place(*a, *b))
      reader.problems.add(*pair, fmt::format("joint '{}' joins a port to itself", joint.name),
                          "two different ports");
    else {
      place_ground(reader.scene.mechanism, *pair, joint);
      check_gap(reader, *pair, joint);
      check_distance(reader, *pair, joint);
    }
  }
  const int index = static_cast<int>(reader.scene.mechanism.joints.size());
  read_elastic(reader, *entry.table, joint, index);
  reader.scene.mechanism.joints.push_back(std::move(joint));
  read_drives(reader, *entry.table, index);
}

}  // namespace

void read_gears(Reader& reader) {
  for (const Entry& entry : entries(reader, "gears")) {
    const toml::array& pair = *entry.table->get("of")->as_array();
    const auto first = reader.coordinate(pair[0]), second = reader.coordinate(pair[1]);
    const double ratio = number(*entry.table, "ratio");
    if (ratio == 0)
      reader.problems.add(*entry.table->get("ratio"),
                          fmt::format("the ratio of gear '{}' is 0", entry.name),
                          "q_second / q_first, other than 0", "-0.5 for 20 teeth on 40");
    if (!first || !second) continue;
    if (first->joint == second->joint && first->coordinate == second->coordinate)
      reader.problems.add(pair,
                          fmt::format("gear '{}' couples a coordinate with itself", entry.name),
                          "two coordinates");
    reader.scene.mechanism.gears.push_back({entry.name,
                                            {first->joint, first->coordinate},
                                            {second->joint, second->coordinate},
                                            ratio});
  }
}

void read_joints(Reader& reader) {
  for (const Entry& entry : entries(reader, "joints")) read_joint(reader, entry);
}

}  // namespace liesl
