#pragma once
/// @file
/// How far a point is from the first-order optimality conditions of a problem, whoever found it.
/// At the end of an ESL cycle this is asked of the *dynamic* problem: a fixed point of the cycle
/// satisfies the conditions of the static one and may be far from optimal (Stolpe 2014).

#include <Eigen/Core>
#include <map>
#include <string>

#include "optim/nlp/evaluator.hpp"
#include "optim/nlp/problem.hpp"

namespace liesl {

struct KktOptions {
  double active = 1e-3;        ///< constraints with g/scale >= -active may carry a multiplier, > 0
  double active_bound = 1e-6;  ///< so may bounds this close, relative to the range, > 0
  double tolerance = 1e-3;     ///< largest residual that holds() accepts, in (0, 1)

  std::vector<std::string> errors() const;
};

/// All residuals are free of units: with D the ranges of the variables and S = max(|f|, |D df|),
///     r = D (df + sum lambda_i dg_i - zl + zu) / S,
/// where lambda, zl, zu >= 0 of the near-active constraints and bounds minimise |r|_2.
struct KktResidual {
  double stationarity = 0;       ///< |r|_inf; 0 = optimal, order 1 = no multiplier helps
  double feasibility = 0;        ///< largest g/scale, 0 if feasible
  double complementarity = 0;    ///< largest lambda_i |g_i| / S
  std::string worst_variable;    ///< of the stationarity: which one should move
  double worst_slope = 0;        ///< component of r there: < 0 = it should grow
  std::string worst_constraint;  ///< of the feasibility; empty if feasible
  std::map<ConstraintId, double> multipliers;            ///< of the near-active, unit f / g
  Eigen::VectorXd lower_multipliers, upper_multipliers;  ///< unit f / x
  int active = 0;                                        ///< near-active constraints

  bool holds(double tolerance) const {
    return stationarity <= tolerance && feasibility <= tolerance && complementarity <= tolerance;
  }
  std::string brief() const;  ///< one line
};

/// At x, which must lie within the bounds (to round-off). Evaluates values and gradients once;
/// throws std::runtime_error if they are not finite.
KktResidual kkt_residual(Problem& problem, const Eigen::VectorXd& x,
                         const KktOptions& options = {});
/// With values and gradients at hand (`point.has_gradients`).
KktResidual kkt_residual(const Problem& problem, const NlpPoint& point,
                         const KktOptions& options = {});

/// min |A z - b|_2 subject to z >= 0. Active set method: Lawson & Hanson, Solving Least Squares
/// Problems (1974), ch. 23. Columns of zero length get z = 0.
Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

}  // namespace liesl
