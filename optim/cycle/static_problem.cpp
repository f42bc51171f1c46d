#include "optim/cycle/static_problem.hpp"

#include "optim/nlp/ipopt_driver.hpp"
#include "optim/nlp/nlopt_driver.hpp"
#include "optim/nlp/separable.hpp"

namespace liesl {
namespace {

constexpr int kMaxRounds = 8;  // screening: optimise, look at all cases, again

NlpResult optimise(StaticProblem& problem, const CycleOptions& cycle, const NlpWarmStart& warm,
                   const std::function<bool()>& keep_going, int max_iterations) {
  NlpOptions options;
  options.max_iterations = max_iterations;
  options.progress = [&](const NlpProgress&) { return !keep_going || keep_going(); };
  options.tolerance = 1e-7;
  options.feasibility = 1e-7;
  switch (cycle.optimizer) {
    case Optimizer::Mma:
      return solve_nlopt(problem, NloptMethod::Mma, options);
    case Optimizer::Ccsaq:
      return solve_nlopt(problem, NloptMethod::Ccsaq, options);
    case Optimizer::Slsqp:
      return solve_nlopt(problem, NloptMethod::Slsqp, options);
    case Optimizer::Ipopt:
      break;
  }
  if (cycle.model == NlpModel::Separable) {
    options.tolerance = 1e-6;
    return solve_separable(problem, options);
  }
  return solve_ipopt(problem, options, warm.multipliers.empty() ? nullptr : &warm);
}

}  // namespace

StaticAnswer solve_static(StaticProblem& problem, const CycleOptions& options, NlpWarmStart& warm,
                          const std::function<bool()>& keep_going, int max_iterations) {
  StaticAnswer answer;
  for (int round = 0; round < kMaxRounds; ++round) {
    answer.result = optimise(problem, options, warm, keep_going, max_iterations);
    answer.iterations += answer.result.iterations;
    if (answer.result.status == NlpStatus::Infeasible) break;  // nor with more cases
    if (problem.add_violated(answer.result.x, 1e-6) == 0) break;
  }
  warm = answer.result.warm_start();
  return answer;
}

}  // namespace liesl
