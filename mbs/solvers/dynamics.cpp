#include "mbs/solvers/dynamics.hpp"

#include <fmt/format.h>

#include <chrono>
#include <ctime>

#include "mbs/solvers/ringing.hpp"
#include "mbs/system/constraint_rank.hpp"

namespace liesl {
namespace {

constexpr int kGrowAfter = 4;    // good steps before the step doubles again
constexpr double kSafety = 0.5;  // adaptive: double below kSafety^3 of the tolerance
constexpr double kTurn = 0.05;   // rad a step that a user should know of

/// Steps of size step / 2^level on a grid, so that every multiple of `step` is met.
class StepGrid {
 public:
  StepGrid(const SimulationOptions& o)
      : step_(o.step), fine_(o.step_min > 0 ? o.step_min : o.step / 1024) {
    while (step_ / (1L << (deepest_ + 1)) >= fine_ * (1 - 1e-12)) ++deepest_;
  }
  double h() const { return step_ / static_cast<double>(1L << level_); }
  bool halve() {
    if (level_ == deepest_) return false;
    ++level_;
    ticks_ *= 2;
    good_ = 0;
    return true;
  }
  /// After a good step: one tick on; `may_grow` allows the next step to double.
  void advance(bool may_grow) {
    ++ticks_;
    good_ = may_grow ? good_ + 1 : 0;
    if (level_ > 0 && good_ >= kGrowAfter && ticks_ % 2 == 0) {
      --level_;
      ticks_ /= 2;
      good_ = 0;
    }
  }
  /// Whole steps done, or -1 between two of them.
  long whole() const { return ticks_ % (1L << level_) == 0 ? ticks_ >> level_ : -1; }
  double time() const { return h() * static_cast<double>(ticks_); }

 private:
  double step_, fine_;
  int level_ = 0, deepest_ = 0, good_ = 0;
  long ticks_ = 0;
};

/// The largest turn of a body in one step.
struct FastestTurn {
  double angle = 0;  ///< rad
  int node = 0;

  template <FrameGroup G>
  void step(const Model<G>& model, const State<G>& s, double h) {
    for (const int k : model.frames()) {
      const double turned =
          h * s.v.template segment<G::rotation_dim>(G::dim * k + G::space_dim).norm();
      if (turned > angle) *this = {turned, k};
    }
  }
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Writes down what a replay needs; nothing without a tape.
template <FrameGroup G>
class TapeWriter {
 public:
  TapeWriter(Tape<G>* tape, const GeneralizedAlpha<G>& integrator, const SimulationOptions& o,
             const InitialState& start, long steps)
      : tape_(tape), integrator_(integrator) {
    if (!tape_) return;
    const int root = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(steps))));
    *tape_ = {tape_->every > 0 ? tape_->every : root, o, start, {}, {}, {}};
  }
  void checkpoint(const State<G>& s) {
    if (tape_) tape_->checkpoints.push_back({tape_->attempts.size(), s, integrator_.memory()});
  }
  /// @param s the state after the attempt
  void add(const Attempt& attempt, const State<G>& s) {
    if (!tape_) return;
    tape_->attempts.push_back(attempt);
    if (!attempt.accepted) return;
    tape_->end = s;
    if (++since_ < tape_->every) return;
    since_ = 0;
    checkpoint(s);
  }

 private:
  Tape<G>* tape_;
  const GeneralizedAlpha<G>& integrator_;
  int since_ = 0;
};

/// What a user should know of a run: another step than asked for, refactorised tangents, halved
/// steps, joint forces that ring.
void add_warnings(Report& report, double step, double asked, TangentStrategy tangent,
                  const Ringing& ringing) {
  if (std::abs(step - asked) > 1e-9 * asked)
    report.warnings.push_back(fmt::format(
        "the step is {:.6g} s instead of {:.6g} s, so that whole steps end at the duration", step,
        asked));
  if (report.tangent_refreshes > 0 && tangent == TangentStrategy::Constant)
    report.warnings.push_back(fmt::format(
        "the constant tangent was replaced by that of the moment {} times: the deformations leave "
        "its range",
        report.tangent_refreshes));
  if (report.rejected_steps > 0)
    report.warnings.push_back(
        fmt::format("{} steps were tried again with half the step, down to {:.3g} s",
                    report.rejected_steps, report.smallest_step));
  if (ringing.lasts())
    report.warnings.push_back(
        fmt::format("the joint forces ring: {:.2g} of their size changes sign at every step, for "
                    "want of numerical damping; simulation.rho_inf = {:.2f} calms them",
                    ringing.share(), ringing.calm_rho()));
}

/// Second order in the turn of a step, and it adds up turn by turn: a top that turns by 0.15 rad a
/// step is off by a fourth of its height after 100 turns (docs/stability.md).
template <FrameGroup G>
void add_turn_warning(Report& report, const Model<G>& model, const FastestTurn& turn) {
  if (turn.angle <= kTurn) return;
  size_t body = 0;
  while (body + 1 < model.bodies.size() &&
         model.first_node(static_cast<int>(body) + 1) <= turn.node)
    ++body;
  report.warnings.push_back(fmt::format(
      "body '{}' turns by up to {:.2g} rad a step, which is much: compare with a smaller "
      "simulation.step",
      model.bodies[body]->name, turn.angle));
}

/// What the start has to say. @returns whether the run continues
bool take_start(const InitialState& start, Report& report) {
  report.warnings = start.redundant;
  report.warnings.insert(report.warnings.end(), start.warnings.begin(), start.warnings.end());
  report.status = start.status;
  report.reason = start.reason;
  return start.status == SolveStatus::Converged;
}

/// Why the smallest step `h`, to the time `t`, failed.
std::string failure(const StepResult& step, double t, double h) {
  const auto residual =
      std::isfinite(step.residual) ? fmt::format("{:.2g}", step.residual) : "beyond all numbers";
  return fmt::format("{} at t = {:.6g} s with the smallest step {:.3g} s (relative residual {})",
                     step.failure, t, h, residual);
}

}  // namespace

template <FrameGroup G>
DynamicResult<G> simulate(const Model<G>& model, const SimulationOptions& options,
                          const Progress& progress, Tape<G>* tape) {
  options.require_valid();
  const long whole_steps = std::lround(std::ceil(options.duration / options.step * (1 - 1e-12)));
  SimulationOptions o = options;
  o.step = options.duration / static_cast<double>(whole_steps);
  DynamicResult<G> result;
  Report& report = result.report;
  State<G> s = model.initial_state();
  result.start = make_consistent(model, o, s);
  if (!take_start(result.start, report)) return result;
  result.trajectory.reserve(s, static_cast<int>(whole_steps / o.output_every) + 2);
  State<G> seen;  // completed
  const auto record = [&] {
    seen = s;
    model.complete(seen);
    result.trajectory.record(seen);
  };
  record();

  GeneralizedAlpha<G> integrator(model, o);
  integrator.start(s);
  TapeWriter<G> writer(tape, integrator, o, result.start, whole_steps);
  writer.checkpoint(s);
  StepGrid grid(o);
  Ringing ringing;
  FastestTurn turn;
  report.smallest_step = o.step;
  const double error_limit = o.error_tolerance * model.length;
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu_start = std::clock();
  while (grid.whole() < whole_steps) {
    const double h = grid.h();
    StepResult step = integrator.step(s, h);
    report.newton_iterations += step.iterations;
    report.tangent_refreshes += step.tangents;
    if (!step.converged) {
      writer.add({h, s.t, false}, s);
      ++report.rejected_steps;
      if (grid.halve()) {
        report.smallest_step = std::min(report.smallest_step, grid.h());
        continue;
      }
      report.status = SolveStatus::NotConverged;
      report.reason = failure(step, s.t + h, h);
      break;
    }
    ++report.steps;
    grid.advance(!o.adaptive || step.error < kSafety * kSafety * kSafety * error_limit);
    s.t = grid.time();
    writer.add({h, s.t, true}, s);
    ringing.step(s.lambda, h);
    turn.step(model, s, h);
    report.max_constraint_residual =
        std::max(report.max_constraint_residual, integrator.equations().constraint_residual());
    if (o.adaptive && step.error > error_limit && grid.halve())
      report.smallest_step = std::min(report.smallest_step, grid.h());
    const long whole = grid.whole();
    if (whole > 0 && (whole % o.output_every == 0 || whole == whole_steps)) record();
    if (const auto why = contradiction(model, s); !why.empty()) {
      report.status = SolveStatus::Inconsistent;
      report.reason = why;
      break;
    }
    if (progress && !progress(s.t)) {
      report.status = SolveStatus::Interrupted;
      report.reason = fmt::format("stopped at t = {:.6g} s on request", s.t);
      break;
    }
  }
  report.stepping_s = seconds_since(start);
  report.stepping_cpu_s = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
  report.factorizations = integrator.factorizations();
  add_warnings(report, o.step, options.step, integrator.tangent(), ringing);
  add_turn_warning(report, model, turn);
  return result;
}

template DynamicResult<SE2> simulate(const Model<SE2>&, const SimulationOptions&, const Progress&,
                                     Tape<SE2>*);
template DynamicResult<SE3> simulate(const Model<SE3>&, const SimulationOptions&, const Progress&,
                                     Tape<SE3>*);

}  // namespace liesl
