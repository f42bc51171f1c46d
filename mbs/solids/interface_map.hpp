#pragma once
/// @file
/// The map from the coordinates of a meshed part to the displacements of its nodes.

#include <Eigen/SparseCore>
#include <vector>

#include "mbs/solids/interface.hpp"
#include "mbs/solids/mesh.hpp"

namespace liesl {

/// Displacement of a point by the rigid motions about `centre`: dim x 3 (plane) or 6.
Eigen::MatrixXd rigid_displacement(int dim, const Eigen::Vector3d& x,
                                   const Eigen::Vector3d& centre);

/// The same of all freedoms of a node: `freedoms` = dim, its displacement, or with its rotation
/// behind that, 3 in the plane and 6 in space.
Eigen::MatrixXd rigid_motion(int dim, int freedoms, const Eigen::Vector3d& x,
                             const Eigen::Vector3d& centre);

struct InterfaceMap {
  Eigen::SparseMatrix<double> T;  ///< node freedoms x q
  std::vector<int> coordinate;    ///< by freedom; -1: depends on others
};

/// Rigid: u_i = rigid_motion(x_i) q_P, rotations of nodes among them. Averaged, of displacements:
/// with the rows C of the least-squares motion of the nodes, q_P = C u; the freedoms d that a
/// pivoted QR of C picks are solved for, u_d = C_d^-1 (q_P - C_rest u_rest).
/// @param freedoms of a node  @throws std::invalid_argument, see SolidModel
InterfaceMap interface_map(const SolidMesh& mesh, int freedoms,
                           const std::vector<Interface>& interfaces);

}  // namespace liesl
