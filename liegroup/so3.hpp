#pragma once
/// @file
/// Rotations SO(3). R maps local to inertial components; tangent w [3], local frame.

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <concepts>
#include <functional>

#include "liegroup/coefficients.hpp"
#include "liegroup/concepts.hpp"
#include "liegroup/so3_series.hpp"

namespace liesl {

/// Rotation of space. T, T^-1 and their derivatives: see So3Series.
struct SO3 {
  using Tangent = Eigen::Vector3d;
  using Matrix = Eigen::Matrix3d;
  static constexpr int dim = 3;
  static constexpr int rotation_dim = 3;

  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();

  SO3() = default;
  explicit SO3(const Eigen::Matrix3d& rotation) : R(rotation) {}

  static SO3 identity() { return {}; }
  SO3 operator*(const SO3& other) const { return SO3(product<3>(R, other.R)); }
  Eigen::Vector3d operator*(const Eigen::Vector3d& a) const { return R * a; }
  SO3 inverse() const { return SO3(transpose<3>(R)); }

  /// Rodrigues: exp(w) = I + c1 w~ + c2 w~^2.
  static SO3 exp(const Tangent& w) {
    const trig::Stumpff3 c = trig::stumpff3(w.squaredNorm());
    return SO3(So3Series{.f1 = c.c1, .f2 = c.c2}.value(w));
  }

  /// w with exp(w) = R and |w| <= pi. At |w| = pi both w and -w are logarithms and one of them is
  /// returned; up to there the error is a few units of rounding.
  static Tangent log(const SO3& H) { return log(H.R); }
  static Tangent log(const Eigen::Matrix3d& R) {
    Tangent w;
    return log_of_small(R, w) ? w : log_by_quaternion(R);
  }
  /// The same of four at once: one by one where one of them is large.
  template <std::same_as<Lanes> S>
  static Eigen::Matrix<S, 3, 1> log(const Eigen::Matrix<S, 3, 3>& R) {
    Eigen::Matrix<S, 3, 1> w;
    if (log_of_small(R, w)) return w;
    std::array<Tangent, Lanes::size> one;
    for (int lane = 0; lane < Lanes::size; ++lane)
      one[lane] = log(R.unaryExpr([lane](const S& r) { return r[lane]; }).eval());
    return gather(Four<Tangent>{&one[0], &one[1], &one[2], &one[3]}, std::identity());
  }

  /// Ad(R) = R
  Matrix Ad() const { return R; }
  Matrix AdInv() const { return R.transpose(); }
  /// ad(w) = w~
  static Matrix ad(const Tangent& w) { return hat(w); }

  static Matrix T(const Tangent& w) { return so3_tangent_value(w.squaredNorm()).value(w); }
  static Matrix Tinv(const Tangent& w) {
    return so3_tangent_inverse_value(w.squaredNorm()).value(w);
  }
  static Matrix dT(const Tangent& w, const Tangent& a) {
    return so3_tangent(w.squaredNorm()).dF(w, a);
  }
  static Matrix dTinv(const Tangent& w, const Tangent& a) {
    return so3_tangent_inverse(w.squaredNorm()).dF(w, a);
  }
  static Matrix dTinvT(const Tangent& w, const Tangent& n) {
    return so3_tangent_inverse_transposed(w.squaredNorm()).dF(w, n);
  }

  /// w = log(H) and T^-1(w) with shared coefficients.
  static void log_and_Tinv(const SO3& H, Tangent& w, Matrix& Tinv_w) {
    w = log(H);
    Tinv_w = Tinv(w);
  }

  /// One Newton step R <- R (3 I - R'R)/2 towards the nearest rotation (polar factor).
  void orthonormalize() { newton_step_to_rotation<3>(R); }

 private:
  /// Whether all angles are small enough for w = (asin s/s) sin|w| n, and then w.
  template <class S>
  static bool log_of_small(const Eigen::Matrix<S, 3, 3>& R, Eigen::Matrix<S, 3, 1>& w) {
    const Eigen::Matrix<S, 3, 1> s = vee(R);  // sin|w| n
    const S sine2 = s.squaredNorm();
    if (!all_at_most(sine2, trig::kArcsineSwitch) || !all_above(R(0, 0) + R(1, 1) + R(2, 2), 1))
      return false;
    w = trig::angle_over_sine(sine2) * s;
    return true;
  }
  /// Quaternion (W, V) up to scale from the row of 4 q q' with the largest pivot [Shepperd 1978];
  /// then w = 2 atan2(|V|, W) V/|V|, without cancellation for every angle. @pre R is not I.
  static Tangent log_by_quaternion(const Eigen::Matrix3d& R) {
    const double trace = R(0, 0) + R(1, 1) + R(2, 2);
    Eigen::Vector3d V(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
    double W = 1 + trace;
    int i = R(0, 0) < R(1, 1) ? 1 : 0;
    if (R(i, i) < R(2, 2)) i = 2;
    if (trace < R(i, i)) {
      const double sign = V[i] < 0 ? -1 : 1;  // W >= 0, so that |w| <= pi
      W = std::abs(V[i]);
      for (int k = 0; k < 3; ++k) V[k] = sign * (R(k, i) + R(i, k));
      V[i] = sign * (1 + 2 * R(i, i) - trace);
    }
    const double sine = V.norm();
    return (2 * std::atan2(sine, W) / sine) * V;
  }
};

static_assert(LieGroup<SO3>);

}  // namespace liesl
