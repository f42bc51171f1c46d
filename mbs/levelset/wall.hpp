#pragma once
/// @file
/// How much material is left between two features.

#include <Eigen/Core>

#include "mbs/levelset/level_set.hpp"

namespace liesl::levelset {

struct Wall {
  double thickness = 0;        ///< m; negative where the two voids overlap
  Eigen::VectorXd derivative;  ///< d thickness/dp, p of the whole tree
  Eigen::Vector3d middle;      ///< where it is thinnest, m
};

/// Thickness of the wall between the void of a (inside a hole, outside an outer contour) and that
/// of b. With the signed distances d_a, d_b of a point to the two outlines, positive in the void,
///   thickness = -2 max_x min(d_a(x), d_b(x)),
/// the shortest distance between the outlines, and smooth through zero where the voids begin to
/// overlap. At the maximum grad d_a = -grad d_b, d_a = d_b, and so (envelope theorem)
///   d thickness/dp = -(d d_a/dp + d d_b/dp),   d d/dp = d nu/dp / |grad nu| at the nearest point,
/// with nu = -sign phi. The maximum is found among `samples` (3 x n, m), then by Newton's method;
/// where that fails (the maximum sits at a kink), phi at the best sample stands for the distance.
/// @param size of p
Wall wall_between(const Part& a, const Part& b, const Eigen::Matrix3Xd& samples, int size);

/// The two halves of it, for many walls of few features: -sign phi of a part at the samples,
/// positive in its void, and what Newton's method makes of the best of them.
Eigen::VectorXd void_at(const Part& part, const Eigen::Matrix3Xd& samples);
Wall wall_between(const Part& a, const Part& b, const Eigen::VectorXd& void_a,
                  const Eigen::VectorXd& void_b, const Eigen::Matrix3Xd& samples, int size);

}  // namespace liesl::levelset
