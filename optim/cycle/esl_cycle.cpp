#include "optim/cycle/esl_cycle.hpp"

#include <fmt/format.h>

#include <chrono>

#include "optim/cycle/motion_problem.hpp"
#include "optim/cycle/trust_region_cycle.hpp"

namespace liesl {

namespace {

constexpr double kSmallestMove = 1e-3;
// Iterations without second derivatives while the loads still change: they converge slowly, and to
// an answer that the next loads move.
constexpr int kFewIterations = 20;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// One run of the cycle; the steps of the algorithm are its member functions.
template <FrameGroup G>
class EslCycle {
 public:
  EslCycle(const DesignSimulator<G>& simulator, const StudySpec& study, const CycleHooks& hooks,
           int bodies)
      : simulator_(simulator),
        study_(study),
        hooks_(hooks),
        record_(simulator, study, hooks, bodies),
        move_(study.cycle.move_limit) {}

  CycleResult<G> run(const std::vector<Cycle>& resume) {
    Eigen::VectorXd x = start_of(resume);
    for (;;) {
      const auto begin = std::chrono::steady_clock::now();
      const Run trial = record_.simulate(x);
      if (!trial->good()) {
        if (!retreat(*trial, x)) break;
        continue;
      }
      Cycle& cycle = record_.add(trial, x, last_, move_);
      record_.keep_if_better(trial, x);
      const bool done = record_.end(agreement(record_.history(), study_.cycle)) ||
                        oscillates_for_good() ||
                        record_.end(used_up(record_.history(), study_.cycle));
      if (!done) x = size(*trial, cycle);
      cycle.seconds = seconds_since(begin);
      last_ = trial;
      if (hooks_.on_cycle) hooks_.on_cycle(record_.history());
      if (record_.asked_to_stop() && !done) {
        record_.end(CycleEnd{CycleStatus::Interrupted,
                             fmt::format("stopped in cycle {} on request", cycle.number)});
        break;
      }
      if (done || record_.end(fixed_point(record_.history().back(), study_.cycle)) ||
          record_.end(stuck(record_.history().back(), study_.cycle)))
        break;
    }
    return record_.finish();
  }

 private:
  using Run = typename CycleRecord<G>::Run;

  Eigen::VectorXd start_of(const std::vector<Cycle>& resume) {
    if (resume.empty()) return simulator_.design().start();
    last_ = record_.restore(resume);
    const Cycle& at = resume.back();
    move_ = at.move;
    return at.next.size() == at.x.size() ? at.next : at.x;
  }

  /// A design whose simulation fails is half-way taken back. False: nothing to go back to.
  bool retreat(const DesignRun<G>& trial, Eigen::VectorXd& x) {
    const Report& report = trial.simulation.report;
    if (report.status == SolveStatus::Interrupted)
      return !record_.end(CycleEnd{CycleStatus::Interrupted, report.reason});
    move_ *= 0.5;
    if (record_.history().empty() || move_ < kSmallestMove)
      return !record_.end(CycleEnd{CycleStatus::SimulationFailed,
                                   "the simulation of a design failed: " + report.reason});
    record_.result().warnings.push_back(
        "a design could not be simulated and was taken back half-way: " + report.reason);
    x = 0.5 * (x + record_.history().back().x);
    return true;
  }

  /// Halves the move limit of a cycle that oscillates; true if that does not help any more.
  bool oscillates_for_good() {
    if (!oscillates(record_.history(), study_.cycle)) return false;
    move_ *= 0.5;
    return move_ < kSmallestMove &&
           record_.end(CycleEnd{CycleStatus::Oscillating,
                                "the designs go to and fro although the move limits shrank; the "
                                "best one is returned"});
  }

  /// The static optimum under the loads of this cycle, then a step towards the fixed point.
  Eigen::VectorXd size(const DesignRun<G>& trial, Cycle& cycle) {
    take_answer(*motion_problem(study_, simulator_, trial, cycle.x, move_), cycle);
    cycle.next = next_design(record_.history(), simulator_.design().variables());
    return cycle.next;
  }

  void take_answer(StaticProblem& problem, Cycle& cycle) {
    const auto& variables = problem.variables();
    cycle.lower.resize(cycle.x.size());
    cycle.upper.resize(cycle.x.size());
    for (int i = 0; i < cycle.x.size(); ++i) {
      cycle.lower[i] = variables[i].lower;
      cycle.upper[i] = variables[i].upper;
    }
    const int all = NlpOptions().max_iterations, few = problem.has_hessian() ? all : kFewIterations;
    StaticAnswer answer = solve_static(problem, study_.cycle, warm_, hooks_.keep_going, few);
    cycle.iterations = answer.iterations;
    if (few < all && answer.result.status == NlpStatus::IterationLimit &&
        step_size(cycle, answer.result.x) <= study_.cycle.tolerance) {  // few led nowhere
      answer = solve_static(problem, study_.cycle, warm_, hooks_.keep_going, all);
      cycle.iterations += answer.iterations;
    }
    cycle.load_cases = problem.load_cases();
    cycle.move = move_;
    cycle.answer = answer.result.x;
  }

  const DesignSimulator<G>& simulator_;
  const StudySpec& study_;
  const CycleHooks& hooks_;
  CycleRecord<G> record_;
  double move_;
  Run last_;  ///< null: none yet
  NlpWarmStart warm_;
};

}  // namespace

template <FrameGroup G>
CycleResult<G> run_cycle(const Mechanism& mechanism, const Space<G>& space,
                         const SimulationOptions& simulation, const StudySpec& study,
                         const CycleHooks& hooks, const std::vector<Cycle>& resume) {
  const auto bodies = static_cast<int>(mechanism.bodies.size());
  StudySpec as = study;
  std::string refused;
  if (study.cycle.method != CycleMethod::Esl && simulation.type == SimulationType::Dynamic) try {
      if (study.cycle.method == CycleMethod::Auto) as.cycle.method = CycleMethod::Esl1;
      const DesignSimulator<G> simulator(mechanism, space, simulation, as);
      return run_trust_region_cycle(simulator, as, hooks, bodies, resume);
    } catch (const NoSensitivities& error) {
      if (study.cycle.method != CycleMethod::Auto) throw;
      refused = error.what();
    }
  as.cycle.method = CycleMethod::Esl;
  const DesignSimulator<G> simulator(mechanism, space, simulation, as);
  CycleResult<G> result = EslCycle<G>(simulator, as, hooks, bodies).run(resume);
  if (!refused.empty())
    result.warnings.push_back(
        "the plain ESL cycle ran, because this motion has no sensitivities: " + refused);
  return result;
}

template CycleResult<SE2> run_cycle(const Mechanism&, const Space<SE2>&, const SimulationOptions&,
                                    const StudySpec&, const CycleHooks&, const std::vector<Cycle>&);
template CycleResult<SE3> run_cycle(const Mechanism&, const Space<SE3>&, const SimulationOptions&,
                                    const StudySpec&, const CycleHooks&, const std::vector<Cycle>&);

}  // namespace liesl
