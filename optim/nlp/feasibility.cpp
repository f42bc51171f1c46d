#include "optim/nlp/feasibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "optim/nlp/elastic.hpp"

namespace liesl {

using Eigen::VectorXd;

namespace {

constexpr double kCarries = 1e-3;  ///< share of the conflict (multipliers add up to 1)

std::string bounds_in_conflict(const Problem& problem, const NlpResult& r) {
  std::string text;
  for (std::size_t j = 0; j < problem.variables().size(); ++j) {
    const auto& v = problem.variables()[j];
    const auto k = static_cast<int>(j);
    const double range = std::isfinite(v.upper - v.lower) ? v.upper - v.lower : 1.0;
    const bool low = r.lower_multipliers[k] * range > kCarries;
    const bool high = r.upper_multipliers[k] * range > kCarries;
    if (low || high)
      text += fmt::format("{}{} at its {} bound {:.6g}", text.empty() ? " with " : ", ", v.name,
                          low ? "lower" : "upper", low ? v.lower : v.upper);
  }
  return text;
}

std::string describe(const std::vector<NlpViolation>& conflict) {
  constexpr std::size_t kShown = 5;
  std::string text =
      conflict.size() > 1 ? "constraints cannot be met together: " : "a constraint cannot be met: ";
  for (std::size_t k = 0; k < std::min(conflict.size(), kShown); ++k)
    text += fmt::format("{}'{}' exceeds its limit by at least {:.4g}", k ? ", " : "",
                        conflict[k].name, conflict[k].g);
  if (conflict.size() > kShown) text += fmt::format(" and {} more", conflict.size() - kShown);
  return text;
}

}  // namespace

LeastViolation least_violation(NlpSolver solve, Problem& problem, const VectorXd& scale,
                               const VectorXd& start, double start_violation,
                               const NlpOptions& options) {
  ElasticProblem relaxed(problem, {0, 1}, scale, start, start_violation);
  NlpOptions inner = options;
  inner.explain_infeasible = false;
  if (options.progress)
    inner.progress = [&](const NlpProgress& p) { return options.progress({p.iteration, 0, p.f}); };
  const NlpResult r = solve(relaxed, inner, nullptr);

  LeastViolation out;
  out.iterations = r.iterations;
  out.x = r.x.head(r.x.size() - 1);
  if (r.g.size()) {
    const double t = r.x[r.x.size() - 1];
    out.violation = std::max(0.0, r.g.maxCoeff() + t);
  }
  out.solved = r.solved();
  out.reason = "no feasible point found, and the least violation is unknown: " + r.reason;
  if (!r.solved() || out.violation <= options.feasibility) return out;
  const auto& constraints = problem.constraints();
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    const double scaled = r.g[static_cast<int>(i)] + r.x[r.x.size() - 1];
    const auto& c = constraints[i];
    if (scaled > 0 && r.multipliers.at(c.id) > kCarries)
      out.conflict.push_back({c.id, c.name, scaled * scale[static_cast<int>(i)], scaled});
  }
  std::stable_sort(out.conflict.begin(), out.conflict.end(),
                   [](const auto& a, const auto& b) { return a.scaled > b.scaled; });
  out.reason = describe(out.conflict) + bounds_in_conflict(problem, r);
  return out;
}

}  // namespace liesl
