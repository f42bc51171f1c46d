#pragma once
/// @file
/// NLopt: the conservative separable methods and sequential quadratic programming, as a second
/// opinion and for problems without a Hessian.

#include "optim/nlp/problem.hpp"
#include "optim/nlp/result.hpp"

namespace liesl {

enum class NloptMethod {
  Mma,    ///< Svanberg 2002, moving asymptotes
  Ccsaq,  ///< Svanberg 2002, quadratic separable models
  Slsqp   ///< Kraft 1988; fewest evaluations, dense: memory grows with constraints x variables
};

/// Minimises from the start of `problem`. NLopt gives no multipliers (`has_multipliers` is false;
/// kkt_residual estimates them) and tests no optimality conditions: it stops when f or x stand
/// still. So the status comes from kkt_residual at the end: Converged if its stationarity and
/// complementarity are within `tolerance`, Acceptable within `acceptable` or 1e-3 (the error of f
/// is about the square of the residual). A point without a value counts as infinitely bad, which
/// shortens the step; one without a gradient, or too many, ends the run with the best point so far.
/// Options `hessian` and `warm_barrier` are not used. Throws as solve_ipopt does.
NlpResult solve_nlopt(Problem& problem, NloptMethod method, const NlpOptions& options = {});

}  // namespace liesl
