#include "optim/cycle/direct_optimum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>

#include "mbs/linalg/stop_request.hpp"

namespace liesl {
namespace {

using Eigen::VectorXd;

constexpr double kNearLimit = 2e-3;         // limits that may carry a multiplier
constexpr double kDirectTolerance = 1e-4;   // of the scaled optimality conditions
constexpr double kDirectAcceptable = 1e-3;  // the same, where no better is reached
constexpr double kDirectFeasibility =
    1e-5;  // of the limits, or what the study allows if that is less

/// The study as a nonlinear program. Rows in the order of the surrogate's, at every design the
/// same.
class DirectProblem final : public Problem {
 public:
  /// @throws NoSensitivities
  DirectProblem(CycleRecord& record, const VectorXd& start) : record_(record) {
    if (evaluate(start)) constraints_ = surrogate_.problem->constraints();
    for (std::size_t i = 0; i < constraints_.size(); ++i) {
      constraints_[i].id = i;
      constraints_[i].name = fmt::format("{}: {}", i, constraints_[i].name);
    }
  }

  /// Analyses x, unless it is the latest. @returns whether it has values and gradients
  bool evaluate(const VectorXd& x);

  bool good() const { return surrogate_.problem != nullptr; }  ///< at the latest x
  const VectorXd& x() const { return x_; }                     ///< the latest
  const CycleRecord::Analysis& analysis() const { return analysis_; }
  const Surrogate& surrogate() const { return surrogate_; }
  const std::string& failure() const { return failure_; }
  bool interrupted() const { return interrupted_; }

  const std::vector<NlpVariable>& variables() const override { return record_.model().variables(); }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  void values(const VectorXd& x, double& f, VectorXd& g) override {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    f = kNone;
    g.setConstant(kNone);
    if (evaluate(x)) surrogate_.problem->values(x, f, g);
  }
  void gradients(const VectorXd& x, VectorXd& df, RowMatrix& dg) override {
    surrogate_.problem->gradients(x, df, dg);
  }

 private:
  bool analyse(const VectorXd& x);
  void differentiate(const VectorXd& x);

  CycleRecord& record_;
  std::vector<NlpConstraint> constraints_;
  VectorXd x_;
  CycleRecord::Analysis analysis_;  ///< of x
  Surrogate surrogate_;             ///< at x; without a problem: none
  std::string failure_;             ///< why
  bool interrupted_ = false;
};

bool DirectProblem::evaluate(const VectorXd& x) {
  if (x_.size() == x.size() && x_ == x) return good();
  try {
    return analyse(x);
  } catch (const Stopped& stopped) {
    surrogate_ = {};
    failure_ = stopped.what();
    interrupted_ = true;
    return false;
  }
}

bool DirectProblem::analyse(const VectorXd& x) {
  const auto begin = std::chrono::steady_clock::now();
  x_ = x;
  surrogate_ = {};
  analysis_ = record_.analyse(x);
  if (!analysis_->good()) {
    failure_ = analysis_->reason;
    interrupted_ = interrupted_ || analysis_->status == SolveStatus::Interrupted;
    return false;
  }
  Cycle& cycle = record_.add(analysis_, x);
  differentiate(x);
  record_.keep_if_better(analysis_, x);
  cycle.taken = good();
  cycle.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (record_.hooks().on_cycle) record_.hooks().on_cycle(record_.history());
  return good();
}

void DirectProblem::differentiate(const VectorXd& x) {
  const double move = record_.options().move_limit;
  surrogate_ = record_.model().surrogate(*analysis_, x, move, kNearLimit);
  if (!surrogate_.problem) {
    failure_ = "there are no sensitivities: " + surrogate_.optimality.reason;
    return;
  }
  const std::size_t rows = surrogate_.problem->constraints().size();
  if (constraints_.empty() || rows == constraints_.size()) return;
  failure_ = fmt::format("there are {} constraints instead of {}: other steps or load cases", rows,
                         constraints_.size());
  surrogate_.problem.reset();
}

/// Analyses, after the last of which the optimiser is stopped.
bool analyses_used_up(const CycleRecord& record) {
  return static_cast<int>(record.history().size()) >= record.options().max;
}

CycleEnd direct_end(const CycleRecord& record, const DirectProblem& at, const NlpResult& r) {
  const CycleOptions& options = record.options();
  if (at.interrupted() || record.asked_to_stop()) return record.stopped();
  if (!at.good()) return {CycleStatus::SimulationFailed, at.failure()};
  const DesignAnalysis& a = *at.analysis();
  const DynamicOptimality& kkt = at.surrogate().optimality;
  const bool meets = a.worst <= options.feasibility;
  const std::string of =
      fmt::format("KKT conditions: {}; worst limit at {:+.2g}; ", kkt.brief(), a.worst);
  if (meets && kkt.holds()) return {CycleStatus::Optimal, of + r.reason};
  const std::string beyond =
      fmt::format("'{}' is exceeded by {:.3g} %{}", a.worst_constraint, 100 * a.worst,
                  a.worst_at.empty() ? "" : " at " + a.worst_at);
  if (analyses_used_up(record) || r.status == NlpStatus::IterationLimit)
    return {CycleStatus::CycleLimit,
            fmt::format("{} cycles are used up; ", options.max) + of + (meets ? r.reason : beyond)};
  if (meets) return {CycleStatus::Converged, of + r.reason};
  return {CycleStatus::Infeasible, beyond + ": " + r.reason};
}

/// Is the optimiser's answer the end? One that was cut off is, if it is optimal; else the best
/// design that was analysed is.
bool stands(DirectProblem& problem, const NlpResult& r, const CycleOptions& options) {
  if (!problem.evaluate(r.x)) return false;
  return r.solved() || (problem.analysis()->worst <= options.feasibility &&
                        problem.surrogate().optimality.holds());
}

}  // namespace

LoopResult optimise_directly(DesignModel& model, const CycleOptions& options,
                             const CycleHooks& hooks, const std::vector<Cycle>& resume) {
  for (const Cycle& cycle : resume)
    if (static_cast<std::size_t>(cycle.x.size()) != model.variables().size())
      throw std::invalid_argument("resume: the interrupted run has other variables");
  CycleRecord record(model, options, hooks);
  DirectProblem problem(record, model.start());
  if (!problem.good()) {
    const bool stopped = problem.interrupted();
    return record.finish({stopped ? CycleStatus::Interrupted : CycleStatus::SimulationFailed,
                          "the start cannot be analysed: " + problem.failure()});
  }
  NlpOptions nlp;
  nlp.max_iterations = options.max;
  nlp.tolerance = kDirectTolerance;
  nlp.acceptable = kDirectAcceptable;
  nlp.feasibility = std::min(kDirectFeasibility, options.feasibility);
  nlp.explain_infeasible = false;  // it would be one more optimisation
  nlp.progress = [&](const NlpProgress&) {
    return !record.asked_to_stop() && !problem.interrupted() && !analyses_used_up(record);
  };
  const NlpResult r = solve_by(problem, options, nlp);
  const bool goes_on = !record.asked_to_stop() && !problem.interrupted();
  if (goes_on && (stands(problem, r, options) || problem.evaluate(record.best()))) {
    record.keep(problem.analysis(), problem.x());
    record.certify(problem.surrogate().optimality);
  }
  return record.finish(direct_end(record, problem, r));
}

}  // namespace liesl
