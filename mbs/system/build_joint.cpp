#include "mbs/system/build_joint.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <stdexcept>

#include "mbs/system/build_force.hpp"

namespace liesl {
namespace {

constexpr double kGapTolerance = 1e-3;  // of the size of the mechanism

/// Three unit axes, the first one given, the second one as given or any; in a plane each of them
/// is in it or normal to it.
template <class G>
Mat3 axes_of(const JointSpec& j, const Space<G>& space) {
  const int given = kind_of(j.type).axes;
  Mat3 e;
  e.col(0) = j.axis;
  if constexpr (G::space_dim == 2) {
    const Vec3 n = space.frame.R.col(2);
    if (given == 0) e.col(0) = n;
    e.col(1) = std::abs(n.dot(e.col(0))) > 0.5 ? Vec3(space.frame.R.col(0)) : n;
  } else {
    e.col(1) = j.axis.unitOrthogonal();
  }
  if (given == 2) e.col(1) = j.axis2;
  e.col(2) = e.col(0).cross(e.col(1));
  return e;
}

/// The row on G; empty if one of its axes is normal to the plane.
template <class G>
std::optional<Row<G>> row_on(const JointRow& row, const Mat3& axes, const JointSpec& joint,
                             double distance, const Space<G>& space) {
  const auto e = [&](int i) { return space.reduce_vector(axes.col(i)); };
  const auto seen = [&](std::initializer_list<int> list) {
    return std::all_of(list.begin(), list.end(), [&](int i) { return e(i).norm() > 0.5; });
  };
  switch (row.kind) {
    case JointRow::Kind::Displacement:
      if (seen({row.m})) return Row<G>::displacement(e(row.m));
      break;
    case JointRow::Kind::Perpendicular:
      if (seen({row.m, row.n})) return Row<G>::perpendicular(e(row.m), e(row.n));
      break;
    case JointRow::Kind::Angle:
      if (seen({row.m, row.n, row.k})) return Row<G>::angle(e(row.m), e(row.n), e(row.k), e(row.k));
      break;
    case JointRow::Kind::Screw:
      if (seen({0, 1, 2}))
        return Row<G>::screw(e(row.k), joint.pitch / (2 * M_PI), e((row.k + 2) % 3),
                             e((row.k + 1) % 3));
      break;
    case JointRow::Kind::Distance:
      return Row<G>::distance(distance);
  }
  return {};
}

template <class G>
void check_pitch(const JointSpec& joint) {
  const auto refuse = [&joint](const char* why) {
    throw std::invalid_argument(fmt::format("joint '{}': {}", joint.name, why));
  };
  if (!kind_of(joint.type).pitch) return;
  if (joint.pitch == 0 || !std::isfinite(joint.pitch))
    refuse("expected a pitch other than 0; without displacement it is a revolute joint");
  if (G::space_dim == 2) refuse("a screw moves out of the plane it turns in; build it in space");
}

template <FrameGroup G>
CouplingRow<G>* find_coordinate(Coupling<G>& c, int coordinate) {
  for (auto& e : c.rows)
    if (e.coordinate == coordinate) return &e;
  return nullptr;
}

/// Places the ports: a gap that is a motion of the joint is no displacement, coordinates are zero
/// in the scene as given. The ground is where the other port is, unless its offset is a point there
/// (to kGapTolerance of the mechanism's size, which the assembly closes).
template <FrameGroup G>
void place(const Mechanism& mechanism, const JointSpec& j, const Ports<G>& ports, Coupling<G>& c) {
  Vec3 at_a = mechanism.frame(j.a).x, at_b = mechanism.frame(j.b).x;
  const JointKind& kind = kind_of(j.type);
  const Vec3 gap = at_b - at_a, free = kind.free_part(j.axis, gap);
  const bool closed = (gap - free).norm() <= kGapTolerance * mechanism.size();
  const auto anywhere = [&](const Port& p) {
    return p.body < 0 && (!closed || p.offset.x.isZero(0));
  };
  if (kind.acts_on_distance())
    ;  // from port to port
  else if (anywhere(j.a))
    at_a = at_b;
  else if (anywhere(j.b))
    at_b = at_a;
  else
    at_a += free;
  c.a = ports.at(j.a, at_a);
  c.b = ports.at(j.b, at_b);
}

/// The row of a force on a joint: its coordinate, or the sum with its shares.
template <FrameGroup G>
Row<G> row_of(Coupling<G>& c, const CouplingRow<G>& coordinate, const ForceSpec& force) {
  if (force.shares.empty()) return coordinate.row;
  std::vector<Row<G>> parts{coordinate.row};
  for (const CoordinateShare& share : force.shares)
    if (const CouplingRow<G>* other = find_coordinate(c, share.coordinate))
      parts.push_back(other->row.scaled(share.weight));
  return Row<G>::sum(std::move(parts));
}

}  // namespace

template <FrameGroup G>
std::vector<CouplingRow<G>> joint_rows(const JointSpec& joint, double distance,
                                       const Space<G>& space) {
  check_pitch<G>(joint);
  const JointKind& kind = kind_of(joint.type);
  const Mat3 axes = axes_of(joint, space);
  std::vector<CouplingRow<G>> out;
  for (const JointRow& row : kind.constraints)
    if (const auto r = row_on(row, axes, joint, distance, space))
      out.push_back({*r, Role::Constraint, TimeFunction(), {}, -1});
  for (int i = 0; i < kind.coordinate_count(); ++i)
    if (const auto r =
            row_on(kind.coordinates[static_cast<std::size_t>(i)], axes, joint, distance, space))
      out.push_back({*r, Role::Observed, TimeFunction(), {}, i});
  return out;
}

template <FrameGroup G>
Coupling<G> build_joint(const Mechanism& mechanism, int index, const Space<G>& space,
                        const Ports<G>& ports) {
  const JointSpec& j = mechanism.joints[static_cast<std::size_t>(index)];
  Coupling<G> c;
  c.name = j.name;
  place(mechanism, j, ports, c);
  c.rows = joint_rows(j, (mechanism.frame(j.b).x - mechanism.frame(j.a).x).norm(), space);
  for (size_t d = 0; d < mechanism.drives.size(); ++d)
    if (const DriveSpec& drive = mechanism.drives[d]; drive.joint == index)
      if (CouplingRow<G>* e = find_coordinate(c, drive.coordinate)) {
        e->role = Role::Constraint;
        e->target = drive.motion;
        e->drive = static_cast<int>(d);
      }
  for (size_t i = 0; i < mechanism.forces.size(); ++i)
    if (const ForceSpec& f = mechanism.forces[i]; f.joint == index)
      if (const CouplingRow<G>* e = find_coordinate(c, f.coordinate)) {
        CouplingRow<G> force = *e;
        force.row = row_of(c, *e, f);
        set_force(force, f, static_cast<int>(i));
        force.drive = -1;
        force.coordinate = -1;
        c.rows.push_back(force);
      }
  return c;
}

template Coupling<SE2> build_joint(const Mechanism&, int, const Space<SE2>&, const Ports<SE2>&);
template Coupling<SE3> build_joint(const Mechanism&, int, const Space<SE3>&, const Ports<SE3>&);
template std::vector<CouplingRow<SE2>> joint_rows(const JointSpec&, double, const Space<SE2>&);
template std::vector<CouplingRow<SE3>> joint_rows(const JointSpec&, double, const Space<SE3>&);

}  // namespace liesl
