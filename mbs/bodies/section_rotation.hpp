#pragma once
/// @file
/// Kinetic energy of the rotation of sections in a two-node element of fourth
/// order:
///
///   T = [y_A . J_a y_A + y_B . J_a y_B + y_A . (J_c S + S J_c) y_B]/2,  y_k =
///   w_k + B rho_k',
///
/// S = R_A^T R_B, rho_k = R_k^T r how far the middle turns beyond the mean of
/// both nodes (by bending and by shear, r in hermite_inertia.hpp) in the axes
/// of node k, rho_k' its rate there, which a rigid motion of the element does
/// not change, and B rho = e_1 x (beta rho) the part beta of it, as a rotation.
/// y_k is what the section of node k, if it moved like those between the nodes,
/// would turn with.
///
/// By Hamilton's principle in body axes p' + w x p - dT/dh is on w_k and B^T p'
/// on rho_k, p = dT/dy.

#include <array>

#include "liegroup/rotation.hpp"

namespace liesl {

template <FrameGroup G>
class SectionRotation {
 public:
  static constexpr int dim = G::dim, sd = G::space_dim, rd = G::rotation_dim;
  using Scalar = typename G::Scalar;
  using Pair = Eigen::Matrix<Scalar, 2 * dim, 1>;
  using PairMatrix = Eigen::Matrix<Scalar, 2 * dim, 2 * dim>;
  using Vector = Eigen::Matrix<Scalar, sd, 1>;
  using Inertia = Eigen::Matrix<Scalar, rd, rd>;
  using Turning = Eigen::Matrix<Scalar, sd, rd>;

  /// X w = w x e_1.
  static Turning turning() { return -RotationOf<G>::cross(Vector::Unit(0)); }

  /// @param Ja,Jc kg m^2
  /// @param beta  share by direction (component 0 is unused)
  SectionRotation(const Scalar& L, const Inertia& Ja, const Inertia& Jc, const Vector& beta);
  /// Four at once.
  template <class One>
  explicit SectionRotation(const Four<SectionRotation<One>>& four)
      : L_(gather(four, &SectionRotation<One>::L_)),
        Ja_(gather(four, &SectionRotation<One>::Ja_)),
        Jc_(gather(four, &SectionRotation<One>::Jc_)),
        beta_(gather(four, &SectionRotation<One>::beta_)) {}

  /// g += what T asks for at velocities v and accelerations a of both nodes, 2
  /// dim each: M a and the gyroscopic force, N and N m in the axes of the
  /// nodes.
  void add_force(const G& A, const G& B, const Scalar* v, const Pair& a, Pair& g) const;
  /// M of T = v . M v/2, at these frames.
  void add_mass(const G& A, const G& B, PairMatrix& M) const;
  /// d (force without M vdot)/dv.
  void add_gyroscopic_tangent(const G& A, const G& B, const Scalar* v, PairMatrix& C) const;
  /// d force/d[h_A; h_B] at constant v and a.
  void add_stiffness(const G& A, const G& B, const Scalar* v, const Pair& a, PairMatrix& K) const;
  /// T, J.
  Scalar kinetic_energy(const G& A, const G& B, const Scalar* v) const;
  /// dT/d[h_A; h_B] at constant v.
  void add_kinetic_gradient(const G& A, const G& B, const Scalar* v, Pair& g) const;

 private:
  template <FrameGroup>
  friend class SectionRotation;

  using Rotation = Eigen::Matrix<Scalar, sd, sd>;
  using Angular = Eigen::Matrix<Scalar, rd, 1>;
  using Gradient = Eigen::Matrix<Scalar, sd, 2 * dim>;
  /// By [q; w_A; w_B], q = R_A^T (x_B - x_A)/L.
  static constexpr int relative = sd + 2 * rd;
  using RelativeGradient = Eigen::Matrix<Scalar, sd, relative>;
  using TurnGradient = Eigen::Matrix<Scalar, rd, 2 * dim>;
  /// A node as the other one sees it.
  struct Place {
    int at, other;  ///< first of their unknowns
    double sign;    ///< of x in r
    Rotation S;     ///< from the axes of the other one
    Vector rho;
  };
  struct Values;  ///< vectors, of which forces are made
  template <int K>
  struct Jets;      ///< vectors with their derivatives, of which tangents are made:
  struct ByRates;   ///< by rates, frames constant
  struct ByFrames;  ///< by frames, rates constant
  template <class Q>
  struct Node;
  template <class Q>
  struct Motion;
  template <class Q>
  struct Turn;
  template <class Q>
  struct Momentum;
  template <class Q>
  struct Force;

  std::array<Place, 2> places(const G& A, const G& B) const;
  /// Where w of the node whose unknowns begin there is among [q; w_A; w_B].
  static constexpr int turn_of(int at) { return at == 0 ? sd : sd + rd; }
  RelativeGradient relative_gradient(const Place& me) const;
  Gradient gradient(const Place& me) const;
  /// D by q, w_A and w_B as one by the increments of both nodes. @param S of node A
  template <int n>
  Eigen::Matrix<Scalar, n, 2 * dim> by_increments(const Eigen::Matrix<Scalar, n, relative>& D,
                                                  const Rotation& S) const;
  TurnGradient turn_gradient(const Place& me) const;
  Inertia coupling(const Place& me) const;
  static Motion<Values> motion(const Place& me, const Scalar* v, const Pair& a);
  template <class Q>
  Node<Q> node(const Place& me, typename Q::Frame S, typename Q::Turned rho,
               const Motion<Q>& q) const;
  Node<ByRates> by_rates(const Place& me, const Scalar* v) const;
  Node<ByFrames> by_frames(const Place& me, const Scalar* v, const Pair& a) const;
  template <class Q>
  typename Q::Space rate(const Node<Q>& me, const Node<Q>& other) const;
  template <class Q>
  Turn<Q> turn(const Node<Q>& me, const Node<Q>& other) const;
  template <class Q>
  Momentum<Q> momentum(const Node<Q>& me, const Turn<Q>& my, const Turn<Q>& its) const;
  template <class Q>
  void add_force_of(const Node<Q>& me, const Turn<Q>& my, const Node<Q>& other, const Turn<Q>& its,
                    Force<Q>& on_me, Force<Q>& on_other) const;
  template <class Q>
  void add_force_of(const Node<Q>& A, const Node<Q>& B, Force<Q>& on_A, Force<Q>& on_B) const;
  template <class Q>
  void add_derivative(const Node<Q>& A, const Node<Q>& B, const Rotation& S, PairMatrix& K) const;

  Scalar L_;
  Inertia Ja_, Jc_;
  Vector beta_;
};

extern template class SectionRotation<SE2>;
extern template class SectionRotation<SE3>;

}  // namespace liesl
