#include "optim/cycle/design_loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "mbs/linalg/stop_request.hpp"

namespace liesl {

using Eigen::VectorXd;

namespace {

/// The plain cycle ends on its last simulation, and an earlier design may be the best.
void say_which_design(const CycleOptions& options, const std::string& of, LoopResult& result) {
  const History& history = result.history;
  if (options.method != CycleMethod::Esl || !result.best || history.empty() ||
      history.back().x == result.x)
    return;
  const auto at = std::find_if(history.rbegin(), history.rend(),
                               [&](const Cycle& c) { return c.x == result.x; });
  if (at == history.rend()) return;
  result.reason +=
      fmt::format("; the design is that of cycle {}{}, the {}", at->number, of,
                  at->worst <= options.feasibility ? "best that meets all limits" : "least bad");
}

}  // namespace

Cycle& CycleRecord::add(const Analysis& analysis, const VectorXd& x) {
  Cycle c;
  c.number = history().empty() ? 1 : history().back().number + 1;
  c.x = x;
  c.mass = analysis->mass;
  c.objective = analysis->objective;
  static_cast<LimitExcesses&>(c) = *analysis;
  c.loads = analysis->loads;
  if (last_) c.load_change = model_.load_change(*analysis, *last_);
  c.unit = model_.unit(x);
  c.effort = model_.effort();
  if (!result_.first) result_.first = analysis->figures();
  last_ = analysis;
  result_.history.push_back(c);
  return result_.history.back();
}

CycleEnd CycleRecord::stopped() const {
  if (history().empty())
    return {CycleStatus::Interrupted, "stopped in the first analysis on request"};
  return {CycleStatus::Interrupted,
          fmt::format("stopped in cycle {}{} on request", history().back().number, hooks_.of)};
}

CycleEnd CycleRecord::lost(const NoSensitivities& why) {
  result_.lost = why.what();
  return {CycleStatus::SimulationFailed,
          fmt::format("there are no sensitivities any more after cycle {}{}: {}; bounds that leave "
                      "such designs out let the study go on",
                      history().back().number, hooks_.of, why.what())};
}

void CycleRecord::restore(const std::vector<Cycle>& resume) {
  for (const auto& cycle : resume)
    if (static_cast<std::size_t>(cycle.x.size()) != model_.variables().size())
      throw std::invalid_argument("resume: the interrupted run has other variables");
  result_.history = resume;
  const auto best =
      std::min_element(resume.begin(), resume.end(), [this](const Cycle& a, const Cycle& b) {
        return better(a.worst, a.objective, b.worst, b.objective);
      });
  const Analysis first = analyse(resume.front().x);
  result_.first = first->figures();
  keep_if_better(best == resume.begin() ? first : analyse(best->x), best->x);
}

bool CycleRecord::better(double worst, double objective, double than_worst,
                         double than_objective) const {
  const bool meets = worst <= options_.feasibility,
             other_meets = than_worst <= options_.feasibility;
  return meets != other_meets ? meets : meets ? objective < than_objective : worst < than_worst;
}

void CycleRecord::keep_if_better(const Analysis& a, const VectorXd& x) {
  if (!a->good()) return;
  const auto& best = result_.best;
  if (!best || better(a->worst, a->objective, best->worst, best->objective)) keep(a, x);
}

void CycleRecord::keep(const Analysis& analysis, const VectorXd& x) {
  result_.best = analysis;
  result_.x = x;
  result_.optimality.reset();
  last_ = analysis;
}

void CycleRecord::go_on() {
  const bool any = !history().empty();
  if (any) last_ = analyse(history().back().x);
  model_.take_over(any ? history().back().effort : SimulationEffort());
}

LoopResult CycleRecord::finish(const CycleEnd& end) {
  if (end.status == CycleStatus::Interrupted) stop_is_heard();
  result_.status = end.status;
  result_.reason = end.reason;
  if (!history().empty() && end.status != CycleStatus::Interrupted)
    result_.history.back().end = end.status;
  last_.reset();
  if (result_.best && !result_.optimality) evaluate_certificate();
  say_which_design(options_, hooks_.of, result_);
  return std::move(result_);
}

/// Only of a design the loop stands by.
void CycleRecord::evaluate_certificate() {
  const CycleStatus s = result_.status;
  if (options_.optimality == OptimalityCheck::Never || s == CycleStatus::Infeasible ||
      s == CycleStatus::SimulationFailed || s == CycleStatus::Interrupted)
    return;
  try {
    result_.optimality = model_.optimality(*result_.best, result_.x, hooks_.progress);
  } catch (const Stopped&) {
    stop_is_heard();
    return warn("the dynamic optimality conditions were not checked: stopped on request");
  }
  const DynamicOptimality& o = *result_.optimality;
  if (!o.residual) warn("the dynamic optimality conditions were not checked: " + o.reason);
  if (!o.residual || options_.method != CycleMethod::Esl) return;
  const bool agree = s == CycleStatus::Converged;
  if (o.holds()) {
    if (!agree) return;
    result_.status = CycleStatus::Optimal;
    if (history().back().end == s) result_.history.back().end = CycleStatus::Optimal;
    result_.reason =
        "the optimality conditions of the motion hold (" + o.brief() + "); " + result_.reason;
    return;
  }
  if (agree)
    result_.reason =
        "loads and design agree, but the dynamic optimality conditions do not hold: " + o.brief() +
        "; " + result_.reason;
  warn(
      "not optimal for the motion itself: the cycle does not see how the loads follow the design, "
      "and a lighter one may be near" +
      (agree ? "" : " (" + o.brief() + ")") + "; cycle.method = \"esl1\" does");
}

namespace {

/// Where an interrupted run goes on.
Step resumed(CycleRecord& record, StepRule& rule, const std::vector<Cycle>& cycles) {
  record.restore(cycles);
  Step step;
  try {
    step = rule.resume(record);
  } catch (const NoSensitivities& why) {
    step.end = record.lost(why);
  }
  record.go_on();
  return step;
}

}  // namespace

LoopResult run_loop(DesignModel& model, StepRule& rule, const CycleOptions& options,
                    const CycleHooks& hooks, const std::vector<Cycle>& resume) {
  using Clock = std::chrono::steady_clock;
  CycleRecord record(model, options, hooks);
  Step step{model.start(), {}};
  if (!resume.empty()) step = resumed(record, rule, resume);
  while (!step.end) {
    const auto start = Clock::now();
    Cycle* cycle = nullptr;
    try {
      const CycleRecord::Analysis analysis = record.analyse(step.x);
      if (analysis->status == SolveStatus::Interrupted) {
        step.end = CycleEnd{CycleStatus::Interrupted, analysis->reason};
        break;
      }
      if (!analysis->good()) {
        step = rule.retreat(record, *analysis, step.x);
        continue;
      }
      cycle = &record.add(analysis, step.x);
      step = rule.next(record, analysis, *cycle);
    } catch (const Stopped&) {
      step.end = record.stopped();
    } catch (const NoSensitivities& why) {
      if (record.history().size() <= (cycle ? 1 : 0)) throw;  // nobody was told of a cycle yet
      step.end = record.lost(why);
    }
    if (!cycle) break;
    cycle->seconds = std::chrono::duration<double>(Clock::now() - start).count();
    cycle->end.reset();
    if (step.end && step.end->status != CycleStatus::Interrupted) cycle->end = step.end->status;
    if (hooks.on_cycle) hooks.on_cycle(record.history());
    if (record.asked_to_stop() && !step.end) step.end = record.stopped();
  }
  return record.finish(*step.end);
}

}  // namespace liesl
