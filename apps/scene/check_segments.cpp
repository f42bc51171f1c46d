/// @file
/// What beams that are chains of segments cannot do: they have no shear and no torsion, and the
/// nodes between their ends are points.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "apps/scene/reader.hpp"
#include "mbs/sections/section_law.hpp"
#include "mbs/system/plane.hpp"

namespace liesl {

namespace {

bool is_chain(const Mechanism& m, const BodySpec& body) {
  const auto* beam = std::get_if<BeamSpec>(&body.kind);
  return beam && model_of(*beam, m.formalism) == BeamModel::Segments;
}

/// First frequency of a hinged beam (S. P. Timoshenko, Philos. Mag. 41 (1921) 744-746): what shear
/// and rotary inertia, which a chain of segments has not, take of it, pi^2/2 (EI/GA + rho I/rho
/// A)/L^2, at the worst of its sections.
double left_out_of(const BeamSpec& beam, const Space<SE2>& plane) {
  double length = 0, worst = 0;
  for (std::size_t e = 0; e < beam.sections.size(); ++e) {
    const SE3& at = beam.nodes[e];
    length += (beam.nodes[e + 1].x - at.x).norm();
    const SectionLaw law = section_law(beam.sections[e], beam.material);
    const SE3 align = plane.alignment(at);
    const SE2::Matrix K = plane.reduce_law(law.K, align), M = plane.reduce_law(law.M, align);
    worst = std::max(worst, K(2, 2) / K(1, 1) + M(2, 2) / M(1, 1));
  }
  return 0.5 * M_PI * M_PI * worst / (length * length);
}

class SegmentCheck {
 public:
  explicit SegmentCheck(Reader& reader) : reader_(reader), m_(reader.scene.mechanism) {}

  void check() {
    check_space();
    for (std::size_t j = 0; j < m_.joints.size(); ++j) check_joint(static_cast<int>(j));
    for (const ForceSpec& force : m_.forces)
      if (force.joint < 0)
        for (const Port& port : {force.a, force.b}) check_lug("forces", force.name, port);
    for (const LoadSpec& load : m_.loads) check_load(load);
    if (plane_)
      for (const BodySpec& body : m_.bodies)
        if (is_chain(m_, body)) tell_what_is_left_out(body);
  }

 private:
  void tell_what_is_left_out(const BodySpec& body) {
    constexpr double kMuch = 0.01;
    const double share = left_out_of(std::get<BeamSpec>(body.kind), *plane_);
    if (share > kMuch)
      reader_.scene.warnings.push_back(fmt::format(
          "beam '{}' is too stout for a chain of segments, which has no shear and no rotary "
          "inertia: they would change its first frequency by about {:.2g} %",
          body.name, 100 * share));
  }

  /// Is this a node between the ends of a chain?
  bool inner(const Port& port) const {
    if (port.body < 0) return false;
    const BodySpec& body = m_.bodies[static_cast<std::size_t>(port.body)];
    if (!is_chain(m_, body)) return false;
    const auto& nodes = std::get<BeamSpec>(body.kind).nodes;
    return port.node > 0 && port.node + 1 < static_cast<int>(nodes.size());
  }
  const std::string& name_of(const Port& port) const {
    return m_.bodies[static_cast<std::size_t>(port.body)].name;
  }
  void refuse(const char* group, const std::string& name, const std::string& what,
              const std::string& expected) {
    const auto at = reader_.root[group][name];
    reader_.problems.add(at.node() ? *at.node() : static_cast<const toml::node&>(reader_.root),
                         what, expected, "formalism se3 has it");
  }

  void check_space() {
    const auto chain = std::find_if(m_.bodies.begin(), m_.bodies.end(),
                                    [this](const BodySpec& body) { return is_chain(m_, body); });
    const SimulationOptions& o = reader_.scene.simulation;
    const PlaneSearch found = find_plane(m_);
    plane_ = found.plane;
    std::string why;
    if (!found.plane)
      why = found.reason;
    else if (o.space == SpaceChoice::Spatial)
      why = "simulation.space = \"spatial\"";
    else if (o.type == SimulationType::Modes && o.space == SpaceChoice::Auto)
      why = "modes may leave the plane";
    else if (o.type == SimulationType::Static && o.critical && o.space == SpaceChoice::Auto)
      why = "critical loads may leave the plane";
    if (!why.empty())
      refuse("bodies", chain->name,
             fmt::format("beam '{}' has no torsion as a chain of segments: {}", chain->name, why),
             "a scene in a plane");
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
      if (distance || (joint.type == JointType::Revolute && !acts(index))) continue;
      refuse("joints", joint.name,
             fmt::format("joint '{}' turns a node of '{}' that has no rotation as a chain of "
                         "segments",
                         joint.name, name_of(port)),
             "a revolute joint without drive, spring or gear, a rod or a cylinder; or the end of a "
             "beam");
    }
  }

  void check_load(const LoadSpec& load) {
    const bool chain =
        load.port.body >= 0 && is_chain(m_, m_.bodies[static_cast<std::size_t>(load.port.body)]);
    if (!chain || !(load.spread || inner(load.port))) return;
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
};

}  // namespace

void check_segments(Reader& reader) {
  const Mechanism& m = reader.scene.mechanism;
  for (const char* group : {"bodies", "joints", "forces", "loads", "simulation", "gears"})
    if (reader.broken.contains(group)) return;
  if (std::any_of(m.bodies.begin(), m.bodies.end(),
                  [&m](const BodySpec& body) { return is_chain(m, body); }))
    SegmentCheck(reader).check();
}

}  // namespace liesl
