#pragma once
/// @file
/// Matrix functions F(w) = I + f1(z) w~ + f2(z) w~^2, z = w.w, and their derivatives. T, T^-1 and
/// T^-T of SO(3) have this form; those of SE(3) are built from the same three derivatives, because
/// h~ = [w~ u~; 0 w~] makes every power series of ad(h) equal to [F(w)  DF(w)[u]; 0  F(w)].

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "liegroup/lanes.hpp"
#include "liegroup/trig_series.hpp"

namespace liesl {

/// v~ with v~ a = v x a.
template <class S>
Eigen::Matrix<S, 3, 3> hat(const Eigen::Matrix<S, 3, 1>& v) {
  Eigen::Matrix<S, 3, 3> M;
  M << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return M;
}
inline Eigen::Matrix3d hat(const Eigen::Vector3d& v) { return hat<double>(v); }

/// Axial vector of the antisymmetric part of M; vee(hat(v)) = v.
template <class S>
Eigen::Matrix<S, 3, 1> vee(const Eigen::Matrix<S, 3, 3>& M) {
  return {0.5 * (M(2, 1) - M(1, 2)), 0.5 * (M(0, 2) - M(2, 0)), 0.5 * (M(1, 0) - M(0, 1))};
}

/// s~ + a b' + c d' + diagonal I, coefficient by coefficient: whole-matrix expressions of odd size
/// cost store-forwarding stalls here (twice the time of the beam kernel's T^-1).
template <class S>
Eigen::Matrix<S, 3, 3> rank_two(const Eigen::Matrix<S, 3, 1>& s, const Eigen::Matrix<S, 3, 1>& a,
                                const Eigen::Matrix<S, 3, 1>& b, const Eigen::Matrix<S, 3, 1>& c,
                                const Eigen::Matrix<S, 3, 1>& d, const S& diagonal) {
  Eigen::Matrix<S, 3, 3> M;
  M(0, 0) = a[0] * b[0] + c[0] * d[0] + diagonal;
  M(1, 0) = a[1] * b[0] + c[1] * d[0] + s[2];
  M(2, 0) = a[2] * b[0] + c[2] * d[0] - s[1];
  M(0, 1) = a[0] * b[1] + c[0] * d[1] - s[2];
  M(1, 1) = a[1] * b[1] + c[1] * d[1] + diagonal;
  M(2, 1) = a[2] * b[1] + c[2] * d[1] + s[0];
  M(0, 2) = a[0] * b[2] + c[0] * d[2] + s[1];
  M(1, 2) = a[1] * b[2] + c[1] * d[2] - s[0];
  M(2, 2) = a[2] * b[2] + c[2] * d[2] + diagonal;
  return M;
}

/// Coefficients at one z: f, g = 2 df/dz, k = 4 d2f/dz2 (so that d f(w.w) = g w.dw, d g = k w.dw).
template <class S>
struct So3SeriesOf {
  using Vector = Eigen::Matrix<S, 3, 1>;
  using Matrix = Eigen::Matrix<S, 3, 3>;

  S f1, f2, g1 = 0, g2 = 0, k1 = 0, k2 = 0;

  /// F(w)
  Matrix value(const Vector& w) const {
    const Vector b = 0.5 * f2 * w;
    return rank_two<S>(f1 * w, w, b, b, w, 1 - f2 * w.squaredNorm());
  }

  /// F(w) a
  Vector apply(const Vector& w, const Vector& a) const {
    const Vector wa = w.cross(a);
    return a + f1 * wa + f2 * w.cross(wa);
  }

  /// DF(w)[u], the derivative of F in the direction u:
  /// f1 u~ + f2 (w~ u~ + u~ w~) + (w.u) (g1 w~ + g2 w~^2). Needs g.
  Matrix directional(const Vector& w, const Vector& u) const {
    const S p = w.dot(u);
    const Vector b = f2 * u + (0.5 * p * g2) * w;
    return rank_two<S>(f1 * u + (p * g1) * w, w, b, b, w, -p * (2 * f2 + g2 * w.squaredNorm()));
  }

  /// D_w [F(w) a] = -f1 a~ - f2 ((w x a)~ + w~ a~) + (g1 w x a + g2 w x (w x a)) w'. Needs g.
  /// Used here and below: (w x a)~ + w~ a~ = 2 a w' - w a' - (w.a) I.
  Matrix dF(const Vector& w, const Vector& a) const {
    const Vector wa = w.cross(a), b = f2 * a;
    const Vector c = g1 * wa + g2 * w.cross(wa) - 2 * b;
    return rank_two<S>(-f1 * a, w, b, c, w, w.dot(b));
  }

  /// D_w [DF(w)[u] a], the second derivative of F(w) a with one direction u. Needs g and k:
  /// (g1 u x a + g2 (u x (w x a) + w x (u x a)) + p (k1 w x a + k2 w x (w x a))) w'
  /// + (g1 w x a + g2 w x (w x a)) u' - f2 ((u x a)~ + u~ a~)
  /// - p (g1 a~ + g2 ((w x a)~ + w~ a~)),  p = w.u.
  Matrix d2F(const Vector& w, const Vector& u, const Vector& a) const {
    const S p = w.dot(u);
    const Vector ua = u.cross(a), wa = w.cross(a), wwa = w.cross(wa);
    const Vector left = f2 * u + (p * g2) * w;  // of a'
    const Vector along_u = g1 * wa + g2 * wwa - (2 * f2) * a;
    const Vector along_w =
        g1 * ua + g2 * (u.cross(wa) + w.cross(ua)) + p * (k1 * wa + k2 * wwa - (2 * g2) * a);
    Matrix M = rank_two<S>((-p * g1) * a, left, a, along_w, w, left.dot(a));
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) M(i, j) += along_u[i] * u[j];
    return M;
  }
};

using So3Series = So3SeriesOf<double>;

/// T(w) = I - c2 w~ + c3 w~^2 without derivatives (g and k stay 0).
inline So3Series so3_tangent_value(double z) {
  const trig::Stumpff3 c = trig::stumpff3(z);
  return {.f1 = -c.c2, .f2 = c.c3};
}

/// T(w) with derivatives, dc_k/dz = (k c_{k+2} - c_{k+1})/2 applied once and twice.
inline So3Series so3_tangent(double z) {
  const trig::Stumpff7 c = trig::stumpff7(z);
  const double g2 = 2 * c.c4 - c.c3, g3 = 3 * c.c5 - c.c4;  // 2 dc2, 2 dc3
  const double g4 = 4 * c.c6 - c.c5, g5 = 5 * c.c7 - c.c6;  // 2 dc4, 2 dc5
  return {-c.c2, c.c3, -g2, g3, -(2 * g4 - g3), 3 * g5 - g4};
}

/// T^-1(w) = I + w~/2 + e w~^2 without derivatives.
template <class S>
So3SeriesOf<S> so3_tangent_inverse_value(const S& z) {
  return {.f1 = 0.5, .f2 = trig::inverse_tangent_value(z)};
}

/// T^-1(w) = I + w~/2 + e w~^2.
template <class S>
So3SeriesOf<S> so3_tangent_inverse(const S& z) {
  const trig::InverseTangentSeries<S> s = trig::inverse_tangent_series(z);
  return {0.5, s.e, 0, 2 * s.de, 0, 4 * s.dde};
}

/// T^-T(w) = T^-1(-w) = I - w~/2 + e w~^2.
template <class S>
So3SeriesOf<S> so3_tangent_inverse_transposed(const S& z) {
  So3SeriesOf<S> s = so3_tangent_inverse(z);
  s.f1 = -0.5;
  return s;
}

}  // namespace liesl
