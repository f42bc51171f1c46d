#pragma once
/// @file
/// Two-node geometrically exact beam element with positions and rotations interpolated apart, the
/// element of the classical formalisms: Simo, Vu-Quoc 1986, CMAME 58; Geradin, Cardona 2001,
/// "Flexible Multibody Dynamics", chapter 4. One-point integration of the strains, which keeps a
/// slender element from locking.
///
/// Position linear in s, rotation R(s) = R_A exp(s phi) with phi = log(R_A^T R_B). At the middle,
/// R_m = R_A exp(phi/2):  d = [R_m^T (x_B - x_A); phi],  eps = (d - d0)/L,  n = K eps.
/// Forces and increments are in the local frames of the two nodes, as those of BeamElement, so that
/// either element fits the same solvers.

#include "liegroup/rotation.hpp"
#include "mbs/bodies/linear_law.hpp"

namespace liesl {

template <FrameGroup G>
class ReissnerElement : public LinearLaw<ReissnerElement<G>, G> {
 public:
  static constexpr int dim = G::dim, sd = G::space_dim, rd = G::rotation_dim;
  using Tangent = typename G::Tangent;
  using Matrix = typename G::Matrix;
  using Pair = Eigen::Matrix<double, 2 * dim, 1>;
  using PairMatrix = Eigen::Matrix<double, 2 * dim, 2 * dim>;
  using Gradient = Eigen::Matrix<double, dim, 2 * dim>;
  using Vector = Eigen::Matrix<double, sd, 1>;
  using Rotation = Eigen::Matrix<double, sd, sd>;

  /// @param K section stiffness  @param M_s section inertia per length without coupling of
  /// translation and rotation (the axis goes through the centres of mass)
  ReissnerElement(const G& A, const G& B, const Matrix& K, const Matrix& M_s);

  double length() const { return L_; }
  const Tangent& d0() const { return d0_; }
  const Matrix& section_stiffness() const { return K_; }
  const Matrix& section_inertia() const { return M_s_; }

  /// d = [R_m^T (x_B - x_A); phi]
  static Tangent relative(const G& A, const G& B);
  /// dd = P(d) [dh_A; dh_B]; with E = exp(phi/2):
  ///   d(d_u) = -E^T u_A + E u_B + d_u x (W(-phi) w_A + W(phi) w_B),  W(phi) = T(phi/2) T^-1(phi)/2
  ///   d(phi) = -T^-1(-phi) w_A + T^-1(phi) w_B
  static Gradient P(const Tangent& d);
  /// D_d [P(d) v] for velocities v = [v_A; v_B].
  static Matrix dP(const Tangent& d, const double* v);

  Tangent strain(const G& A, const G& B) const { return (relative(A, B) - d0_) / L_; }
  /// g = P(d)^T (n + damping K d(eps)/dt).  @param v velocities [v_A; v_B], used if damping > 0
  /// @param about unused: the law is linear in the stress
  void internal_force(const G& A, const G& B, const double* v, double damping, Pair& g,
                      const double* about = nullptr) const;
  /// P^T K P / L
  PairMatrix material_tangent(const G& A, const G& B) const;
  /// D_[h_A; h_B] (P^T n) with the stress n of its geometric term given. Not symmetric off
  /// equilibrium.
  PairMatrix tangent(const G& A, const G& B, const Tangent& n) const;

  /// g = inertia force; translations by the consistent mass in inertial axes, rotations by the
  /// consistent inertia in local ones, gyroscopic moments w x J w lumped at the nodes.
  /// @param v velocities [v_A; v_B]  @param a [vdot - R^T gravity] of both nodes
  void inertia_force(const G& A, const G& B, const double* v, const Pair& a, Pair& g) const;
  /// Mass matrix in local axes, and at reference: it changes with R_A^T R_B.
  PairMatrix mass(const G& A, const G& B) const;
  const PairMatrix& mass() const { return mass_; }
  /// Half of a dead load per length to each node, exactly.
  static constexpr bool kTurnsSpreadLoads = false;
  /// Weight needs no correction: it is exact in inertial axes.
  void add_weight_curvature(const G&, const G&, const Vector&, Pair&) const {}
  /// d (inertia force without M vdot) / dv: the gyroscopic and the convective part.
  PairMatrix gyroscopic_tangent(const G& A, const G& B, const double* v) const;
  /// d (inertia force and weight) / d[h_A; h_B]: weight turns, and the mass with R_A^T R_B.
  /// @param v, a as in inertia_force
  PairMatrix inertia_stiffness(const G& A, const G& B, const double* v, const Pair& a,
                               const Vector& gravity) const;
  /// Potential of gravity, J.
  double weight_potential(const G& A, const G& B, const Vector& a) const;
  /// Its gradient by [h_A; h_B]; and that of the kinetic energy at given velocities, whose mass
  /// changes with R = R_A^T R_B by m u_A . R u_B.
  Pair weight_gradient(const G& A, const G& B, const Vector& a) const;
  Pair kinetic_gradient(const G& A, const G& B, const double* v) const;
  double kinetic_energy(const G& A, const G& B, const double* v) const {
    const Eigen::Map<const Pair> V(v);
    return 0.5 * V.dot(mass(A, B) * V);
  }

  /// K_t = P(d0)^T K P(d0)/L at reference.
  PairMatrix constant_tangent() const;
  /// Shares of a load per length: half of it to each node.
  PairMatrix integral(const Matrix& M) const;

 private:
  Tangent d0_;
  double L_;
  Matrix K_, M_s_;
  PairMatrix mass_;
};

extern template class ReissnerElement<SE2>;
extern template class ReissnerElement<SE3>;

}  // namespace liesl
