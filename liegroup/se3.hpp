#pragma once
/// @file
/// Frames of space SE(3). H = (R, x) maps local to inertial coordinates; tangent h = [u; w],
/// translation first, both in the local frame. Formulas: Sonneville, Cardona, Brüls, CMAME 268
/// (2014), Appendix A, in the block form [F(w) DF(w)[u]; 0 F(w)] of liegroup/so3_series.hpp.

#include <Eigen/Core>

#include "liegroup/coefficients.hpp"
#include "liegroup/concepts.hpp"
#include "liegroup/so3.hpp"

namespace liesl {

template <class S = double>
struct SE3Of {
  using Scalar = S;
  template <class T>
  using Over = SE3Of<T>;
  using Tangent = Eigen::Matrix<S, 6, 1>;
  using Matrix = Eigen::Matrix<S, 6, 6>;
  using Rotation = Eigen::Matrix<S, 3, 3>;
  using Vector = Eigen::Matrix<S, 3, 1>;
  static constexpr int dim = 6;
  static constexpr int space_dim = 3;
  static constexpr int rotation_dim = 3;

  Rotation R = Rotation::Identity();
  Vector x = Vector::Zero();

  SE3Of() = default;
  SE3Of(const Rotation& rotation, const Vector& position) : R(rotation), x(position) {}

  static SE3Of identity() { return {}; }
  SE3Of operator*(const SE3Of& other) const {
    return {product<3>(R, other.R), product_plus<3>(R, other.x, x)};
  }
  /// Inertial coordinates R p + x of the point with local coordinates p.
  Vector operator*(const Vector& p) const { return product_plus<3>(R, p, x); }
  SE3Of inverse() const { return {transpose<3>(R), minus_transposed_product<3>(R, x)}; }

  /// R = exp(w), x = T(w)' u = u + c2 w x u + c3 w x (w x u).
  static SE3Of exp(const Tangent& h) {
    const Vector u = h.template head<3>(), w = h.template tail<3>();
    const trig::Stumpff3 c = trig::stumpff3(w.squaredNorm());
    SE3Of H;
    H.R = So3Series{.f1 = c.c1, .f2 = c.c2}.value(w);
    H.x = So3Series{.f1 = c.c2, .f2 = c.c3}.apply(w, u);
    return H;
  }

  /// w = log(R), u = T^-T(w) x. Rotation below pi, see SO3::log.
  static Tangent log(const SE3Of& H) {
    const Vector w = SO3::log(H.R);
    return join(so3_tangent_inverse_transposed(w.squaredNorm()).apply(w, H.x), w);
  }

  /// d = log(H) and T^-1(d) = [A C; 0 A] with shared coefficients: the beam's inner loop.
  /// T^-1(-d) = T^-1(d) - ad(d).
  static void log_and_Tinv(const SE3Of& H, Tangent& d, Matrix& Tinv_d) {
    const Vector w = SO3::log(H.R);
    const So3SeriesOf<S> s = so3_tangent_inverse(w.squaredNorm());
    const Vector u = s.apply(w, H.x) - w.cross(H.x);  // T^-T(w) x
    d = join(u, w);
    fill(Tinv_d, s.value(w), s.directional(w, u));
  }

  /// Ad(H) = [R x~R; 0 R]
  Matrix Ad() const {
    Matrix A;
    fill(A, R, hat_times_R());
    return A;
  }

  /// Ad(H^-1) = [R' -R'x~; 0 R'], -R'x~ = (x~R)'
  Matrix AdInv() const {
    Matrix A;
    fill(A, R.transpose(), hat_times_R().transpose());
    return A;
  }

  /// ad([u;w]) = [w~ u~; 0 w~]
  static Matrix ad(const Tangent& h) {
    Matrix A;
    fill(A, hat(Vector(h.template tail<3>())), hat(Vector(h.template head<3>())));
    return A;
  }

  static Matrix T(const Tangent& h) {
    return value(so3_tangent(h.template tail<3>().squaredNorm()), h);
  }
  static Matrix Tinv(const Tangent& h) {
    return value(so3_tangent_inverse(h.template tail<3>().squaredNorm()), h);
  }
  static Matrix dT(const Tangent& h, const Tangent& a) {
    return derivative(so3_tangent(h.template tail<3>().squaredNorm()), h, a);
  }
  static Matrix dTinv(const Tangent& h, const Tangent& a) {
    return derivative(so3_tangent_inverse(h.template tail<3>().squaredNorm()), h, a);
  }

  /// T^-T(h) n = [A'n_u; C'n_u + A'n_w], hence [0 dA'(n_u); dA'(n_u)  dA'(n_w) + d2A'(u, n_u)].
  static Matrix dTinvT(const Tangent& h, const Tangent& n) {
    const Vector u = h.template head<3>(), w = h.template tail<3>(), nu = n.template head<3>();
    const So3SeriesOf<S> s = so3_tangent_inverse_transposed(w.squaredNorm());
    const Rotation A = s.dF(w, nu), B = s.dF(w, n.template tail<3>()), C = s.d2F(w, u, nu);
    Matrix D;
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) {
        D(i, j) = 0;
        D(i, j + 3) = D(i + 3, j) = A(i, j);
        D(i + 3, j + 3) = B(i, j) + C(i, j);
      }
    }
    return D;
  }

  /// One Newton step of R towards the nearest rotation; x is kept.
  void orthonormalize() { newton_step_to_rotation<3>(R); }

 private:
  static Tangent join(const Vector& u, const Vector& w) {
    Tangent h;
    for (int i = 0; i < 3; ++i) {
      h[i] = u[i];
      h[i + 3] = w[i];
    }
    return h;
  }

  /// x~ R, column by column.
  Rotation hat_times_R() const {
    Rotation M;
    for (int j = 0; j < 3; ++j) {
      M(0, j) = x[1] * R(2, j) - x[2] * R(1, j);
      M(1, j) = x[2] * R(0, j) - x[0] * R(2, j);
      M(2, j) = x[0] * R(1, j) - x[1] * R(0, j);
    }
    return M;
  }

  /// M = [A C; 0 A], by coefficients (see rank_two).
  template <class A3, class C3>
  static void fill(Matrix& M, const A3& A, const C3& C) {
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) {
        M(i, j) = M(i + 3, j + 3) = A(i, j);
        M(i, j + 3) = C(i, j);
        M(i + 3, j) = 0;
      }
    }
  }

  /// [F(w) DF(w)[u]; 0 F(w)]
  static Matrix value(const So3SeriesOf<S>& s, const Tangent& h) {
    const Vector u = h.template head<3>(), w = h.template tail<3>();
    Matrix M;
    fill(M, s.value(w), s.directional(w, u));
    return M;
  }

  /// D_h of [F a_u + DF[u] a_w; F a_w] = [dF(a_w)  dF(a_u) + d2F(u, a_w); 0  dF(a_w)].
  static Matrix derivative(const So3SeriesOf<S>& s, const Tangent& h, const Tangent& a) {
    const Vector u = h.template head<3>(), w = h.template tail<3>(), aw = a.template tail<3>();
    Matrix M;
    fill(M, s.dF(w, aw), s.dF(w, a.template head<3>()) + s.d2F(w, u, aw));
    return M;
  }
};

using SE3 = SE3Of<double>;

static_assert(FrameGroup<SE3>);

}  // namespace liesl
