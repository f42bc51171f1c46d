/// @file
/// What beams that are chains of segments cannot do in space: nothing turns their cross-sections
/// about the axis.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "apps/scene/chains.hpp"
#include "mbs/sections/section_law.hpp"

namespace liesl {
namespace {

constexpr double kStraight = 1e-9;  // rad
constexpr double kRound = 1e-9;     // of the bending stiffness
constexpr double kAlong = 1e-6;     // rad: an axis along a beam
constexpr double kTwist = 1e-9;     // of the moments of a load

/// Along the axis, from the first node on.
Vec3 axis_of(const BeamSpec& beam) { return (beam.nodes[1].x - beam.nodes[0].x).normalized(); }

bool is_straight(const BeamSpec& beam) {
  const Vec3 t = axis_of(beam);
  for (std::size_t e = 0; e + 1 < beam.nodes.size(); ++e)
    if (((beam.nodes[e + 1].x - beam.nodes[e].x).normalized() - t).norm() > kStraight ||
        (beam.nodes[e + 1].R - beam.nodes[0].R).norm() > kStraight)
      return false;
  return true;
}

bool bends_alike(const Section& section, const Material& material) {
  const auto K = section_law(section, material).K;
  return std::abs(K(4, 4) - K(5, 5)) <= kRound * K(5, 5);
}

class SpatialSegmentCheck {
 public:
  explicit SpatialSegmentCheck(Reader& reader) : reader_(reader), m_(reader.scene.mechanism) {}

  void check() {
    for (std::size_t b = 0; b < m_.bodies.size(); ++b) {
      if (const BeamSpec* beam = chain_of(m_, static_cast<int>(b)))
        check_beam(m_.bodies[b].name, *beam);
      else
        check_weight(static_cast<int>(b));
    }
    for (const JointSpec& joint : m_.joints) check_joint(joint);
    for (const LoadSpec& load : m_.loads) check_load(load);
  }

 private:
  void refuse(const char* group, const std::string& name, const std::string& beam,
              const std::string& why, const std::string& expected) {
    refuse_chain(reader_, group, name,
                 fmt::format("beam '{}' has no torsion as a chain of segments: {}", beam, why),
                 expected);
  }
  const std::string& name_of(int body) const {
    return m_.bodies[static_cast<std::size_t>(body)].name;
  }

  void check_beam(const std::string& name, const BeamSpec& beam) {
    if (!is_straight(beam))
      refuse("bodies", name, name, "in space it is curved or twisted at rest",
             "a beam that is straight and not twisted, or a scene in a plane");
    for (const Section& section : beam.sections) {
      if (bends_alike(section, beam.material)) continue;
      refuse(
          "bodies", name, name,
          fmt::format("in space its section '{}' bends more easily in one direction", section.name),
          "sections of one bending stiffness (circle, tube, square), or a scene in a plane");
      break;
    }
    if (beam.damping > 0)
      refuse("bodies", name, name, "in space it has no damping either",
             "damping = 0, or a scene in a plane");
  }

  /// The axes, inertial, of the rotations that a joint leaves free or acts on.
  static std::vector<Vec3> turning_axes(const JointSpec& joint) {
    const Vec3 axes[] = {joint.axis, joint.axis2, joint.axis.cross(joint.axis2)};
    std::vector<Vec3> out;
    for (const JointRow& row : kind_of(joint.type).coordinates)
      if (row.kind == JointRow::Kind::Angle || row.kind == JointRow::Kind::Screw)
        out.push_back(axes[row.about()]);
    return out;
  }

  void check_joint(const JointSpec& joint) {
    for (const Port& port : {joint.a, joint.b}) {
      const BeamSpec* beam = chain_of(m_, port.body);
      if (!beam) continue;
      for (const Vec3& axis : turning_axes(joint)) {
        if (axis.cross(axis_of(*beam)).norm() > kAlong * axis.norm()) continue;
        refuse("joints", joint.name, name_of(port.body),
               fmt::format("joint '{}' turns about its axis", joint.name),
               "an axis across the beam");
        return;
      }
    }
  }

  /// The end of a chain that a body hangs on by a fixed joint and by nothing else.
  const Port* held_by(int body) const {
    const Port* end = nullptr;
    int holders = 0;
    for (const JointSpec& joint : m_.joints)
      for (const bool first : {true, false}) {
        const Port &own = first ? joint.a : joint.b, &other = first ? joint.b : joint.a;
        if (own.body != body) continue;
        ++holders;
        if (joint.type == JointType::Fixed && chain_of(m_, other.body)) end = &other;
      }
    for (const ForceSpec& force : m_.forces)
      holders += force.joint < 0 && (force.a.body == body || force.b.body == body);
    return holders == 1 ? end : nullptr;
  }

  /// Does a force at a place, with a moment, twist the chain that an end belongs to?
  bool twists(const Port& end, const Vec3& place, const Vec3& force, const Vec3& moment) const {
    const Port node{end.body, end.node};
    const Vec3 arm = place - m_.frame(node).x;
    const double about = (moment + arm.cross(force)).dot(axis_of(*chain_of(m_, end.body)));
    return std::abs(about) > kTwist * (moment.norm() + arm.norm() * force.norm());
  }

  void check_load(const LoadSpec& load) {
    if (load.spread || load.port.body < 0) return;
    const Port* end = chain_of(m_, load.port.body) ? &load.port : held_by(load.port.body);
    if (!end) return;
    const SE3 at = m_.frame(load.port);
    const Mat3 axes = load.follower ? at.R : Mat3(Mat3::Identity());
    if (twists(*end, at.x, axes * load.force, axes * load.moment))
      refuse("loads", load.name, name_of(end->body),
             fmt::format("load '{}' acts about its axis", load.name),
             "no moment about the axis of the beam");
  }

  void check_weight(int body) {
    const BodySpec& spec = m_.bodies[static_cast<std::size_t>(body)];
    const auto* rigid = std::get_if<RigidSpec>(&spec.kind);
    const Port* end = rigid ? held_by(body) : nullptr;
    if (!end || m_.gravity.norm() == 0) return;
    const Vec3 centre = rigid->frame.x + rigid->frame.R * rigid->centre;
    if (twists(*end, centre, rigid->mass * m_.gravity, Vec3::Zero()))
      refuse("bodies", spec.name, name_of(end->body),
             fmt::format("the weight of '{}' acts about its axis", spec.name),
             "a centre of mass on the axis of the beam");
  }

  Reader& reader_;
  const Mechanism& m_;
};

}  // namespace

void check_chains_in_space(Reader& reader) { SpatialSegmentCheck(reader).check(); }

}  // namespace liesl
