#pragma once
/// @file
/// Two-node geometrically exact beam element of fourth order on a group of frames: strain linear
/// along the element and condensed (CondensedLaw), inertia consistent with it (HermiteInertia).
/// Nodes, increments and forces are those of BeamElement, and so is what it computes of d alone.

#include <optional>

#include "mbs/bodies/condensed_law.hpp"
#include "mbs/bodies/hermite_inertia.hpp"
#include "mbs/bodies/spread_load.hpp"

namespace liesl {

template <FrameGroup G>
class FourthOrderElement {
 public:
  static constexpr int dim = G::dim;
  using Second = BeamElement<G>;
  using Tangent = typename Second::Tangent;
  using Matrix = typename Second::Matrix;
  using Pair = typename Second::Pair;
  using PairMatrix = typename Second::PairMatrix;
  using Gradient = typename Second::Gradient;
  using Vector = typename Second::Vector;

  /// Element between the frames A and B at rest, whose x is tangent to the axis.
  /// @param K section stiffness  @param M_s section inertia per length, without coupling of
  /// translation and rotation
  FourthOrderElement(const G& A, const G& B, const Matrix& K, const Matrix& M_s);
  /// Its derivative by a parameter: forces, matrices, section forces and energies are d/dp of those
  /// of the element at constant frames and rates.
  FourthOrderElement(const FourthOrderElement& of, const Matrix& dK, const Matrix& dM_s);

  double length() const { return law_.length(); }
  const Tangent& d0() const { return law_.d0(); }
  const CondensedLaw<G>& law() const { return law_; }
  const HermiteInertia<G>& inertia() const { return inertia_; }
  bool is_derivative() const { return dK_.has_value(); }
  const Matrix& section_inertia() const { return M_s_; }
  /// F(d0)^-1 (or its derivative): linear section forces are that times (d - d0)/L.
  const Matrix& stiffness_at_rest() const { return C0_; }
  /// EA/L, N/m.
  double axial_stiffness() const { return law_.section_stiffness()(0, 0) / length(); }

  static Tangent relative(const G& A, const G& B) { return Second::relative(A, B); }
  static Gradient P(const Tangent& d) { return Second::P(d); }
  static Matrix dP(const Tangent& d, const double* v) { return Second::dP(d, v); }

  /// Mean strain (d - d0)/L.
  Tangent strain(const G& A, const G& B) const { return (relative(A, B) - d0()) / length(); }
  /// n of F(d) n = eps: section force in the middle of an element without load.
  Tangent stress(const G& A, const G& B) const;
  /// dn/dd.
  Matrix stress_gradient(const G& A, const G& B) const;
  /// n + dn for increments delta, linearised about `about`.
  Tangent extrapolated(const G& A, const G& B, const Tangent& about, const Pair& delta) const;
  double elastic_energy(const G& A, const G& B) const;
  /// dV/dd: what P(d)^T makes the elastic force of.
  Tangent conjugate(const G& A, const G& B) const;
  /// Power taken out by damping at velocities v, >= 0.
  double dissipation(const G& A, const G& B, const double* v, double damping) const;

  /// g = P(d)^T (dV/dd + damping Y^T dn/dt).
  /// @param v velocities [v_A; v_B]; used only if damping > 0 (stiffness-proportional, s)
  /// @param about null, or the stress about which the law is linearised (statics)
  void internal_force(const G& A, const G& B, const double* v, double damping, Pair& g,
                      const double* about = nullptr) const;
  PairMatrix constant_tangent() const;
  /// dg/dv.
  PairMatrix damping_tangent(const G& A, const G& B, const double* v, double damping) const;
  /// dg/d[h_A; h_B] about the elastic stress n. @param v used only if damping > 0
  PairMatrix damped_tangent(const G& A, const G& B, const Tangent& n, const double* v,
                            double damping) const;
  PairMatrix tangent(const G& A, const G& B, const Tangent& n) const {
    return damped_tangent(A, B, n, nullptr, 0);
  }

  /// Shares of a load per length: of a dead force exact however the element turns.
  PairMatrix load_shares() const;
  static constexpr bool kTurnsSpreadLoads = true;
  /// Less what a load that follows or is a moment does beyond these shares (LineLoad), its tangent,
  /// and of a derivative its own.
  Pair spread_curvature(const G& A, const G& B, const SpreadLoad<G>& load) const;
  PairMatrix spread_curvature_tangent(const G& A, const G& B, const SpreadLoad<G>& load) const;
  Pair spread_derivative(const G& A, const G& B, const SpreadLoad<G>& load) const;

  const PairMatrix& mass() const { return mass_; }
  PairMatrix mass(const G& A, const G& B) const { return inertia_.mass(A, B); }
  void inertia_force(const G& A, const G& B, const double* v, const Pair& a, Pair& g) const {
    inertia_.force(A, B, v, a, g);
  }
  /// Weight is exact in inertial axes.
  void add_weight_curvature(const G&, const G&, const Vector&, Pair&) const {}
  PairMatrix gyroscopic_tangent(const G& A, const G& B, const double* v) const {
    return inertia_.gyroscopic_tangent(A, B, v);
  }
  PairMatrix inertia_stiffness(const G& A, const G& B, const double* v, const Pair& a,
                               const Vector& gravity) const;
  double weight_potential(const G& A, const G& B, const Vector& a) const {
    return inertia_.weight_potential(A, B, a);
  }
  Pair weight_gradient(const G& A, const G& B, const Vector& a) const {
    return inertia_.weight_gradient(A, B, a);
  }
  double kinetic_energy(const G& A, const G& B, const double* v) const {
    return inertia_.kinetic_energy(A, B, v);
  }
  Pair kinetic_gradient(const G& A, const G& B, const double* v) const {
    return inertia_.kinetic_gradient(A, B, v);
  }

 private:
  using Share = typename HermiteInertia<G>::Share;
  Share bending_share() const;
  Share bending_share_by(const Matrix& dK) const;
  /// The section force that works on d for a strain e, or its derivative.
  Tangent conjugate_to(const Tangent& d, const Tangent& e) const;
  /// Y^T dn/dt for a section force n, or its derivative.
  Tangent viscous(const Tangent& d, const Tangent& n, const Tangent& rate) const;
  void need_law(const char* what) const;

  CondensedLaw<G> law_;
  Matrix M_s_, C0_;
  std::optional<Matrix> dK_;  ///< of a derivative
  HermiteInertia<G> inertia_;
  PairMatrix mass_;
};

extern template class FourthOrderElement<SE2>;
extern template class FourthOrderElement<SE3>;

}  // namespace liesl
