#include "optim/cycle/esl_cycle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "mbs/system/response_value.hpp"
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

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// One simulated design.
template <FrameGroup G>
struct Trial {
  Mechanism mechanism;
  std::shared_ptr<Model<G>> model;
  Simulation<G> simulation;
  std::vector<LoadSet> loads;
  std::vector<LimitSeries> limits;
  double worst = -1, worst_time = 0, mass = 0;
  std::string worst_constraint;
};

/// One run of the cycle; the steps of the algorithm are its member functions.
template <FrameGroup G>
class EslCycle {
 public:
  EslCycle(const Mechanism& mechanism, const Space<G>& space, const SimulationOptions& options,
           const StudySpec& study, const CycleHooks& hooks)
      : mechanism_(mechanism),
        space_(space),
        options_(options),
        study_(study),
        hooks_(hooks),
        sizing_(study.design, mechanism),
        move_(study.cycle.move_limit),
        bodies_(limited_bodies(study)) {
    result_.factorizations.assign(mechanism.bodies.size(), 0);
  }

  CycleResult<G> run(const std::vector<Cycle>& resume) {
    Eigen::VectorXd x = start_of(resume);
    for (int number = static_cast<int>(resume.size()) + 1;; ++number) {
      const auto begin = std::chrono::steady_clock::now();
      Trial<G> trial = simulate(x);
      if (trial.simulation.report.status != SolveStatus::Converged) {
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
    finish();
    return std::move(result_);
  }

 private:
  Eigen::VectorXd start_of(const std::vector<Cycle>& resume) {
    Eigen::VectorXd x(sizing_.size());
    for (int i = 0; i < x.size(); ++i) x[i] = sizing_.variables()[i].start;
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
    answer_before_ = resume.back().answer;
    if (answer_before_.size() == x.size()) change_before_ = answer_before_ - resume.back().x;
    return resume.back().next.size() == x.size() ? resume.back().next : resume.back().x;
  }

  Trial<G> simulate(const Eigen::VectorXd& x) {
    Trial<G> t;
    t.mechanism = sizing_.apply(mechanism_, x);
    t.model = std::make_shared<Model<G>>(Model<G>::build(t.mechanism, space_));
    t.simulation = run_simulation(*t.model, options_, hooks_.progress);
    const Report& report = t.simulation.report;
    result_.steps += report.steps;
    result_.newton_iterations += report.newton_iterations;
    result_.stepping_s += report.stepping_s;
    for (size_t b = 0; b < report.factorizations.size(); ++b)
      result_.factorizations[b] += report.factorizations[b];
    t.mass = mass_of(t.mechanism, study_.mass_of);
    if (report.status != SolveStatus::Converged) return t;
    for (const int body : bodies_)
      t.loads.push_back(extract_loads(*t.model, t.simulation.trajectory, body));
    measure(t);
    return t;
  }

  /// The true responses at every step.
  void measure(Trial<G>& t) const {
    const ResponseValues<G> values(t.mechanism, *t.model);
    const auto& trajectory = t.simulation.trajectory;
    State<G> s = t.model->initial_state();
    for (const auto& c : study_.constraints)
      t.limits.push_back({c.response.name, c.limit, {}, 0, 0});
    for (int n = 0; n < trajectory.size(); ++n) {
      trajectory.read(n, s);
      for (size_t i = 0; i < study_.constraints.size(); ++i) {
        const double v = values(study_.constraints[i].response, s).norm();
        LimitSeries& series = t.limits[i];
        series.values.push_back(v);
        if (v > series.largest) {
          series.largest = v;
          series.at_time = s.t;
        }
      }
    }
    for (const auto& series : t.limits)
      if (const double g = series.largest / series.limit - 1; g > t.worst) {
        t.worst = g;
        t.worst_time = series.at_time;
        t.worst_constraint = series.name;
      }
  }

  /// A design whose simulation fails is half-way taken back. False: nothing to go back to.
  bool retreat(const Trial<G>& trial, Eigen::VectorXd& x) {
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

  Cycle& record(const Trial<G>& trial, const Eigen::VectorXd& x, int number) {
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

  static bool same_instants(const Trial<G>& a, const Trial<G>& b) {
    return a.simulation.trajectory.size() == b.simulation.trajectory.size();
  }

  void keep_initial(const Trial<G>& trial) {
    result_.initial = trial.limits;
    result_.mass_initial = trial.mass;
    for (int n = 0; n < trial.simulation.trajectory.size(); ++n)
      result_.times_initial.push_back(trial.simulation.trajectory.time(n));
  }

  bool better(double worst, double mass, double than_worst, double than_mass) const {
    const double allowed = study_.cycle.feasibility;
    const bool meets = worst <= allowed, other_meets = than_worst <= allowed;
    return meets != other_meets ? meets : meets ? mass < than_mass : worst < than_worst;
  }

  /// Best: the lightest among those that meet the limits, else the least violation.
  void keep_best(Trial<G> trial, const Eigen::VectorXd& x) {
    if (trial.simulation.report.status != SolveStatus::Converged) return;
    if (best_ && !better(trial.worst, trial.mass, best_->worst, best_->mass)) return;
    best_ = std::move(trial);
    best_x_ = x;
  }

  bool finished(const Trial<G>& trial, const Cycle& cycle, int number) {
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
  Eigen::VectorXd size(const Trial<G>& trial, Cycle& cycle) {
    const Analysis<G> at{trial.mechanism, trial.model.get(), &trial.simulation.trajectory,
                         trial.loads};
    StaticSizing<G> problem(at, sizing_, study_, cycle.x, move_);
    NlpResult answer;
    for (int round = 0; round < kMaxRounds; ++round) {
      answer = optimise(problem);
      cycle.iterations += answer.iterations;
      if (problem.add_violated(answer.x, 1e-6) == 0) break;
    }
    warm_ = answer.warm_start();
    cycle.load_cases = problem.load_cases();
    cycle.answer = answer.x;
    cycle.next = accelerated(cycle, answer.x);
    last_answer_ = answer;
    return cycle.next;
  }

  /// Secant step on x -> G(x), the answer of the static problem (Anderson 1965, depth one): loads
  /// that follow the mass make the plain cycle halve its error only.
  Eigen::VectorXd accelerated(const Cycle& cycle, const Eigen::VectorXd& answer) {
    Eigen::VectorXd next = answer;
    const Eigen::VectorXd change = answer - cycle.x;
    if (answer_before_.size() == answer.size()) {
      const Eigen::VectorXd difference = change - change_before_;
      const double size = difference.squaredNorm();
      const double theta = size > 0 ? change.dot(difference) / size : 0;
      if (theta > -2 && theta < 0.5) next = answer - theta * (answer - answer_before_);
    }
    answer_before_ = answer;
    change_before_ = change;
    for (int i = 0; i < next.size(); ++i)
      next[i] = std::clamp(next[i], sizing_.variables()[i].lower, sizing_.variables()[i].upper);
    return next;
  }

  /// The static optimum under the loads of a design is that design: nothing is left to agree on.
  bool at_fixed_point(const Cycle& cycle) {
    const auto& o = study_.cycle;
    if (cycle.worst > o.feasibility || cycle.next.size() == 0) return false;
    const double change = change_before_.norm() / cycle.x.norm();
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
        "'{}' cannot be met within the bounds: it stays {:.3g} % above its limit at t = {:.6g} s; "
        "widen the bounds or the limit",
        cycle.worst_constraint, 100 * cycle.worst, cycle.worst_time);
    return true;
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
    for (int n = 0; n < best_->simulation.trajectory.size(); ++n)
      result_.times.push_back(best_->simulation.trajectory.time(n));
    if (!result_.history.empty())
      result_.load_change = result_.history.back().load_change.value_or(0);
    for (const auto& w : best_->simulation.report.warnings) result_.warnings.push_back(w);
    result_.mechanism = best_->mechanism;
    result_.model = best_->model;
    result_.simulation = std::move(best_->simulation);
  }

  const Mechanism& mechanism_;
  const Space<G>& space_;
  const SimulationOptions& options_;
  const StudySpec& study_;
  const CycleHooks& hooks_;
  const Sizing sizing_;
  double move_;
  std::vector<int> bodies_;  ///< that carry limits
  std::optional<Trial<G>> last_, best_;
  Eigen::VectorXd best_x_, answer_before_, change_before_;
  NlpResult last_answer_;
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
