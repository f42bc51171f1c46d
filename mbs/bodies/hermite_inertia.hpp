#pragma once
/// @file
/// Inertia of a two-node beam element of fourth order.
///
/// Kinetic energy of translation by Simpson's rule, the middle where the cubic through both nodes
/// with tangents b_k = R_k e_1 is, x_m = (x_A + x_B)/2 + (L/8)(b_A - b_B), in inertial axes:
///
///   T = m L [|xdot_A|^2 + 4 |xdot_m|^2 + |xdot_B|^2]/12 + (m L^3/24)|rdot|^2 + rotation,
///   r = (x_B - x_A)/L - (b_A + b_B)/2.
///
/// The second term makes waves along the axis of fourth order (masses 5/12, 1/12 of a linear
/// element). Rotation of sections (SectionRotation): (5/12, 1/12) of J L for torsion, (1/3 + j,
/// 1/6 - j) for bending, j = s/(6 (1 + s)), and the part beta = D/J of how far the middle turns
/// beyond the mean, D = (1 - s) J + s^2 m L^2/24, s^2 = 1 - eta and eta the share of bending in the
/// flexibility L^2/(12 EI) + 1/(GA) (from 0 on short elements to 1). With these beta and j bending
/// waves are of fourth order whatever eta is (docs/theory.md).
///
/// T depends on x_B - x_A and S = R_A^T R_B only and is exact for translations: linear momentum
/// and energy are kept, and so is the weight exact. Forces are virtual work of accelerations,
/// sum_k (dV_k)^T Vdot.

#include <vector>

#include "mbs/bodies/section_rotation.hpp"

namespace liesl {

template <FrameGroup G>
class HermiteInertia {
 public:
  static constexpr int dim = G::dim, sd = G::space_dim, rd = G::rotation_dim;
  using Scalar = typename G::Scalar;
  using Tangent = typename G::Tangent;
  using Matrix = typename G::Matrix;
  using Pair = Eigen::Matrix<Scalar, 2 * dim, 1>;
  using PairMatrix = Eigen::Matrix<Scalar, 2 * dim, 2 * dim>;
  using Vector = Eigen::Matrix<Scalar, sd, 1>;
  using Rotation = Eigen::Matrix<Scalar, sd, sd>;
  using Square = Eigen::Matrix<Scalar, 2, 2>;
  using Share = Eigen::Matrix<Scalar, sd, 1>;

  /// The inertia per length M_s (without coupling of translation and rotation), and what J, m and
  /// eta make of bending along y and z (component 0 is unused).
  struct Coefficients {
    Matrix M;     ///< kg/m, kg m
    Share shear;  ///< 12 j J, kg m
    Share beta;   ///< D/J
  };
  /// @param eta share of bending by direction
  static Coefficients coefficients(const Scalar& L, const Matrix& M, const Share& eta);
  /// d(coefficients)/dp.
  static Coefficients derivative(const Scalar& L, const Matrix& M, const Share& eta,
                                 const Matrix& dM, const Share& deta);

  HermiteInertia(const Scalar& L, const Coefficients& c);
  /// Four at once. @pre none is a derivative
  template <class One>
  explicit HermiteInertia(const Four<HermiteInertia<One>>& four)
      : L_(gather(four, &HermiteInertia<One>::L_)),
        m_(gather(four, &HermiteInertia<One>::m_)),
        X_(SectionRotation<G>::turning()),
        AA_(gather(four, &HermiteInertia<One>::AA_)),
        AB_(gather(four, &HermiteInertia<One>::AB_)),
        BB_(gather(four, &HermiteInertia<One>::BB_)),
        M_AA_(gather(four, &HermiteInertia<One>::M_AA_)),
        M_BB_(gather(four, &HermiteInertia<One>::M_BB_)),
        sections_{SectionRotation<G>(
            Four<SectionRotation<One>>{&four[0]->sections_[0], &four[1]->sections_[0],
                                       &four[2]->sections_[0], &four[3]->sections_[0]})} {}
  /// dT/dp: T is linear in M and shear, quadratic in beta.
  HermiteInertia(const Scalar& L, const Coefficients& c, const Coefficients& dc);

  void force(const G& A, const G& B, const Scalar* v, const Pair& a, Pair& g) const;
  PairMatrix mass(const G& A, const G& B) const;
  /// d (force without M vdot)/dv.
  PairMatrix gyroscopic_tangent(const G& A, const G& B, const Scalar* v) const;
  /// d force/d[h_A; h_B] at constant v and a, without what turns in a.
  PairMatrix stiffness(const G& A, const G& B, const Scalar* v, const Pair& a) const;
  /// k += M d[-R^T gravity]/dh of both nodes: what turns in `a` of weight.
  /// @param M mass(A, B)
  static void add_weight_tangent(const G& A, const G& B, const Vector& gravity, const PairMatrix& M,
                                 PairMatrix& k);
  /// T, J.
  Scalar kinetic_energy(const G& A, const G& B, const Scalar* v) const;
  /// dT/d[h_A; h_B] at constant v.
  Pair kinetic_gradient(const G& A, const G& B, const Scalar* v) const;
  Scalar weight_potential(const G& A, const G& B, const Vector& a) const;
  Pair weight_gradient(const G& A, const G& B, const Vector& a) const;

 private:
  template <FrameGroup>
  friend class HermiteInertia;

  using Two = Eigen::Matrix<Scalar, sd, 2>;  ///< [u, w x e_1] of a node
  using Turning = Eigen::Matrix<Scalar, sd, rd>;
  /// Derivatives of both vectors of a node by [u; w]: [uu uw; 0 w1].
  struct Derivatives {
    Rotation uu;
    Turning uw, w1;
  };

  void set_translation();
  Two of_node(const Tangent& v) const;
  Two acceleration(const Tangent& v, const Tangent& a) const;
  Tangent collect(const Two& f) const;
  Derivatives by_rates() const { return {Rotation::Identity(), Turning::Zero(), X_}; }
  Derivatives gyroscopic(const Tangent& v) const;
  Matrix block(const Square& c, const Rotation& R, const Derivatives& by) const;
  template <class F>
  void add_turned(const F& on, int row, int column, PairMatrix& k) const;

  Scalar L_, m_;
  Turning X_;  ///< w x e_1 = X w
  Square AA_, AB_, BB_;
  Matrix M_AA_, M_BB_;                        ///< of translation, constant
  std::vector<SectionRotation<G>> sections_;  ///< one, or the terms of a derivative
};

extern template class HermiteInertia<SE2>;
extern template class HermiteInertia<SE3>;

}  // namespace liesl
