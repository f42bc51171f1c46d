#pragma once
/// @file
/// Elastic law of a beam element whose strain varies linearly along it, its slope condensed: a
/// two-node element of fourth order that neither locks nor has internal unknowns.
///
/// With a(s) = a_0 + a_1 (s - L/2) for the strains including those of the axis, the motion over
/// the element is (Magnus expansion, Iserles, Norsett 1999, to fourth order)
///
///   d = log(H_A^-1 H_B) = L a_0 + (L^3/12) ad(a_0) a_1.
///
/// Potential L/2 eps_0^T K eps_0 + L^3/24 eps_1^T K eps_1 with that as constraint, n its
/// multiplier: K eps_1 = ad(a_0)^T n, the equilibrium of the section forces, and with a_0 = d/L in
/// the terms of higher order
///
///   F(d) n = (d - d0)/L,   F(d) = W K^-1 W^T + ad(d) K^-1 ad(d)^T / 12,
///   V(d) = (L/2) eps^T F(d)^-1 eps,   dV/dd = n + (L/12) ad(z)^T n,   z = K^-1 ad(d)^T n.
///
/// On a straight axis F has 1/(GA) + L^2/(12 EI) for shear: the exact stiffness of Timoshenko's
/// beam. W = I - (L^2/12) ad(a_r) where the curvature of the axis varies, a_r = [0; kappa_1] its
/// slope, which follows from d0 as nodal frames are tangent to it. F is positive definite.

#include "mbs/bodies/beam_element.hpp"

namespace liesl {

template <FrameGroup G>
class CondensedLaw {
 public:
  using Scalar = typename G::Scalar;
  using Tangent = typename G::Tangent;
  using Matrix = typename G::Matrix;
  using Pair = typename BeamElement<G>::Pair;
  using PairMatrix = typename BeamElement<G>::PairMatrix;

  /// @param d0 relative motion of the nodes at rest, x along the axis at both
  /// @param K section stiffness
  CondensedLaw(const Tangent& d0, const Matrix& K);
  /// Four laws at once, for what depends on d. @pre each `uncoupled`
  template <class One>
  explicit CondensedLaw(const Four<CondensedLaw<One>>& laws)
      : d0_(gather(laws, &CondensedLaw<One>::d0_)),
        L_(gather(laws, &CondensedLaw<One>::L_)),
        Kinv_(gather(laws, &CondensedLaw<One>::Kinv_)),
        varied_(gather(laws, &CondensedLaw<One>::varied_)),
        uncoupled_(true) {}

  /// Length along the axis, m.
  Scalar length() const { return L_; }
  const Tangent& d0() const { return d0_; }
  const Matrix& section_stiffness() const { return K_; }
  const Matrix& section_flexibility() const { return Kinv_; }
  /// K has no blocks that couple translation and rotation.
  bool uncoupled() const { return uncoupled_; }

  /// F(d); F(d0)^-1, constant.
  Matrix flexibility(const Tangent& d) const;
  /// F(d)^-1
  Matrix stiffness(const Tangent& d) const;
  const Matrix& stiffness_at_rest() const { return C0_; }
  /// n of F(d) n = e for a strain e (of (d - d0)/L, of its rate too where there is damping).
  Tangent stress(const Tangent& d, const Tangent& e) const;
  /// n + (L/12) ad(z)^T n: the section force that works on d, g = P(d)^T of it.
  Tangent conjugate(const Tangent& d, const Tangent& n) const;
  /// Y = I + (L/12)(ad(z) - ad(d) K^-1 N(n)): dn = F^-1 Y dd/L, and Y^T dn is what the conjugate
  /// force changes by. N(n) x = ad(x)^T n.
  Matrix Y(const Tangent& d, const Tangent& n) const { return Y(d, n, slope(d, n)); }
  /// d(conjugate)/dd = Y^T F^-1 Y / L - (L/12) N^T K^-1 N, symmetric.
  Matrix hessian(const Tangent& d, const Tangent& n) const { return hessian(d, n, slope(d, n)); }
  /// Both with another z than K^-1 ad(d)^T n (LineLoad).
  Matrix Y(const Tangent& d, const Tangent& n, const Tangent& z) const;
  Matrix hessian(const Tangent& d, const Tangent& n, const Tangent& z) const;
  /// N(n): N x = ad(x)^T n, antisymmetric.
  static Matrix force_operator(const Tangent& n);

  /// Slope a_r of the curvature of the axis at rest.
  Tangent slope_of_axis() const;

  /// Viscous section forces c dn/dt, dn/dt = F^-1 Y dd/dt / L: what works on d, Y^T dn/dt, whose
  /// power L dn/dt . F dn/dt is never negative. @param r dd/dt
  Tangent viscous(const Tangent& d, const Tangent& n, const Tangent& r) const;
  /// Its derivative by d at constant r, n that of d.
  Matrix viscous_by_d(const Tangent& d, const Tangent& n, const Tangent& r) const;

  /// g = P(d)^T (conjugate and viscous force), frames A and B of the nodes.
  void force(const G& A, const G& B, const Scalar* v, double damping, Pair& g) const;
  /// dg/dv, and dg/d[h_A; h_B] about the elastic stress n. @param v used only if damping > 0
  PairMatrix damping_tangent(const G& A, const G& B, const Scalar* v, double damping) const;
  PairMatrix tangent(const G& A, const G& B, const Tangent& n, const Scalar* v,
                     double damping) const;

  /// By a parameter of the section, K' = dK/dp, at constant d and e.
  /// dn/dp = F^-1 [W K^-1 K' K^-1 W^T n + ad(d) K^-1 K' z / 12]
  Tangent stress_by(const Tangent& d, const Tangent& n, const Matrix& dK) const;
  /// d(conjugate)/dp, n and its derivative given.
  Tangent conjugate_by(const Tangent& d, const Tangent& n, const Tangent& dn,
                       const Matrix& dK) const;
  /// d(viscous)/dp likewise.
  Tangent viscous_by(const Tangent& d, const Tangent& n, const Tangent& dn, const Tangent& r,
                     const Matrix& dK) const;
  /// d(F(d0)^-1)/dp = C (-dF/dp) C, and d2/dp dq.
  Matrix stiffness_at_rest_by(const Matrix& dK) const;
  Matrix stiffness_at_rest_second(const Matrix& K_p, const Matrix& K_q, const Matrix& K_pq) const;

 private:
  template <FrameGroup>
  friend class CondensedLaw;
  using Gradient = typename BeamElement<G>::Gradient;
  struct RelativeMotion {
    Tangent d;
    Gradient P;
  };

  static RelativeMotion relative_motion(const G& A, const G& B);
  /// z = K^-1 ad(d)^T n
  Tangent slope(const Tangent& d, const Tangent& n) const {
    return Kinv_.lazyProduct(Tangent(-BeamElement<G>::minus_ad_transpose(d, n)));
  }

  /// F(d0) as a linear function of the flexibility X of the section.
  Matrix of_flexibility(const Matrix& X) const;
  /// -dF(d)/dp n
  Tangent minus_flexibility_by(const Tangent& d, const Tangent& n, const Matrix& dK) const;

  Tangent d0_;
  Scalar L_;
  Matrix K_, Kinv_, C0_;
  Matrix W_;       ///< I - (L^2/12) ad(a_r)
  Matrix varied_;  ///< W K^-1 W^T
  bool uncoupled_;
};

extern template class CondensedLaw<SE2>;
extern template class CondensedLaw<SE3>;

}  // namespace liesl
