#pragma once
/// @file
/// A frame in the plane or in space that parameters move.

#include <algorithm>
#include <vector>

#include "liegroup/so3.hpp"
#include "mbs/levelset/level_set.hpp"

namespace liesl::levelset {

/// x = c + R X with R = exp(w~), w the rotation vector; delta R = R (T delta w)~.
struct Placement {
  int count = 3;                   ///< of its parameters: 3 in the plane, 6 in space
  Eigen::Vector3d c;               ///< position, m
  Eigen::Matrix3d R = {}, T = {};  ///< rotation and its tangent operator

  /// x, y, angle.
  static std::vector<Parameter> in_plane(double x, double y, double angle) {
    return {{"x", x}, {"y", y}, {"angle", angle, "rad"}};
  }
  /// x, y, z, rx, ry, rz.
  static std::vector<Parameter> in_space(const Pose& pose) {
    const Eigen::Vector3d &p = pose.position, &w = pose.rotation;
    return {{"x", p[0]},         {"y", p[1]},         {"z", p[2]},
            {"rx", w[0], "rad"}, {"ry", w[1], "rad"}, {"rz", w[2], "rad"}};
  }

  void set(const double* p) {
    const Eigen::Vector3d w = count == 3 ? Eigen::Vector3d(0, 0, p[2]) : Eigen::Vector3d(p + 3);
    c = {p[0], p[1], count == 3 ? 0 : p[2]};
    R = SO3::exp(w).R;
    T = SO3::T(w);
  }
  Eigen::Vector3d to_local(const Eigen::Vector3d& x) const { return R.transpose() * (x - c); }

  /// dp = [d phi/dc; T^T d phi/d(T w)], what the plane has of it.
  void put(const Eigen::Vector3d& dc, const Eigen::Vector3d& turn, double* dp) const {
    const Eigen::Vector3d dw = T.transpose() * turn;
    const int moves = count == 3 ? 2 : 3;
    std::copy_n(dc.data(), moves, dp);
    if (count == 3)
      dp[2] = dw[2];
    else
      std::copy_n(dw.data(), 3, dp + 3);
  }
};

}  // namespace liesl::levelset
