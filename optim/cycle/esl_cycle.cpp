#include "optim/cycle/esl_cycle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "optim/cycle/motion_problem.hpp"

namespace liesl {

namespace {

constexpr double kSmallestMove = 1e-3;
constexpr std::size_t kFewVariables = 12;  // the optimality check simulates twice for each
// Iterations without second derivatives while the loads still change: they converge slowly, and to
// an answer that the next loads move.
constexpr int kFewIterations = 20;
constexpr double kNearActive = 1e-2;  // limits that may hold the mass up when the cycle ends

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// One run of the cycle; the steps of the algorithm are its member functions.
template <FrameGroup G>
class EslCycle {
 public:
  EslCycle(const Mechanism& mechanism, const Space<G>& space, const SimulationOptions& options,
           const StudySpec& study, const CycleHooks& hooks)
      : simulator_(mechanism, space, options, study),
        study_(study),
        hooks_(hooks),
        move_(study.cycle.move_limit) {
    result_.factorizations.assign(mechanism.bodies.size(), 0);
  }

  CycleResult<G> run(const std::vector<Cycle>& resume) {
    Eigen::VectorXd x = start_of(resume);
    for (int number = static_cast<int>(resume.size()) + 1;; ++number) {
      const auto begin = std::chrono::steady_clock::now();
      const Run trial = simulate(x);
      if (!trial->good()) {
        if (!retreat(*trial, x)) break;
        --number;
        continue;
      }
      Cycle& cycle = record(trial, x, number);
      const bool done = ended(agreement(result_.history, study_.cycle)) || oscillates_for_good() ||
                        ended(used_up(result_.history, study_.cycle));
      if (!done) x = size(*trial, cycle);
      cycle.seconds = seconds_since(begin);
      last_ = trial;
      if (hooks_.on_cycle) hooks_.on_cycle(result_.history);
      if (hooks_.keep_going && !hooks_.keep_going() && !done) {
        result_.status = CycleStatus::Interrupted;
        result_.reason = fmt::format("stopped in cycle {} on request", number);
        break;
      }
      if (done || ended(fixed_point(result_.history.back(), study_.cycle)) ||
          ended(stuck(result_.history.back(), study_.cycle)))
        break;
    }
    if (asks_for_optimality()) report_optimality();
    if (result_.status == CycleStatus::Converged) propose_holes();
    finish();
    return std::move(result_);
  }

 private:
  using Run = std::shared_ptr<DesignRun<G>>;

  Eigen::VectorXd start_of(const std::vector<Cycle>& resume) {
    const Eigen::VectorXd x = simulator_.design().start();
    if (resume.empty()) return x;
    for (const auto& cycle : resume) {
      if (cycle.x.size() != x.size())
        throw std::invalid_argument("resume: the interrupted run has other variables");
      result_.history.push_back(cycle);
    }
    // Simulated again: the first (where it came from), the best (to return), the last (its loads).
    const auto best =
        std::min_element(resume.begin(), resume.end(), [this](const Cycle& a, const Cycle& b) {
          return better(a.worst, a.mass, b.worst, b.mass);
        });
    keep_initial(*simulate(resume.front().x));
    keep_best(simulate(best->x), best->x);
    last_ = simulate(resume.back().x);
    keep_best(last_, resume.back().x);
    move_ = resume.back().move;
    return resume.back().next.size() == x.size() ? resume.back().next : resume.back().x;
  }

  Run simulate(const Eigen::VectorXd& x) {
    Run run = std::make_shared<DesignRun<G>>(simulator_.run(x, hooks_.progress));
    const Report& report = run->simulation.report;
    result_.steps += report.steps;
    result_.newton_iterations += report.newton_iterations;
    result_.stepping_s += report.stepping_s;
    for (size_t b = 0; b < report.factorizations.size(); ++b)
      result_.factorizations[b] += report.factorizations[b];
    return run;
  }

  /// A design whose simulation fails is half-way taken back. False: nothing to go back to.
  bool retreat(const DesignRun<G>& trial, Eigen::VectorXd& x) {
    const Report& report = trial.simulation.report;
    if (report.status == SolveStatus::Interrupted) {
      result_.status = CycleStatus::Interrupted;
      result_.reason = report.reason;
      return false;
    }
    move_ *= 0.5;
    if (result_.history.empty() || move_ < kSmallestMove) {
      result_.status = CycleStatus::SimulationFailed;
      result_.reason = "the simulation of a design failed: " + report.reason;
      return false;
    }
    result_.warnings.push_back("a design could not be simulated and was taken back half-way: " +
                               report.reason);
    x = 0.5 * (x + result_.history.back().x);
    return true;
  }

  Cycle& record(const Run& run, const Eigen::VectorXd& x, int number) {
    const DesignRun<G>& trial = *run;
    Cycle c;
    c.number = number;
    c.x = x;
    c.mass = trial.mass;
    c.worst = trial.worst;
    c.worst_constraint = trial.worst_constraint;
    c.worst_time = trial.worst_time;
    c.move = move_;
    if (last_ && last_->good() && last_->times() == trial.times())
      c.load_change = load_change(trial, *last_);
    c.unit = simulator_.design().unit(x);
    if (result_.history.empty()) keep_initial(trial);
    result_.history.push_back(c);
    keep_best(run, x);
    return result_.history.back();
  }

  void keep_initial(const DesignRun<G>& trial) {
    result_.initial = trial.limits;
    result_.mass_initial = trial.mass;
    result_.times_initial = trial.times();
  }

  bool better(double worst, double mass, double than_worst, double than_mass) const {
    const double allowed = study_.cycle.feasibility;
    const bool meets = worst <= allowed, other_meets = than_worst <= allowed;
    return meets != other_meets ? meets : meets ? mass < than_mass : worst < than_worst;
  }

  /// Best: the lightest among those that meet the limits, else the least violation.
  void keep_best(const Run& trial, const Eigen::VectorXd& x) {
    if (!trial->good()) return;
    if (best_ && !better(trial->worst, trial->mass, best_->worst, best_->mass)) return;
    best_ = trial;
    best_x_ = x;
  }

  bool ended(const std::optional<CycleEnd>& end) {
    if (!end) return false;
    result_.status = end->status;
    result_.reason = end->reason;
    return true;
  }

  /// Halves the move limit of a cycle that oscillates; true if that does not help any more.
  bool oscillates_for_good() {
    if (!oscillates(result_.history, study_.cycle)) return false;
    move_ *= 0.5;
    return move_ < kSmallestMove &&
           ended(CycleEnd{CycleStatus::Oscillating,
                          "the designs go to and fro although the move limits shrank; the best "
                          "one is returned"});
  }

  /// The static optimum under the loads of this cycle, then a step towards the fixed point.
  Eigen::VectorXd size(const DesignRun<G>& trial, Cycle& cycle) {
    take_answer(*motion_problem(study_, simulator_, trial, cycle.x, move_), cycle);
    cycle.next = next_design(result_.history, simulator_.design().variables());
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

  /// Only of a design the cycle stands by, and if it costs no more than some cycles do.
  bool asks_for_optimality() const {
    const bool stands = result_.status == CycleStatus::Converged ||
                        result_.status == CycleStatus::CycleLimit ||
                        result_.status == CycleStatus::Oscillating;
    const auto choice = study_.cycle.optimality;
    return best_ && stands &&
           (choice == OptimalityCheck::Always ||
            (choice == OptimalityCheck::Auto &&
             simulator_.design().variables().size() <= kFewVariables));
  }

  void report_optimality() {
    result_.optimality =
        check_optimality(simulator_, *best_, best_x_, kNearActive, hooks_.progress);
    const DynamicOptimality& o = *result_.optimality;
    if (!o.residual)
      result_.warnings.push_back("the dynamic optimality conditions were not checked: " + o.reason);
    if (!o.residual || o.holds()) return;
    if (result_.status == CycleStatus::Converged)
      result_.reason =
          "loads and design agree, but the dynamic optimality conditions do not hold: " +
          o.brief() + "; " + result_.reason;
    result_.warnings.push_back(
        "not optimal for the motion itself: the cycle does not see how the loads follow the "
        "design, and a lighter one may be near (" +
        o.brief() + ")");
  }

  /// @pre the cycle converged, and `best_` still has its motion
  void propose_holes() {
    const Design& design = simulator_.design();
    for (int k = 0; k < design.parts(); ++k) {
      const int body = design.part(k).body;
      const auto& counted = study_.mass_of;
      if (std::find(counted.begin(), counted.end(), body) == counted.end()) continue;
      result_.proposals.push_back(
          {body, propose_hole(motion_task(study_, simulator_, k, *best_),
                              study_.shapes.at(body).walls, design.of_part(k, best_x_))});
    }
  }

  void finish() {
    if (!best_) return;
    result_.x = best_x_;
    result_.mass = best_->mass;
    result_.worst = best_->worst;
    result_.final = best_->limits;
    for (const auto& loads : best_->loads)
      result_.identity.emplace_back(
          loads.body, check_identity(*best_->model, best_->simulation.trajectory, loads));
    const Design& design = simulator_.design();
    for (int k = 0; k < design.parts(); ++k) {
      PartShape& part = design.part(k);
      part.shape->set(part.design.parameters(design.of_part(k, best_x_)));
      const Fractions fractions = volume_fractions(part.model.mesh(), *part.shape);
      for (const auto& loads : best_->solid_loads)
        if (loads.body == part.body)
          result_.identity.emplace_back(loads.body,
                                        check_identity(part.model, fractions.value, loads));
    }
    result_.times = best_->times();
    if (!result_.history.empty()) result_.load_change = result_.history.back().load_change;
    for (const auto& w : best_->simulation.report.warnings) result_.warnings.push_back(w);
    result_.mechanism = best_->mechanism;
    result_.model = best_->model;
    result_.simulation = std::move(best_->simulation);
  }

  const DesignSimulator<G> simulator_;
  const StudySpec& study_;
  const CycleHooks& hooks_;
  double move_;
  Run last_, best_;  ///< null: none yet
  Eigen::VectorXd best_x_;
  NlpWarmStart warm_;
  CycleResult<G> result_;
};

}  // namespace

template <FrameGroup G>
CycleResult<G> run_cycle(const Mechanism& mechanism, const Space<G>& space,
                         const SimulationOptions& simulation, const StudySpec& study,
                         const CycleHooks& hooks, const std::vector<Cycle>& resume) {
  return EslCycle<G>(mechanism, space, simulation, study, hooks).run(resume);
}

template CycleResult<SE2> run_cycle(const Mechanism&, const Space<SE2>&, const SimulationOptions&,
                                    const StudySpec&, const CycleHooks&, const std::vector<Cycle>&);
template CycleResult<SE3> run_cycle(const Mechanism&, const Space<SE3>&, const SimulationOptions&,
                                    const StudySpec&, const CycleHooks&, const std::vector<Cycle>&);

}  // namespace liesl
