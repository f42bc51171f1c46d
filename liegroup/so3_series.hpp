#pragma once
/// @file
/// Matrix functions F(w) = I + f1(z) w~ + f2(z) w~^2, z = w.w, and their derivatives. T, T^-1 and
/// T^-T of SO(3) have this form; those of SE(3) are built from the same three derivatives, because
/// h~ = [w~ u~; 0 w~] makes every power series of ad(h) equal to [F(w)  DF(w)[u]; 0  F(w)].

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "liegroup/trig_series.hpp"

namespace liesl {

/// v~ with v~ a = v x a.
inline Eigen::Matrix3d hat(const Eigen::Vector3d& v) {
  Eigen::Matrix3d M;
  M << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return M;
}

/// Axial vector of the antisymmetric part of M; vee(hat(v)) = v.
inline Eigen::Vector3d vee(const Eigen::Matrix3d& M) {
  return {0.5 * (M(2, 1) - M(1, 2)), 0.5 * (M(0, 2) - M(2, 0)), 0.5 * (M(1, 0) - M(0, 1))};
}

/// Coefficients at one z: f, g = 2 df/dz, k = 4 d2f/dz2 (so that d f(w.w) = g w.dw, d g = k w.dw).
struct So3Series {
  double f1, f2, g1 = 0, g2 = 0, k1 = 0, k2 = 0;

  /// F(w)  [3x3]
  Eigen::Matrix3d value(const Eigen::Vector3d& w) const {
    Eigen::Matrix3d F = hat(f1 * w);
    F.noalias() += (f2 * w) * w.transpose();
    F.diagonal().array() += 1 - f2 * w.squaredNorm();
    return F;
  }

  /// F(w) a  [3]
  Eigen::Vector3d apply(const Eigen::Vector3d& w, const Eigen::Vector3d& a) const {
    const Eigen::Vector3d wa = w.cross(a);
    return a + f1 * wa + f2 * w.cross(wa);
  }

  /// DF(w)[u], the derivative of F in the direction u  [3x3]:
  /// f1 u~ + f2 (w~ u~ + u~ w~) + (w.u) (g1 w~ + g2 w~^2). Needs g.
  Eigen::Matrix3d directional(const Eigen::Vector3d& w, const Eigen::Vector3d& u) const {
    const double p = w.dot(u);
    Eigen::Matrix3d C = hat(f1 * u + (p * g1) * w);
    const Eigen::Vector3d b = f2 * u + (0.5 * p * g2) * w;  // C = ~ + w b' + b w' + diagonal
    C.noalias() += w * b.transpose();
    C.noalias() += b * w.transpose();
    C.diagonal().array() -= p * (2 * f2 + g2 * w.squaredNorm());
    return C;
  }

  /// D_w [F(w) a]  [3x3]:
  /// -f1 a~ - f2 ((w x a)~ + w~ a~) + (g1 w x a + g2 w x (w x a)) w'. Needs g.
  Eigen::Matrix3d dF(const Eigen::Vector3d& w, const Eigen::Vector3d& a) const {
    const Eigen::Vector3d wa = w.cross(a);
    Eigen::Matrix3d D = first_order(f1, f2, w, a);
    D.noalias() += (g1 * wa + g2 * w.cross(wa)) * w.transpose();
    return D;
  }

  /// D_w [DF(w)[u] a]  [3x3], the second derivative of F(w) a with one direction u. Needs g and k.
  Eigen::Matrix3d d2F(const Eigen::Vector3d& w, const Eigen::Vector3d& u,
                      const Eigen::Vector3d& a) const {
    const double p = w.dot(u);
    const Eigen::Vector3d ua = u.cross(a), wa = w.cross(a), wwa = w.cross(wa);
    const Eigen::Vector3d along_w =
        g1 * ua + g2 * (u.cross(wa) + w.cross(ua)) + p * (k1 * wa + k2 * wwa);
    Eigen::Matrix3d D = first_order(p * g1, p * g2, w, a) + first_order(0, f2, u, a);
    D.noalias() += along_w * w.transpose();
    D.noalias() += (g1 * wa + g2 * wwa) * u.transpose();
    return D;
  }

 private:
  /// -s a~ - t ((w x a)~ + w~ a~), with (w x a)~ = a w' - w a' and w~ a~ = a w' - (w.a) I.
  static Eigen::Matrix3d first_order(double s, double t, const Eigen::Vector3d& w,
                                     const Eigen::Vector3d& a) {
    Eigen::Matrix3d D = hat(-s * a);
    const Eigen::Vector3d ta = t * a;
    D.noalias() += w * ta.transpose();
    D.noalias() -= (2 * ta) * w.transpose();
    D.diagonal().array() += w.dot(ta);
    return D;
  }
};

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

/// T^-1(w) = I + w~/2 + e w~^2.
inline So3Series so3_tangent_inverse(double z) {
  const trig::InverseTangentSeries s = trig::inverse_tangent_series(z);
  return {0.5, s.e, 0, 2 * s.de, 0, 4 * s.dde};
}

/// T^-T(w) = T^-1(-w) = I - w~/2 + e w~^2.
inline So3Series so3_tangent_inverse_transposed(double z) {
  So3Series s = so3_tangent_inverse(z);
  s.f1 = -0.5;
  return s;
}

}  // namespace liesl
