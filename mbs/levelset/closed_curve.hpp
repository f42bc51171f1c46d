#pragma once
/// @file
/// Signed distance to a closed planar outline whose control points are variables (thesis eq. 3.6).

#include <Eigen/Core>
#include <vector>

#include "mbs/levelset/level_set.hpp"

namespace liesl::levelset {

enum class CurveKind {
  Polyline,  ///< straight between the points
  Spline,    ///< the periodic C2 cubic through the points, uniform knots
  Nurbs      ///< periodic rational cubic B-spline, uniform knots; the points control it, and each
             ///< has a weight > 0 that is a variable, too
};

/// Parameters "p0.x", "p0.y", ..., then "w0", ... for NURBS. phi is the distance to the nearest
/// point of the curve, positive inside, whichever way round the points go:
///   phi = n . (x - gamma(t)),  d phi/dx = n,  d phi/dp = -n . d gamma/dp
/// with n the inward normal at the nearest point; t does not enter (envelope theorem).
/// @param points at least 3 (Polyline) or 4
/// @throws std::invalid_argument for too few points, or weights that do not fit
LevelSetPtr closed_curve(CurveKind kind, const std::vector<Eigen::Vector2d>& points,
                         std::vector<double> weights = {});

}  // namespace liesl::levelset
