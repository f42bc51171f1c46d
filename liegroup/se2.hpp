#pragma once
/// @file
/// Frames of the plane SE(2). H = (R, x) maps local to inertial coordinates; tangent
/// h = [u_x, u_y, w] in the local frame. J = [0 -1; 1 0], z = w^2; c_k, e: trig_series.hpp.

#include <Eigen/Core>
#include <cmath>

#include "liegroup/coefficients.hpp"
#include "liegroup/concepts.hpp"
#include "liegroup/lanes.hpp"
#include "liegroup/trig_series.hpp"

namespace liesl {

template <class S = double>
struct SE2Of {
  using Scalar = S;
  template <class T>
  using Over = SE2Of<T>;
  using Tangent = Eigen::Matrix<S, 3, 1>;
  using Matrix = Eigen::Matrix<S, 3, 3>;
  using Rotation = Eigen::Matrix<S, 2, 2>;
  using Vector = Eigen::Matrix<S, 2, 1>;
  static constexpr int dim = 3;
  static constexpr int space_dim = 2;
  static constexpr int rotation_dim = 1;

  Rotation R = Rotation::Identity();
  Vector x = Vector::Zero();

  SE2Of() = default;
  SE2Of(const Rotation& rotation, const Vector& position) : R(rotation), x(position) {}

  static SE2Of identity() { return {}; }
  SE2Of operator*(const SE2Of& other) const {
    return {product<2>(R, other.R), product_plus<2>(R, other.x, x)};
  }
  /// Inertial coordinates R p + x of the point with local coordinates p.
  Vector operator*(const Vector& p) const { return product_plus<2>(R, p, x); }
  SE2Of inverse() const { return {transpose<2>(R), minus_transposed_product<2>(R, x)}; }

  /// R = [cos w, -sin w; sin w, cos w], x = c1 u + w c2 J u.
  static SE2Of exp(const Tangent& h) {
    const S w = h[2], z = w * w;
    const trig::Stumpff3 c = trig::stumpff3(z);
    const S sine = w * c.c1, cosine = 1 - z * c.c2;
    SE2Of H;
    H.R << cosine, -sine, sine, cosine;
    H.x << c.c1 * h[0] - w * c.c2 * h[1], c.c1 * h[1] + w * c.c2 * h[0];
    return H;
  }

  /// w = angle of R in [-pi, pi], u = (1 - z e) x - w/2 J x. A rotation of pi has two logarithms.
  static Tangent log(const SE2Of& H) {
    const S w = angle(H.R);
    return local_log(w, trig::inverse_tangent_value(w * w), H.x);
  }

  /// d = log(H) and T^-1(d) with shared coefficients. T^-1(-d) = T^-1(d) - ad(d).
  static void log_and_Tinv(const SE2Of& H, Tangent& d, Matrix& Tinv_d) {
    const S w = angle(H.R), e = trig::inverse_tangent_value(w * w);
    d = local_log(w, e, H.x);
    Tinv_d = tangent_inverse(d, e);
  }

  /// Ad(H) = [R -Jx; 0 1]
  Matrix Ad() const {
    Matrix A;
    A << R(0, 0), R(0, 1), x[1], R(1, 0), R(1, 1), -x[0], 0, 0, 1;
    return A;
  }

  /// Ad(H^-1) = [R' R'Jx; 0 1]
  Matrix AdInv() const {
    Matrix A;
    A << R(0, 0), R(1, 0), R(1, 0) * x[0] - R(0, 0) * x[1],  //
        R(0, 1), R(1, 1), R(1, 1) * x[0] - R(0, 1) * x[1],   //
        0, 0, 1;
    return A;
  }

  /// ad([u; w]) = [wJ -Ju; 0 0]
  static Matrix ad(const Tangent& h) {
    Matrix A;
    A << 0, -h[2], h[1], h[2], 0, -h[0], 0, 0, 0;
    return A;
  }

  /// T = [c1 I - w c2 J, c2 Ju + w c3 u; 0 1]
  static Matrix T(const Tangent& h) {
    const S w = h[2];
    const trig::Stumpff3 c = trig::stumpff3(w * w);
    Matrix M;
    M << c.c1, w * c.c2, -c.c2 * h[1] + w * c.c3 * h[0],  //
        -w * c.c2, c.c1, c.c2 * h[0] + w * c.c3 * h[1],   //
        0, 0, 1;
    return M;
  }

  /// T^-1 = [(1 - z e) I + w/2 J, w e u - Ju/2; 0 1]
  static Matrix Tinv(const Tangent& h) {
    return tangent_inverse(h, trig::inverse_tangent_value(h[2] * h[2]));
  }

  /// D_u = a_w (c2 J + w c3 I); D_w = 2 w dc1 a_u - (c2 + 2 z dc2) J a_u
  ///                                + a_w (2 w dc2 Ju + (c3 + 2 z dc3) u), dc = dc/dz.
  static Matrix dT(const Tangent& h, const Tangent& a) {
    const S w = h[2], z = w * w;
    const trig::Stumpff7 c = trig::stumpff7(z);
    const S p = w * (c.c3 - c.c2), q = c.c2 + z * (2 * c.c4 - c.c3);
    const S r = w * (2 * c.c4 - c.c3), s = c.c3 + z * (3 * c.c5 - c.c4);
    Matrix M;
    M << a[2] * w * c.c3, -a[2] * c.c2, p * a[0] + q * a[1] + a[2] * (s * h[0] - r * h[1]),  //
        a[2] * c.c2, a[2] * w * c.c3, p * a[1] - q * a[0] + a[2] * (s * h[1] + r * h[0]),    //
        0, 0, 0;
    return M;
  }

  /// D_u = a_w (w e I - J/2); D_w = -2 w (e + z de) a_u + J a_u/2 + a_w (e + 2 z de) u.
  static Matrix dTinv(const Tangent& h, const Tangent& a) {
    const S w = h[2], z = w * w;
    const trig::InverseTangentSeries s = trig::inverse_tangent_series(z);
    const S p = -2 * w * (s.e + z * s.de), q = s.e + 2 * z * s.de;
    Matrix M;
    M << a[2] * w * s.e, 0.5 * a[2], p * a[0] - 0.5 * a[1] + q * a[2] * h[0],  //
        -0.5 * a[2], a[2] * w * s.e, p * a[1] + 0.5 * a[0] + q * a[2] * h[1],  //
        0, 0, 0;
    return M;
  }

  /// T^-T n = [((1 - z e) I - w/2 J) n_u; (w e u - Ju/2).n_u + n_w].
  static Matrix dTinvT(const Tangent& h, const Tangent& n) {
    const S w = h[2], z = w * w;
    const trig::InverseTangentSeries s = trig::inverse_tangent_series(z);
    const S p = -2 * w * (s.e + z * s.de), q = s.e + 2 * z * s.de;
    Matrix M;
    M << 0, 0, p * n[0] + 0.5 * n[1],  //
        0, 0, p * n[1] - 0.5 * n[0],   //
        w * s.e * n[0] - 0.5 * n[1], w * s.e * n[1] + 0.5 * n[0], q * (h[0] * n[0] + h[1] * n[1]);
    return M;
  }

  /// One Newton step of R towards the nearest rotation; x is kept.
  void orthonormalize() { newton_step_to_rotation<2>(R); }

 private:
  static S angle(const Rotation& R) {
    const S s = 0.5 * (R(1, 0) - R(0, 1)), c = R(0, 0) + R(1, 1), ss = s * s;
    if (all_at_most(ss, trig::kArcsineSwitch) && all_above(c, 0))
      return trig::angle_over_sine(ss) * s;
    using std::atan2;
    return atan2(S(2 * s), c);
  }

  /// [T^-T(w) x; w]
  static Tangent local_log(const S& w, const S& e, const Vector& x) {
    const S g = 1 - w * w * e, half = 0.5 * w;
    return {g * x[0] + half * x[1], g * x[1] - half * x[0], w};
  }

  static Matrix tangent_inverse(const Tangent& h, const S& e) {
    const S w = h[2], g = 1 - w * w * e;
    Matrix M;
    M << g, -0.5 * w, w * e * h[0] + 0.5 * h[1],  //
        0.5 * w, g, w * e * h[1] - 0.5 * h[0],    //
        0, 0, 1;
    return M;
  }
};

using SE2 = SE2Of<double>;

static_assert(FrameGroup<SE2>);

}  // namespace liesl
