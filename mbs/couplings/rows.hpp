#pragma once
/// @file
/// Scalar functions of the relative motion of two ports. Every joint constraint, drive, spring,
/// damper and actuator is made of them, for every group of frames.
///
/// With port frames (R_a, x_a), (R_b, x_b): R = R_a^T R_b, p = R_a^T (x_b - x_a). Gradients are
/// with respect to left-invariant increments of the two ports, [u_a; w_a; u_b; w_b].

#include <Eigen/Core>
#include <cmath>

#include "liegroup/concepts.hpp"

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
  Along,     ///< m . p: displacement of b along m of a
  Normal,    ///< m . R n: cosine between m of a and n of b (zero: they are normal)
  Angle,     ///< atan2(m . R n, m2 . R n2), continued beyond pi
  Distance,  ///< |p|
};

template <FrameGroup G>
class Row {
 public:
  static constexpr int sd = G::space_dim, rd = G::rotation_dim, dim = G::dim;
  using Vector = Eigen::Matrix<double, sd, 1>;
  using Motion = RelativeMotion<G>;
  using Gradient = Eigen::Matrix<double, 2 * dim, 1>;
  using Hessian = Eigen::Matrix<double, 2 * dim, 2 * dim>;

  static Row along(const Vector& m) { return {RowKind::Along, m, m, m, m}; }
  static Row normal(const Vector& m, const Vector& n) { return {RowKind::Normal, m, n, m, n}; }
  /// Angle whose sine is m . R n and whose cosine is m2 . R n2.
  static Row angle(const Vector& m, const Vector& n, const Vector& m2, const Vector& n2) {
    return {RowKind::Angle, m, n, m2, n2};
  }
  static Row distance() {
    const Vector zero = Vector::Zero();
    return {RowKind::Distance, zero, zero, zero, zero};
  }

  RowKind kind() const { return kind_; }

  /// @param near the value it had last: an angle is continued from there, over any number of turns
  double value(const Motion& r, double near) const {
    switch (kind_) {
      case RowKind::Along:
        return m_.dot(r.p);
      case RowKind::Normal:
        return m_.dot(r.R * n_);
      case RowKind::Distance:
        return r.p.norm();
      case RowKind::Angle:
        break;
    }
    const double angle = std::atan2(m_.dot(r.R * n_), m2_.dot(r.R * n2_));
    return angle + 2 * M_PI * std::round((near - angle) / (2 * M_PI));
  }

  void gradient(const Motion& r, Gradient& g) const {
    switch (kind_) {
      case RowKind::Along:
        g << -m_, X(m_).transpose() * r.p, r.R.transpose() * m_, Angular::Zero();
        return;
      case RowKind::Normal:
        g = cosine_gradient(r, m_, n_);
        return;
      case RowKind::Distance: {
        const Vector e = r.p / r.p.norm();
        g << -e, Angular::Zero(), r.R.transpose() * e, Angular::Zero();
        return;
      }
      case RowKind::Angle: {
        const double s = m_.dot(r.R * n_), c = m2_.dot(r.R * n2_);
        g = (c * cosine_gradient(r, m_, n_) - s * cosine_gradient(r, m2_, n2_)) / (s * s + c * c);
        return;
      }
    }
  }

  /// Left-invariant derivative of the gradient: the geometric stiffness of a unit force.
  Hessian hessian(const Motion& r) const {
    switch (kind_) {
      case RowKind::Along:
        return along_hessian(r);
      case RowKind::Normal:
        return cosine_hessian(r, m_, n_);
      case RowKind::Distance:
        return distance_hessian(r);
      case RowKind::Angle:
        break;
    }
    const double s = m_.dot(r.R * n_), c = m2_.dot(r.R * n2_), q = s * s + c * c;
    const Gradient gs = cosine_gradient(r, m_, n_), gc = cosine_gradient(r, m2_, n2_);
    const Gradient g = (c * gs - s * gc) / q;
    return (c * cosine_hessian(r, m_, n_) - s * cosine_hessian(r, m2_, n2_) + gs * gc.transpose() -
            gc * gs.transpose() - 2 * g * (s * gs + c * gc).transpose()) /
           q;
  }

 private:
  using Angular = Eigen::Matrix<double, rd, 1>;
  using Cross = Eigen::Matrix<double, sd, rd>;

  Row(RowKind kind, const Vector& m, const Vector& n, const Vector& m2, const Vector& n2)
      : kind_(kind), m_(m), n_(n), m2_(m2), n2_(n2) {}

  /// X(v) w = w x v; X(v)^T a = v x a.
  static Cross X(const Vector& v) {
    if constexpr (sd == 2)
      return Vector(-v.y(), v.x());
    else
      return (Cross() << 0, v.z(), -v.y(), -v.z(), 0, v.x(), v.y(), -v.x(), 0).finished();
  }

  static Gradient cosine_gradient(const Motion& r, const Vector& m, const Vector& n) {
    Gradient g;
    g << Vector::Zero(), X(m).transpose() * (r.R * n), Vector::Zero(),
        X(n).transpose() * (r.R.transpose() * m);
    return g;
  }

  static Hessian cosine_hessian(const Motion& r, const Vector& m, const Vector& n) {
    const Vector Rn = r.R * n, Rtm = r.R.transpose() * m;
    Hessian h = Hessian::Zero();
    h.template block<rd, rd>(sd, sd) = -X(m).transpose() * X(Rn);
    h.template block<rd, rd>(sd, dim + sd) = X(m).transpose() * r.R * X(n);
    h.template block<rd, rd>(dim + sd, sd) = X(n).transpose() * r.R.transpose() * X(m);
    h.template block<rd, rd>(dim + sd, dim + sd) = -X(n).transpose() * X(Rtm);
    return h;
  }

  Hessian along_hessian(const Motion& r) const {
    Hessian h = Hessian::Zero();
    const Cross Xm = X(m_);
    h.template block<rd, sd>(sd, 0) = -Xm.transpose();
    h.template block<rd, rd>(sd, sd) = -Xm.transpose() * X(r.p);
    h.template block<rd, sd>(sd, dim) = Xm.transpose() * r.R;
    h.template block<sd, rd>(dim, sd) = r.R.transpose() * Xm;
    h.template block<sd, rd>(dim, dim + sd) = -X(r.R.transpose() * m_);
    return h;
  }

  Hessian distance_hessian(const Motion& r) const {
    Gradient g;
    gradient(r, g);
    const double l = r.p.norm();
    const Vector pb = r.R.transpose() * r.p;
    Hessian h = Hessian::Zero();
    // -d(p)/l on the rows of u_a, d(R^T p)/l on those of u_b, and the change of 1/l.
    h.template block<sd, sd>(0, 0).setIdentity();
    h.template block<sd, rd>(0, sd) = X(r.p);
    h.template block<sd, sd>(0, dim) = -r.R;
    h.template block<sd, sd>(dim, 0) = -r.R.transpose();
    h.template block<sd, sd>(dim, dim).setIdentity();
    h.template block<sd, rd>(dim, dim + sd) = -X(pb);
    return (h - g * g.transpose()) / l;
  }

  RowKind kind_;
  Vector m_, n_, m2_, n2_;
};

}  // namespace liesl
