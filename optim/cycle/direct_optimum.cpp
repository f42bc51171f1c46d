#include "optim/cycle/direct_optimum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "optim/cycle/study_program.hpp"
#include "optim/nlp/elastic.hpp"

namespace liesl {
namespace {

using Eigen::VectorXd;

constexpr double kDirectTolerance = 1e-4;   // of the scaled optimality conditions
constexpr double kDirectAcceptable = 1e-3;  // the same, where no better is reached
/// Of the limits, or what the study allows if that is less.
constexpr double kDirectFeasibility = 1e-5;
/// Share of the analyses for a first design that meets the limits.
constexpr double kHopeful = 0.5;

/// The study as a nonlinear program whose designs are cycles of a record.
class DirectProblem final : public StudyProgram {
 public:
  /// @throws NoSensitivities
  DirectProblem(CycleRecord& record, const VectorXd& start)
      : StudyProgram(record.model(), record.options().move_limit),
        record_(record),
        variables_(record.model().variables()) {
    begin(start);
  }
  bool interrupted() const { return interrupted_ || stopped(); }
  /// Has a design met the limits so far?
  bool met() const { return least_violation() <= record_.options().feasibility; }
  /// Relative, of the design that exceeds its limits least.
  double least_violation() const {
    const History& all = record_.history();
    return std::ranges::min_element(all, {}, &Cycle::worst)->worst;
  }
  /// Cannot the largest violation of the latest design be brought down near it?
  bool stationary() const {
    return good() && surrogate().optimality.violation &&
           surrogate().optimality.violation->stationary();
  }
  void start_from(const VectorXd& x) {
    for (std::size_t j = 0; j < variables_.size(); ++j)
      variables_[j].start = x[static_cast<Eigen::Index>(j)];
  }
  const std::vector<NlpVariable>& variables() const override { return variables_; }

 private:
  std::shared_ptr<DesignAnalysis> analyse(const VectorXd& x) override {
    begin_ = std::chrono::steady_clock::now();
    auto analysis = record_.analyse(x);
    interrupted_ = interrupted_ || analysis->status == SolveStatus::Interrupted;
    return analysis;
  }
  void look_at(const VectorXd& x) override {
    Cycle& cycle = record_.add(analysis(), x);
    record_.keep_if_better(analysis(), x);  // before gradients, in which it may be stopped
    differentiate(x);
    if (good() && record_.best() == x) record_.certify(surrogate().optimality);
    cycle.taken = good();
    cycle.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    if (record_.hooks().on_cycle) record_.hooks().on_cycle(record_.history());
  }

  CycleRecord& record_;
  std::vector<NlpVariable> variables_;
  std::chrono::steady_clock::time_point begin_;
  bool interrupted_ = false;
};

/// Analyses, after the last of which the optimiser is stopped.
bool analyses_used_up(const CycleRecord& record, double share = 1) {
  return static_cast<double>(record.history().size()) >= share * record.options().max;
}

bool goes_on(const CycleRecord& record, const DirectProblem& problem) {
  return !record.asked_to_stop() && !problem.interrupted() && !analyses_used_up(record);
}

NlpOptions options_of(const CycleOptions& cycle) {
  NlpOptions nlp;
  nlp.max_iterations = cycle.max;
  nlp.tolerance = kDirectTolerance;
  nlp.acceptable = kDirectAcceptable;
  nlp.feasibility = std::min(kDirectFeasibility, cycle.feasibility);
  nlp.explain_infeasible = false;  // `search` looks for the least violation itself
  return nlp;
}

/// Optimises until no design has met the limits in a share of the analyses. Then it brings down the
/// largest violation from the best design, and optimises from there if that meets the limits: an
/// optimiser that is given an impossible study goes to and fro, far from what it could reach.
NlpResult search(DirectProblem& problem, const CycleRecord& record) {
  const CycleOptions& cycle = record.options();
  NlpOptions nlp = options_of(cycle);
  nlp.progress = [&](const NlpProgress&) {
    return goes_on(record, problem) && (problem.met() || !analyses_used_up(record, kHopeful));
  };
  NlpResult r = solve_by(problem, cycle, nlp);
  if (problem.met() || !goes_on(record, problem)) return r;
  const auto rows = static_cast<Eigen::Index>(problem.constraints().size());
  ElasticProblem least(problem, {0, 1}, VectorXd::Ones(rows), record.best(),
                       problem.least_violation());
  nlp.progress = [&](const NlpProgress&) {
    return goes_on(record, problem) && !problem.met() && !problem.stationary();
  };
  CycleOptions by_asymptotes = cycle;
  by_asymptotes.optimizer = Optimizer::Ipopt;
  by_asymptotes.model = NlpModel::Separable;
  const NlpResult nearest = solve_by(least, by_asymptotes, nlp);
  if (problem.met() && goes_on(record, problem)) {
    problem.start_from(record.best());
    nlp.progress = [&](const NlpProgress&) { return goes_on(record, problem); };
    return solve_by(problem, cycle, nlp);
  }
  r.x = record.best();
  r.status = nearest.solved() ? NlpStatus::Infeasible : nearest.status;
  r.reason = "the largest violation was brought down as far as possible: " + nearest.reason;
  return r;
}

CycleEnd direct_end(const CycleRecord& record, const DirectProblem& at, const NlpResult& r) {
  const CycleOptions& options = record.options();
  if (at.interrupted() || record.asked_to_stop()) return record.stopped();
  if (!at.good()) return {CycleStatus::SimulationFailed, at.failure()};
  const DesignAnalysis& a = *at.analysis();
  const DynamicOptimality& kkt = at.surrogate().optimality;
  const bool meets = a.worst <= options.feasibility;
  const bool cut = analyses_used_up(record);  // the optimiser has no reason of its own then
  const std::string by = cut ? "" : "; " + r.reason;
  const std::string of = "KKT conditions: " + kkt.brief();
  if (meets && kkt.holds()) return {CycleStatus::Optimal, of + by};
  const std::string beyond =
      fmt::format("'{}' is exceeded by {:.3g} %{}", a.worst_constraint, 100 * a.worst,
                  a.worst_at.empty() ? "" : " at " + a.worst_at);
  if (!meets && at.stationary())
    return {CycleStatus::Infeasible, beyond + "; the design is " + kkt.violation->brief()};
  if (cut || r.status == NlpStatus::IterationLimit)
    return {CycleStatus::CycleLimit,
            fmt::format("cycle.max = {} designs after the first are used up; ", options.max) + of +
                (meets ? by : "; " + beyond)};
  if (meets) return {CycleStatus::Converged, of + by};
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
  const NlpResult r = search(problem, record);
  const bool ended = !record.asked_to_stop() && !problem.interrupted();
  if (ended && (stands(problem, r, options) || problem.evaluate(record.best()))) {
    record.keep(problem.analysis(), problem.x());
    record.certify(problem.surrogate().optimality);
  }
  return record.finish(direct_end(record, problem, r));
}

}  // namespace liesl
