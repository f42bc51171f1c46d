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

#include "liegroup/se2.hpp"
#include "liegroup/se3.hpp"
#include "mbs/bodies/linear_law.hpp"
#include "mbs/bodies/spread_load.hpp"

namespace liesl {

template <FrameGroup G>
class BeamElement : public LinearLaw<BeamElement<G>, G> {
 public:
  static constexpr int dim = G::dim;
  using Scalar = typename G::Scalar;
  using Tangent = typename G::Tangent;
  using Matrix = typename G::Matrix;
  using Pair = Eigen::Matrix<Scalar, 2 * dim, 1>;
  using PairMatrix = Eigen::Matrix<Scalar, 2 * dim, 2 * dim>;
  using Gradient = Eigen::Matrix<Scalar, dim, 2 * dim>;
  using Vector = Eigen::Matrix<Scalar, G::space_dim, 1>;
  using Rotation = Eigen::Matrix<Scalar, G::space_dim, G::space_dim>;

  /// Element between the frames A and B at rest; its length is the translation of d0, m.
  /// @param K section stiffness  @param M_s section inertia per length
  BeamElement(const G& A, const G& B, const Matrix& K, const Matrix& M_s);

  double length() const { return L_; }
  const Tangent& d0() const { return d0_; }
  const Matrix& section_stiffness() const { return K_; }
  const Matrix& section_inertia() const { return M_s_; }

  /// d = log(H_A^-1 H_B)
  static Tangent relative(const G& A, const G& B) { return G::log(A.inverse() * B); }
  /// eps = (d - d0)/L
  Tangent strain(const G& A, const G& B) const;

  /// P(d) = [-T^-1(-d), T^-1(d)]: dd = P(d) [dh_A; dh_B].
  static Gradient P(const Tangent& d);
  /// D_d [P(d) v] for velocities v = [v_A; v_B].
  static Matrix dP(const Tangent& d, const Scalar* v);

  /// P(d) v, T^-1(d) given.
  static Tangent relative_rate(const Tangent& d, const Matrix& Tinv_d, const Scalar* v) {
    const Eigen::Map<const Tangent> v_A(v), v_B(v + dim);
    return Tinv_d.lazyProduct(Tangent(v_B - v_A)) + G::ad(d).lazyProduct(v_A);
  }
  /// g = P(d)^T n, n = section_force(d, T^-1(d)).
  template <class F>
  static void transmit(const G& A, const G& B, const F& section_force, Pair& g) {
    Tangent d;
    Matrix Ti;
    G::log_and_Tinv(A.inverse() * B, d, Ti);
    const Tangent n = section_force(d, Ti), on_B = Ti.transpose().lazyProduct(n);
    // -T^-T(-d) n = -T^-T(d) n + ad(d)^T n
    g.template head<dim>() = -on_B - minus_ad_transpose(d, n);
    g.template tail<dim>() = on_B;
  }

  /// g = P(d)^T n with n = K eps + damping K d(eps)/dt; returns n.
  /// @param v velocities [v_A; v_B]; used only if damping > 0 (stiffness-proportional, s)
  /// @param about unused: the law is linear in the stress
  Tangent internal_force(const G& A, const G& B, const double* v, double damping, Pair& g,
                         const double* about = nullptr) const;

  /// K_t = P(d0)^T K P(d0) / L, constant in the local frames.
  PairMatrix constant_tangent() const;

  /// P(d)^T K P(d) / L
  PairMatrix material_tangent(const G& A, const G& B) const;
  /// D_[h_A; h_B] (P(d)^T n(d)) with the stress n of the stiffness term exact and that of the
  /// geometric term given (an extrapolated one in statics, see IterationMatrix). Not symmetric off
  /// equilibrium.
  PairMatrix tangent(const G& A, const G& B, const Tangent& n) const;

  /// Q(s) = [Ad(exp(-s d)) - s T(s d) T^-1(-d), s T(s d) T^-1(d)]: v(s) = Q(s) [v_A; v_B].
  static Gradient Q(const Tangent& d, double s);

  /// L int_0^1 Q^T M Q ds at d0, three-point Gauss: exact for straight elements.
  /// M = section inertia: mass matrix. M = I: shares of a load per length.
  PairMatrix integral(const Matrix& M) const;
  const PairMatrix& mass() const { return mass_; }

  /// The same with the frames of its nodes: here constant (eq. of the papers: at d0).
  const PairMatrix& mass(const G&, const G&) const { return mass_; }

  /// g = M a + L int Q^T (-ad(v)^T M_s v) ds: inertia with the constant mass matrix, and the
  /// gyroscopic force, two-point Gauss, which does no work: v . g_gyr = 0.
  /// @param v velocities [v_A; v_B]  @param a [vdot - R^T gravity] of both nodes
  void inertia_force(const G& A, const G& B, const double* v, const Pair& a, Pair& g) const;
  /// g += what the mass matrix misses of the weight when the element turns by more than at
  /// reference. M [R_A^T a; R_B^T a] takes R(s)^T a as linear in s; to second order in the rotation
  /// vector w it is linear - s(1 - s)/2 w x (w x R_mid^T a).
  /// @param a gravity, inertial axes, m/s^2
  void add_weight_curvature(const G& A, const G& B, const Vector& a, Pair& g) const;
  /// The same for a dead force per length and its share by integral(I), and its tangent.
  Pair spread_curvature(const G& A, const G& B, const SpreadLoad<G>& load) const;
  PairMatrix spread_curvature_tangent(const G& A, const G& B, const SpreadLoad<G>& load) const;

  /// The shares of a dead load per length need a correction, see spread_curvature.
  static constexpr bool kTurnsSpreadLoads = true;

  /// d (inertia force without M vdot) / dv, and d (weight) / d[h_A; h_B].
  PairMatrix gyroscopic_tangent(const G& A, const G& B, const double* v) const;
  PairMatrix weight_tangent(const G& A, const G& B, const Vector& a) const;
  /// d (inertia force and weight) / d[h_A; h_B]: the mass matrix is constant, the weight turns.
  PairMatrix inertia_stiffness(const G& A, const G& B, const double*, const Pair&,
                               const Vector& gravity) const {
    if (gravity.squaredNorm() == 0) return PairMatrix::Zero();
    return weight_tangent(A, B, gravity);
  }
  /// Potential of gravity, J: two-point Gauss along the element.
  double weight_potential(const G& A, const G& B, const Vector& a) const;
  /// Its gradient by [h_A; h_B]; and that of the kinetic energy at given velocities: none, the mass
  /// is constant.
  Pair weight_gradient(const G& A, const G& B, const Vector& a) const;
  Pair kinetic_gradient(const G&, const G&, const double*) const { return Pair::Zero(); }
  double kinetic_energy(const G&, const G&, const double* v) const {
    const Eigen::Map<const Pair> V(v);
    return 0.5 * V.dot(mass_ * V);
  }

  /// -ad(v)^T p for a momentum p: the force that turns momentum with the frame.
  /// [w x p_u; u x p_u + w x p_w] in space.
  static Tangent minus_ad_transpose(const Tangent& v, const Tangent& p);
  /// D_v (-ad(v)^T M v).
  static Matrix minus_ad_transpose_derivative(const Tangent& v, const Matrix& M);

 private:
  using Bubble = Eigen::Matrix<double, 2 * dim, G::space_dim>;

  Pair curvature(const Bubble& bubble, const G& A, const G& B, const Vector& a) const;
  PairMatrix curvature_tangent(const Bubble& bubble, const G& A, const G& B, const Vector& a) const;

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

extern template class BeamElement<SE2>;
extern template class BeamElement<SE3>;

}  // namespace liesl
