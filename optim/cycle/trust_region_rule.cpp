#include "optim/cycle/trust_region_rule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace liesl {
namespace {

constexpr double kTake = 0.1;   // share of the predicted decrease that a step must bring
constexpr double kGood = 0.75;  // share from which the radius may grow
constexpr double kShrink = 0.3, kGrow = 2;
constexpr double kSmallestRadius = 1e-6;
constexpr double kPenalty = 10;            // sigma at first; the objective counts 1
constexpr double kMargin = 2, kLeast = 1;  // penalty over the sum of the multipliers; at least
constexpr double kStronger = 5;            // penalty against the one before
constexpr double kClose = 0.1;             // of the allowed violation
constexpr double kMore = 0.5;  // share of a decrease of the violation that a penalty must not miss
constexpr double kCounts = 0.05;   // share of objective_tolerance that a decrease must have
constexpr double kSmall = 0.1;     // of the objective at the start: nearer to zero is the same
constexpr double kNothing = 1e-7;  // a decrease that round-off may bring
constexpr double kActive = 2e-3;   // limits that may carry a multiplier
constexpr double kSame = 1e-6;     // two answers of one surrogate

}  // namespace

TrustRegionRule::TrustRegionRule(const CycleOptions& options)
    : largest_(options.move_limit),
      radius_(largest_),
      penalty_(kPenalty),
      plain_(!options.from_optimum) {}

template <class Figures>
double TrustRegionRule::merit(const Figures& a) const {
  return a.objective / scale() + penalty_ * std::max(0.0, a.worst);
}

Step TrustRegionRule::resume(CycleRecord& record) {
  const History& history = record.history();
  const auto taken =
      std::find_if(history.rbegin(), history.rend(), [](const Cycle& c) { return c.taken; });
  const std::vector<Cycle> rejected(taken.base(), history.end());
  objective_0_ = history.front().objective;
  radius_ = taken->move;
  penalty_ = taken->penalty;
  warm_ = taken->warm;
  maxima_ = taken->maxima;
  before_ = {taken->before, {}};
  plain_ = plain_ && taken->number == history.front().number;
  x_ = taken->x;
  at_ = record.analyse(x_);
  if (!at_->good()) return retreat(record, *at_, x_);
  record.keep(at_, x_);
  return repeat(record, rejected);
}

Step TrustRegionRule::repeat(CycleRecord& record, const std::vector<Cycle>& rejected) {
  Step step = propose(record, nullptr);
  for (const Cycle& c : rejected) {
    if (step.end) break;
    if ((step.x - c.x).norm() > kSame * c.x.norm()) {  // other options, another machine
      radius_ = rejected.back().move;
      penalty_ = rejected.back().penalty;
      return propose(record, nullptr);
    }
    judge(merit(c));
    if (plain_)
      correct();
    else if (const auto again = record.analyse(c.x); again->good())
      learn(record, *again, c.x);
    step = propose(record, nullptr);
  }
  return step;
}

Step TrustRegionRule::next(CycleRecord& record, const CycleRecord::Analysis& analysis,
                           Cycle& cycle) {
  if (!at_) objective_0_ = analysis->objective;
  cycle.taken = !at_ || judge(merit(*analysis));
  cycle.penalty = penalty_;
  cycle.warm = warm_;
  cycle.move = radius_;
  if (cycle.taken) {
    if (at_) remember(record, *at_);
    plain_ = plain_ && !at_;
    cycle.maxima = maxima_;
    cycle.before = before_.x;
    x_ = cycle.x;
    at_ = analysis;
    surrogate_ = {};
    record.keep(at_, x_);
  } else if (plain_) {
    correct();
  } else {
    learn(record, *analysis, cycle.x);
  }
  return propose(record, &cycle);
}

void TrustRegionRule::remember(CycleRecord& record, const DesignAnalysis& left) {
  before_ = known(record, left, x_);
  auto maxima = maxima_of(before_.values);
  maxima_.resize(plain_ ? 0 : maxima.size());
  for (std::size_t r = 0; r < maxima_.size(); ++r) maxima_[r].merge(maxima[r]);
  if (on_bound()) before_ = {};
}

CorrectedProblem::KnownDesign TrustRegionRule::known(CycleRecord& record,
                                                     const DesignAnalysis& analysis,
                                                     const Eigen::VectorXd& x) const {
  return {x, record.model().response_values(analysis, surrogate_.problem->responses())};
}

void TrustRegionRule::learn(CycleRecord& record, const DesignAnalysis& rejected,
                            const Eigen::VectorXd& x) {
  surrogate_.problem->make_conservative(known(record, rejected, x));
}

Step TrustRegionRule::retreat(CycleRecord& record, const DesignAnalysis& failed,
                              const Eigen::VectorXd& x) {
  if (!surrogate_.problem)
    return {x, CycleEnd{CycleStatus::SimulationFailed,
                        "a design cannot be analysed: " + failed.reason}};
  record.warn("a design could not be analysed: " + failed.reason);
  judge({});
  if (plain_) correct();
  return propose(record, nullptr);
}

bool TrustRegionRule::judge(std::optional<double> trial) {
  const double ratio = trial ? (merit(*at_) - *trial) / predicted_ : -1;
  if (ratio < kTake)
    radius_ *= plain_ ? 1 : kShrink;
  else if (ratio > kGood && on_bound())
    radius_ = std::min(largest_, kGrow * radius_);
  return ratio >= kTake;
}

bool TrustRegionRule::on_bound() const {
  const auto& bounds = surrogate_.problem->variables();
  for (int i = 0; i < answer_.x.size(); ++i) {
    const NlpVariable& b = bounds[static_cast<std::size_t>(i)];
    const double slack = 1e-3 * (b.upper - b.lower);
    if (answer_.x[i] < b.lower + slack || answer_.x[i] > b.upper - slack) return true;
  }
  return false;
}

/// The answer of the surrogate at x_k, or the end.
Step TrustRegionRule::propose(CycleRecord& record, Cycle* cycle) {
  if (!surrogate_.problem) {
    make_surrogate(record);
    if (!surrogate_.problem)
      return {x_, CycleEnd{CycleStatus::SimulationFailed,
                           "there are no sensitivities: " + surrogate_.optimality.reason}};
  } else if (radius_ < kSmallestRadius) {
    return {x_, stalled(record)};
  }
  return trial_step(record, cycle);
}

void TrustRegionRule::make_surrogate(CycleRecord& record) {
  if (plain_) surrogate_ = record.model().uncorrected(*at_, x_, radius_);
  plain_ = surrogate_.problem != nullptr;
  if (!plain_) surrogate_ = record.model().surrogate(*at_, x_, radius_, kActive);
  built_ = radius_;
  if (!surrogate_.problem) return;
  if (!plain_) record.certify(surrogate_.optimality);  // of the best so far, however it ends
  take_history(record);
}

void TrustRegionRule::take_history(CycleRecord& record) {
  CorrectedProblem& problem = *surrogate_.problem;
  if (!maxima_.empty())
    problem.add_records(
        near_maxima(maxima_, record.model().response_values(*at_, problem.responses())));
  if (before_.x.size() == 0 || plain_) return;
  if (before_.values.empty()) {
    if (const auto analysis = record.analyse(before_.x); analysis->good())
      before_ = known(record, *analysis, before_.x);
  }
  problem.pass_through(before_);
}

void TrustRegionRule::correct() {
  plain_ = false;
  surrogate_ = {};
}

Step TrustRegionRule::trial_step(CycleRecord& record, Cycle* cycle) {
  for (;;) {
    surrogate_.problem->narrow(std::min(1.0, radius_ / built_));
    solve(record);
    if (cycle) {
      cycle->load_cases = surrogate_.problem->load_cases();
      cycle->iterations += answer_.iterations;
    }
    if (record.asked_to_stop()) return {x_, record.stopped()};
    if (!answer_.reason.empty()) return without_answer(record, cycle);
    predicted_ = merit(*at_) - answer_.merit;
    const auto limit = used_up(record.history(), record.options());
    if (plain_ && (limit || predicted_ <= record.options().objective_tolerance)) {
      correct();
      return propose(record, cycle);
    }
    // Rows that are conservative say how far to go, not that there is nothing to gain.
    if (predicted_ <= kNothing && !is_optimal(record) && surrogate_.problem->forget_rejected())
      continue;
    // The optimum of a problem that is not convex, and no better than here.
    if (predicted_ <= 0 && !surrogate_.optimality.holds() && radius_ > kSmallestRadius) {
      radius_ *= kShrink;
      continue;
    }
    if (auto end = settled(record, predicted_)) return {x_, std::move(end)};
    if (limit) return {x_, is_optimal(record) ? stalled(record) : *limit};
    return {answer_.x, {}};
  }
}

/// Of a surrogate that has no value where it starts: with gradients, then nearer, then none.
Step TrustRegionRule::without_answer(CycleRecord& record, Cycle* cycle) {
  if (plain_) {
    correct();
    return propose(record, cycle);
  }
  radius_ *= kShrink;
  if (radius_ < kSmallestRadius)
    return {x_, CycleEnd{CycleStatus::SimulationFailed,
                         "the problem of the cycle has no value: " + answer_.reason}};
  return trial_step(record, cycle);
}

/// The surrogate within its bounds, with a penalty that is large enough for it: a larger one brings
/// it hardly closer to the limits, by what it comes closer at all (R. H. Byrd, J. Nocedal,
/// R. A. Waltz 2008, "Steering exact penalty methods", Optim. Methods Softw. 23).
void TrustRegionRule::solve(CycleRecord& record) {
  const double allowed = record.options().feasibility;
  const auto at = [&](double penalty) {
    return solve_elastic(*surrogate_.problem, {1 / scale(), penalty}, record.options(), warm_,
                         record.hooks().keep_going);
  };
  answer_ = at(penalty_);
  if (!answer_.reason.empty()) return;
  if (answer_.violation <= kClose * allowed) {
    penalty_ = std::max(kLeast, kMargin * answer_.multipliers);
    return;
  }
  while (answer_.violation > kClose * allowed) {
    ElasticAnswer closer = at(kStronger * penalty_);
    if (!closer.reason.empty()) return;
    const double gained = answer_.violation - closer.violation, all = at_->worst - closer.violation;
    if (gained <= std::max(kMore * all, kNothing)) return;
    penalty_ *= kStronger;
    answer_ = std::move(closer);
  }
}

std::optional<CycleEnd> TrustRegionRule::settled(CycleRecord& record, double predicted) const {
  // The merit is of the objective at the start, the tolerance of that here, which may be small.
  const double share = std::clamp(std::abs(at_->objective) / scale(), kSmall, 1.0);
  const double counts = kCounts * share * record.options().objective_tolerance;
  if (predicted > (is_optimal(record) ? counts : kNothing)) return {};
  if (at_->worst > record.options().feasibility) return infeasible(record);
  return stalled(record);
}

/// Is the last design that was taken feasible and certified, whatever is left to gain?
bool TrustRegionRule::is_optimal(const CycleRecord& record) const {
  return at_->worst <= record.options().feasibility && surrogate_.optimality.holds();
}

std::string TrustRegionRule::place() const {
  return at_->worst_at.empty() ? "" : " at " + at_->worst_at;
}

CycleEnd TrustRegionRule::stalled(CycleRecord& record) const {
  const DynamicOptimality& kkt = surrogate_.optimality;
  record.certify(kkt);
  if (at_->worst > record.options().feasibility)
    return {CycleStatus::Infeasible,
            fmt::format("no step improves the design any more, and '{}' stays {:.3g} % above its "
                        "limit{}{}",
                        at_->worst_constraint, 100 * at_->worst, place(), certificate())};
  return {kkt.holds() ? CycleStatus::Optimal : CycleStatus::Converged,
          "KKT conditions: " + kkt.brief()};
}

/// What is known of the violation: "; the design is a stationary point of ...".
std::string TrustRegionRule::certificate() const {
  const auto& violation = surrogate_.optimality.violation;
  return violation ? "; the design is " + violation->brief() : "";
}

CycleEnd TrustRegionRule::infeasible(CycleRecord& record) const {
  DynamicOptimality none;
  none.reason = "limits are exceeded";
  none.violation = surrogate_.optimality.violation;
  record.certify(none);
  return {CycleStatus::Infeasible,
          fmt::format("no design near meets all limits: '{}' is exceeded by {:.3g} %{}, "
                      "and by at least {:.3g} % nearby; widen the bounds or the limit{}",
                      at_->worst_constraint, 100 * at_->worst, place(), 100 * answer_.violation,
                      certificate())};
}

}  // namespace liesl
