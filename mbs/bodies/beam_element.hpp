#pragma once
/// @file
/// Two-node geometrically exact beam element on a group of frames G (SE(2) or SE(3)).
/// Sonneville, Cardona, Bruls 2014, "Geometrically exact beam finite element formulated on the
/// special Euclidean group SE(3)", CMAME 268.
///
/// Relative motion d = log(H_A^-1 H_B), interpolation H(s) = H_A exp(s d), s in [0, 1],
/// strain eps = (d - d0)/L [-, 1/m], section forces n = K eps [N, N m]. All forces and increments
/// are in the local frames of the two nodes, translation first: [u_A; w_A; u_B; w_B].

#include <Eigen/Core>
#include <array>

#include "liegroup/concepts.hpp"

namespace liesl {

template <FrameGroup G>
class BeamElement {
 public:
  static constexpr int dim = G::dim;
  using Tangent = typename G::Tangent;
  using Matrix = typename G::Matrix;
  using Pair = Eigen::Matrix<double, 2 * dim, 1>;
  using PairMatrix = Eigen::Matrix<double, 2 * dim, 2 * dim>;
  using Gradient = Eigen::Matrix<double, dim, 2 * dim>;
  using Vector = Eigen::Matrix<double, G::space_dim, 1>;
  using Rotation = Eigen::Matrix<double, G::space_dim, G::space_dim>;

  /// @param K section stiffness, @param M_s section inertia per length, @param length L in m:
  /// arc length of the reference curve between the nodes
  BeamElement(const G& A, const G& B, const Matrix& K, const Matrix& M_s)
      : d0_(G::log(A.inverse() * B)), L_(d0_.template head<G::space_dim>().norm()), K_(K), M_s_(M_s) {
    const auto [points, weights] = gauss2();
    for (int i = 0; i < 2; ++i) {
      Q_[i] = Q(d0_, points[i]);
      weight_[i] = L_ * weights[i];
      bubble_ += 0.5 * points[i] * (1 - points[i]) * weight_[i] * Q_[i].transpose() *
                 M_s_.template leftCols<G::space_dim>();
    }
    const Rotation R = A.R.transpose() * B.R, W = 0.5 * (R - R.transpose());
    W0_squared_ = W * W;
  }

  double length() const { return L_; }
  const Tangent& d0() const { return d0_; }
  const Matrix& section_stiffness() const { return K_; }
  const Matrix& section_inertia() const { return M_s_; }

  Tangent strain(const G& A, const G& B) const { return (G::log(A.inverse() * B) - d0_) / L_; }

  /// P(d) = [-T^-1(-d), T^-1(d)]: dd = P(d) [dh_A; dh_B].
  static Gradient P(const Tangent& d) {
    Gradient p;
    p << -G::Tinv(-d), G::Tinv(d);
    return p;
  }

  /// g = P(d)^T n with n = K eps + damping K d(eps)/dt; returns n.
  /// @param v velocities [v_A; v_B]; used only if damping > 0 (stiffness-proportional, s)
  Tangent internal_force(const G& A, const G& B, const double* v, double damping, Pair& g) const {
    Tangent d;
    Matrix Ti;
    G::log_and_Tinv(A.inverse() * B, d, Ti);
    const Matrix Tm = Ti - G::ad(d);  // T^-1(-d)
    Tangent strain = (d - d0_) / L_;
    if (damping > 0) {
      using Map = Eigen::Map<const Tangent>;
      strain += (damping / L_) * (Ti * Map(v + dim) - Tm * Map(v));
    }
    const Tangent n = K_ * strain;
    g.template head<dim>().noalias() = -Tm.transpose() * n;
    g.template tail<dim>().noalias() = Ti.transpose() * n;
    return n;
  }

  /// K_t = P(d0)^T K P(d0) / L, constant in the local frames.
  PairMatrix constant_tangent() const {
    const Gradient p = P(d0_);
    return p.transpose() * K_ * p / L_;
  }

  /// D_[h_A; h_B] (P(d)^T n(d)) with the stress n of the stiffness term exact and that of the
  /// geometric term given (DESIGN section 6: extrapolated stress). Not symmetric off equilibrium.
  PairMatrix tangent(const G& A, const G& B, const Tangent& n) const {
    const Tangent d = G::log(A.inverse() * B);
    const Gradient p = P(d);
    Gradient geometric_A = G::dTinvT(-d, n) * p;  // -T^-T(-d) n: the two signs cancel
    Gradient geometric_B = G::dTinvT(d, n) * p;
    PairMatrix k = p.transpose() * K_ * p / L_;
    k.template topRows<dim>() += geometric_A;
    k.template bottomRows<dim>() += geometric_B;
    return k;
  }

  /// Q(s) = [Ad(exp(-s d)) - s T(s d) T^-1(-d), s T(s d) T^-1(d)]: v(s) = Q(s) [v_A; v_B].
  static Gradient Q(const Tangent& d, double s) {
    const Matrix sT = s * G::T(s * d);
    Gradient q;
    q << G::exp(s * d).AdInv() - sT * G::Tinv(-d), sT * G::Tinv(d);
    return q;
  }

  /// L int_0^1 Q^T M Q ds at d0, three-point Gauss: exact for straight elements.
  /// M = section inertia: mass matrix. M = I: shares of a load per length.
  PairMatrix integral(const Matrix& M) const {
    PairMatrix m = PairMatrix::Zero();
    const double a = std::sqrt(0.15);
    const double points[] = {0.5 - a, 0.5, 0.5 + a}, weights[] = {5. / 18, 8. / 18, 5. / 18};
    for (int i = 0; i < 3; ++i) {
      const Gradient q = Q(d0_, points[i]);
      m += L_ * weights[i] * q.transpose() * M * q;
    }
    return m;
  }
  PairMatrix mass() const { return integral(M_s_); }

  /// g += what the mass matrix misses of the weight when the element turns by more than at
  /// reference. M [R_A^T a; R_B^T a] takes R(s)^T a as linear in s; to second order in the rotation
  /// vector w it is linear - s(1 - s)/2 w x (w x R_mid^T a).
  /// @param a gravity, inertial axes, m/s^2
  void add_weight_curvature(const G& A, const G& B, const Vector& a, Pair& g) const {
    const Rotation R = A.R.transpose() * B.R, W = 0.5 * (R - R.transpose());
    const Vector mean = 0.5 * (A.R.transpose() * a + B.R.transpose() * a);
    g.noalias() += bubble_ * Vector(W * (W * mean) - W0_squared_ * mean);
  }

  /// g += L int Q^T (-v^T M_s v) ds, two-point Gauss; does no work: v . g = 0.
  void add_gyroscopic(const double* v, Pair& g) const {
    const Eigen::Map<const Pair> V(v);
    for (int i = 0; i < 2; ++i) {
      const Tangent vs = Q_[i] * V;
      g.noalias() += Q_[i].transpose() * Tangent(weight_[i] * minus_ad_transpose(vs, M_s_ * vs));
    }
  }

  /// d add_gyroscopic / dv.
  PairMatrix gyroscopic_tangent(const double* v) const {
    const Eigen::Map<const Pair> V(v);
    PairMatrix c = PairMatrix::Zero();
    for (int i = 0; i < 2; ++i) {
      const Tangent vs = Q_[i] * V;
      c += weight_[i] * Q_[i].transpose() * minus_ad_transpose_derivative(vs, M_s_) * Q_[i];
    }
    return c;
  }

  /// -ad(v)^T p for a momentum p: the force that turns momentum with the frame.
  static Tangent minus_ad_transpose(const Tangent& v, const Tangent& p) {
    return -G::ad(v).transpose() * p;
  }
  /// D_v (-ad(v)^T M v).
  static Matrix minus_ad_transpose_derivative(const Tangent& v, const Matrix& M) {
    Matrix c = -G::ad(v).transpose() * M;
    const Tangent p = M * v;
    for (int j = 0; j < dim; ++j) c.col(j) -= G::ad(Tangent::Unit(j)).transpose() * p;
    return c;
  }

 private:
  static std::pair<std::array<double, 2>, std::array<double, 2>> gauss2() {
    const double a = 0.5 / std::sqrt(3.0);
    return {{0.5 - a, 0.5 + a}, {0.5, 0.5}};
  }

  Tangent d0_;
  double L_;
  Matrix K_, M_s_;
  std::array<Gradient, 2> Q_;
  std::array<double, 2> weight_;
  /// L int Q^T M_s [I; 0] s(1 - s)/2 ds
  Eigen::Matrix<double, 2 * dim, G::space_dim> bubble_ = Eigen::Matrix<double, 2 * dim, G::space_dim>::Zero();
  Rotation W0_squared_;
};

}  // namespace liesl
