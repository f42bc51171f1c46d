#pragma once
/// @file
/// C2 cubic curve through points in space, with its arc length.

#include <Eigen/Core>
#include <vector>

namespace liesl {

/// Piecewise cubic r(tau), tau = length of the polygon up to a point; second derivative continuous,
/// third too at the second and the last but one point (not-a-knot).
class CubicSpline {
 public:
  /// @throws std::invalid_argument for less than two points or neighbours that coincide
  explicit CubicSpline(std::vector<Eigen::Vector3d> points);

  double length() const { return arc_length_.back(); }
  /// Parameter tau at arc length s in [0, length()].
  double parameter(double s) const;
  Eigen::Vector3d position(double tau) const;
  /// dr/dtau
  Eigen::Vector3d derivative(double tau) const;

 private:
  std::size_t segment(double tau) const;
  double length_between(double tau0, double tau1) const;
  void solve_curvatures();
  void tabulate_length();

  std::vector<Eigen::Vector3d> points_;
  std::vector<double> knots_;
  Eigen::MatrixX3d second_;                // r'' at the points
  std::vector<double> fine_, arc_length_;  // tau and s at the ends of the parts of each segment
};

}  // namespace liesl
