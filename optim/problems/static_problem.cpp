#include "optim/problems/static_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "optim/nlp/evaluator.hpp"
#include "optim/nlp/ipopt_driver.hpp"
#include "optim/nlp/nlopt_driver.hpp"
#include "optim/nlp/separable.hpp"

namespace liesl {
namespace {

using Eigen::VectorXd;

// Of a quasi-Newton method on a problem that is exact near its start only.
constexpr int kFewIterations = 50;
constexpr int kMaxRounds = 8;    // screening: optimise, look at all cases, again
constexpr double kHopeless = 1;  // violation, relative to the limit

NlpResult optimise(Problem& problem, const CycleOptions& cycle, const NlpWarmStart& warm,
                   const std::function<bool()>& keep_going, int max_iterations) {
  NlpOptions options;
  options.max_iterations = max_iterations;
  options.progress = [&](const NlpProgress&) { return !keep_going || keep_going(); };
  options.tolerance = 1e-7;
  options.feasibility = 1e-7;
  return solve_by(problem, cycle, std::move(options), warm);
}

}  // namespace

NlpResult solve_by(Problem& problem, const CycleOptions& cycle, NlpOptions options,
                   const NlpWarmStart& warm) {
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
    options.tolerance = std::max(options.tolerance, 1e-6);
    options.acceptable = std::max(options.acceptable, options.tolerance);
    return solve_separable(problem, options);
  }
  return solve_ipopt(problem, options, warm.multipliers.empty() ? nullptr : &warm);
}

double limit_value(const StudySpec& study, const LimitedResponse& r) {
  if (r.part_limit >= 0) return study.part_limits[static_cast<std::size_t>(r.part_limit)].limit;
  return study.constraints[static_cast<std::size_t>(r.constraint)].limit;
}

std::string limit_name(const StudySpec& study, const LimitedResponse& r) {
  const std::string& name =
      r.part_limit >= 0 ? study.part_limits[static_cast<std::size_t>(r.part_limit)].name
                        : study.constraints[static_cast<std::size_t>(r.constraint)].response.name;
  if (study.scenarios.empty()) return name;
  return name + " (" + study.scenarios[static_cast<std::size_t>(r.scenario)] + ")";
}

StaticAnswer solve_static(StaticProblem& problem, const CycleOptions& options, NlpWarmStart& warm,
                          const std::function<bool()>& keep_going, int max_iterations) {
  StaticAnswer answer;
  for (int round = 0; round < kMaxRounds; ++round) {
    answer.result = optimise(problem, options, warm, keep_going, max_iterations);
    answer.iterations += answer.result.iterations;
    if (answer.result.status == NlpStatus::Infeasible) break;  // nor with more cases
    if (keep_going && !keep_going()) break;
    if (problem.add_violated(answer.result.x, 1e-6) == 0) break;
  }
  warm = answer.result.warm_start();
  return answer;
}

namespace {

/// The terms of the objective among the rows, each with its largest g.
std::vector<Epigraph> epigraphs(const std::vector<ObjectiveTerm>& terms, const VectorXd& g) {
  std::map<int, Epigraph> by_number;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    if (terms[i].number < 0) continue;
    const int row = static_cast<int>(i);
    Epigraph& e = by_number[terms[i].number];
    e.start = e.rows.empty() ? g[row] : std::max(e.start, g[row]);
    e.weight = terms[i].weight;
    e.rows.push_back(row);
  }
  std::vector<Epigraph> out;
  for (auto& [number, e] : by_number) out.push_back(std::move(e));
  return out;
}

/// The rows at a start; none, and why, if there is no value.
std::optional<VectorXd> rows_at(StaticProblem& problem, const VectorXd& x, std::string& reason) {
  VectorXd g(static_cast<Eigen::Index>(problem.constraints().size()));
  double f = 0;
  problem.values(x, f, g);
  reason.clear();
  if (std::isfinite(f) && g.allFinite()) return g;
  reason = problem.undefined_reason();
  if (reason.empty() && !std::isfinite(f)) reason = fmt::format("the objective is {}", f);
  for (Eigen::Index i = 0; i < g.size() && reason.empty(); ++i)
    if (!std::isfinite(g[i]))
      reason =
          fmt::format("'{}' is {}", problem.constraints()[static_cast<std::size_t>(i)].name, g[i]);
  return {};
}

/// Is a row a limit, not of a term of the objective?
bool is_limit(const std::vector<ObjectiveTerm>& terms, std::size_t row) {
  return terms.empty() || terms[row].number < 0;
}

double largest_excess(const VectorXd& g, const std::vector<ObjectiveTerm>& terms) {
  double largest = 0;
  for (Eigen::Index i = 0; i < g.size(); ++i)
    if (is_limit(terms, static_cast<std::size_t>(i))) largest = std::max(largest, g[i]);
  return largest;
}

}  // namespace

ElasticAnswer solve_elastic(StaticProblem& problem, ElasticProblem::Weights weights,
                            const CycleOptions& options, NlpWarmStart& warm,
                            const std::function<bool()>& keep_going) {
  ElasticAnswer answer;
  answer.x = start_of(problem);
  const auto n = answer.x.size();
  const int most = problem.has_hessian() ? NlpOptions().max_iterations : kFewIterations;
  NlpResult result;
  for (int round = 0; round < kMaxRounds; ++round) {
    std::optional<VectorXd> g = rows_at(problem, answer.x, answer.reason);
    if (!g && round > 0) g = rows_at(problem, answer.x = start_of(problem), answer.reason);
    if (!g) return answer;
    const std::vector<ObjectiveTerm> terms = problem.objective_terms();
    ElasticProblem elastic(problem, weights, VectorXd::Ones(g->size()), answer.x,
                           largest_excess(*g, terms), epigraphs(terms, *g));
    result = optimise(elastic, options, warm, keep_going, most);
    answer.iterations += result.iterations;
    if (result.g.size() != g->size()) answer.reason = result.reason;
    if (!answer.reason.empty()) return answer;
    answer.x = result.x.head(n);
    answer.violation = std::max(0.0, result.x[result.x.size() - 1]);
    answer.merit = result.f;
    if (keep_going && !keep_going()) break;
    // Of limits missed by more than themselves the worst cases: all the others say nothing to t.
    const bool hopeless = answer.violation > kHopeless && terms.empty();
    const double allowed = hopeless ? answer.violation : 0;
    if (problem.add_violated(answer.x, allowed + 1e-6 * (1 + allowed)) == 0) break;
  }
  const std::vector<ObjectiveTerm> terms = problem.objective_terms();
  for (std::size_t i = 0; i < problem.constraints().size(); ++i)
    if (const auto found = result.multipliers.find(problem.constraints()[i].id);
        found != result.multipliers.end() && is_limit(terms, i))
      answer.multipliers += found->second;
  warm = result.warm_start();
  return answer;
}

}  // namespace liesl
