#include "mbs/model/body_alone.hpp"

#include <algorithm>
#include <stdexcept>
#include <type_traits>

namespace liesl {
namespace {

/// Moves a part of a parameter to its numbers in the body alone; false: it is of something else.
struct Renumber {
  const BodyAlone& alone;

  template <class Part>
  bool operator()(Part& part) const {
    if constexpr (requires { part.body; }) {
      const bool own = part.body == alone.body;
      part.body = 0;
      return own;
    } else if constexpr (std::is_same_v<Part, ForceDerivative>) {
      const auto at = std::find(alone.forces.begin(), alone.forces.end(), part.force);
      part.force = static_cast<int>(at - alone.forces.begin());
      return at != alone.forces.end();
    } else {
      return false;
    }
  }
};

}  // namespace

BodyAlone body_alone(const Mechanism& whole, int body) {
  if (body < 0 || body >= static_cast<int>(whole.bodies.size()))
    throw std::invalid_argument("body alone: there is no such body");
  BodyAlone out{whole, body, {}};
  Mechanism& m = out.mechanism;
  m.bodies = {whole.bodies[static_cast<std::size_t>(body)]};
  m.bodies[0].velocity = m.bodies[0].angular_velocity = Vec3::Zero();
  m.gravity = Vec3::Zero();
  m.loads.clear();
  m.gears.clear();
  m.joints.clear();
  m.drives.clear();
  m.forces.clear();
  const auto alone = [&](const Port& port) {
    return port.body == body ? Port{0, port.node, port.offset} : Port{-1, 0, whole.frame(port)};
  };
  std::vector<int> joint_of(whole.joints.size(), -1);
  for (std::size_t j = 0; j < whole.joints.size(); ++j) {
    JointSpec joint = whole.joints[j];
    if (joint.a.body != body && joint.b.body != body) continue;
    joint.a = alone(joint.a);
    joint.b = alone(joint.b);
    joint_of[j] = static_cast<int>(m.joints.size());
    m.joints.push_back(std::move(joint));
  }
  for (DriveSpec drive : whole.drives) {
    drive.joint = joint_of[static_cast<std::size_t>(drive.joint)];
    drive.motion = TimeFunction::constant(0);
    if (drive.joint >= 0) m.drives.push_back(std::move(drive));
  }
  for (std::size_t f = 0; f < whole.forces.size(); ++f) {
    ForceSpec force = whole.forces[f];
    const bool own = force.joint >= 0 ? joint_of[static_cast<std::size_t>(force.joint)] >= 0
                                      : force.a.body == body || force.b.body == body;
    if (!own) continue;
    if (force.joint >= 0) {
      force.joint = joint_of[static_cast<std::size_t>(force.joint)];
    } else {
      force.a = alone(force.a);
      force.b = alone(force.b);
    }
    out.forces.push_back(static_cast<int>(f));
    m.forces.push_back(std::move(force));
  }
  return out;
}

Parameter parameter_alone(const Parameter& whole, const BodyAlone& alone) {
  Parameter out{whole.name, {}};
  for (auto part : whole.parts)
    if (std::visit(Renumber{alone}, part)) out.parts.push_back(std::move(part));
  return out;
}

}  // namespace liesl
