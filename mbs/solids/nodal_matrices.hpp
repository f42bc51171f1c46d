#pragma once
/// @file
/// Stiffness and mass of a part between its nodes, as another program gives them.

#include <Eigen/SparseCore>

#include "mbs/solids/mesh.hpp"

namespace liesl {

/// Freedoms: dim * node + component, in the axes of the nodes' positions.
struct NodalMatrices {
  Eigen::SparseMatrix<double> K;  ///< N/m, dim N x dim N, both triangles
  Eigen::SparseMatrix<double> M;  ///< kg, likewise
};

/// The mass matrix of one component, N x N, of nodes with M = m (x) I: the consistent or lumped
/// mass of solids, from which every inertia integral follows.
/// @param nodes mesh without cells
/// @throws std::invalid_argument that says which matrix has what wrong: sizes, numbers that are not
/// finite, no symmetry (to 1e-9 of the largest entry), rigid motions that take forces (1e-8 of the
/// terms they are made of), a mass between components or unlike in them, a mass that is not
/// positive
Eigen::SparseMatrix<double> component_mass(const SolidMesh& nodes, const NodalMatrices& matrices);

/// K takes work for every displacement: K + s M has a Cholesky factor, s = 1e-8 max K_jj / max M_jj
/// for the rigid motions, which take none. @pre component_mass accepts the matrices
/// @throws std::invalid_argument if it has none: a sign, a unit or an entry is wrong
void require_positive_stiffness(const NodalMatrices& matrices);

}  // namespace liesl
