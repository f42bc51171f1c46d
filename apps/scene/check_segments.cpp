/// @file
/// What beams that are chains of segments cannot do: they have no shear and no torsion, and the
/// nodes between their ends are points.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "apps/scene/chains.hpp"
#include "mbs/sections/section_law.hpp"
#include "mbs/system/plane.hpp"

namespace liesl {

namespace {

/// First frequency of a hinged beam (S. P. Timoshenko, Philos. Mag. 41 (1921) 744-746): what shear
/// and rotary inertia, which a chain of segments has not, take of it, pi^2/2 (EI/GA + rho I/rho
/// A)/L^2, at the worst of its sections. @param plane if the chain is in one
double left_out_of(const BeamSpec& beam, const std::optional<Space<SE2>>& plane) {
  double length = 0, worst = 0;
  for (std::size_t e = 0; e < beam.sections.size(); ++e) {
    const SE3& at = beam.nodes[e];
    length += (beam.nodes[e + 1].x - at.x).norm();
    const SectionLaw law = section_law(beam.sections[e], beam.material);
    double share = law.K(5, 5) / law.K(1, 1) + law.M(5, 5) / law.M(1, 1);
    if (plane) {
      const SE3 align = plane->alignment(at);
      const SE2::Matrix K = plane->reduce_law(law.K, align), M = plane->reduce_law(law.M, align);
      share = K(2, 2) / K(1, 1) + M(2, 2) / M(1, 1);
    }
    worst = std::max(worst, share);
  }
  return 0.5 * M_PI * M_PI * worst / (length * length);
}

class SegmentCheck {
 public:
  explicit SegmentCheck(Reader& reader) : reader_(reader), m_(reader.scene.mechanism) {}

  void check() {
    find_space();
    if (spatial_) check_chains_in_space(reader_);
    for (std::size_t j = 0; j < m_.joints.size(); ++j) check_joint(static_cast<int>(j));
    for (const ForceSpec& force : m_.forces)
      if (force.joint < 0)
        for (const Port& port : {force.a, force.b}) check_lug("forces", force.name, port);
    for (const LoadSpec& load : m_.loads) check_load(load);
    for (std::size_t b = 0; b < m_.bodies.size(); ++b)
      if (const BeamSpec* beam = chain_of(m_, static_cast<int>(b)))
        tell_what_is_left_out(m_.bodies[b].name, *beam);
  }

 private:
  void tell_what_is_left_out(const std::string& name, const BeamSpec& beam) {
    constexpr double kMuch = 0.01;
    const double share = left_out_of(beam, plane_);
    if (share > kMuch)
      reader_.scene.warnings.push_back(fmt::format(
          "beam '{}' is too stout for a chain of segments, which has no shear and no rotary "
          "inertia: they would change its first frequency by about {:.2g} %",
          name, 100 * share));
  }

  /// Is this a node between the ends of a chain?
  bool inner(const Port& port) const {
    const BeamSpec* beam = chain_of(m_, port.body);
    return beam && port.node > 0 && port.node + 1 < static_cast<int>(beam->nodes.size());
  }
  const std::string& name_of(const Port& port) const {
    return m_.bodies[static_cast<std::size_t>(port.body)].name;
  }
  void refuse(const char* group, const std::string& name, const std::string& what,
              const std::string& expected) {
    refuse_chain(reader_, group, name, what, expected);
  }

  /// In a plane or in space? What turns a beam about its axis is refused there.
  void find_space() {
    const SimulationOptions& o = reader_.scene.simulation;
    const SpaceChoice asked = o.space;
    const PlaneSearch found = find_plane(m_);
    const bool modes = o.type == SimulationType::Modes,
               critical = o.type == SimulationType::Static && o.critical;
    spatial_ = asked == SpaceChoice::Spatial ||
               (asked == SpaceChoice::Auto && (!found.plane || modes || critical));
    if (!spatial_ || (!modes && !critical)) {
      if (!spatial_) plane_ = found.plane;
      return;
    }
    const char* what = modes ? "modes" : "critical loads";
    const std::string why = found.plane && asked == SpaceChoice::Auto
                                ? fmt::format("{} may leave the plane", what)
                                : fmt::format("{} in space would turn it about its axis", what);
    for (std::size_t b = 0; b < m_.bodies.size(); ++b) {
      if (!chain_of(m_, static_cast<int>(b))) continue;
      const std::string& name = m_.bodies[b].name;
      refuse("bodies", name,
             fmt::format("beam '{}' has no torsion as a chain of segments: {}", name, why),
             "a scene in a plane");
      break;
    }
    spatial_ = false;  // that is what has to be said
  }

  void check_lug(const char* group, const std::string& name, const Port& port) {
    if (!inner(port) || port.offset.x.norm() == 0) return;
    refuse(group, name,
           fmt::format("'{}' is attached at an offset from '{}', a node that has no rotation as a "
                       "chain of segments",
                       name, name_of(port)),
           "a point of a node at an end, or the node itself");
  }

  bool acts(int joint) const {
    const auto of = [joint](const auto& x) { return x.joint == joint; };
    return std::any_of(m_.drives.begin(), m_.drives.end(), of) ||
           std::any_of(m_.forces.begin(), m_.forces.end(), of) ||
           std::any_of(m_.gears.begin(), m_.gears.end(),
                       [&](const GearSpec& g) { return of(g.first) || of(g.second); });
  }

  void check_joint(int index) {
    const JointSpec& joint = m_.joints[static_cast<std::size_t>(index)];
    const bool distance = kind_of(joint.type).acts_on_distance();
    for (const Port& port : {joint.a, joint.b}) {
      if (!inner(port)) continue;
      check_lug("joints", joint.name, port);
      const JointType turns_freely = spatial_ ? JointType::Spherical : JointType::Revolute;
      if (distance || (joint.type == turns_freely && !acts(index))) continue;
      refuse(
          "joints", joint.name,
          fmt::format("joint '{}' turns a node of '{}' that has no rotation as a chain of "
                      "segments",
                      joint.name, name_of(port)),
          fmt::format("a {} joint without drive, spring or gear, a rod or a cylinder; or the end "
                      "of a beam",
                      kind_of(turns_freely).name));
    }
  }

  void check_load(const LoadSpec& load) {
    if (!chain_of(m_, load.port.body) || !(load.spread || inner(load.port))) return;
    if (!load.spread) check_lug("loads", load.name, load.port);
    if (load.moment.norm() == 0 && !load.follower) return;
    refuse("loads", load.name,
           fmt::format("load '{}' {} nodes of '{}' that have no rotation as a chain of segments",
                       load.name, load.follower ? "follows" : "turns", name_of(load.port)),
           "a force in inertial axes, or a moment at an end");
  }

  Reader& reader_;
  const Mechanism& m_;
  std::optional<Space<SE2>> plane_;
  bool spatial_ = false;
};

}  // namespace

void check_segments(Reader& reader) {
  const Mechanism& m = reader.scene.mechanism;
  for (const char* group : {"bodies", "joints", "forces", "loads", "simulation", "gears"})
    if (reader.broken.contains(group)) return;
  for (std::size_t b = 0; b < m.bodies.size(); ++b)
    if (chain_of(m, static_cast<int>(b))) return SegmentCheck(reader).check();
}

}  // namespace liesl
