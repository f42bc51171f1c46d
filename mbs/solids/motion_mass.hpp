#pragma once
/// @file
/// The mass of all motions of a part of small displacements in a moving frame.

#include <Eigen/Core>

#include "mbs/solids/solid_model.hpp"

namespace liesl {

/// Velocities of the nodes are linear in y = [v; omega; edot; omega_x e; omega_y e; omega_z e] (in
/// the plane [v; omega; edot; omega e]): those of displacements v + omega x (s + phi e) + phi edot,
/// of rotations omega + phi edot. With W of these columns,
///   T = y^T (W^T M W) y / 2,
/// whatever the nodes share of their masses. Only v . (omega x e) is not that of M: an accelerated
/// frame acts as gravity does, and momentum is the rate of the first moment, where it is
/// v . (omega x N e), N = (W^T M W)_{v edot}, as it is of solids.
/// @param basis Psi, coordinates q of the model x e  @param origin of the frame, in the axes of the
/// mesh  @param turn components in the axes of the frame from those in the axes of the mesh
/// @return W^T M W, kg, kg m, kg m^2  @pre model.coupled_mass()
Eigen::MatrixXd motion_mass(const SolidModel& model, const Eigen::MatrixXd& basis,
                            const Eigen::Vector3d& origin, const Eigen::Matrix3d& turn);

}  // namespace liesl
