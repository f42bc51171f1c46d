#pragma once
/// @file
/// Stiffness and mass of a part between its nodes, as another program gives them.

#include <Eigen/SparseCore>
#include <optional>

#include "mbs/solids/mesh.hpp"

namespace liesl {

/// Freedoms node by node, in the axes of the nodes' positions: displacements, or displacements and
/// rotations (one in the plane, three in space).
struct NodalMatrices {
  Eigen::SparseMatrix<double> K;  ///< N/m (N, N m of rotations), both triangles
  Eigen::SparseMatrix<double> M;  ///< kg (kg m, kg m^2), likewise
};

/// Freedoms of a node: dim, or 3 (plane) and 6 (space) with its rotation.
/// @param nodes mesh without cells  @pre require_free_part accepts the matrices
int freedoms_of_a_node(const SolidMesh& nodes, const NodalMatrices& matrices);

/// @throws std::invalid_argument that says which matrix has what wrong: sizes, numbers that are not
/// finite, no symmetry (to 1e-9 of the largest entry), rigid motions that take forces (1e-8 of the
/// terms they are made of) or have not the mass of a rigid body (1e-6 of it), a mass that is not
/// positive
void require_free_part(const SolidMesh& nodes, const NodalMatrices& matrices);

/// The mass matrix of one component, N x N, where M = m (x) I: the consistent or lumped mass of
/// solids, from which every inertia integral follows. Nothing where components are coupled, as by a
/// static condensation, or nodes have rotations. @pre require_free_part accepts the matrices
std::optional<Eigen::SparseMatrix<double>> component_mass(const SolidMesh& nodes,
                                                          const NodalMatrices& matrices);

/// K takes work for every displacement: K + s M has a Cholesky factor, s = 1e-8 max K_jj / max M_jj
/// for the rigid motions, which take none. @pre require_free_part accepts the matrices
/// @throws std::invalid_argument if it has none: a sign, a unit or an entry is wrong
void require_positive_stiffness(const NodalMatrices& matrices);

}  // namespace liesl
