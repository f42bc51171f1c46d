#include "mbs/solvers/dynamics.hpp"

#include <fmt/format.h>

#include <chrono>
#include <ctime>

#include "mbs/solvers/divergence.hpp"
#include "mbs/solvers/ringing.hpp"
#include "mbs/solvers/statics.hpp"
#include "mbs/solvers/step_control.hpp"
#include "mbs/system/constraint_rank.hpp"
#include "mbs/system/penalty.hpp"

namespace liesl {
namespace {

constexpr double kTurn = 0.05;             // rad a step that a user should know of
constexpr double kBend = 0.5;              // rad of one element that a user should know of
constexpr double kFold = 0.99 * M_PI;      // rad
constexpr double kOpen = 0.01;             // of the deformation that a user should know of
constexpr double kApart = 10;              // times that: nothing to rely on
constexpr double kOpenRigid = 1e-4;        // of the length, where nothing deforms
constexpr double kKept = 64e6;             // bytes of states on a tape with all of them
constexpr double kCopies = 4;              // of a state in a checkpoint, at most
constexpr double kStartTolerance = 1e-10;  // of the equilibrium that a motion starts from

/// The largest turn of a body in one step.
struct FastestTurn {
  double angle = 0;  ///< rad
  int node = 0;

  template <FrameGroup G>
  void step(const Model<G>& model, const State<G>& s, double h) {
    for (const int k : model.frames()) {
      const double square =
          h * h * s.v.template segment<G::rotation_dim>(G::dim * k + G::space_dim).squaredNorm();
      if (square > angle * angle) *this = {std::sqrt(square), k};
    }
  }
};

/// How far elements turn from one end to the other: their strain has no unique value at pi. (Those
/// whose nodes follow a floating frame have linear strains.) Cosines tell it, once a step.
template <FrameGroup G>
class LargestBend {
 public:
  explicit LargestBend(const Model<G>& model) {
    for (size_t b = 0; b < model.bodies.size(); ++b) {
      const Body<G>& body = *model.bodies[b];
      const auto turns = [&body](int k) {
        return body.kind(k) == NodeKind::Frame || body.kind(k) == NodeKind::Position;
      };
      for (int e = 0; e < body.elements(); ++e) {
        if (!turns(e) || !turns(e + 1)) continue;
        const double c = cosine(body.reference[e], body.reference[e + 1]);
        elements_.push_back({model.first_node(static_cast<int>(b)) + e, b, c, c, c});
      }
    }
  }
  void step(const State<G>& s) {
    for (Element& e : elements_) {
      const double c = cosine(s.H[e.node], s.H[e.node + 1]);
      e.least = std::min(e.least, c);
      e.most = std::max(e.most, c);
      if (c >= least_) continue;
      least_ = c;
      turned_ = e.body;
    }
  }

  double whole() const { return std::acos(least_); }  ///< rad: the largest turn
  size_t turned() const { return turned_; }           ///< body where it is
  /// The largest change of a turn since rest, rad, and its body.
  std::pair<double, size_t> change() const {
    std::pair<double, size_t> largest{0, 0};
    for (const Element& e : elements_)
      for (const double c : {e.least, e.most})
        if (const double by = std::abs(std::acos(c) - std::acos(e.rest)); by > largest.first)
          largest = {by, e.body};
    return largest;
  }

 private:
  struct Element {
    int node;  ///< the first
    size_t body;
    double rest, least, most;  ///< cosines of its turn
  };
  /// trace(R_a^T R_b) is 1 + 2 cos(angle) in space, 2 cos(angle) in the plane.
  static double cosine(const G& a, const G& b) {
    const double trace = a.R.cwiseProduct(b.R).sum();
    return std::clamp(0.5 * (trace - (G::space_dim - 2)), -1., 1.);
  }
  std::vector<Element> elements_;
  double least_ = 1;
  size_t turned_ = 0;
};

/// Time of the stepping: runs, but not while something looks at the states.
class Watch {
 public:
  /// @param processors whether their time is asked for, too: each look at it calls the system
  explicit Watch(bool processors) : processors_(processors) {}
  void go() {
    wall_ = std::chrono::steady_clock::now();
    if (processors_) cpu_ = std::clock();
  }
  void stop(Report& report) const {
    report.stepping_s +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_).count();
    if (processors_)
      report.stepping_cpu_s += static_cast<double>(std::clock() - cpu_) / CLOCKS_PER_SEC;
  }

 private:
  bool processors_;
  std::chrono::steady_clock::time_point wall_;
  std::clock_t cpu_ = 0;
};

/// Positions of the static equilibrium under the loads of t = 0 into s. @returns how it went
template <FrameGroup G>
InitialState take_equilibrium(const Model<G>& model, const SimulationOptions& options,
                              State<G>& s) {
  SimulationOptions statics = options;
  statics.type = SimulationType::Static;
  statics.tolerance = std::min(options.tolerance, kStartTolerance);
  statics.at = 0;
  statics.max_load = 1;
  statics.arc_length = statics.critical = false;
  const StaticResult<G> found = solve_static(model, statics);
  InitialState out = found.start;
  out.status = found.report.status;
  if (out.status != SolveStatus::Converged) {
    out.reason = "no equilibrium to start from: " + found.report.reason;
    return out;
  }
  State<G> rest = s;
  found.trajectory.read(found.trajectory.size() - 1, rest);
  if (found.negative.back() > 0)
    out.warnings.push_back(
        "the equilibrium that the motion starts from is not stable: the smallest disturbance "
        "leaves it");
  s.H = rest.H;
  s.w = rest.w;
  s.rows = rest.rows;
  return out;
}

/// Bytes of the numbers of a state.
template <FrameGroup G>
double size_of(const State<G>& s) {
  const auto numbers =
      s.v.size() + s.vdot.size() + s.a.size() + s.w.size() + s.lambda.size() + s.rows.size();
  return static_cast<double>(sizeof(double)) * static_cast<double>(numbers) +
         static_cast<double>(sizeof(G)) * static_cast<double>(s.H.size());
}

/// Writes down what a replay needs; nothing without a tape. Short motions have a checkpoint after
/// every step, so that a replay has nothing to solve.
template <FrameGroup G>
class TapeWriter {
 public:
  TapeWriter(Tape<G>* tape, const GeneralizedAlpha<G>& integrator, const SimulationOptions& o,
             const InitialState& start, long steps, const State<G>& s)
      : tape_(tape), integrator_(integrator) {
    if (!tape_) return;
    const int root = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(steps))));
    const bool all = kCopies * size_of(s) * static_cast<double>(steps) <= kKept;
    *tape_ = {tape_->every > 0 ? tape_->every : all ? 1 : root, o, start, {}, {}, {}};
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
/// steps, errors that were too large, joint forces that ring.
void add_warnings(Report& report, const SimulationOptions& o, double asked, TangentStrategy tangent,
                  const Ringing& ringing) {
  const double step = o.step;
  if (std::abs(step - asked) > 1e-9 * asked)
    report.warnings.push_back(fmt::format(
        "the step is {:.6g} s instead of {:.6g} s, so that whole steps end at the duration", step,
        asked));
  const long stalled = report.tangent_refreshes - report.tangent_renewals;
  if (stalled > 0 && tangent == TangentStrategy::Constant)
    report.warnings.push_back(fmt::format(
        "the constant tangent was replaced by that of the moment {} times: the deformations leave "
        "its range",
        stalled));
  if (report.rejected_steps > 0)
    report.warnings.push_back(
        o.adaptive
            ? fmt::format("{} steps did not converge and were tried again with half the step",
                          report.rejected_steps)
            : fmt::format("{} steps were tried again with half the step, down to {:.3g} s",
                          report.rejected_steps, report.smallest_step));
  if (report.inexact_steps > 0)
    report.warnings.push_back(fmt::format(
        "the error of {} steps is above simulation.error_tolerance = {:g} with the smallest step, "
        "{:.3g} s: allow smaller ones by simulation.step_min",
        report.inexact_steps, o.error_tolerance, report.smallest_step));
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

template <FrameGroup G>
void add_bend_warning(Report& report, const Model<G>& model, const LargestBend<G>& bend) {
  const auto [largest, body] = bend.change();
  if (largest <= kBend) return;
  report.warnings.push_back(
      fmt::format("an element of '{}' bends by up to {:.2g} rad, which is much: compare with more "
                  "elements",
                  model.bodies[body]->name, largest));
}

/// What closes joints besides larger weights.
std::string instead_of(const Penalty& penalty) {
  if (penalty.form == ConstraintForm::Augmented) return "";
  return fmt::format("{}, or take simulation.constraints = \"augmented\"",
                     penalty.damping > 0
                         ? ", lower simulation.penalty_damping, which keeps them open as long"
                         : "");
}

/// What penalties leave open, and whether that counts beside the deformation.
template <FrameGroup G>
void report_penalty(const Model<G>& model, const JointOpening<G>& open, Report& report) {
  PenaltyReport& p = report.penalty;
  p.used = true;
  p.displacement = model.penalty.displacement;
  p.rotation = model.penalty.rotation;
  const auto worst = open.worst();
  p.joint = worst.joint;
  p.opening = worst.opening;
  p.deformation = worst.deformation;
  p.share = worst.share;
  p.rigid = open.rigid();
  const double limit = p.rigid ? kOpenRigid : kOpen;
  if (p.share <= limit) return;
  const std::string text = fmt::format(
      "the joints open by up to {:.3g} m ('{}'), {:.2g} % of {}: raise simulation.penalty ({:g} "
      "N/m) and penalty_rotation ({:g} N m){}",
      p.opening, p.joint, 100 * p.share,
      p.rigid ? std::string("the mechanism's length")
              : fmt::format("the largest deformation beside it of {:.3g} m", p.deformation),
      p.displacement, p.rotation, instead_of(model.penalty));
  report.warnings.push_back(text);
  if (p.share <= kApart * limit || report.status != SolveStatus::Converged) return;
  report.status = SolveStatus::Inaccurate;
  report.reason = text;
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
  return fmt::format("{} at t = {:.6g} s with the smallest step {:.3g} s {}", step.failure, t, h,
                     relative_residual(step.residual));
}

/// Puts s where the motion starts. @returns whether the run goes on
template <FrameGroup G>
bool begin(const Model<G>& model, const SimulationOptions& o, State<G>& s,
           DynamicResult<G>& result) {
  std::vector<std::string> of_equilibrium;
  if (o.start == StartChoice::Equilibrium) {
    result.start = take_equilibrium(model, o, s);
    if (!take_start(result.start, result.report)) return false;
    of_equilibrium = result.start.warnings;
  }
  result.start = make_consistent(model, o, s);
  auto& warnings = result.start.warnings;
  warnings.insert(warnings.begin(), of_equilibrium.begin(), of_equilibrium.end());
  return take_start(result.start, result.report);
}

/// What the report has of an attempt at a step.
void count(const StepResult& step, double h, Report& report) {
  report.newton_iterations += step.iterations;
  report.tangent_refreshes += step.tangents;
  report.tangent_renewals += step.renewed;
  report.smallest_step = std::min(report.smallest_step, h);
  if (!step.converged) ++report.rejected_steps;
  if (step.converged && !step.accepted) ++report.refused_steps;
  if (!step.accepted) return;
  ++report.steps;
  report.penalty.augmentations += step.augmentations;
  report.penalty.most_augmentations =
      std::max(report.penalty.most_augmentations, step.augmentations);
}

/// Does the run end after an accepted step? Then status and reason are set.
template <FrameGroup G>
bool ends(const Model<G>& model, const State<G>& s, const LargestBend<G>& bend,
          const Progress& progress, Report& report) {
  const auto end = [&report](SolveStatus status, std::string reason) {
    report.status = status;
    report.reason = std::move(reason);
    return true;
  };
  if (bend.whole() > kFold)
    return end(
        SolveStatus::NotConverged,
        fmt::format("an element of '{}' turns by pi at t = {:.6g} s, where its strain has no "
                    "unique value: use more elements",
                    model.bodies[bend.turned()]->name, s.t));
  for (size_t b = 0; b < model.bodies.size(); ++b)
    if (const auto of = model.bodies[b]->fault(s.H.data() + model.first_node(static_cast<int>(b))))
      return end(SolveStatus::NotConverged,
                 fmt::format("{} at t = {:.6g} s: {}, or a finer simulation.step", of->what, s.t,
                             of->remedy));
  if (auto why = contradiction(model, s, s.t); !why.empty())
    return end(SolveStatus::Inconsistent, std::move(why));
  if (progress && !progress(s.t))
    return end(SolveStatus::Interrupted, fmt::format("stopped at t = {:.6g} s on request", s.t));
  return false;
}

template <FrameGroup G>
State<G> completed(const Model<G>& model, State<G> s) {
  model.complete(s);
  return s;
}

}  // namespace

template <FrameGroup G>
DynamicResult<G> simulate(const Model<G>& model, const SimulationOptions& options,
                          const Progress& progress, Tape<G>* tape, const Observer<G>& observe) {
  options.require_valid();
  const long whole_steps = std::lround(std::ceil(options.duration / options.step * (1 - 1e-12)));
  SimulationOptions o = options;
  o.step = options.duration / static_cast<double>(whole_steps);
  DynamicResult<G> result;
  Report& report = result.report;
  State<G> s = model.initial_state();
  if (!begin(model, o, s, result)) return result;
  result.trajectory.reserve(s, static_cast<int>(whole_steps / o.output_every) + 2);
  State<G> seen;  // completed
  const auto show = [&](bool recorded) {
    if (!recorded && !observe) return;
    seen = s;
    model.complete(seen);
    if (recorded) result.trajectory.record(seen);
    if (observe) observe(seen, recorded);
  };
  show(true);

  GeneralizedAlpha<G> integrator(model, o);
  integrator.start(s);
  TapeWriter<G> writer(tape, integrator, o, result.start, whole_steps, s);
  writer.checkpoint(s);
  const double error_limit = o.error_tolerance * model.length;
  StepControl control(o, error_limit);
  Ringing ringing;
  FastestTurn turn;
  LargestBend<G> bend(model);
  JointOpening<G> open(model);
  report.smallest_step = o.step;
  const bool penalised = model.penalty.form != ConstraintForm::Multipliers;
  Watch watch(!observe);
  watch.go();
  while (control.whole() < whole_steps) {
    const double h = control.h(), limit = control.error_limit();
    const StepResult step = integrator.step(s, h, limit);
    count(step, h, report);
    if (step.accepted) {
      if (o.adaptive && step.error > error_limit) ++report.inexact_steps;
      control.advance(step.error);
      s.t = control.time();
    }
    writer.add({h, s.t, limit, step.accepted}, s);
    if (!step.accepted) {
      if (control.retry(step)) continue;
      report.status = SolveStatus::NotConverged;
      report.reason = failure(step, s.t + h, h);
      break;
    }
    ringing.step(s.lambda, h);
    turn.step(model, s, h);
    bend.step(s);
    const Equations<G>& equations = integrator.equations();
    report.max_constraint_residual = std::max(report.max_constraint_residual, equations.opening());
    const long whole = control.whole();
    watch.stop(report);
    if (penalised) open.step(equations.gap, completed(model, s));
    show(whole > 0 && (whole % o.output_every == 0 || whole == whole_steps));
    watch.go();
    if (ends(model, s, bend, progress, report)) break;
  }
  watch.stop(report);
  report.factorizations = integrator.factorizations();
  add_warnings(report, o, options.step, integrator.tangent(), ringing);
  add_turn_warning(report, model, turn);
  add_bend_warning(report, model, bend);
  if (penalised) report_penalty(model, open, report);
  return result;
}

template DynamicResult<SE2> simulate(const Model<SE2>&, const SimulationOptions&, const Progress&,
                                     Tape<SE2>*, const Observer<SE2>&);
template DynamicResult<SE3> simulate(const Model<SE3>&, const SimulationOptions&, const Progress&,
                                     Tape<SE3>*, const Observer<SE3>&);

}  // namespace liesl
