#pragma once
/// @file
/// What a small round hole does to a meshed part, per volume that it takes out.
///
/// Topological derivatives of quantities y = c^T K^-1 f for a hole with a free edge (a circle in
/// plane stress, a sphere in space) whose radius goes to zero: with sigma the stress of the load f
/// and tau that of the output c, both without the hole,
///   dy/dV = (product sigma : tau + trace tr sigma tr tau) / E,
///   plane stress: product = 4, trace = -1;
///   space: product = 10 (1 + nu) k, trace = -(1 + 5 nu) k, k = 3 (1 - nu) / (2 (7 - 5 nu)).
/// The compliance is y with c = f. Sources: Sokolowski, Zochowski 1999, "On the topological
/// derivative in shape optimization", SIAM J. Control Optim. 37, 1251-1272; Garreau, Guillaume,
/// Masmoudi 2001, ibid. 39, 1756-1778; Novotny, Feijoo, Taroco, Padra 2003, CMAME 192, 803-829
/// (plane) and 2007, CMAME 196, 4354-4364 (space).

#include "mbs/solids/solid_statics.hpp"

namespace liesl {

/// Factors of sigma : tau and of tr sigma tr tau in E dy/dV.
struct HoleForm {
  double product = 0, trace = 0;
};
HoleForm hole_form(int dim, double nu);

/// dy/dV [Pa] for the stresses of load and output in the order of CellMatrices.
double hole_effect(int dim, const Material& material, const Eigen::VectorXd& sigma,
                   const Eigen::VectorXd& tau);

/// sum_n w_n d(f_n^T u_n)/dV at the centres of the cells, J/m^3; w [cases]. The stress is that of
/// the full material, so that only values of full cells mean something. With inertia relief the
/// mass that goes is part of it: + rho (mu . R a + u . R b), a and b as in
/// SolidStatics::output_gradient. @pre the last solve of `statics` gave Solved
Eigen::VectorXd compliance_of_holes(const SolidStatics& statics, const Eigen::VectorXd& w);
/// sum_n w_n dy(output, n)/dV, unit of the output / m^3.
Eigen::VectorXd output_of_holes(const SolidStatics& statics, int output, const Eigen::VectorXd& w);

}  // namespace liesl
