#pragma once
/// @file
/// Shape optimisation under loads that stay: static optima within move limits of the outline, one
/// after the other, until the optimum lies inside.

#include "optim/cycle/cycle_rules.hpp"
#include "optim/cycle/static_shape.hpp"

namespace liesl {

struct ShapeStep {
  int number = 0;
  Eigen::VectorXd x;   ///< where the step starts
  SolidCheck check;    ///< of x
  int load_cases = 0;  ///< retained at the end of the step
  int iterations = 0;  ///< of the optimiser
  double seconds = 0;
};

struct ShapeResult {
  CycleStatus status = CycleStatus::Infeasible;
  std::string reason;
  std::vector<ShapeStep> history;  ///< the last one is of the final design
  Eigen::VectorXd x;               ///< final design; empty if there is none
  double stationarity = 0;         ///< scaled residual of the optimality conditions
  Eigen::VectorXd fractions;       ///< of the final design
  Eigen::MatrixXd displacements;   ///< of the nodes in all cases, node freedoms x cases, m
  Eigen::MatrixXd von_mises;       ///< relaxed, at the centres, cells x cases, Pa
};

struct ShapeHooks {
  std::function<void(const std::vector<ShapeStep>&)> on_step;
  std::function<bool()> keep_going;  ///< false = Interrupted
};

struct ShapeMoves {
  double cells = 2;     ///< the outline moves by at most so many cells in a step
  double share = 0.25;  ///< and a variable by this share of its range
};

/// Ends Converged where the optimum of a step keeps off its move limits and meets all limits;
/// Infeasible with the name of what cannot be met or of what is cut; CycleLimit after
/// `task.cycle.max` steps.
ShapeResult optimise_shape(const SolidTask& task, const ShapeMoves& moves,
                           const ShapeHooks& hooks = {});

}  // namespace liesl
