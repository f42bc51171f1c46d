#pragma once
/// @file
/// Scalar functions of the relative motion of two ports. Every joint constraint, drive, spring,
/// damper and actuator is made of them, for every group of frames.
///
/// With port frames (R_a, x_a), (R_b, x_b): R = R_a^T R_b, p = R_a^T (x_b - x_a). Gradients are
/// with respect to left-invariant increments of the two ports, [u_a; w_a; u_b; w_b].

#include <Eigen/Core>
#include <vector>

#include "liegroup/se2.hpp"
#include "liegroup/se3.hpp"

namespace liesl {

/// R and p of two frames.
template <FrameGroup G>
struct RelativeMotion {
  using Rotation = Eigen::Matrix<double, G::space_dim, G::space_dim>;
  using Vector = Eigen::Matrix<double, G::space_dim, 1>;
  Rotation R;
  Vector p;
  RelativeMotion(const G& a, const G& b)
      : R(a.R.transpose() * b.R), p(a.R.transpose() * (b.x - a.x)) {}
};

enum class RowKind {
  Displacement,   ///< m . p: of b along m of a (Haug 1989: dot-2 constraint)
  Perpendicular,  ///< m . R n (dot-1): cosine between m of a and n of b (zero: they are normal)
  Angle,          ///< atan2(m . R n, m2 . R n2), continued beyond pi
  Distance,       ///< |p| - its value at rest
  Screw,          ///< m . p - lead Angle: displacement along m less `lead` for each radian
  Sum             ///< of other rows
};

template <FrameGroup G>
class Row {
 public:
  static constexpr int sd = G::space_dim, rd = G::rotation_dim, dim = G::dim;
  using Vector = Eigen::Matrix<double, sd, 1>;
  using Motion = RelativeMotion<G>;
  using Gradient = Eigen::Matrix<double, 2 * dim, 1>;
  using Hessian = Eigen::Matrix<double, 2 * dim, 2 * dim>;

  static Row displacement(const Vector& m) { return {RowKind::Displacement, m, m, m, m}; }
  static Row perpendicular(const Vector& m, const Vector& n) {
    return {RowKind::Perpendicular, m, n, m, n};
  }
  /// Angle whose sine is m . R n and whose cosine is m2 . R n2.
  static Row angle(const Vector& m, const Vector& n, const Vector& m2, const Vector& n2) {
    return {RowKind::Angle, m, n, m2, n2};
  }
  /// m . p - lead (angle whose sine is s . R n and whose cosine is n . R n).
  /// @param lead m a radian, not zero
  static Row screw(const Vector& m, double lead, const Vector& s, const Vector& n) {
    Row row(RowKind::Screw, s, n, n, n);
    row.screw_axis_ = m;
    row.lead_ = lead;
    return row;
  }
  /// |p| - rest.
  static Row distance(double rest = 0) {
    const Vector zero = Vector::Zero();
    Row row(RowKind::Distance, zero, zero, zero, zero);
    row.rest_ = rest;
    return row;
  }
  /// The sum of rows, `scaled` as they are; angles among them are not continued beyond pi.
  static Row sum(std::vector<Row> parts) {
    const Vector zero = Vector::Zero();
    Row row(RowKind::Sum, zero, zero, zero, zero);
    row.parts_ = std::move(parts);
    return row;
  }
  /// This row times a constant factor, not zero.
  Row scaled(double factor) const {
    Row row = *this;
    row.factor_ *= factor;
    return row;
  }

  RowKind kind() const { return kind_; }

  /// @param previous the value it had last: an angle is continued from there, over any number of
  /// turns.
  ///   A screw takes the turn at which its value is closest to `previous`.
  double value(const Motion& r, double previous) const;
  void gradient(const Motion& r, Gradient& g) const;
  /// Left-invariant derivative of the gradient: the geometric stiffness of a unit force.
  Hessian hessian(const Motion& r) const;

 private:
  using Angular = Eigen::Matrix<double, rd, 1>;
  using Cross = Eigen::Matrix<double, sd, rd>;

  Row(RowKind kind, const Vector& m, const Vector& n, const Vector& m2, const Vector& n2)
      : kind_(kind), m_(m), n_(n), m2_(m2), n2_(n2) {}

  /// X(v) w = w x v; X(v)^T a = v x a.
  static Cross X(const Vector& v);
  double unscaled_value(const Motion& r, double previous) const;
  Gradient unscaled_gradient(const Motion& r) const;
  Hessian unscaled_hessian(const Motion& r) const;
  static Gradient displacement_gradient(const Motion& r, const Vector& m);
  static Hessian displacement_hessian(const Motion& r, const Vector& m);
  static Gradient cosine_gradient(const Motion& r, const Vector& m, const Vector& n);
  static Hessian cosine_hessian(const Motion& r, const Vector& m, const Vector& n);
  double angle(const Motion& r) const;
  Gradient angle_gradient(const Motion& r) const;
  Hessian angle_hessian(const Motion& r) const;
  static Gradient distance_gradient(const Motion& r);
  Hessian distance_hessian(const Motion& r) const;

  RowKind kind_;
  Vector m_, n_, m2_, n2_;              ///< of Displacement, Perpendicular and the angle
  Vector screw_axis_ = Vector::Zero();  ///< of a screw
  double lead_ = 0;                     ///< of a screw, m/rad
  double rest_ = 0;                     ///< of a distance, m
  double factor_ = 1;
  std::vector<Row> parts_;  ///< of a sum
};

extern template class Row<SE2>;
extern template class Row<SE3>;

}  // namespace liesl
