#pragma once
/// @file
/// Equilibria under a growing load: load steps or arc length, stability, critical loads.

#include <functional>

#include "mbs/solvers/initial_state.hpp"
#include "mbs/solvers/trajectory.hpp"

namespace liesl {

/// A load factor at which the tangent loses (or regains) definiteness.
struct CriticalPoint {
  double load = 0;            ///< load factor
  int before = 0, after = 0;  ///< negative eigenvalues of the tangent on either side
  bool limit_point = false;   ///< the load factor has an extremum; else a bifurcation
};

template <FrameGroup G>
struct StaticResult {
  Trajectory<G> trajectory;       ///< equilibria, t = load factor; the first record is the scene as
                                  ///< assembled, at load factor 0
  std::vector<int> negative;      ///< by record: negative eigenvalues of the tangent on the motions
                                  ///< that the joints leave; 0 = stable. The first record takes the
                                  ///< next one's if it is singular without load
  std::vector<int> iterations;    ///< by load step: corrections
  std::vector<double> residuals;  ///< relative, by iteration of the last load step
  std::vector<CriticalPoint> critical;
  Report report;
  InitialState start;
};

/// Called after each step with the load factor reached; return false to stop (Interrupted).
using LoadProgress = std::function<bool(double load)>;

/// Takes the load factor from 0 to options.max_load: gravity, constant loads and constant forces of
/// actuators are multiplied by it; tables and expressions are functions of it, drives too (for
/// them t = load factor). Each load step is a Newton iteration with the exact tangent and
/// extrapolated prestress (static_newton.hpp); one that fails is halved down to 1/1024 of its size,
/// then the path ends NotConverged at the load reached, with the records until there.
///
/// options.arc_length: the path is followed by linearised arc length past limit points, which are
/// located to 1e-5 of the load factor, until max_load, -max_load or 500 steps.
/// options.critical: loads where the number of negative eigenvalues changes between two records
/// are located to 1e-5; the first is reported in Report::warnings.
///
/// Singular: something can move freely at the start, with the body's name and the motion;
/// Inconsistent: cannot be assembled. Never throws for non-convergence; no record holds a NaN.
template <FrameGroup G>
StaticResult<G> solve_static(const Model<G>& model, const SimulationOptions& options,
                             const LoadProgress& progress = {});

extern template StaticResult<SE2> solve_static(const Model<SE2>&, const SimulationOptions&,
                                               const LoadProgress&);
extern template StaticResult<SE3> solve_static(const Model<SE3>&, const SimulationOptions&,
                                               const LoadProgress&);

}  // namespace liesl
