#include "optim/nlp/ipopt_driver.hpp"

#include <fmt/format.h>

#include <IpIpoptApplication.hpp>
#include <IpSolveStatistics.hpp>
#include <IpTNLP.hpp>
#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <stdexcept>

#include "mbs/linalg/blas_threads.hpp"
#include "optim/nlp/evaluator.hpp"
#include "optim/nlp/feasibility.hpp"

namespace liesl {

using Eigen::Map;
using Eigen::VectorXd;
using Ipopt::Index;
using Ipopt::Number;

namespace {

constexpr double kIpoptInfinity = 1e20;  ///< beyond nlp_upper_bound_inf = 1e19
constexpr double kFar = 10;              ///< scaled violation of a start that may be hopeless
constexpr double kHopeless = 1e-3;       ///< share of it that stays however the variables are

/// Scaled problem as Ipopt asks for it; all the work is done by Evaluator.
class Adapter : public Ipopt::TNLP {
 public:
  Adapter(Evaluator& e, const NlpWarmStart* warm) : e_(e), warm_(warm), y(e.start()) {
    lambda.setZero(e.m());
    z_lower.setZero(e.n());
    z_upper.setZero(e.n());
  }

  bool get_nlp_info(Index& n, Index& m, Index& nnz_jac, Index& nnz_h,
                    IndexStyleEnum& style) override {
    n = e_.n();
    m = e_.m();
    nnz_jac = n * m;
    nnz_h = diagonal() ? n : n * (n + 1) / 2;
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index n, Number* lo, Number* up, Index m, Number* g_lo,
                       Number* g_up) override {
    Map<VectorXd>(lo, n) = e_.lower().cwiseMax(-kIpoptInfinity);
    Map<VectorXd>(up, n) = e_.upper().cwiseMin(kIpoptInfinity);
    std::fill_n(g_lo, m, -kIpoptInfinity);
    std::fill_n(g_up, m, 0.0);
    return true;
  }

  bool get_starting_point(Index n, bool, Number* y0, bool want_z, Number* zl, Number* zu, Index m,
                          bool want_lambda, Number* l) override {
    Map<VectorXd>(y0, n) = y;
    const NlpScaling& s = e_.scaling();
    const bool bounds = warm_ && warm_->lower.size() == n && warm_->upper.size() == n;
    if (want_z) {
      Map<VectorXd>(zl, n).setZero();
      Map<VectorXd>(zu, n).setZero();
      if (bounds) Map<VectorXd>(zl, n) = warm_->lower.cwiseProduct(s.x) / s.f;
      if (bounds) Map<VectorXd>(zu, n) = warm_->upper.cwiseProduct(s.x) / s.f;
    }
    for (Index i = 0; want_lambda && i < m; ++i) {
      const auto found = warm_->multipliers.find(e_.problem().constraints()[i].id);
      l[i] = found == warm_->multipliers.end() ? 0 : found->second * s.g[i] / s.f;
    }
    return true;
  }

  bool eval_f(Index n, const Number* x, bool, Number& f) override {
    if (!e_.values(Map<const VectorXd>(x, n))) return false;
    f = e_.F();
    return true;
  }

  bool eval_grad_f(Index n, const Number* x, bool, Number* df) override {
    if (!e_.gradients(Map<const VectorXd>(x, n))) return false;
    Map<VectorXd>(df, n) = e_.dF();
    return true;
  }

  bool eval_g(Index n, const Number* x, bool, Index m, Number* g) override {
    if (!e_.values(Map<const VectorXd>(x, n))) return false;
    Map<VectorXd>(g, m) = e_.G();
    return true;
  }

  bool eval_jac_g(Index n, const Number* x, bool, Index m, Index, Index* row, Index* col,
                  Number* values) override {
    for (Index i = 0, k = 0; !values && i < m; ++i)
      for (Index j = 0; j < n; ++j, ++k) row[k] = i, col[k] = j;
    if (!values) return true;
    if (!e_.gradients(Map<const VectorXd>(x, n))) return false;
    e_.dG(values);
    return true;
  }

  bool eval_h(Index n, const Number* x, bool, Number sigma, Index m, const Number* l, bool, Index,
              Index* row, Index* col, Number* values) override {
    for (Index i = 0, k = 0; !values && i < n; ++i)
      for (Index j = diagonal() ? i : 0; j <= i; ++j, ++k) row[k] = i, col[k] = j;
    if (!values) return true;
    if (!e_.hessian(Map<const VectorXd>(x, n), sigma, Map<const VectorXd>(l, m))) return false;
    for (Index i = 0, k = 0; i < n; ++i)
      for (Index j = diagonal() ? i : 0; j <= i; ++j, ++k) values[k] = e_.H()(i, j);
    return true;
  }

  bool intermediate_callback(Ipopt::AlgorithmMode, Index iteration, Number, Number, Number, Number,
                             Number, Number, Number, Number, Index, const Ipopt::IpoptData*,
                             Ipopt::IpoptCalculatedQuantities*) override {
    iterations = iteration;
    return e_.proceed(iteration);
  }

  void finalize_solution(Ipopt::SolverReturn, Index n, const Number* x, const Number* zl,
                         const Number* zu, Index m, const Number*, const Number* l, Number,
                         const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    y = Map<const VectorXd>(x, n);
    const auto finite = [](const Number* v, Index size) {
      return v && Map<const VectorXd>(v, size).allFinite();
    };
    if (finite(zl, n)) z_lower = Map<const VectorXd>(zl, n).cwiseMax(0);
    if (finite(zu, n)) z_upper = Map<const VectorXd>(zu, n).cwiseMax(0);
    if (finite(l, m)) lambda = Map<const VectorXd>(l, m).cwiseMax(0);
  }

 private:
  bool diagonal() const { return e_.problem().hessian_shape() == HessianShape::Diagonal; }

  Evaluator& e_;
  const NlpWarmStart* warm_;

 public:
  VectorXd y;  ///< start, then the last point
  VectorXd lambda, z_lower, z_upper;
  int iterations = 0;
};

bool use_exact(const Problem& problem, const NlpOptions& options) {
  if (options.hessian == HessianUse::Exact && !problem.has_hessian())
    throw std::invalid_argument(
        "invalid options of the optimiser:\n  hessian: expected a problem with a Hessian, got one "
        "without; hint: HessianUse::Auto");
  return problem.has_hessian() && options.hessian != HessianUse::Quasi;
}

void set_options(Ipopt::OptionsList& list, const NlpOptions& o, bool exact, bool warm) {
  const auto number = [&](const char* name, double v) {
    if (!list.SetNumericValue(name, v))
      throw std::logic_error(fmt::format("Ipopt refuses {} = {}", name, v));
  };
  const auto integer = [&](const char* name, int v) {
    if (!list.SetIntegerValue(name, v))
      throw std::logic_error(fmt::format("Ipopt refuses {} = {}", name, v));
  };
  const auto text = [&](const char* name, const char* v) {
    if (!list.SetStringValue(name, v))
      throw std::logic_error(fmt::format("Ipopt refuses {} = {}", name, v));
  };
  text("sb", "yes");
  integer("print_level", 0);
  text("linear_solver", "mumps");   // the others are not in the package and end the process
  integer("mumps_pivot_order", 0);  // AMD: a few dense columns, for which Scotch takes seconds
  text("nlp_scaling_method", "none");
  number("bound_relax_factor", 0.1 * std::min(o.feasibility, o.tolerance));
  integer("max_iter", o.max_iterations);
  number("tol", o.tolerance);
  number("constr_viol_tol", o.feasibility);
  number("acceptable_tol", o.acceptable);
  number("acceptable_constr_viol_tol", o.feasibility);
  text("hessian_approximation", exact ? "exact" : "limited-memory");
  if (!exact) text("limited_memory_aug_solver", "extended");
  if (!warm) return;
  text("warm_start_init_point", "yes");
  number("mu_init", o.warm_barrier);
  for (const char* push :
       {"warm_start_bound_push", "warm_start_bound_frac", "warm_start_slack_bound_push",
        "warm_start_slack_bound_frac", "warm_start_mult_bound_push"})
    number(push, o.warm_barrier);
}

std::mutex ipopt_mutex;
thread_local bool inside_ipopt = false;

Ipopt::ApplicationReturnStatus run(const Ipopt::SmartPtr<Adapter>& adapter, const NlpOptions& o,
                                   bool exact, bool warm) {
  if (inside_ipopt)
    throw std::logic_error("solve_ipopt: called from within an evaluation of another solve_ipopt");
  const std::lock_guard lock(ipopt_mutex);
  struct Inside {
    Inside() { inside_ipopt = true; }
    ~Inside() { inside_ipopt = false; }
  } inside;
  one_blas_thread();
  const Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(false);
  set_options(*application->Options(), o, exact, warm);
  const auto ready = application->Initialize("");  // "": no ipopt.opt of the working directory
  if (ready != Ipopt::Solve_Succeeded)
    throw std::logic_error("Ipopt refuses its options: code " + std::to_string(ready));
  return application->OptimizeTNLP(Ipopt::SmartPtr<Ipopt::TNLP>(GetRawPtr(adapter)));
}

void translate(Ipopt::ApplicationReturnStatus code, const Evaluator& e, NlpResult& r) {
  const auto set = [&r](NlpStatus status, std::string reason) {
    r.status = status;
    r.reason = std::move(reason);
  };
  switch (code) {
    case Ipopt::Solve_Succeeded:
      return set(NlpStatus::Converged, "optimality conditions hold");
    case Ipopt::Solved_To_Acceptable_Level:
      return set(NlpStatus::Acceptable, "optimality conditions hold to the acceptable tolerance");
    case Ipopt::Infeasible_Problem_Detected:
    case Ipopt::Restoration_Failed:
      return set(NlpStatus::Infeasible, "no feasible point found");
    case Ipopt::Maximum_Iterations_Exceeded:
      return set(NlpStatus::IterationLimit, fmt::format("{} iterations used up", r.iterations));
    case Ipopt::Maximum_CpuTime_Exceeded:
    case Ipopt::User_Requested_Stop:
      if (e.out_of_time()) return set(NlpStatus::IterationLimit, "time is used up");
      return set(NlpStatus::Stopped, e.failure().empty() ? "stopped on request" : e.failure());
    case Ipopt::Search_Direction_Becomes_Too_Small:
      return set(NlpStatus::Stopped, "steps became too small");
    case Ipopt::Diverging_Iterates:
      return set(NlpStatus::Stopped, "the variables grow without limit; hint: give them bounds");
    case Ipopt::Invalid_Number_Detected:
      return set(NlpStatus::Stopped, e.failure().empty() ? "a value is not finite" : e.failure());
    case Ipopt::Not_Enough_Degrees_Of_Freedom:
      return set(NlpStatus::Stopped, "no variable is free to move");
    default:
      return set(NlpStatus::Stopped, fmt::format("Ipopt ended with code {}", int(code)));
  }
}

/// Multipliers in units of the problem.
void take_multipliers(const Adapter& a, const Evaluator& e, NlpResult& r) {
  const NlpScaling& s = e.scaling();
  r.has_multipliers = true;
  r.lower_multipliers = a.z_lower.cwiseQuotient(s.x) * s.f;
  r.upper_multipliers = a.z_upper.cwiseQuotient(s.x) * s.f;
  for (int i = 0; i < e.m(); ++i)
    r.multipliers[e.problem().constraints()[i].id] = a.lambda[i] * s.f / s.g[i];
}

/// Ipopt drops fixed variables and gives them no multiplier: theirs is the whole residual.
void carry_by_fixed(const Problem& problem, VectorXd& residual, Adapter& a) {
  for (int j = 0; j < residual.size(); ++j) {
    const auto& v = problem.variables()[j];
    if (v.lower < v.upper) continue;
    const double carried = residual[j] + a.z_lower[j] - a.z_upper[j];
    a.z_lower[j] = std::max(carried, 0.0);
    a.z_upper[j] = std::max(-carried, 0.0);
    residual[j] = 0;
  }
}

NlpResult unusable(const Evaluator& e) {
  NlpResult r;
  e.report({start_of(e.problem()), 0, VectorXd(), false, {}, {}}, r);
  r.stationarity = 1;
  r.reason = "the start cannot be evaluated: " + e.failure();
  return r;
}

/// One run of Ipopt from adapter->y.
NlpResult run_once(Evaluator& e, const NlpOptions& options, const NlpWarmStart* warm,
                   const VectorXd* start) {
  const bool exact = use_exact(e.problem(), options);
  const Ipopt::SmartPtr<Adapter> adapter = new Adapter(e, warm);
  if (start) adapter->y = *start;
  const auto code = run(adapter, options, exact, warm != nullptr);
  e.rethrow();
  NlpResult r;
  r.iterations = adapter->iterations;
  translate(code, e, r);
  const bool last = r.solved() && e.values(adapter->y);
  e.rethrow();
  if (r.solved() && !last) {
    r.status = NlpStatus::Stopped;
    r.reason = e.failure();
  }
  const NlpPoint chosen = last ? e.point() : *e.best();
  const VectorXd y = chosen.x.cwiseQuotient(e.scaling().x);
  r.stationarity = 1;
  if (e.gradients(y)) {
    VectorXd residual = e.residual(adapter->lambda) - adapter->z_lower + adapter->z_upper;
    carry_by_fixed(e.problem(), residual, *adapter);
    r.stationarity = e.stationarity(residual);
  }
  e.rethrow();
  e.report(chosen, r);
  take_multipliers(*adapter, e, r);
  return r;
}

/// Infeasible at the point of least violation `least`.
void report_conflict(Evaluator& e, const LeastViolation& least, NlpResult& r) {
  r.reason = least.reason;
  r.conflict = least.conflict;
  r.stationarity = 1;
  r.status = least.solved ? NlpStatus::Infeasible : NlpStatus::Stopped;
  if (least.solved && e.values(least.x.cwiseQuotient(e.scaling().x))) e.report(e.point(), r);
  e.rethrow();
}

/// A start that misses its constraints by far: whether they can be met at all is asked first, in
/// units of that violation. Ipopt by itself would use up its iterations on it.
/// @returns the answer if they cannot; else `start` becomes a better one
std::optional<NlpResult> hopeless(Evaluator& e, const NlpOptions& options,
                                  std::optional<VectorXd>& start) {
  const double violation = largest_violation(e.point().g, e.scaling().g);
  if (!options.explain_infeasible || violation <= kFar) return {};
  LeastViolation least =
      least_violation(solve_ipopt, e.problem(), violation * e.scaling().g, e.point().x, 1, options);
  if (!least.solved || least.violation <= kHopeless) {
    start = least.x.cwiseQuotient(e.scaling().x);
    return {};
  }
  for (auto& c : least.conflict) c.scaled *= violation;
  NlpResult r;
  r.iterations = least.iterations;
  report_conflict(e, least, r);
  return r;
}

/// The constraints in conflict, or a second run from a feasible point.
NlpResult explain(Evaluator& e, const NlpOptions& options, NlpResult r) {
  const LeastViolation least =
      least_violation(solve_ipopt, e.problem(), e.scaling().g, r.x, r.violation, options);
  if (least.solved && least.violation <= options.feasibility) {
    const VectorXd start = least.x.cwiseQuotient(e.scaling().x);
    NlpResult again = run_once(e, options, nullptr, &start);
    again.iterations += r.iterations;
    if (again.status == NlpStatus::Infeasible) again.status = NlpStatus::Stopped;
    return again;
  }
  r.iterations += least.iterations;
  report_conflict(e, least, r);
  return r;
}

}  // namespace

NlpResult solve_ipopt(Problem& problem, const NlpOptions& options, const NlpWarmStart* warm) {
  Evaluator e(problem, options);
  if (!e.usable()) return unusable(e);
  std::optional<VectorXd> start;
  if (auto early = hopeless(e, options, start)) return *early;
  NlpResult r = run_once(e, options, warm, start ? &*start : nullptr);
  const bool infeasible = r.violation > options.feasibility;
  if (r.status == NlpStatus::Infeasible && !infeasible) {
    r.status = NlpStatus::Stopped;  // restoration failed near a feasible point
    r.reason = "no further progress from a feasible point";
  }
  if (r.status == NlpStatus::Infeasible && options.explain_infeasible)
    r = explain(e, options, std::move(r));
  const bool nearly = r.status == NlpStatus::Stopped && e.failure().empty() &&
                      r.stationarity <= options.acceptable && r.violation <= options.feasibility;
  if (nearly) r.status = NlpStatus::Acceptable;
  if (infeasible && r.status == NlpStatus::IterationLimit)
    r.reason += fmt::format("; constraints are still violated by {:.2e} (scaled)", r.violation);
  if (r.status == NlpStatus::Stopped) r.reason = e.with_failure(r.reason);
  return r;
}

}  // namespace liesl
