#pragma once
/// @file
/// Which scenes live in a plane, and the map between the plane and space.

#include <Eigen/Core>
#include <optional>
#include <string>

#include "liegroup/se2.hpp"
#include "liegroup/se3.hpp"
#include "mbs/model/mechanism.hpp"

namespace liesl {

/// The map between a group of frames and space. A body's own axes may be turned about the
/// in-plane axis of the node (`align`) so that their third axis is the normal of the plane.
template <class G>
struct Space;

/// Space itself: all maps are identities.
template <>
struct Space<SE3> {
  using Vector = Eigen::Vector3d;
  SE3 reduce(const SE3& H, const SE3& /*align*/) const { return H; }
  SE3 embed(const SE3& H, const SE3& /*align*/) const { return H; }
  Vector reduce_vector(const Vec3& v) const { return v; }
  SE3::Tangent reduce_wrench(const Vec3& f, const Vec3& m) const {
    return (SE3::Tangent() << f, m).finished();
  }
  SE3::Tangent reduce_local(const SE3::Tangent& h, const SE3&) const { return h; }
  SE3::Tangent embed_local(const SE3::Tangent& h, const SE3&) const { return h; }
  SE3::Matrix reduce_law(const SE3::Matrix& K, const SE3&) const { return K; }
  /// Turn of a frame's own axes that puts their third axis on the normal of the plane.
  SE3 alignment(const SE3&) const { return SE3::identity(); }
};

/// The plane through `frame.x` spanned by the first two axes of `frame`.
template <>
struct Space<SE2> {
  using Vector = Eigen::Vector2d;
  SE3 frame = SE3::identity();

  /// H = frame * embed(reduced) * align.
  SE2 reduce(const SE3& H, const SE3& align) const;
  SE3 embed(const SE2& H, const SE3& align) const;
  Vector reduce_vector(const Vec3& v) const { return (frame.R.transpose() * v).head<2>(); }
  SE2::Tangent reduce_wrench(const Vec3& f, const Vec3& m) const;
  /// Local velocities, forces: [u; w] in the body's own axes <-> [u_x, u_y, w].
  SE2::Tangent reduce_local(const SE3::Tangent& h, const SE3& align) const;
  SE3::Tangent embed_local(const SE2::Tangent& h, const SE3& align) const;
  SE2::Matrix reduce_law(const SE3::Matrix& K, const SE3& align) const;
  SE3 alignment(const SE3& H) const;
};

/// Result of the search: a plane, or the first thing that leaves it.
struct PlaneSearch {
  std::optional<Space<SE2>> plane;
  std::string reason;  ///< "every joint axis is along z, ..." or "gravity leaves the plane ..."
};

/// The plane in which the mechanism moves by mirror symmetry: all nodes, ports and centres of
/// mass in it, gravity and forces along it, moments, rotation axes normal to it, sections and
/// inertias with a principal axis normal to it.
PlaneSearch find_plane(const Mechanism& mechanism);

}  // namespace liesl
