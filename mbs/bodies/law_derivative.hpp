#pragma once
/// @file
/// What a body is made of, as far as a parameter can change it, and its derivative d/dp.

#include <Eigen/Core>
#include <variant>
#include <vector>

#include "liegroup/concepts.hpp"

namespace liesl {

class SolidModel;

/// Section data of one element in the local axes of G: SE(3) [eps_x, gamma_y, gamma_z, kappa_x,
/// kappa_y, kappa_z], SE(2) [eps_x, gamma_y, kappa_z]; or their derivatives by a parameter.
template <FrameGroup G>
struct ElementSection {
  typename G::Matrix K, M;
};

/// d(fractions)/dp of the cells of a meshed part.
struct FractionDerivative {
  const SolidModel* model = nullptr;  ///< of the part
  Eigen::VectorXd fractions;          ///< by cell, those that the body was made with
  Eigen::VectorXd derivative;         ///< by cell
};

/// d(stiffness)/dp, d(mass)/dp and d(stress of the material at given strains)/dp of all cells of a
/// meshed part alike, relative to the part's own: [1/E, 0, 1/E] by E, [0, 1/rho, 0] by rho,
/// [1/t, 1/t, 0] by the thickness t of a planar mesh.
struct ScaleDerivative {
  double stiffness = 0, mass = 0, stress = 0;  ///< 1 per unit of p
};

/// d/dp of what a body is made of, by its kind:
/// - a beam, whatever it moves as: d(K, M_s)/dp of each element;
/// - a rigid body: d(inertia)/dp, the generalized inertia about its frame, conjugate to [u; w];
/// - a meshed part: d(fractions)/dp of its cells; or the scale of its matrices.
template <FrameGroup G>
using LawDerivative = std::variant<std::vector<ElementSection<G>>, typename G::Matrix,
                                   FractionDerivative, ScaleDerivative>;

}  // namespace liesl
