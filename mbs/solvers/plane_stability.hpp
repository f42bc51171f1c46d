#pragma once
/// @file
/// Does a motion in the plane of a mechanism stay there? Small motions out of the plane, linearised
/// about a state of the planar motion.

#include <optional>

#include "mbs/solvers/iteration_matrix.hpp"
#include "mbs/system/spatial_view.hpp"

namespace liesl {

/// With left-invariant increments eta of the frames, dv = eta' + ad(v) eta and
/// dvdot = eta'' + ad(v) eta' + ad(vdot) eta, the equations of motion in space become
///   M eta'' + (C + M ad(v)) eta' + (K + C ad(v) + M ad(vdot)) eta + B^T dlambda = 0, B eta = 0,
/// and by the symmetry of the mechanism motions out of the plane are apart from those in it. Their
/// lowest eigenvalue omega^2 of the symmetric part of (K + ..., M) tells: below zero a small motion
/// grows as exp(t sqrt(-omega^2)). Gyroscopic forces and damping are not counted.
class PlaneStability {
 public:
  /// @param model of the mechanism in its plane
  PlaneStability(const Mechanism& mechanism, const Model<SE2>& model);

  /// sqrt(-omega^2), 1/s; 0: nothing grows; empty: it cannot be told (bodies with nodes that follow
  /// others, no accelerations that balance the forces).
  /// @param s a state of the motion, with its accelerations
  std::optional<double> growth(const State<SE2>& s);

 private:
  bool take(const State<SE2>& s);
  bool find_multipliers();
  void take_rates();
  /// Columns: increments out of the plane, orthonormal in each node.
  Eigen::SparseMatrix<double> out_of_plane() const;

  const Model<SE2>& plane_;
  SpatialView<SE2> view_;
  Model<SE3> model_;
  State<SE3> s_;
  Equations<SE3> equations_;
  IterationMatrix<SE3> matrix_;
  RateTangents<SE3> rates_;
  bool frames_only_ = true;
  Eigen::SparseMatrix<double> out_of_plane_;
};

}  // namespace liesl
