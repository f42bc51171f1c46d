#include "optim/cycle/trust_region_cycle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "optim/cycle/corrected_problem.hpp"
#include "optim/cycle/coupled_problem.hpp"
#include "optim/cycle/motion_problem.hpp"

namespace liesl {

namespace {

constexpr double kTake = 0.1;   // share of the predicted decrease that a step must bring
constexpr double kGood = 0.75;  // share from which the radius may grow
constexpr double kShrink = 0.3, kGrow = 2;
constexpr double kSmallestRadius = 1e-6;
constexpr double kPenalty = 10;                // sigma at first; the mass counts 1
constexpr double kMargin = 2, kLeast = 1;      // penalty over the sum of the multipliers; at least
constexpr double kStronger = 5;                // penalty against the one before
constexpr double kClose = 0.1, kCloser = 0.9;  // of the allowed violation; of the one before
constexpr double kCounts = 0.1;    // share of objective_tolerance that a decrease must have
constexpr double kNothing = 1e-7;  // a decrease that round-off may bring
constexpr double kActive = 2e-3;   // limits that may carry a multiplier

/// One run of the cycle; the steps of the algorithm are its member functions.
template <FrameGroup G>
class TrustRegionCycle {
 public:
  TrustRegionCycle(const DesignSimulator<G>& simulator, const StudySpec& study,
                   const CycleHooks& hooks, int bodies)
      : simulator_(simulator),
        study_(study),
        hooks_(hooks),
        record_(simulator, study, hooks, bodies),
        radius_(study.cycle.move_limit) {}

  CycleResult<G> run(const std::vector<Cycle>& resume) {
    if (begin(resume))
      while (step()) {
      }
    return record_.finish();
  }

 private:
  using Run = typename CycleRecord<G>::Run;
  /// What a cycle knows of the design it starts from.
  struct Centre {
    Eigen::VectorXd x;
    Run run;
  };

  double merit(const DesignRun<G>& run) const {
    return run.mass / mass_0_ + penalty_ * std::max(0.0, run.worst);
  }

  /// Simulates the start, or the last design that an interrupted run has taken.
  bool begin(const std::vector<Cycle>& resume) {
    if (!resume.empty()) {
      record_.restore(resume);
      const auto taken =
          std::find_if(resume.rbegin(), resume.rend(), [](const Cycle& c) { return c.taken; });
      mass_0_ = resume.front().mass;
      radius_ = resume.back().move;
      penalty_ = std::max(kPenalty, resume.back().penalty);
      at_ = {taken->x, record_.simulate(taken->x)};
      record_.keep(at_.run, at_.x);
      return at_.run->good() || failed(*at_.run);
    }
    at_.x = simulator_.design().start();
    const Clock::time_point start = Clock::now();
    at_.run = record_.simulate(at_.x);
    if (!at_.run->good()) return failed(*at_.run);
    mass_0_ = at_.run->mass;
    Cycle& cycle = record_.add(at_.run, at_.x, nullptr, radius_);
    cycle.taken = true;
    record_.keep(at_.run, at_.x);
    return report(cycle, start);
  }

  bool failed(const DesignRun<G>& run) {
    const Report& report = run.simulation.report;
    const bool stopped = report.status == SolveStatus::Interrupted;
    record_.end(
        CycleEnd{stopped ? CycleStatus::Interrupted : CycleStatus::SimulationFailed,
                 stopped ? report.reason : "the simulation of a design failed: " + report.reason});
    return false;
  }

  /// From one design to the next. False: the cycle has ended.
  bool step() {
    auto statics = motion_problem(study_, simulator_, *at_.run, at_.x, radius_);
    const MotionGradients<G> motion = gradients_at(*statics);
    if (!motion.reason().empty())
      return !record_.end(CycleEnd{CycleStatus::SimulationFailed,
                                   "there are no sensitivities: " + motion.reason()});
    const DynamicOptimality kkt =
        check_optimality(simulator_, study_, at_.x, motion, *statics, kActive);
    if (study_.cycle.method == CycleMethod::Full)
      statics = std::make_unique<CoupledProblem>(std::move(statics), at_.x);
    CorrectedProblem<G> problem(std::move(statics), motion, at_.x, study_.cycle.approximation);
    const double built = radius_;
    for (;;) {
      const Clock::time_point start = Clock::now();
      problem.narrow(std::min(1.0, radius_ / built));
      const ElasticAnswer answer = solve(problem);
      if (record_.asked_to_stop()) return !interrupted();
      const double predicted = merit(*at_.run) - answer.merit;
      if (predicted <= 0 && !kkt.holds() && radius_ > kSmallestRadius) {
        radius_ *= kShrink;  // the optimum of a model that is not convex, and no better than here
        continue;
      }
      if (settled(predicted, kkt, answer)) return false;
      if (record_.end(used_up(record_.history(), study_.cycle))) return false;
      const Run trial = record_.simulate(answer.x);
      if (trial->simulation.report.status == SolveStatus::Interrupted) return failed(*trial);
      if (!trial->good()) {
        record_.result().warnings.push_back("a design could not be simulated: " +
                                            trial->simulation.report.reason);
      }
      const double ratio = trial->good() ? (merit(*at_.run) - merit(*trial)) / predicted : -1;
      const bool taken = ratio >= kTake;
      update_radius(ratio, answer, problem.variables());
      if (trial->good()) {
        Cycle& cycle = record_.add(trial, answer.x, at_.run, radius_);
        cycle.taken = taken;
        cycle.penalty = penalty_;
        cycle.load_cases = problem.load_cases();
        cycle.iterations = answer.iterations;
        if (!report(cycle, start)) return false;
      }
      if (taken) {
        at_ = {answer.x, trial};
        record_.keep(trial, answer.x);
        return true;
      }
      if (radius_ < kSmallestRadius) return !stalled(kkt);
    }
  }

  MotionGradients<G> gradients_at(const StaticProblem& statics) const try {
    return {simulator_.design(), *at_.run, at_.x, statics.responses()};
  } catch (const std::invalid_argument& error) {
    throw NoSensitivities(error.what());
  }

  /// The corrected problem within its bounds, with a penalty that is large enough for it: one that
  /// a larger one does not bring closer to the limits.
  ElasticAnswer solve(CorrectedProblem<G>& problem) {
    const auto at = [&](double penalty) {
      return solve_elastic(problem, {1 / mass_0_, penalty}, study_.cycle, warm_, hooks_.keep_going);
    };
    ElasticAnswer answer = at(penalty_);
    if (answer.violation <= kClose * study_.cycle.feasibility) {
      penalty_ = std::max(kLeast, kMargin * answer.multipliers);
      return answer;
    }
    while (answer.violation > kClose * study_.cycle.feasibility) {
      const ElasticAnswer closer = at(kStronger * penalty_);
      if (closer.violation > kCloser * answer.violation) return answer;
      penalty_ *= kStronger;
      answer = closer;
    }
    return answer;
  }

  /// Nothing that counts is left to gain.
  bool settled(double predicted, const DynamicOptimality& kkt, const ElasticAnswer& answer) {
    const double counts = kCounts * study_.cycle.objective_tolerance;
    if (predicted > (kkt.holds() ? counts : kNothing)) return false;
    if (at_.run->worst > study_.cycle.feasibility) return record_.end(infeasible(answer));
    return stalled(kkt);
  }

  bool stalled(const DynamicOptimality& kkt) {
    record_.certify(kkt);
    const double worst = at_.run->worst;
    if (worst > study_.cycle.feasibility)
      return record_.end(CycleEnd{
          CycleStatus::Infeasible,
          fmt::format("no step improves the design any more, and '{}' stays {:.3g} % above its "
                      "limit at t = {:.6g} s",
                      at_.run->worst_constraint, 100 * worst, at_.run->worst_time)});
    return record_.end(
        CycleEnd{kkt.holds() ? CycleStatus::Optimal : CycleStatus::Converged,
                 fmt::format("KKT conditions of the motion: {}; worst limit at {:+.2g}",
                             kkt.brief(), worst)});
  }

  CycleEnd infeasible(const ElasticAnswer& answer) const {
    return {CycleStatus::Infeasible,
            fmt::format("no design near meets all limits: '{}' is exceeded by {:.3g} % at t = "
                        "{:.6g} s, and by at least {:.3g} % nearby; widen the bounds or the "
                        "limit, or start from another design",
                        at_.run->worst_constraint, 100 * at_.run->worst, at_.run->worst_time,
                        100 * answer.violation)};
  }

  void update_radius(double ratio, const ElasticAnswer& answer,
                     const std::vector<NlpVariable>& bounds) {
    bool on_bound = false;
    for (int i = 0; i < answer.x.size(); ++i) {
      const NlpVariable& b = bounds[static_cast<std::size_t>(i)];
      const double slack = 1e-3 * (b.upper - b.lower);
      on_bound |= answer.x[i] < b.lower + slack || answer.x[i] > b.upper - slack;
    }
    if (ratio < kTake)
      radius_ *= kShrink;
    else if (ratio > kGood && on_bound)
      radius_ = std::min(study_.cycle.move_limit, kGrow * radius_);
  }

  using Clock = std::chrono::steady_clock;

  /// Hands a cycle to the caller. False: asked to stop.
  bool report(Cycle& cycle, Clock::time_point start) {
    cycle.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (hooks_.on_cycle) hooks_.on_cycle(record_.history());
    return !(record_.asked_to_stop() && interrupted());
  }

  bool interrupted() {
    return record_.end(
        CycleEnd{CycleStatus::Interrupted,
                 fmt::format("stopped in cycle {} on request", record_.history().back().number)});
  }

  const DesignSimulator<G>& simulator_;
  const StudySpec& study_;
  const CycleHooks& hooks_;
  CycleRecord<G> record_;
  Centre at_;
  double radius_, mass_0_ = 1, penalty_ = kPenalty;
  NlpWarmStart warm_;
};

}  // namespace

template <FrameGroup G>
CycleResult<G> run_trust_region_cycle(const DesignSimulator<G>& simulator, const StudySpec& study,
                                      const CycleHooks& hooks, int bodies,
                                      const std::vector<Cycle>& resume) {
  return TrustRegionCycle<G>(simulator, study, hooks, bodies).run(resume);
}

template CycleResult<SE2> run_trust_region_cycle(const DesignSimulator<SE2>&, const StudySpec&,
                                                 const CycleHooks&, int, const std::vector<Cycle>&);
template CycleResult<SE3> run_trust_region_cycle(const DesignSimulator<SE3>&, const StudySpec&,
                                                 const CycleHooks&, int, const std::vector<Cycle>&);

}  // namespace liesl
