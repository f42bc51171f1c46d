#pragma once
/// @file
/// What a load per length p (wrench in local axes) does inside an element of fourth order beyond
/// shares of its nodes: virtual work p . dh with the motion of the element itself, whose strain is
/// linear (CondensedLaw). By the formula of Euler and Maclaurin, to the fifth power of L,
///
///   int p . dh ds = L/2 [p.dh_A + p.dh_B] - (L^2/12) [(p . dh)'_B - (p . dh)'_A],
///   dh' = da - ad(a) dh,   a = d/L + a_1 (s - L/2),   a_1 = a_r + K^-1 [ad(d/L)^T n - p],
///
/// the slope with what p adds to the equilibrium of section forces, n' = ad(a)^T n - p. With it
/// the law is F(d) n = (d - d0)/L + (L/12) ad(d) y, y = K^-1 p, and the force that works on d
///
///   n + (L/12) ad(z)^T n,   z = K^-1 ad(d)^T n - L y.
///
/// Loads that follow the section have a constant p: at constant a_1
///
///   f_A, f_B = L/2 p -+ (L/12) ad(d)^T p + (L^2/24) ad(L a_1)^T p.
///
/// Dead moments m have (m . R dw)' = R^T m . dkappa: (L/12)(R_A^T m - R_B^T m) on the rotation in
/// d. Dead forces are exact in the shares.

#include "mbs/bodies/condensed_law.hpp"
#include "mbs/bodies/spread_load.hpp"

namespace liesl {

template <FrameGroup G>
class LineLoad {
 public:
  using Tangent = typename G::Tangent;
  using Matrix = typename G::Matrix;
  using Pair = typename BeamElement<G>::Pair;
  using PairMatrix = typename BeamElement<G>::PairMatrix;

  /// @param law outlives this
  LineLoad(const CondensedLaw<G>& law, const SpreadLoad<G>& load, const G& A, const G& B);

  /// Forces on both nodes, in their axes, beyond L/2 p and -+ L^2/12 across the axis of its force.
  Pair force() const;
  /// d(force)/d[h_A; h_B].
  PairMatrix tangent() const;
  /// d(force)/dp by a parameter of the section, K' = dK/dp, at constant frames.
  Pair force_by(const Matrix& dK) const;

 private:
  static constexpr int dim = G::dim, sd = G::space_dim, rd = G::rotation_dim;
  using Gradient = typename BeamElement<G>::Gradient;
  /// A section force in the law and z of it.
  struct Slope {
    Tangent n, z;
  };

  Tangent conjugate_change() const;
  Tangent conjugate_by(const Slope& of, const Tangent& dn, const Tangent& dz) const;
  /// d(what works on d)/d[h_A; h_B].
  Gradient conjugate_tangent() const;
  void add_turning_of_moments(Gradient& by_h) const;
  Matrix slope_gradient() const;

  const CondensedLaw<G>& law_;
  SpreadLoad<G> load_;
  double L_;
  Tangent d_;
  Gradient P_;
  Tangent mu_A_ = Tangent::Zero(), mu_B_ = Tangent::Zero();  ///< dead moments at the nodes
  Tangent p_;                                                ///< in the slope
  Tangent dn_;                                               ///< section force by p
  Slope free_, loaded_;                                      ///< without p, and with it
};

extern template class LineLoad<SE2>;
extern template class LineLoad<SE3>;

}  // namespace liesl
