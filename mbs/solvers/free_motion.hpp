#pragma once
/// @file
/// Motions that nothing resists: a mechanism where a structure was meant.

#include <Eigen/Core>
#include <string>

#include "mbs/solvers/iteration_matrix.hpp"

namespace liesl {

/// Basis of the nodal increments x with B x = 0 and no stiffness, |x^T K x| < 1e-14 of the largest
/// stiffness of each body, orthonormal with rotations times model.length; n x (number of free
/// motions, at most 8). No unit matters, of length, force or amplitudes: each of those is set
/// against its own stiffness. Costs one factorisation and some solves.
/// @param A the tangent [K B^T; B 0] at some state
template <FrameGroup G>
Eigen::MatrixXd free_motions(const Model<G>& model, const Eigen::SparseMatrix<double>& A);

/// One sentence for the user: "body 'arm' can rotate about (0, 0, 1) through (1, 0, 0) at its node
/// 0
/// ..."; names the body that moves most. @pre motions has columns
template <FrameGroup G>
std::string describe_free_motion(const Model<G>& model, const State<G>& s,
                                 const Eigen::MatrixXd& motions);

extern template Eigen::MatrixXd free_motions(const Model<SE2>&, const Eigen::SparseMatrix<double>&);
extern template Eigen::MatrixXd free_motions(const Model<SE3>&, const Eigen::SparseMatrix<double>&);
extern template std::string describe_free_motion(const Model<SE2>&, const State<SE2>&,
                                                 const Eigen::MatrixXd&);
extern template std::string describe_free_motion(const Model<SE3>&, const State<SE3>&,
                                                 const Eigen::MatrixXd&);

}  // namespace liesl
