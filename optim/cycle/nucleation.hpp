#pragma once
/// @file
/// Where a new hole in a meshed part would reduce the objective, from the topological derivative at
/// an optimum, and how it becomes a feature of the outline that moves like the others.
/// Experimental.
///
/// Source: H. A. Eschenauer, V. V. Kobelev, A. Schumacher 1994, "Bubble method for topology and
/// shape optimization of structures", Structural Optimization 8, 42-51; the derivative:
/// mbs/solids/topological_derivative.hpp.

#include "optim/problems/solid_task.hpp"

namespace liesl {

struct Nucleus {
  Eigen::Vector3d place;  ///< m, in the coordinates of the mesh
  double radius = 0;      ///< m
  double gain = 0;        ///< what the objective falls by, per volume taken out: unit / m^3
};

struct HoleProposal {
  /// -dL/dV at the centres of full cells, unit of the objective / m^3, with the multipliers of the
  /// design; 0 in other cells. Empty if it is not known, see `reason`.
  Eigen::VectorXd gain;
  std::optional<Nucleus> nucleus;
  std::string reason;  ///< why there is no nucleus; empty if there is one
};

/// Where a new hole would reduce the objective in one meshed part.
struct PartProposal {
  int body = 0;
  HoleProposal hole;
};

/// The cell with the largest gain round whose centre a hole of kHoleCells cells' radius leaves
/// kClearCells cells, and the largest `least` of the walls, to the surface of the mesh, interfaces,
/// held nodes and all that is not full. Evaluates the static problem at x once.
HoleProposal propose_hole(const SolidTask& task, const std::vector<WallSpec>& walls,
                          const Eigen::VectorXd& x);

inline constexpr double kHoleCells = 3, kClearCells = 2;

/// Adds the nucleus to the outline, taken off the whole shape: an ellipse (ellipsoid) "new_hole1",
/// and its variables to the design: position within the mesh, half-axes from one cell to half the
/// longest side of the mesh. Where the design has walls, the hole keeps from each feature or
/// interface in them the least of their thicknesses, from another hole the least of all.
/// @returns the name of the feature
std::string insert_hole(const Nucleus& nucleus, const SolidMesh& mesh, levelset::ShapeSpec& outline,
                        ShapeDesignSpec& design);

}  // namespace liesl
