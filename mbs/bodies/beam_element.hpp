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
      : d0_(G::log(A.inverse() * B)),
        L_(d0_.template head<G::space_dim>().norm()),
        K_(K),
        M_s_(M_s) {
    for (int i = 0; i < 2; ++i) {
      const double s = 0.5 + (i - 0.5) / std::sqrt(3.0), weight = 0.5 * L_;
      const Gradient q = Q(d0_, s);
      Q_.template middleRows<dim>(dim * i) = q;
      weighted_Qt_.template middleCols<dim>(dim * i) = weight * q.transpose();
      spread_bubble_ +=
          0.5 * s * (1 - s) * weight * q.transpose().template leftCols<G::space_dim>();
      bubble_ +=
          0.5 * s * (1 - s) * weight * q.transpose() * M_s_.template leftCols<G::space_dim>();
    }
    mass_ = integral(M_s_);
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
    Tangent strain = (d - d0_) / L_;
    if (damping > 0) {
      using Map = Eigen::Map<const Tangent>;
      const Matrix Tm = Ti - G::ad(d);  // T^-1(-d)
      strain += (damping / L_) * (Ti * Map(v + dim) - Tm * Map(v));
    }
    const Tangent n = K_.lazyProduct(strain);
    const Tangent on_B = Ti.transpose().lazyProduct(n);
    // -T^-T(-d) n = -T^-T(d) n + ad(d)^T n
    g.template head<dim>() = -on_B - minus_ad_transpose(d, n);
    g.template tail<dim>() = on_B;
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
  const PairMatrix& mass() const { return mass_; }

  /// g += what the mass matrix misses of the weight when the element turns by more than at
  /// reference. M [R_A^T a; R_B^T a] takes R(s)^T a as linear in s; to second order in the rotation
  /// vector w it is linear - s(1 - s)/2 w x (w x R_mid^T a).
  /// @param a gravity, inertial axes, m/s^2
  void add_weight_curvature(const G& A, const G& B, const Vector& a, Pair& g) const {
    g += curvature(bubble_, A, B, a);
  }
  PairMatrix weight_curvature_tangent(const G& A, const G& B, const Vector& a) const {
    return curvature_tangent(bubble_, A, B, a);
  }
  /// The same for a dead force per length q [N/m] and its share by integral(I).
  Pair spread_curvature(const G& A, const G& B, const Vector& q) const {
    return curvature(spread_bubble_, A, B, q);
  }
  PairMatrix spread_curvature_tangent(const G& A, const G& B, const Vector& q) const {
    return curvature_tangent(spread_bubble_, A, B, q);
  }

  /// g = M a + L int Q^T (-ad(v)^T M_s v) ds: inertia with the constant mass matrix, and the
  /// gyroscopic force, two-point Gauss, which does no work: v . g_gyr = 0.
  /// @param v velocities [v_A; v_B]  @param a accelerations [a_A; a_B]
  void inertia_force(const double* v, const Pair& a, Pair& g) const {
    const Pair vs = Q_.lazyProduct(Eigen::Map<const Pair>(v));
    Pair f;
    for (int i = 0; i < 2; ++i) {
      const auto vi = vs.template segment<dim>(dim * i);
      f.template segment<dim>(dim * i) = minus_ad_transpose(vi, M_s_.lazyProduct(vi));
    }
    g = mass_.lazyProduct(a);
    g += weighted_Qt_.lazyProduct(f);
  }
  /// g += the gyroscopic force alone.
  void add_gyroscopic(const double* v, Pair& g) const {
    Pair f;
    inertia_force(v, Pair::Zero(), f);
    g += f;
  }

  /// d add_gyroscopic / dv.
  PairMatrix gyroscopic_tangent(const double* v) const {
    const Eigen::Map<const Pair> V(v);
    PairMatrix c = PairMatrix::Zero();
    for (int i = 0; i < 2; ++i) {
      const auto q = Q_.template middleRows<dim>(dim * i);
      c += weighted_Qt_.template middleCols<dim>(dim * i) *
           minus_ad_transpose_derivative(Tangent(q * V), M_s_) * q;
    }
    return c;
  }

  /// -ad(v)^T p for a momentum p: the force that turns momentum with the frame.
  /// [w x p_u; u x p_u + w x p_w] in space.
  static Tangent minus_ad_transpose(const Tangent& v, const Tangent& p) {
    if constexpr (G::space_dim == 2) {
      return {-v[2] * p[1], v[2] * p[0], v[0] * p[1] - v[1] * p[0]};
    } else {
      Tangent f;
      f << v[4] * p[2] - v[5] * p[1], v[5] * p[0] - v[3] * p[2], v[3] * p[1] - v[4] * p[0],
          v[1] * p[2] - v[2] * p[1] + v[4] * p[5] - v[5] * p[4],
          v[2] * p[0] - v[0] * p[2] + v[5] * p[3] - v[3] * p[5],
          v[0] * p[1] - v[1] * p[0] + v[3] * p[4] - v[4] * p[3];
      return f;
    }
  }
  /// D_v (-ad(v)^T M v).
  static Matrix minus_ad_transpose_derivative(const Tangent& v, const Matrix& M) {
    Matrix c = -G::ad(v).transpose() * M;
    const Tangent p = M * v;
    for (int j = 0; j < dim; ++j) c.col(j) -= G::ad(Tangent::Unit(j)).transpose() * p;
    return c;
  }

 private:
  using Bubble = Eigen::Matrix<double, 2 * dim, G::space_dim>;

  /// bubble (w x (w x m) - its value at reference), m the mean of R^T a at the nodes.
  Pair curvature(const Bubble& bubble, const G& A, const G& B, const Vector& a) const {
    const Rotation R = A.R.transpose() * B.R, W = 0.5 * (R - R.transpose());
    const Vector mean = 0.5 * (A.R.transpose() * a + B.R.transpose() * a);
    return bubble * Vector(W * (W * mean) - W0_squared_ * mean);
  }

  /// D_[h_A; h_B] curvature, column by column: dR = -e~ R or R e~.
  PairMatrix curvature_tangent(const Bubble& bubble, const G& A, const G& B,
                               const Vector& a) const {
    const Rotation R = A.R.transpose() * B.R, W = 0.5 * (R - R.transpose());
    const Vector at_A = A.R.transpose() * a, at_B = B.R.transpose() * a, mean = 0.5 * (at_A + at_B);
    PairMatrix k = PairMatrix::Zero();
    for (int i = G::space_dim; i < dim; ++i) {
      const Rotation e =
          G::ad(Tangent::Unit(i)).template topLeftCorner<G::space_dim, G::space_dim>();
      const auto column = [&](const Rotation& dR, const Vector& dmean) -> Pair {
        const Rotation dW = 0.5 * (dR - dR.transpose());
        return bubble *
               Vector(dW * (W * mean) + W * (dW * mean) + W * (W * dmean) - W0_squared_ * dmean);
      };
      k.col(i) = column(-e * R, -0.5 * e * at_A);
      k.col(dim + i) = column(R * e, -0.5 * e * at_B);
    }
    return k;
  }

  Tangent d0_;
  double L_;
  Matrix K_, M_s_;
  PairMatrix mass_;
  PairMatrix Q_;                           ///< Q at both Gauss points, one below the other
  PairMatrix weighted_Qt_;                 ///< their transposes times L/2, side by side
  Bubble bubble_ = Bubble::Zero();         ///< L int Q^T M_s [I; 0] s(1 - s)/2 ds
  Bubble spread_bubble_ = Bubble::Zero();  ///< the same with the identity for M_s
  Rotation W0_squared_;
};

}  // namespace liesl
