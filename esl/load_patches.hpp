#pragma once
/// @file
/// Loads on the free nodes of a meshed part as a few resultants, to be shown.

#include <Eigen/SparseCore>

#include "mbs/solids/solid_model.hpp"

namespace liesl {

/// Cells of a regular grid over the mesh that hold free nodes. What acts on the nodes of a patch,
/// f_i at x_i, is the wrench [sum f_i; sum (x_i - x) x f_i] at its place x, the mean of its nodes:
/// with those on the interfaces the same force and moment as all of the load.
struct LoadPatches {
  Eigen::Matrix3Xd places;                ///< m, axes of the mesh
  Eigen::SparseMatrix<double> resultant;  ///< 6 patches x coordinates q of the part; N, N m

  /// [force; moment] of each patch under loads f in the coordinates q.
  Eigen::Matrix<double, 6, Eigen::Dynamic> of(const Eigen::VectorXd& f) const;
};

/// About kLoadPatches of them, as square as the box of the mesh allows; the mesh alone decides, so
/// that all designs of a part have the same.
inline constexpr int kLoadPatches = 24;
LoadPatches load_patches(const SolidModel& model);

}  // namespace liesl
