#pragma once
/// @file
/// The rotations of a group of frames by themselves: SO(3), or SO(2), where everything commutes.

#include "liegroup/se2.hpp"
#include "liegroup/se3.hpp"

namespace liesl {

/// Operators of the rotations of G on rotation vectors (rotation_dim numbers), as in LieGroup.
template <FrameGroup G>
struct RotationOf;

template <class S>
struct RotationOf<SE3Of<S>> {
  using Vector = Eigen::Matrix<S, 3, 1>;
  using Matrix = Eigen::Matrix<S, 3, 3>;
  static Matrix exp(const Vector& w) { return SO3::exp(w).R; }
  static Vector log(const Matrix& R) { return SO3::log(R); }
  static Matrix T(const Vector& w) { return SO3::T(w); }
  static Matrix Tinv(const Vector& w) { return SO3::Tinv(w); }
  static Matrix dT(const Vector& w, const Vector& a) { return SO3::dT(w, a); }
  /// The derivative of T in the direction u, and D_w of that times a.
  static Matrix DT(const Vector& w, const Vector& u) {
    return so3_tangent(w.squaredNorm()).directional(w, u);
  }
  static Matrix d2T(const Vector& w, const Vector& u, const Vector& a) {
    return so3_tangent(w.squaredNorm()).d2F(w, u, a);
  }
  static Matrix dTinvT(const Vector& w, const Vector& n) { return SO3::dTinvT(w, n); }
  /// a x w = cross(a) w  [space_dim x rotation_dim]; a . (b x w) = (cross(b)^T a) . w
  static Matrix cross(const Vector& a) { return hat(a); }
};

template <class S>
struct RotationOf<SE2Of<S>> {
  using Vector = Eigen::Matrix<S, 1, 1>;
  using Matrix = Eigen::Matrix<S, 1, 1>;
  static Eigen::Matrix2d exp(const Vector& w) { return SE2::exp({0, 0, w[0]}).R; }
  static Vector log(const Eigen::Matrix2d& R) {
    return SE2::log({R, Eigen::Vector2d::Zero()}).tail<1>();
  }
  static Matrix T(const Vector&) { return Matrix::Identity(); }
  static Matrix Tinv(const Vector&) { return Matrix::Identity(); }
  static Matrix dT(const Vector&, const Vector&) { return Matrix::Zero(); }
  static Matrix DT(const Vector&, const Vector&) { return Matrix::Zero(); }
  static Matrix d2T(const Vector&, const Vector&, const Vector&) { return Matrix::Zero(); }
  static Matrix dTinvT(const Vector&, const Vector&) { return Matrix::Zero(); }
  static Eigen::Matrix<S, 2, 1> cross(const Eigen::Matrix<S, 2, 1>& a) { return {a.y(), -a.x()}; }
};

}  // namespace liesl
