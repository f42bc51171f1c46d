#pragma once
/// @file
/// Stiffness, mass and stress of one cell, in plane stress or in space. Quadrilaterals and
/// hexahedra of order 1 have incompatible modes, so that they bend without locking.

#include <Eigen/Core>

#include "mbs/sections/section.hpp"

namespace liesl {

/// Degrees of freedom: dim * node + component. Stresses: xx, yy, xy, or xx, yy, zz, xy, yz, zx.
struct CellMatrices {
  Eigen::MatrixXd K;       ///< N/m; incompatible modes condensed: K_uu - K_ua K_aa^-1 K_au
  Eigen::MatrixXd M;       ///< kg, consistent, of one component: nodes x nodes
  Eigen::MatrixXd stress;  ///< Pa/m, at the centre: sigma = stress * u
  double volume = 0;       ///< m^3
};

/// Isoparametric displacement with the quadrature of `cell_quadrature`; of 4-node quadrilaterals
/// and 8-node hexahedra plus incompatible modes 1 - xi_i^2 in each direction, with the Jacobian of
/// the centre (Taylor, Beresford, Wilson 1976, "A non-conforming element for stress analysis", Int.
/// J. Numer. Meth. Engng 10, 1211-1219: QM6), which passes the patch test. 3-node triangles and
/// 4-node tetrahedra have constant strain: they lock in bending.
/// @param nodes 3 x nodes of the cell, m  @param thickness of planar cells, m; not used in space
CellMatrices cell_matrices(int dim, const Eigen::Matrix3Xd& nodes, const Material& material,
                           double thickness);

}  // namespace liesl
