#include "optim/cycle/esl_cycle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "optim/cycle/static_sizing.hpp"
#include "optim/nlp/ipopt_driver.hpp"
#include "optim/nlp/nlopt_driver.hpp"
#include "optim/nlp/separable.hpp"

namespace liesl {

const char* to_string(CycleStatus status) {
  switch (status) {
    case CycleStatus::Converged:
      return "converged";
    case CycleStatus::CycleLimit:
      return "cycle limit";
    case CycleStatus::Oscillating:
      return "oscillating";
    case CycleStatus::Infeasible:
      return "infeasible";
    case CycleStatus::SimulationFailed:
      return "simulation failed";
    case CycleStatus::Interrupted:
      return "interrupted";
  }
  return "";
}

namespace {

constexpr int kMaxRounds = 8;        // screening: optimise, look at all cases, again
constexpr double kStuck = 1e-6;      // relative change of a design that counts as none
constexpr double kFixedPoint = 0.1;  // change of a design, of the tolerance, that ends the cycle
constexpr double kSmallestMove = 1e-3;
constexpr int kFewVariables = 12;     // the optimality check simulates twice for each
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
      DesignRun<G> trial = simulate(x);
      if (!trial.good()) {
        if (!retreat(trial, x)) break;
        --number;
        continue;
      }
      Cycle& cycle = record(trial, x, number);
      const bool done = finished(trial, cycle, number);
      if (!done) x = size(trial, cycle);
      cycle.seconds = seconds_since(begin);
      last_ = std::move(trial);
      if (hooks_.on_cycle) hooks_.on_cycle(result_.history);
      if (hooks_.keep_going && !hooks_.keep_going() && !done) {
        result_.status = CycleStatus::Interrupted;
        result_.reason = fmt::format("stopped in cycle {} on request", number);
        break;
      }
      if (done || at_fixed_point(result_.history.back()) || stuck(result_.history.back())) break;
    }
    if (asks_for_optimality()) report_optimality();
    finish();
    return std::move(result_);
  }

 private:
  Eigen::VectorXd start_of(const std::vector<Cycle>& resume) {
    const Eigen::VectorXd x = simulator_.start();
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
    keep_initial(simulate(resume.front().x));
    keep_best(simulate(best->x), best->x);
    last_ = simulate(resume.back().x);
    keep_best(*last_, resume.back().x);
    move_ = resume.back().move;
    return resume.back().next.size() == x.size() ? resume.back().next : resume.back().x;
  }

  DesignRun<G> simulate(const Eigen::VectorXd& x) {
    DesignRun<G> run = simulator_.run(x, hooks_.progress);
    const Report& report = run.simulation.report;
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

  Cycle& record(const DesignRun<G>& trial, const Eigen::VectorXd& x, int number) {
    Cycle c;
    c.number = number;
    c.x = x;
    c.mass = trial.mass;
    c.worst = trial.worst;
    c.worst_constraint = trial.worst_constraint;
    c.worst_time = trial.worst_time;
    c.move = move_;
    if (last_ && last_->loads.size() == trial.loads.size() && same_instants(*last_, trial))
      c.load_change =
          load_change(trial.loads, last_->loads, G::dim, G::space_dim, trial.model->length);
    if (result_.history.empty()) keep_initial(trial);
    result_.history.push_back(c);
    keep_best(trial, x);
    return result_.history.back();
  }

  static bool same_instants(const DesignRun<G>& a, const DesignRun<G>& b) {
    return a.simulation.trajectory.size() == b.simulation.trajectory.size();
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
  void keep_best(DesignRun<G> trial, const Eigen::VectorXd& x) {
    if (!trial.good()) return;
    if (best_ && !better(trial.worst, trial.mass, best_->worst, best_->mass)) return;
    best_ = std::move(trial);
    best_x_ = x;
  }

  bool finished(const DesignRun<G>& trial, const Cycle& cycle, int number) {
    const auto& o = study_.cycle;
    const auto& h = result_.history;
    if (h.size() >= 2 && cycle.load_change && *cycle.load_change < o.tolerance &&
        trial.worst <= o.feasibility &&
        std::abs(cycle.mass - h[h.size() - 2].mass) <= o.objective_tolerance * cycle.mass) {
      result_.status = CycleStatus::Converged;
      result_.reason = fmt::format(
          "loads changed by {:.2g}, mass by {:.2g}, worst limit at {:+.2g}", *cycle.load_change,
          std::abs(cycle.mass / h[h.size() - 2].mass - 1), trial.worst);
      return true;
    }
    if (oscillates()) {
      move_ *= 0.5;
      if (move_ < kSmallestMove) {
        result_.status = CycleStatus::Oscillating;
        result_.reason =
            "the designs go to and fro although the move limits shrank; the best one is returned";
        return true;
      }
    }
    if (number > o.max) {
      result_.status = CycleStatus::CycleLimit;
      result_.reason = fmt::format("{} cycles are used up; loads still changed by {:.2g}", o.max,
                                   cycle.load_change.value_or(1));
      return true;
    }
    return false;
  }

  /// The last three changes of mass alternate and do not shrink; below the tolerance they may.
  bool oscillates() const {
    const auto& h = result_.history;
    if (h.size() < 4) return false;
    const auto change = [&](size_t back) {
      return h[h.size() - back].mass - h[h.size() - back - 1].mass;
    };
    return change(1) * change(2) < 0 && change(2) * change(3) < 0 &&
           std::abs(change(1)) > 0.7 * std::abs(change(3)) &&
           std::abs(change(1)) > study_.cycle.objective_tolerance * h.back().mass;
  }

  NlpResult optimise(StaticSizing<G>& problem) const {
    NlpOptions options;
    options.progress = [this](const NlpProgress&) {
      return !hooks_.keep_going || hooks_.keep_going();
    };
    options.tolerance = 1e-7;
    options.feasibility = 1e-7;
    switch (study_.cycle.optimizer) {
      case Optimizer::Mma:
        return solve_nlopt(problem, NloptMethod::Mma, options);
      case Optimizer::Ccsaq:
        return solve_nlopt(problem, NloptMethod::Ccsaq, options);
      case Optimizer::Slsqp:
        return solve_nlopt(problem, NloptMethod::Slsqp, options);
      case Optimizer::Ipopt:
        break;
    }
    if (study_.cycle.model == NlpModel::Separable) {
      options.tolerance = 1e-6;
      return solve_separable(problem, options);
    }
    return solve_ipopt(problem, options, warm_.multipliers.empty() ? nullptr : &warm_);
  }

  /// The static optimum under the loads of this cycle, then a step towards the fixed point.
  Eigen::VectorXd size(const DesignRun<G>& trial, Cycle& cycle) {
    const Analysis<G> at{trial.mechanism, trial.model.get(), &trial.simulation.trajectory,
                         trial.loads};
    StaticSizing<G> problem(at, simulator_.sizing(), study_, cycle.x, move_);
    NlpResult answer;
    for (int round = 0; round < kMaxRounds; ++round) {
      answer = optimise(problem);
      cycle.iterations += answer.iterations;
      if (answer.status == NlpStatus::Infeasible) break;  // nor with more cases
      if (problem.add_violated(answer.x, 1e-6) == 0) break;
    }
    warm_ = answer.warm_start();
    cycle.load_cases = problem.load_cases();
    cycle.move = move_;
    cycle.answer = answer.x;
    cycle.next = accelerated();
    return cycle.next;
  }

  /// Secant step on x -> G(x), the answer of the static problem (Anderson 1965, depth one): loads
  /// that follow the mass make the plain cycle halve its error only. An answer that a move limit
  /// cut off says nothing of G.
  Eigen::VectorXd accelerated() const {
    const auto& h = result_.history;
    const Cycle& now = h.back();
    Eigen::VectorXd next = now.answer;
    if (h.size() < 2 || on_move_limit(now) || on_move_limit(h[h.size() - 2])) return next;
    const Cycle& before = h[h.size() - 2];
    const Eigen::VectorXd change = now.answer - now.x;
    const Eigen::VectorXd difference = change - (before.answer - before.x);
    const double size = difference.squaredNorm();
    const double theta = size > 0 ? change.dot(difference) / size : 0;
    if (theta > -2 && theta < 0.5) next -= theta * (now.answer - before.answer);
    for (int i = 0; i < next.size(); ++i) {
      const auto& v = simulator_.sizing().variables()[i];
      next[i] = std::clamp(next[i], v.lower, v.upper);
    }
    return next;
  }

  /// A variable went as far as it may in one cycle, and not to its own bound.
  bool on_move_limit(const Cycle& cycle) const {
    for (int i = 0; i < cycle.answer.size(); ++i) {
      const auto& v = simulator_.sizing().variables()[i];
      const double close = kStuck * cycle.x[i];
      const double lower = cycle.x[i] * (1 - cycle.move), upper = cycle.x[i] * (1 + cycle.move);
      if (lower > v.lower && cycle.answer[i] < lower + close) return true;
      if (upper < v.upper && cycle.answer[i] > upper - close) return true;
    }
    return false;
  }

  /// The static optimum under the loads of a design is that design: nothing is left to agree on.
  bool at_fixed_point(const Cycle& cycle) {
    const auto& o = study_.cycle;
    if (cycle.worst > o.feasibility || cycle.next.size() == 0) return false;
    const double change = (cycle.answer - cycle.x).norm() / cycle.x.norm();
    if (change > kFixedPoint * o.tolerance) return false;
    result_.status = CycleStatus::Converged;
    result_.reason = fmt::format(
        "the static optimum under the loads is the design itself within {:.2g}, worst limit at "
        "{:+.2g}",
        change, cycle.worst);
    return true;
  }

  /// Nothing moves any more and a limit is still violated.
  bool stuck(const Cycle& cycle) {
    if (cycle.worst <= study_.cycle.feasibility || cycle.next.size() == 0) return false;
    if ((cycle.next - cycle.x).norm() > kStuck * cycle.x.norm()) return false;
    result_.status = CycleStatus::Infeasible;
    result_.reason = fmt::format(
        "'{}' cannot be met within the bounds: it stays {} its limit at t = {:.6g} s; widen the "
        "bounds or the limit",
        cycle.worst_constraint,
        cycle.worst < 10 ? fmt::format("{:.3g} % above", 100 * cycle.worst)
                         : fmt::format("{:.3g} times", 1 + cycle.worst),
        cycle.worst_time);
    return true;
  }

  /// Only of a design the cycle stands by, and if it costs no more than some cycles do.
  bool asks_for_optimality() const {
    const bool stands = result_.status == CycleStatus::Converged ||
                        result_.status == CycleStatus::CycleLimit ||
                        result_.status == CycleStatus::Oscillating;
    const auto choice = study_.cycle.optimality;
    return best_ && stands &&
           (choice == OptimalityCheck::Always ||
            (choice == OptimalityCheck::Auto && simulator_.sizing().size() <= kFewVariables));
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
        "design, "
        "and a lighter one may be near (" +
        o.brief() + ")");
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
    result_.times = best_->times();
    if (!result_.history.empty())
      result_.load_change = result_.history.back().load_change.value_or(0);
    for (const auto& w : best_->simulation.report.warnings) result_.warnings.push_back(w);
    result_.mechanism = best_->mechanism;
    result_.model = best_->model;
    result_.simulation = std::move(best_->simulation);
  }

  const DesignSimulator<G> simulator_;
  const StudySpec& study_;
  const CycleHooks& hooks_;
  double move_;
  std::optional<DesignRun<G>> last_, best_;
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
