#pragma once
/// @file
/// A machine with a joint of any kind, for tests that take every row of the table of joints.

#include "mbs/static_cases.hpp"
#include "reference/mechanisms.hpp"

namespace liesl::test {

/// A driven beam with a block at its end, by a joint of the kind, with a spring of a table and a
/// damper on each of its coordinates.
inline Mechanism jointed(const JointKind& kind, const Vec3& axis, const Vec3& axis2) {
  Mechanism m;
  m.gravity = {1, -9, 0.5};
  const Section s = section((SE3::Tangent() << 90, 40, 50, 7, 8, 9).finished());
  m.bodies = {{"beam", beam(straight({0, 0, 0}, {2, 0, 0}, 2), s)},
              {"block", block({2.5, 0.8, 0}, 2, 0.7)}};
  const auto off = [](double x, double y) { return SE3(Mat3::Identity(), Vec3(x, y, 0)); };
  JointSpec root, joint;
  root.name = "root";
  root.type = JointType::Revolute;
  root.b = {0, 0};
  joint.name = kind.name;
  joint.type = kind.type;
  joint.axis = axis;
  joint.axis2 = axis2;
  joint.pitch = kind.pitch ? 0.7 : 0;
  joint.a = {0, 2, off(0, 0.3)};
  joint.b = {1, 0, kind.acts_on_distance() ? off(0.2, 0.1) : off(-0.5, -0.5)};
  m.joints = {root, joint};
  for (int i = 0; i < kind.coordinate_count(); ++i) {
    ForceSpec f;
    f.name = joint.name + std::to_string(i);
    f.joint = 1;
    f.coordinate = i;
    f.damping = 0.7;
    f.curve.emplace(std::vector<double>{-3, -1, 1, 3}, std::vector<double>{-90, -20, 20, 90},
                    TimeFunction::Interpolation::Cubic);
    m.forces.push_back(f);
  }
  DriveSpec drive;
  drive.motion = TimeFunction::rate(2, 0.1);
  m.drives.push_back(drive);
  return m;
}

}  // namespace liesl::test
