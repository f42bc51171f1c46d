#pragma once
/// @file
/// How nearly the constraints of a problem can be met together:
///
///     minimise t   subject to   g_i(x) / scale_i <= t,   lower <= x <= upper,   t >= 0
///
/// (elastic.hpp without its objective).
/// t = 0: a feasible point, well inside if there is an inside. t > 0 (locally least): the
/// constraints with a multiplier are the ones that contradict each other.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "optim/nlp/problem.hpp"
#include "optim/nlp/result.hpp"

namespace liesl {

struct LeastViolation {
  bool solved = false;   ///< the problem above was solved
  double violation = 0;  ///< t, scaled
  Eigen::VectorXd x;
  std::vector<NlpViolation> conflict;  ///< empty if t is within the feasibility tolerance
  int iterations = 0;
  std::string reason;  ///< sentence that names the conflict, or why it is unknown
};

/// What solves the problem above: `solve_ipopt`, which asks for least violations itself.
using NlpSolver = NlpResult (*)(Problem&, const NlpOptions&, const NlpWarmStart*);

/// @param scale of the constraints, all > 0. Solved by `solve` from `start`, which has the scaled
/// violation `start_violation`.
LeastViolation least_violation(NlpSolver solve, Problem& problem, const Eigen::VectorXd& scale,
                               const Eigen::VectorXd& start, double start_violation,
                               const NlpOptions& options);

}  // namespace liesl
