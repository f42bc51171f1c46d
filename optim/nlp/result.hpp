#pragma once
/// @file
/// What a driver is told and what it answers: options with their ranges, result with a reason.

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "optim/nlp/problem.hpp"

namespace liesl {

enum class NlpStatus {
  Converged,       ///< optimality conditions hold within `tolerance`, constraints in `feasibility`
  Acceptable,      ///< feasible and within `acceptable` of optimality, but no better is reached
  IterationLimit,  ///< iterations or time are used up
  Infeasible,      ///< no point near meets all constraints; `conflict` says which and by how much
  Stopped          ///< anything else; `reason` says what
};
const char* to_string(NlpStatus status);

/// State of the iteration, for progress displays. All in units of the problem.
struct NlpProgress {
  int iteration = 0;
  double f = 0;
  double violation = 0;  ///< largest g/scale, 0 if feasible
};

enum class HessianUse {
  Auto,   ///< exact if the problem has one
  Exact,  ///< refuse a problem without
  Quasi   ///< limited-memory BFGS even if the problem has one
};

/// Variables are scaled by their range, f by its start, g by NlpConstraint::scale; tolerances
/// refer to scaled quantities.
struct NlpOptions {
  int max_iterations = 300;   ///< >= 1
  double tolerance = 1e-8;    ///< of the scaled optimality conditions, in (0, 1)
  double feasibility = 1e-8;  ///< allowed g/scale, in (0, 1)
  double acceptable = 1e-5;   ///< of the scaled optimality conditions, in [tolerance, 1)
  double time_limit = std::numeric_limits<double>::infinity();  ///< s, > 0
  HessianUse hessian = HessianUse::Auto;
  /// Barrier parameter that an interior point method starts from with a warm start, in (0, 1).
  double warm_barrier = 1e-6;
  /// Look for the conflicting constraints when no feasible point is found (one more solution).
  bool explain_infeasible = true;
  std::function<bool(const NlpProgress&)> progress;  ///< returns false to stop

  std::vector<std::string> errors() const;  ///< empty = valid
};

/// Multipliers to start from, as an earlier result left them. Constraints the new problem does not
/// have are ignored, those without an entry start at zero.
struct NlpWarmStart {
  std::map<ConstraintId, double> multipliers;
  Eigen::VectorXd lower, upper;  ///< of the bounds, by variable; empty = none
};

struct NlpViolation {
  ConstraintId id = 0;
  std::string name;
  double g = 0;       ///< unit of g; > 0
  double scaled = 0;  ///< g / scale
};

/// Nothing in it is NaN. With L = f + sum lambda_i g_i - sum zl_j (x_j - lower_j) +
/// sum zu_j (x_j - upper_j): dL/dx = 0, lambda, zl, zu >= 0 at an optimum.
struct NlpResult {
  NlpStatus status = NlpStatus::Stopped;
  std::string reason;            ///< one sentence
  Eigen::VectorXd x;             ///< within the bounds; the start if nothing could be evaluated
  double f = 0;                  ///< at x
  Eigen::VectorXd g;             ///< at x; empty (and f = 0) if the start could not be evaluated
  double violation = 0;          ///< largest g/scale at x, 0 if feasible
  double stationarity = 0;       ///< scaled residual of dL/dx = 0; 1 if unknown
  bool has_multipliers = false;  ///< false: the optimiser does not give any (NLopt)
  std::map<ConstraintId, double> multipliers;            ///< unit f / g
  Eigen::VectorXd lower_multipliers, upper_multipliers;  ///< by variable, unit f / x
  std::vector<NlpViolation> conflict;  ///< Infeasible: least violation possible, largest first
  int iterations = 0;
  int evaluations = 0;           ///< of f and g
  int gradient_evaluations = 0;  ///< of df and dg
  int failed_evaluations = 0;    ///< of `evaluations`: NaN or infinite
  double time = 0;               ///< s

  bool solved() const { return status == NlpStatus::Converged || status == NlpStatus::Acceptable; }
  NlpWarmStart warm_start() const { return {multipliers, lower_multipliers, upper_multipliers}; }
  std::string brief() const;  ///< one line
};

}  // namespace liesl
