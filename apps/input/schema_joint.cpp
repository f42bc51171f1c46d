/// @file
/// Table of the keys of joints and their drives; kinds of joints are rows of `joint_kinds`.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/input/schema.hpp"
#include "mbs/model/joint_kind.hpp"

namespace liesl {

namespace {

/// "fixed, spherical, rod": kinds of joints without an axis.
std::string without_axis() {
  std::vector<std::string_view> names;
  for (const JointKind& kind : joint_kinds())
    if (kind.axes == 0) names.push_back(kind.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::vector<Key> joint_keys() {
  // clang-format off
  std::vector<Key> keys = {
    {"joints", Type::Named, "", kOptional, kAny, "Joints by name. Each joins two ports: `body.port`, or `ground`. Coordinates are zero in the scene as given."},
    {"joints.*", Type::Table, "", kOptional, kAny, "A joint: exactly one of the joint types."},
  };
  for (const JointKind& kind : joint_kinds())
    keys.push_back({fmt::format("joints.*.{}", kind.name), Type::Pair, "", kOneOf, kAny, fmt::format("{} {}", kind.motion, kind.coordinates_text())});
  const std::vector<Key> rest = {
    {"joints.*.axis", Type::Vector, "-", "[0, 0, 1]", kAny, fmt::format("Inertial, at the start; normalised. Unused by {} joints.", without_axis()), 3},
    {"joints.*.axis2", Type::Vector, "-", "[1, 0, 0]", kAny, "Universal joints and bushings: second axis, normal to the first; normalised.", 3},
    {"joints.*.pitch", Type::Number, "m", kOptional, kAny, "Screw joints, required there, not 0: displacement of the second port along `axis` in one positive turn. Negative: left-handed."},
    {"joints.*.stiffness", Type::NumberOrMatrix, "N/m, N, N m/rad", kOptional, kNotNegative, "Bushings: of the six coordinates, six numbers, or a symmetric matrix without negative eigenvalues where they are coupled. Cylinders: one number.", 6},
    {"joints.*.damping", Type::NumberOrMatrix, "N s/m, N s, N m s/rad", kOptional, kNotNegative, "The same of the damping.", 6},
    {"joints.*.force", Type::Function, "N", kOptional, kAny, "Cylinders: pushes the ports apart."},
    {"joints.*.drive", Type::TableOrList, "", kOptional, kAny, "Prescribes a joint coordinate: exactly one of `rate`, `table`, `expression`."},
    {"joints.*.drive.rate", Type::Number, "rad/s or m/s", kOneOf, kAny, "Constant rate."},
    {"joints.*.drive.ramp", Type::Number, "s", "0", kNotNegative, "Duration of the cycloidal start from rest to `rate`."},
    {"joints.*.drive.table", Type::Rows, "s, rad or m", kOneOf, kAny, "Rows [t, q], t increasing.", 2},
    {"joints.*.drive.interpolation", Type::Choice, "", "\"cubic\"", kAny, "Of the table: cubic is C1 without overshoot; quintic is C4, linear in the values, starts and ends with rate and acceleration 0, and may overshoot.", 0, "linear cubic quintic"},
    {"joints.*.drive.expression", Type::Text, "rad or m", kOneOf, kAny, "q as an expression of t (s), as in \"sin(2*pi*t)\"."},
    {"joints.*.drive.coordinate", Type::Integer, "", "0", {0, max_coordinates() - 1.0}, "Which coordinate of the joint."},
  };
  // clang-format on
  keys.insert(keys.end(), rest.begin(), rest.end());
  return keys;
}

}  // namespace liesl
