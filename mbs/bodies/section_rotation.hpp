#pragma once
/// @file
/// Kinetic energy of the rotation of sections in a two-node element of fourth order:
///
///   T = [w_A . J_a w_A + w_B . J_a w_B + w_A . (J_c S + S J_c) w_B]/2
///     + sum_k [(L/2) w_k . E^T rho_k' + rho_k' . c rho_k'/4],
///   E w = D (w x e_1),  c = L D^2/J,  S = R_A^T R_B,
///
/// k = A, B, rho_k = R_k^T r how far the middle turns beyond the mean of both nodes (by bending and
/// by shear, r in hermite_inertia.hpp) in the axes of node k, and rho_k' its rate there: what a
/// rigid motion of the element does not change. With J_a + J_c = J L/2 a straight element has
/// (J L/2) |w_mean + (D/J) rho'|^2 and (J_a - J_c)/4 |w_B - w_A|^2: positive whatever D is.
///
/// Forces follow from Hamilton's principle in body axes, with w_k' = (d h_k/dt) + w_k x h_k.

#include <array>

#include "liegroup/rotation.hpp"

namespace liesl {

template <FrameGroup G>
class SectionRotation {
 public:
  static constexpr int dim = G::dim, sd = G::space_dim, rd = G::rotation_dim;
  using Pair = Eigen::Matrix<double, 2 * dim, 1>;
  using PairMatrix = Eigen::Matrix<double, 2 * dim, 2 * dim>;
  using Vector = Eigen::Matrix<double, sd, 1>;
  using Inertia = Eigen::Matrix<double, rd, rd>;
  using Turning = Eigen::Matrix<double, sd, rd>;

  /// X w = w x e_1.
  static Turning turning() { return -RotationOf<G>::cross(Vector::Unit(0)); }

  /// @param Ja,Jc kg m^2
  /// @param D     kg m
  /// @param c     kg m^2
  SectionRotation(double L, const Inertia& Ja, const Inertia& Jc, const Vector& D, const Vector& c);

  void add_force(const G& A, const G& B, const double* v, const Pair& a, Pair& g) const;
  void add_mass(const G& A, const G& B, PairMatrix& M) const;
  /// d (force without M vdot)/dv.
  void add_gyroscopic_tangent(const G& A, const G& B, const double* v, PairMatrix& C) const;
  /// d force/d[h_A; h_B] at constant v and a.
  void add_stiffness(const G& A, const G& B, const double* v, const Pair& a, PairMatrix& K) const;
  /// dT/d[h_A; h_B] at constant v.
  void add_kinetic_gradient(const G& A, const G& B, const double* v, Pair& g) const;

 private:
  using Rotation = Eigen::Matrix<double, sd, sd>;
  using Gradient = Eigen::Matrix<double, sd, 2 * dim>;
  /// A node as the other one sees it.
  struct Place {
    int at, other;  ///< first of their unknowns
    double sign;    ///< of x in r
    Rotation S;     ///< from the axes of the other one
    Vector rho;
  };
  struct Values;  ///< vectors, of which forces are made
  struct Jets;    ///< vectors with their derivatives, of which tangents are made
  template <class Q>
  struct Node;
  template <class Q>
  struct Force;

  std::array<Place, 2> places(const G& A, const G& B) const;
  Gradient gradient(const Place& me) const;
  Node<Jets> by_rates(const Place& me, const double* v) const;
  Node<Jets> by_frames(const Place& me, const double* v, const Pair& a) const;
  template <class Q>
  typename Q::Space rate(const Node<Q>& me, const Node<Q>& other) const;
  template <class Q>
  typename Q::Space second_rate(const Node<Q>& me, const Node<Q>& other,
                                const typename Q::Space& rate) const;
  template <class Q>
  typename Q::Angular momentum_rate(const Node<Q>& me, const Node<Q>& other) const;
  template <class Q>
  void add_force_of(const Node<Q>& me, const Node<Q>& other, Force<Q>& on_me,
                    Force<Q>& on_other) const;
  void add_derivative(const Node<Jets>& A, const Node<Jets>& B, PairMatrix& K) const;

  double L_;
  Inertia Ja_, Jc_;
  Vector c_;
  Turning X_, E_;
};

extern template class SectionRotation<SE2>;
extern template class SectionRotation<SE3>;

}  // namespace liesl
