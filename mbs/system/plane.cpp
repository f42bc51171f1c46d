#include "mbs/system/plane.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <vector>

#include "liegroup/smallest_rotation.hpp"
#include "mbs/sections/section_law.hpp"

namespace liesl {
namespace {

constexpr double kTolerance = 1e-9;  // relative to the size of what is compared

using Matrix6 = SE3::Matrix;
using Vector6 = SE3::Tangent;

Matrix6 turned(const Matrix6& K, const Mat3& A) {
  Matrix6 T = Matrix6::Zero();
  T.topLeftCorner<3, 3>() = A;
  T.bottomRightCorner<3, 3>() = A;
  return T * K * T.transpose();
}

constexpr int kInPlane[] = {0, 1, 5}, kOutOfPlane[] = {2, 3, 4};

}  // namespace

SE3 Space<SE2>::alignment(const SE3& H) const {
  const Vec3 n = H.R.transpose() * frame.R.col(2);  // the normal in the body's own axes
  SE3 align = SE3::identity();
  if (std::abs(n.x()) < kTolerance)
    align.R = Eigen::AngleAxisd(std::atan2(n.y(), n.z()), Vec3::UnitX()).toRotationMatrix();
  else
    align.R = smallest_rotation(n, Vec3::UnitZ());
  return align;
}

SE2 Space<SE2>::reduce(const SE3& H, const SE3& align) const {
  const SE3 E = frame.inverse() * H * align.inverse();
  const double angle = std::atan2(E.R(1, 0), E.R(0, 0));
  SE2 h = SE2::identity();
  h.R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  h.x = E.x.head<2>();
  return h;
}

SE3 Space<SE2>::embed(const SE2& h, const SE3& align) const {
  SE3 E = SE3::identity();
  E.R.topLeftCorner<2, 2>() = h.R;
  E.x.head<2>() = h.x;
  return frame * E * align;
}

SE2::Tangent Space<SE2>::reduce_wrench(const Vec3& f, const Vec3& m) const {
  const Vec3 force = frame.R.transpose() * f;
  return {force.x(), force.y(), frame.R.col(2).dot(m)};
}

SE2::Tangent Space<SE2>::reduce_local(const SE3::Tangent& h, const SE3& align) const {
  const Vec3 u = align.R * h.head<3>(), w = align.R * h.tail<3>();
  return {u.x(), u.y(), w.z()};
}

SE3::Tangent Space<SE2>::embed_local(const SE2::Tangent& h, const SE3& align) const {
  SE3::Tangent full;
  full << align.R.transpose() * Vec3(h[0], h[1], 0), align.R.transpose() * Vec3(0, 0, h[2]);
  return full;
}

SE2::Matrix Space<SE2>::reduce_law(const SE3::Matrix& K, const SE3& align) const {
  const Matrix6 k = turned(K, align.R);
  SE2::Matrix r;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) r(i, j) = k(kInPlane[i], kInPlane[j]);
  return r;
}

namespace {

/// Collects points and directions and asks each part of the mechanism for the first that leaves.
class Search {
 public:
  explicit Search(const Mechanism& m) : m_(m) { collect(); }

  PlaneSearch run() {
    Space<SE2> plane;
    for (const auto& body : m_.bodies)
      if (const auto* solid = std::get_if<SolidSpec>(&body.kind); solid && solid->mesh().dim == 3)
        return {std::nullopt, fmt::format("'{}' is meshed in space", body.name)};
    if (!choose_plane(plane)) return {std::nullopt, reason_};
    plane_ = plane;
    for (const auto check : {&Search::bodies, &Search::joints, &Search::loads})
      if (!(this->*check)()) return {std::nullopt, reason_};
    const Vec3 n = plane.frame.R.col(2) + Vec3::Zero();  // -0 + 0 = 0
    return {plane,
            fmt::format("all points, forces and sections are symmetric to the plane with normal "
                        "({:.4g}, {:.4g}, {:.4g})",
                        n.x(), n.y(), n.z())};
  }

 private:
  void collect() {
    for (const auto& body : m_.bodies) {
      if (const auto* beam = std::get_if<BeamSpec>(&body.kind))
        for (const auto& H : beam->nodes) points_.push_back(H.x);
      if (const auto* rigid = std::get_if<RigidSpec>(&body.kind)) {
        points_.push_back(rigid->frame.x);
        points_.push_back(rigid->frame.x + rigid->frame.R * rigid->centre);
      }
      if (const auto* solid = std::get_if<SolidSpec>(&body.kind))
        for (std::size_t k = 0; k < solid->interfaces().size(); ++k)
          points_.push_back(solid->port(static_cast<int>(k)).x);
    }
    for (const auto& j : m_.joints)
      for (const auto* port : {&j.a, &j.b})
        if (port->body >= 0 || kind_of(j.type).acts_on_distance())
          points_.push_back(m_.frame(*port).x);
    for (const auto& f : m_.forces)
      if (f.joint < 0) {
        points_.push_back(m_.frame(f.a).x);
        points_.push_back(m_.frame(f.b).x);
      }
    for (const auto& l : m_.loads)  // beside the plane a force turns the body out of it
      if (l.port.body >= 0 && !l.spread && l.force.norm() > 0)
        points_.push_back(m_.frame(l.port).x);
    for (const auto& p : points_) size_ = std::max(size_, (p - points_[0]).norm());
  }

  /// Normal: spanned out by the points; if they are on a line, by what else fixes it.
  bool choose_plane(Space<SE2>& plane) {
    if (points_.empty()) return fail("there are no bodies");
    Vec3 along = Vec3::Zero(), normal = Vec3::Zero();
    for (const auto& p : points_)
      if ((p - points_[0]).norm() > along.norm()) along = p - points_[0];
    for (const auto& p : points_)
      if (along.cross(p - points_[0]).norm() > normal.norm()) normal = along.cross(p - points_[0]);
    if (normal.norm() > kTolerance * along.norm() * size_)
      normal.normalize();
    else
      normal.setZero();
    for (const auto& body : m_.bodies)
      if (const auto* solid = std::get_if<SolidSpec>(&body.kind);
          solid && solid->mesh().dim == 2 && normal.norm() == 0)
        normal = solid->frame.R.col(2);
    std::vector<Vec3> in_plane{m_.gravity};
    for (const auto& l : m_.loads)
      if (!l.follower) in_plane.push_back(l.force);
    for (const auto& v : in_plane)
      if (normal.norm() == 0 && along.cross(v).norm() > kTolerance * along.norm() * v.norm())
        normal = along.cross(v).normalized();
    for (const auto& j : m_.joints)
      if (normal.norm() == 0 && only_turns(kind_of(j.type))) normal = j.axis;
    for (const auto& l : m_.loads)
      if (normal.norm() == 0 && l.moment.norm() > 0 && !l.follower) normal = l.moment.normalized();
    if (normal.norm() == 0) return fail("nothing singles out a plane");
    for (int i = 0; i < 3; ++i)  // the same plane for +n and -n: prefer the positive one
      if (std::abs(normal[i]) > 0.5) normal *= normal[i] > 0 ? 1 : -1;
    Vec3 first =
        std::abs(normal.z()) > 1 - kTolerance ? Vec3::UnitX() : normal.cross(Vec3::UnitZ());
    first = (first - first.dot(normal) * normal).normalized();
    plane.frame.R << first, normal.cross(first), normal;
    plane.frame.x = std::abs(points_[0].dot(normal)) < kTolerance * size_
                        ? Vec3(Vec3::Zero())
                        : Vec3(points_[0].dot(normal) * normal);
    return true;
  }

  bool bodies() {
    for (const auto& p : points_)
      if (std::abs(normal().dot(p - plane_.frame.x)) > kTolerance * size_)
        return fail(
            fmt::format("point ({:.4g}, {:.4g}, {:.4g}) is outside of the plane of the others",
                        p.x(), p.y(), p.z()));
    for (const auto& body : m_.bodies) {
      if (!along(body.velocity) || !normal_to(body.angular_velocity))
        return fail(fmt::format("the initial velocity of '{}' leaves the plane", body.name));
      if (const auto* beam = std::get_if<BeamSpec>(&body.kind)) {
        for (size_t e = 0; e < beam->sections.size(); ++e)
          for (const SE3* H : {&beam->nodes[e], &beam->nodes[e + 1]}) {
            const SectionLaw law = section_law(beam->sections[e], beam->material);
            if (!along(H->R.col(0)) || couples(law.K, *H) || couples(law.M, *H))
              return fail(fmt::format("a section of '{}' has no principal axis normal to the plane",
                                      body.name));
          }
      } else if (const auto* rigid = std::get_if<RigidSpec>(&body.kind)) {
        const Vec3 n = rigid->frame.R.transpose() * normal();
        if (!n.cross(rigid->inertia * n).isZero(kTolerance * rigid->inertia.norm()))
          return fail(
              fmt::format("'{}' has no principal axis of inertia normal to the plane", body.name));
      } else if (const auto* solid = std::get_if<SolidSpec>(&body.kind)) {
        if (!normal_to(solid->frame.R.col(2)))
          return fail(fmt::format("the mesh of '{}' leaves the plane of the others", body.name));
      }
    }
    return along(m_.gravity) || fail("gravity leaves the plane");
  }

  bool joints() {
    for (const auto& j : m_.joints) {
      const bool turns = normal_to(j.axis), slides = along(j.axis);
      const JointKind& kind = kind_of(j.type);
      if (kind.pitch)
        return fail(
            fmt::format("{} joint '{}' moves along the axis it turns about", kind.name, j.name));
      if (!turns && !slides && kind.axes > 0)
        return fail(
            fmt::format("the axis of joint '{}' is neither in the plane nor normal to it", j.name));
      if (kind.axes == 2 && !along(j.axis2) && (turns || !normal_to(j.axis2)))
        return fail(fmt::format("the second axis of joint '{}' leaves the plane", j.name));
    }
    for (const auto& g : m_.gears)
      for (const auto* q : {&g.first, &g.second})
        if (!planar_coordinate(q->joint, q->coordinate))
          return fail(fmt::format("gear '{}' turns out of the plane", g.name));
    for (const auto& d : m_.drives)
      if (!planar_coordinate(d.joint, d.coordinate))
        return fail(fmt::format("joint '{}' is driven out of the plane", m_.joints[d.joint].name));
    return std::all_of(m_.forces.begin(), m_.forces.end(),
                       [this](const ForceSpec& f) { return f.joint < 0 || force_on_joint(f); });
  }

  bool force_on_joint(const ForceSpec& f) {
    const bool planar = planar_coordinate(f.joint, f.coordinate);
    for (const CoordinateShare& share : f.shares)
      if (planar_coordinate(f.joint, share.coordinate) != planar)
        return fail(
            fmt::format("force '{}' couples a coordinate in the plane with one out of it", f.name));
    return planar || idle_in_plane(f) ||
           fail(fmt::format("force '{}' acts out of the plane", f.name));
  }

  bool loads() {
    for (const auto& l : m_.loads) {
      const Mat3 R = l.follower ? m_.frame(l.port).R : Mat3::Identity();
      if (!along(R * l.force) || !normal_to(R * l.moment))
        return fail(fmt::format("load '{}' leaves the plane", l.name));
    }
    return true;
  }

  /// Is this joint coordinate a motion in the plane, whatever the axes that the scene leaves open?
  bool planar_coordinate(int joint, int coordinate) const {
    const JointSpec& j = m_.joints[joint];
    const JointKind& kind = kind_of(j.type);
    if (coordinate >= kind.coordinate_count()) return false;
    const JointRow& row = kind.coordinates[static_cast<std::size_t>(coordinate)];
    if (row.kind == JointRow::Kind::Distance) return true;
    if (row.kind == JointRow::Kind::Displacement)
      return kind.axes == 2 || row.m == 0 ? !normal_to(axis_of(j, row.m)) : normal_to(j.axis);
    return normal_to(axis_of(j, row.about()));
  }
  /// Axis number `i` of a joint; the third where the second one is given.
  static Vec3 axis_of(const JointSpec& j, int i) {
    return i == 0 ? j.axis : i == 1 ? j.axis2 : Vec3(j.axis.cross(j.axis2));
  }
  /// Is this the spring of a bushing out of the plane, relaxed there?
  bool idle_in_plane(const ForceSpec& f) const {
    const JointKind& kind = kind_of(m_.joints[static_cast<std::size_t>(f.joint)].type);
    return kind.constraints.empty() && f.rest == 0 && f.force.is_constant() && f.force(0) == 0 &&
           (!f.curve || (*f.curve)(0) == 0);
  }
  /// Does the joint leave one rotation and nothing else?
  static bool only_turns(const JointKind& kind) {
    return !kind.pitch && kind.coordinates.size() == 1 &&
           kind.coordinates[0].kind == JointRow::Kind::Angle;
  }

  bool along(const Vec3& v) const { return std::abs(normal().dot(v)) <= kTolerance * v.norm(); }
  bool normal_to(const Vec3& v) const { return normal().cross(v).norm() <= kTolerance * v.norm(); }
  bool couples(const Matrix6& K, const SE3& H) const {
    const Matrix6 k = turned(K, plane_.alignment(H).R);
    for (int i : kInPlane)
      for (int j : kOutOfPlane)
        if (std::abs(k(i, j)) + std::abs(k(j, i)) >
            kTolerance * std::sqrt(std::abs(k(i, i) * k(j, j))))
          return true;
    return false;
  }
  Vec3 normal() const { return plane_.frame.R.col(2); }
  bool fail(std::string why) {
    reason_ = std::move(why);
    return false;
  }

  const Mechanism& m_;
  std::vector<Vec3> points_;
  double size_ = 0;
  Space<SE2> plane_;
  std::string reason_;
};

}  // namespace

PlaneSearch find_plane(const Mechanism& mechanism) { return Search(mechanism).run(); }

}  // namespace liesl
