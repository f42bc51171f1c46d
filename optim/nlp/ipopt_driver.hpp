#pragma once
/// @file
/// Ipopt: primal-dual interior point method (Waechter & Biegler, Math. Program. 106, 2006). The
/// choice for exact Hessians and for many constraints.

#include "optim/nlp/problem.hpp"
#include "optim/nlp/result.hpp"

namespace liesl {

/// Minimises from the start of `problem`, with the multipliers of `warm` if given (then near the
/// bounds where the start is). Uses the exact Hessian if the problem has one, else L-BFGS.
///
/// If no feasible point is found, the least violation is looked for (feasibility.hpp): the run is
/// repeated once from a feasible point, or the result is Infeasible and names the conflict.
/// A point without a value (NaN) makes Ipopt shorten its step; at the start, or thirty in a row,
/// it ends the run.
/// The result is the best point evaluated unless the status is Converged or Acceptable.
///
/// Ipopt and MUMPS are not thread-safe: calls wait for each other in the whole process, and a
/// problem that calls this from within its own evaluation gets std::logic_error.
/// @throws std::invalid_argument for invalid options or problem, listing everything that is wrong;
///         and whatever the problem or the progress function throws
NlpResult solve_ipopt(Problem& problem, const NlpOptions& options = {},
                      const NlpWarmStart* warm = nullptr);

}  // namespace liesl
