#pragma once
/// @file
/// The rotation from one direction to another that turns least.

#include "liegroup/so3.hpp"

namespace liesl {

/// The smallest rotation from a to b, unit vectors: z + c~ + c c^T/(1 + z), c = a x b, z = a . b,
/// 1 + z = |a + b|^2/2. Of opposite ones half a turn, 2 u u^T - 1 about a u normal to a.
inline Eigen::Matrix3d smallest_rotation(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  constexpr double kOpposite = 1e-16;  // 1 + z: 1e-8 rad off
  const Eigen::Vector3d c = a.cross(b);
  const double more = 0.5 * (a + b).squaredNorm();
  if (more > kOpposite)
    return (more - 1) * Eigen::Matrix3d::Identity() + hat(c) + c * c.transpose() / more;
  int least = 0;
  a.cwiseAbs().minCoeff(&least);
  const Eigen::Vector3d u = a.cross(Eigen::Vector3d::Unit(least)).normalized();
  return 2 * u * u.transpose() - Eigen::Matrix3d::Identity();
}

}  // namespace liesl
