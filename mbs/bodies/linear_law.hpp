#pragma once
/// @file
/// What the elements of second order share: constant strain eps = (d - d0)/L and a linear law
/// n = K eps, V = (L/2) eps^T K eps.

#include <Eigen/Core>

#include "liegroup/concepts.hpp"

namespace liesl {

/// @tparam E element with relative, P, dP, strain, section_stiffness, d0, length, integral,
/// material_tangent and tangent of the stress
template <class E, FrameGroup G>
class LinearLaw {
 public:
  using Tangent = typename G::Tangent;
  using Matrix = typename G::Matrix;
  using Pair = Eigen::Matrix<double, 2 * G::dim, 1>;
  using PairMatrix = Eigen::Matrix<double, 2 * G::dim, 2 * G::dim>;

  /// n = K eps, and dV/dd, which is n, too.
  Tangent stress(const G& A, const G& B) const {
    return self().section_stiffness() * self().strain(A, B);
  }
  Tangent conjugate(const G& A, const G& B) const { return stress(A, B); }
  /// dn/dd = K/L
  Matrix stress_gradient(const G&, const G&) const {
    return self().section_stiffness() / self().length();
  }
  /// n + (K/L) P(d) delta
  Tangent extrapolated(const G& A, const G& B, const Tangent& /*about*/, const Pair& delta) const {
    const Tangent d = E::relative(A, B), change = E::P(d) * delta;
    return self().section_stiffness() * (d - self().d0() + change) / self().length();
  }
  double elastic_energy(const G& A, const G& B) const {
    const Tangent eps = self().strain(A, B);
    return 0.5 * self().length() * eps.dot(self().section_stiffness() * eps);
  }
  /// c L (deps/dt)^T K deps/dt
  double dissipation(const G& A, const G& B, const double* v, double damping) const {
    const Tangent rate = E::P(E::relative(A, B)) * Eigen::Map<const Pair>(v);
    return damping / self().length() * rate.dot(self().section_stiffness() * rate);
  }
  const Matrix& stiffness_at_rest() const { return self().section_stiffness(); }
  double axial_stiffness() const { return self().section_stiffness()(0, 0) / self().length(); }
  /// Shares of a load per length.
  PairMatrix load_shares() const { return self().integral(Matrix::Identity()); }
  /// dg/dv of the damping.
  PairMatrix damping_tangent(const G& A, const G& B, const double*, double damping) const {
    return damping * self().material_tangent(A, B);
  }
  /// dg/d[h_A; h_B]: with damping c the stress is n + c K P v/L, whose strain rate P(d) v changes
  /// with d, too.
  PairMatrix damped_tangent(const G& A, const G& B, Tangent n, const double* v,
                            double damping) const {
    PairMatrix k = PairMatrix::Zero();
    if (damping > 0) {
      const Tangent d = E::relative(A, B);
      const typename E::Gradient P = E::P(d);
      const Matrix K = self().section_stiffness() * (damping / self().length());
      n += K * (P * Eigen::Map<const Pair>(v));
      k += P.transpose() * K * E::dP(d, v) * P;
    }
    return k + self().tangent(A, B, n);
  }

 private:
  const E& self() const { return static_cast<const E&>(*this); }
};

}  // namespace liesl
