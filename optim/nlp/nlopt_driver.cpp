#include "optim/nlp/nlopt_driver.hpp"

#include <fmt/format.h>
#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <stdexcept>

#include "optim/nlp/evaluator.hpp"
#include "optim/nlp/feasibility.hpp"
#include "optim/nlp/ipopt_driver.hpp"
#include "optim/nlp/kkt.hpp"

namespace liesl {

using Eigen::Map;
using Eigen::VectorXd;

namespace {

/// Residual that is Acceptable whatever the options say: f stands still to about its square.
constexpr double kStandingStill = 1e-3;

struct Session {
  Evaluator& e;
  nlopt_opt opt;
  VectorXd y;  ///< start, then the last point
  int calls = 0;
};

/// Values (and gradients) at y. Without a value NLopt gets infinity, which shortens its step;
/// without a gradient, after an exception or too many failures in a row it is told to stop.
bool evaluate(Session& s, unsigned n, const double* y, bool gradients) {
  const Map<const VectorXd> at(y, n);
  const bool value = s.e.values(at);
  if (value && (!gradients || s.e.gradients(at))) return true;
  if (value || s.e.broken() || s.e.given_up()) nlopt_force_stop(s.opt);
  return false;
}

double objective(unsigned n, const double* y, double* df, void* data) {
  auto& s = *static_cast<Session*>(data);
  if (!evaluate(s, n, y, df != nullptr)) {
    if (df) std::fill_n(df, n, 0.0);
    return HUGE_VAL;
  }
  if (!s.e.proceed(++s.calls)) nlopt_force_stop(s.opt);
  if (df) Map<VectorXd>(df, n) = s.e.dF();
  return s.e.F();
}

void constraints(unsigned m, double* g, unsigned n, const double* y, double* dg, void* data) {
  auto& s = *static_cast<Session*>(data);
  if (!evaluate(s, n, y, dg != nullptr)) {
    std::fill_n(g, m, HUGE_VAL);
    if (dg) std::fill_n(dg, std::size_t{m} * n, 0.0);
    return;
  }
  Map<VectorXd>(g, m) = s.e.G();
  if (dg) s.e.dG(dg);
}

nlopt_algorithm algorithm(NloptMethod method) {
  switch (method) {
    case NloptMethod::Mma:
      return NLOPT_LD_MMA;
    case NloptMethod::Ccsaq:
      return NLOPT_LD_CCSAQ;
    case NloptMethod::Slsqp:
      return NLOPT_LD_SLSQP;
  }
  throw std::invalid_argument("solve_nlopt: expected Mma, Ccsaq or Slsqp");
}

/// Stops when f or x stand still far below what `tolerance` asks of the optimality conditions,
/// whose residual is about the square root of the error of f.
constexpr double kStandstill = 1e-4;

nlopt_result run(Session& s, const NlpOptions& o) {
  const auto check = [](nlopt_result code, const char* what) {
    if (code < 0) throw std::logic_error(fmt::format("NLopt refuses {}: code {}", what, int(code)));
  };
  const VectorXd lower = s.e.lower(), upper = s.e.upper();
  const VectorXd tolerance = VectorXd::Constant(s.e.m(), o.feasibility);
  check(nlopt_set_min_objective(s.opt, objective, &s), "the objective");
  check(nlopt_set_lower_bounds(s.opt, lower.data()), "the lower bounds");
  check(nlopt_set_upper_bounds(s.opt, upper.data()), "the upper bounds");
  if (s.e.m() > 0)
    check(nlopt_add_inequality_mconstraint(s.opt, static_cast<unsigned>(s.e.m()), constraints, &s,
                                           tolerance.data()),
          "the constraints");
  check(nlopt_set_ftol_rel(s.opt, std::max(1e-15, kStandstill * o.tolerance)), "ftol_rel");
  check(nlopt_set_xtol_rel(s.opt, std::max(1e-14, kStandstill * o.tolerance)), "xtol_rel");
  check(nlopt_set_maxeval(s.opt, o.max_iterations), "maxeval");
  if (std::isfinite(o.time_limit)) check(nlopt_set_maxtime(s.opt, o.time_limit), "maxtime");
  s.y = s.e.start().cwiseMax(lower).cwiseMin(upper);
  double f = 0;
  return nlopt_optimize(s.opt, s.y.data(), &f);
}

/// Where NLopt ended if that is feasible and as good as the best point (which may live off the
/// feasibility tolerance), else the best point.
NlpPoint choose(Session& s, const NlpOptions& o) {
  constexpr double kAsGood = 1e-6;
  const NlpPoint best = *s.e.best();
  if (!s.y.allFinite() || !s.e.values(s.y)) return best;
  const NlpPoint& last = s.e.point();
  const bool feasible = largest_violation(last.g, s.e.scaling().g) <= o.feasibility;
  return feasible && last.f <= best.f + kAsGood * std::abs(best.f) ? last : best;
}

/// Status of r.x from what can be checked there, not from why NLopt stopped.
void judge(Evaluator& e, nlopt_result code, const NlpOptions& o, NlpResult& r) {
  double residual = 1;
  if (e.gradients(r.x.cwiseQuotient(e.scaling().x))) {
    KktOptions k;
    k.active = std::max(1e-4, 10 * o.feasibility);
    const KktResidual kkt = kkt_residual(e.problem(), e.point(), k);
    r.stationarity = kkt.stationarity;
    residual = std::max(kkt.stationarity, kkt.complementarity);
  }
  const bool feasible = r.violation <= o.feasibility;
  const bool limit = code == NLOPT_MAXEVAL_REACHED || code == NLOPT_MAXTIME_REACHED ||
                     (code == NLOPT_FORCED_STOP && e.out_of_time());
  const std::string quality = fmt::format(
      "{:.1e} of the optimality conditions is left (no multipliers from NLopt)", residual);
  if (code == NLOPT_FORCED_STOP && !limit) {
    r.reason = e.failure().empty() ? "stopped" : e.failure();
  } else if (feasible && residual <= std::max(o.acceptable, kStandingStill)) {
    r.status = residual <= o.tolerance ? NlpStatus::Converged : NlpStatus::Acceptable;
    r.reason = quality;
  } else if (limit) {
    r.status = NlpStatus::IterationLimit;
    r.reason = code == NLOPT_MAXEVAL_REACHED ? fmt::format("{} evaluations used up", r.evaluations)
                                             : "time is used up";
  } else if (!feasible) {
    r.status = NlpStatus::Infeasible;
    r.reason = "no feasible point found";
  } else {
    r.reason = e.with_failure("f and x stand still, but " + quality);
  }
}

void explain_infeasible(Evaluator& e, const NlpOptions& o, NlpResult& r) {
  const LeastViolation least =
      least_violation(solve_ipopt, e.problem(), e.scaling().g, r.x, r.violation, o);
  r.reason = least.reason;
  r.conflict = least.conflict;
  r.stationarity = 1;
  if (!least.conflict.empty()) return;
  r.status = NlpStatus::Stopped;
  if (least.solved)
    r.reason = "stuck at a point that violates constraints, though a feasible one exists";
}

}  // namespace

NlpResult solve_nlopt(Problem& problem, NloptMethod method, const NlpOptions& options) {
  Evaluator e(problem, options);
  NlpResult r;
  r.stationarity = 1;
  if (!e.usable()) {
    e.report({start_of(problem), 0, VectorXd(), false, {}, {}}, r);
    r.reason = "the start cannot be evaluated: " + e.failure();
    return r;
  }
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> opt(
      nlopt_create(algorithm(method), static_cast<unsigned>(e.n())), &nlopt_destroy);
  if (!opt) throw std::bad_alloc();
  Session session{e, opt.get(), e.start()};
  const nlopt_result code = run(session, options);
  e.rethrow();
  const NlpPoint chosen = choose(session, options);
  e.report(chosen, r);
  judge(e, code, options, r);
  e.rethrow();
  e.report(chosen, r);
  r.iterations = session.calls;
  if (r.status == NlpStatus::Infeasible && options.explain_infeasible)
    explain_infeasible(e, options, r);
  return r;
}

}  // namespace liesl
