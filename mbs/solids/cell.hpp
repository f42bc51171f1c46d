#pragma once
/// @file
/// Stiffness, mass and stress of one cell, quadrilateral (plane stress) or hexahedron, with
/// incompatible modes, so that it bends without locking.

#include <Eigen/Core>

#include "mbs/sections/section.hpp"

namespace liesl {

/// Degrees of freedom: dim * corner + component. Stresses: xx, yy, xy, or xx, yy, zz, xy, yz, zx.
struct CellMatrices {
  Eigen::MatrixXd K;       ///< N/m, condensed: K_uu - K_ua K_aa^-1 K_au
  Eigen::MatrixXd M;       ///< kg, consistent, of one component: corners x corners
  Eigen::MatrixXd stress;  ///< Pa/m, at the centre: sigma = stress * u
  double volume = 0;       ///< m^3
};

/// Isoparametric displacement plus incompatible modes 1 - xi_i^2 in each direction, with the
/// Jacobian of the centre (Taylor, Beresford, Wilson 1976, "A non-conforming element for stress
/// analysis", Int. J. Numer. Meth. Engng 10, 1211-1219: QM6), which passes the patch test; full
/// Gauss integration (2 points a direction).
/// @param corners 3 x 4 or 8, m  @param thickness of quadrilaterals, m; not used in space
CellMatrices cell_matrices(int dim, const Eigen::Matrix3Xd& corners, const Material& material,
                           double thickness);

}  // namespace liesl
