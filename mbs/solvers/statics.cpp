#include "mbs/solvers/statics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "mbs/linalg/inertia.hpp"
#include "mbs/solvers/divergence.hpp"
#include "mbs/solvers/free_motion.hpp"
#include "mbs/solvers/static_newton.hpp"
#include "mbs/system/constraint_rank.hpp"

namespace liesl {
namespace {

constexpr int kDeepest = 10;  // halvings of a load step
constexpr int kMaxArcSteps = 500;
constexpr int kWantedIterations = 5;  // arc length: steps grow below, shrink above
constexpr double kLargestArc = 4;     // of the first step
constexpr double kLocated = 1e-5;     // of a critical load, relative
constexpr int kMaxBisections = 40;
constexpr int kMostCriticalPoints = 20;  // of one step
constexpr double kSkew = 1e-7;           // of the tangent, on the motions that the joints leave
constexpr double kSmallestPart = 1e-3;   // of a step, when the load hardly changes over it
constexpr double kSide = 0.1;            // part of a step to either side of a possible extremum
constexpr double kSuspicious = 1e-9;     // reciprocal condition that asks for a look at the tangent
constexpr double kPoseTurn = 0.1;        // rad, or of the mechanism's length: a drive's way at once
constexpr int kPoseSamples = 256;        // of the drives between 0 and simulation.at
constexpr int kMaxPoses = 4096;

/// Negative eigenvalues of tangents on the motions that the joints leave. Where loads make them
/// unsymmetric (those that follow the motion; spread ones, whose shares of the nodes have no
/// potential) there is no such count that means anything: 1
/// if the determinant is negative, which changes where a further equilibrium branches off.
class NegativeCount {
 public:
  /// @param A tangent with constraints  @param n unknowns without multipliers  @returns -1:
  /// singular
  int operator()(const Eigen::SparseMatrix<double>& A, int n) {
    follows_ = follows_ || skew_on_null_space(A, n) > kSkew;
    if (follows_) return negative_determinant(A, n).value_or(-1);
    return negative_on_null_space(A, n).value_or(-1);
  }
  /// Has a tangent been unsymmetric?
  bool follows() const { return follows_; }

 private:
  bool follows_ = false;
};

/// Load factors done/of of the largest, of = load_steps 2^depth: steps are halved where they fail
/// and doubled where they converge in few iterations. A single load at which the tangent is
/// singular is not reached by halving: where the smallest step does not converge, the step beyond
/// it is tried.
class LoadSteps {
 public:
  explicit LoadSteps(const SimulationOptions& o) : largest_(o.max_load), of_(o.load_steps) {}

  bool ended() const { return done_ == of_; }
  double size() const { return largest_ / static_cast<double>(of_); }
  double target() const {
    const long to = done_ + ahead_;
    return to == of_ ? largest_ : largest_ * static_cast<double>(to) / static_cast<double>(of_);
  }
  void advance(int iterations) {
    done_ += std::exchange(ahead_, 1);
    if (depth_ == 0 || done_ % 2 != 0 || iterations > kWantedIterations) return;
    --depth_;
    done_ /= 2;
    of_ /= 2;
  }
  bool goes_beyond() const { return ahead_ == 2; }
  /// Another target. @returns false if there is none left
  bool retry(bool beyond) {
    if (depth_ < kDeepest) {
      ++depth_;
      done_ *= 2;
      of_ *= 2;
      return true;
    }
    if (!beyond || goes_beyond() || done_ + 2 > of_) return false;
    ahead_ = 2;
    return true;
  }

 private:
  double largest_;
  int depth_ = 0;
  long done_ = 0, of_, ahead_ = 1;
};

template <FrameGroup G>
class LoadPath {
 public:
  LoadPath(const Model<G>& model, const SimulationOptions& options, State<G>& s,
           StaticResult<G>& result, const LoadProgress& progress)
      : model_(model),
        o_(options),
        s_(s),
        result_(result),
        progress_(progress),
        newton_(model, options),
        direction_(Eigen::VectorXd::Zero(model.size())) {}

  void run() {
    result_.trajectory.record(s_);
    if (!regular_at_start()) return;
    if (o_.arc_length)
      follow_arc();
    else
      grow_load();
    tell_critical();
  }

 private:
  /// Does anything move freely, without load and under the first load step too (a pendulum hangs)?
  bool regular_at_start() {
    result_.negative.push_back(negative(s_));
    if (!suspicious()) return true;
    const Eigen::MatrixXd motions = free_motions(model_, newton_.system().matrix());
    unknown_at_start_ = motions.cols() > 0;
    if (!unknown_at_start_) return true;
    State<G> loaded = s_;
    loaded.t = o_.max_load / o_.load_steps;
    const auto& A = newton_.tangent(loaded);
    if (!suspicious() || free_motions(model_, A).cols() == 0) return true;
    stop(SolveStatus::Singular, describe_free_motion(model_, s_, motions));
    return false;
  }

  /// Is the tangent last assembled singular, or near to?
  bool suspicious() {
    return !newton_.system().factor() || newton_.system().lu().reciprocal_condition() < kSuspicious;
  }

  void grow_load() {
    LoadSteps steps(o_);
    std::string stuck;
    while (!steps.ended()) {
      const double target = steps.target();
      const State<G> before = s_;
      const NewtonResult step = newton_.solve(s_, target);
      if (take(step)) {
        if (!accept(before, target - before.t)) return;
        steps.advance(step.iterations);
        continue;
      }
      if (!steps.goes_beyond())
        stuck = fmt::format(
            "{} between the load factors {:.6g} (reached) and {:.6g}, with the smallest load step "
            "{:.3g} {}; simulation.arc_length = true goes past a maximum of the load",
            step.failure, s_.t, target, steps.size(), relative_residual(step.residuals.back()));
      if (!steps.retry(!step.misshapen)) return stop(SolveStatus::NotConverged, stuck);
      result_.report.smallest_step = std::min(result_.report.smallest_step, steps.size());
    }
  }

  void follow_arc() {
    const double speed = newton_.speed(s_);
    const double first = speed * o_.max_load / o_.load_steps;
    if (!(first > 0))
      return stop(SolveStatus::Singular,
                  "the load moves nothing at the start: arc length has no direction");
    double ds = first;
    for (int n = 0; n < kMaxArcSteps; ++n) {
      const State<G> before = s_;
      const Eigen::VectorXd direction = direction_;
      const NewtonResult step = newton_.follow(s_, ds, direction);
      if (!take(step)) {
        if (ds < first / (1 << kDeepest))
          return stop(
              SolveStatus::NotConverged,
              fmt::format("{} after the load factor {:.6g} with the smallest arc length {:.3g}",
                          step.failure, before.t, ds));
        ds /= 2;
        --n;
        continue;
      }
      if (s_.t >= o_.max_load) {  // land on the end
        const NewtonResult last = newton_.solve(s_, o_.max_load);
        if (!last.converged) s_ = before, last_load_step(before);
        accept(before, ds);
        return;
      }
      direction_ = newton_.last_direction();
      if (!accept(before, ds, &direction)) return;
      if (s_.t <= -o_.max_load)
        return stop(SolveStatus::Converged,
                    fmt::format("the path went back to the load factor {:.6g}", s_.t));
      ds *=
          std::clamp(std::sqrt(kWantedIterations / static_cast<double>(step.iterations)), 0.5, 1.5);
      ds = std::min(ds, kLargestArc * first);
    }
    stop(SolveStatus::NotConverged,
         fmt::format("{} steps of arc length ended at the load factor {:.6g}, before {:.6g}",
                     kMaxArcSteps, s_.t, o_.max_load));
  }

  /// From the last state below the end to the end, if Newton's method does not get there from
  /// above.
  void last_load_step(const State<G>& before) {
    const NewtonResult step = newton_.solve(s_, o_.max_load);
    if (!step.converged)
      stop(SolveStatus::NotConverged, fmt::format("{} between the load factors {:.6g} and {:.6g}",
                                                  step.failure, before.t, o_.max_load));
  }

  /// Books an attempt; @returns whether it converged.
  bool take(const NewtonResult& step) {
    Report& report = result_.report;
    report.newton_iterations += step.iterations;
    if (!step.converged) {
      ++report.rejected_steps;
      return false;
    }
    ++report.steps;
    result_.iterations.push_back(step.iterations);
    result_.residuals = step.residuals;
    report.max_constraint_residual =
        std::max(report.max_constraint_residual, newton_.equations().constraint_residual());
    return true;
  }

  /// Counts, locates what happened since `before` (a step of size `step`), records.
  /// @returns false if the path ends here.
  bool accept(const State<G>& before, double step, const Eigen::VectorXd* direction = nullptr) {
    const int now = negative(s_);
    if (unknown_at_start_) result_.negative.back() = now;
    unknown_at_start_ = false;
    const int then = result_.negative.back();
    if (now != then && (o_.critical || o_.arc_length)) locate(before, step, direction, then, now);
    result_.trajectory.record(s_);
    result_.negative.push_back(now);
    if (const auto why = contradiction(model_, s_, o_.at); !why.empty()) {
      stop(SolveStatus::Inconsistent, why);
      return false;
    }
    if (progress_ && !progress_(s_.t)) {
      stop(SolveStatus::Interrupted,
           fmt::format("stopped at the load factor {:.6g} on request", s_.t));
      return false;
    }
    return true;
  }

  int negative(const State<G>& s) { return count_(newton_.tangent(s), model_.size()); }

  /// All the places of the step from `before` where the count changes, one after another.
  void locate(const State<G>& before, double step, const Eigen::VectorXd* direction, int then,
              int now) {
    double from = 0, load = before.t;
    for (int count = then, found = 0; count != now && found < kMostCriticalPoints; ++found)
      count = locate_next(before, step, direction, count, now, from, load);
  }

  /// Bisects the step between `low` (at `load_low`) and its end, where the count is `now`, for the
  /// place where it is no longer `then`; both move there. @returns the count behind it
  int locate_next(const State<G>& before, double step, const Eigen::VectorXd* direction, int then,
                  int now, double& low, double& load_low) {
    double high = 1, load_high = s_.t;
    for (int i = 0; i < kMaxBisections; ++i) {
      const bool close = std::abs(load_high - load_low) <= kLocated * std::abs(load_high);
      if (close && high - low < kSmallestPart) break;
      const double middle = 0.5 * (low + high);
      State<G> s = before;
      const NewtonResult part = direction ? newton_.follow(s, middle * step, *direction)
                                          : newton_.solve(s, before.t + middle * step);
      result_.report.newton_iterations += part.iterations;
      if (!part.converged) break;
      const int count = negative(s);
      (count == then ? low : high) = middle;
      (count == then ? load_low : load_high) = s.t;
      if (count != then) now = count;
    }
    const double load = 0.5 * (load_low + load_high);
    const bool limit = direction && is_limit(before, step, *direction, 0.5 * (low + high), load);
    result_.critical.push_back({load, then, now, limit});
    low = high;
    load_low = load_high;
    return now;
  }

  /// Does the load factor have an extremum at the fraction `at` of a step? It is `load` there.
  bool is_limit(const State<G>& before, double step, const Eigen::VectorXd& direction, double at,
                double load) {
    double change[2];
    for (int side = 0; side < 2; ++side) {
      State<G> s = before;
      const double fraction = at + (side == 0 ? -1 : 1) * kSide;
      if (fraction > 0 && !newton_.follow(s, fraction * step, direction).converged) return false;
      change[side] = s.t - load;
    }
    return change[0] * change[1] > 0;
  }

  void tell_critical() {
    if (count_.follows())
      result_.report.warnings.push_back(
          "loads that follow the motion, or spread over bent beams, make the tangent unsymmetric: "
          "where equilibria branch off is found, flutter is not; a motion shows it");
    for (const auto& c : result_.critical)
      result_.report.warnings.push_back(fmt::format(
          "{} at the load factor {:.6g}: the tangent has {} negative {} before and {} after",
          c.limit_point ? "limit point" : "critical load", c.load, c.before,
          count_.follows() ? "determinants" : "eigenvalues", c.after));
    const int last = count_.follows() ? 0 : result_.negative.back();
    if (result_.critical.empty() && last > 0)
      result_.report.warnings.push_back(
          fmt::format("the equilibrium at the load factor {:.6g} is not stable: the tangent has {} "
                      "negative eigenvalues; simulation.critical = true finds where that began",
                      s_.t, last));
  }

  void stop(SolveStatus status, std::string reason) {
    result_.report.status = status;
    result_.report.reason = std::move(reason);
  }

  const Model<G>& model_;
  const SimulationOptions& o_;
  State<G>& s_;
  StaticResult<G>& result_;
  const LoadProgress& progress_;
  StaticNewton<G> newton_;
  Eigen::VectorXd direction_;      ///< of the path at s_, in local frames
  bool unknown_at_start_ = false;  ///< without load the tangent is singular: nothing to count
  NegativeCount count_;
};

}  // namespace

/// Way of the drives between two times, rad or the mechanism's length.
template <FrameGroup G>
double way_between(const Model<G>& model, double from, double to) {
  double way = 0;
  for (const auto& c : model.couplings)
    for (const auto& e : c.rows) {
      if (e.role != Role::Constraint) continue;
      const bool length =
          e.row.kind() == RowKind::Displacement || e.row.kind() == RowKind::Distance;
      way = std::max(way, std::abs(e.target(to) - e.target(from)) / (length ? model.length : 1));
    }
  return way;
}

template <FrameGroup G>
InitialState take_pose(const Model<G>& model, const SimulationOptions& options, State<G>& s) {
  double way = 0;
  for (int i = 0; i < kPoseSamples && options.at > 0; ++i)
    way += way_between(model, options.at * i / kPoseSamples, options.at * (i + 1) / kPoseSamples);
  const int poses = static_cast<int>(std::clamp(std::ceil(way / kPoseTurn), 0., 1. * kMaxPoses));
  InitialState out;
  for (int i = poses > 0 ? 0 : 1; i <= std::max(poses, 1) && out.status == SolveStatus::Converged;
       ++i) {
    s.t = poses == 0 || i == poses ? options.at : options.at * i / poses;
    const double moved = out.moved;
    out = assemble(model, options.step, s);
    out.moved += moved;
  }
  return out;
}

template <FrameGroup G>
StaticResult<G> solve_static(const Model<G>& model, const SimulationOptions& options,
                             const LoadProgress& progress) {
  options.require_valid();
  StaticResult<G> result;
  State<G> s = model.initial_state();
  s.v.setZero();
  result.start = take_pose(model, options, s);
  s.t = 0;  // the load factor from here on
  result.report.warnings = result.start.redundant;
  if (result.start.status != SolveStatus::Converged) {
    result.report.status = result.start.status;
    result.report.reason = result.start.reason;
    return result;
  }
  result.report.smallest_step = options.max_load / options.load_steps;
  const auto start = std::chrono::steady_clock::now();
  LoadPath<G>(model, options, s, result, progress).run();
  result.report.stepping_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

template InitialState take_pose(const Model<SE2>&, const SimulationOptions&, State<SE2>&);
template InitialState take_pose(const Model<SE3>&, const SimulationOptions&, State<SE3>&);
template StaticResult<SE2> solve_static(const Model<SE2>&, const SimulationOptions&,
                                        const LoadProgress&);
template StaticResult<SE3> solve_static(const Model<SE3>&, const SimulationOptions&,
                                        const LoadProgress&);

}  // namespace liesl
