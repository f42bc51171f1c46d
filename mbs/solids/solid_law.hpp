#pragma once
/// @file
/// Hyperelastic laws of meshed parts whose nodes all move: isotropic, in terms of the
/// Green-Lagrange strain E, with C = I + 2 E and J = sqrt(det C).

#include <Eigen/Core>

#include "mbs/sections/section.hpp"

namespace liesl {

enum class SolidLaw {
  StVenantKirchhoff,  ///< W = lambda tr(E)^2/2 + mu E:E; small strains, any rotations
  NeoHookean          ///< W = mu/2 (tr C - 3 - 2 ln J) + lambda/2 (ln J)^2, compressible
};
/// "st_venant_kirchhoff", "neo_hookean": as a scene calls it.
const char* to_string(SolidLaw law);

/// @tparam D 2: plane stress, 3: space
template <int D>
struct LawAtPoint {
  static constexpr int kStrains = D == 2 ? 3 : 6;
  double energy = 0;  ///< W, J/m^3
  double across = 1;  ///< stretch of a plate through its thickness
  /// d(ln across)/dE; zero in space
  Eigen::Matrix<double, kStrains, 1> thinning = Eigen::Matrix<double, kStrains, 1>::Zero();
  Eigen::Matrix<double, kStrains, 1> stress;          ///< S = dW/dE, Pa
  Eigen::Matrix<double, kStrains, kStrains> tangent;  ///< dS/dE, Pa
};

/// W, S and dS/dE at a strain [E_xx, E_yy, (E_zz,) 2 E_xy(, 2 E_yz, 2 E_zx)]. In the plane E_zz is
/// that of S_zz = 0. Not finite where det C <= 0 (neo-Hookean).
template <int D>
LawAtPoint<D> solid_law(SolidLaw law, const Material& material,
                        const Eigen::Matrix<double, (D == 2 ? 3 : 6), 1>& strain);

}  // namespace liesl
