#pragma once
/// @file
/// Other starts of a study whose cycle ends infeasible: no step from there brings it nearer to its
/// limits, which is said of that design and not of all. Other designs, or a slower motion whose
/// optimum is followed back to full speed.

#include <optional>
#include <stdexcept>

#include "optim/cycle/design_loop.hpp"

namespace liesl {

/// The study, starting at x, values of its variables in the order of Design::variables().
StudySpec starting_at(StudySpec study, const Eigen::VectorXd& x);

/// The study from restart `number`, 1 to kMostRestarts: every variable at lower + s (upper - lower)
/// with s = 0.9, 0.5, 0.1, 0.7, 0.3; values of drives and the duration stay where they start.
/// @param variables of the design. None: nothing that may move would start elsewhere.
std::optional<StudySpec> restarted(const StudySpec& study,
                                   const std::vector<NlpVariable>& variables, int number);

/// Share of the speed in stage 0 .. stages of a continuation: 0.9 + 0.1 stage/stages.
/// @pre stages > 0
double stage_speed(int stage, int stages);

namespace detail {

/// The cycles of all starts so far, as one history.
class StartHistory {
 public:
  StartHistory(const CycleHooks& hooks, const std::vector<Cycle>& resume)
      : hooks_(hooks), resume_(resume) {}

  /// Hooks of a start; `on_cycle` sees the cycles of those before it, too.
  /// @param of what reasons say of a cycle of this start
  CycleHooks hooks(int start, const std::string& of = "") const;
  /// What an interrupted run has of a start.
  std::vector<Cycle> resume(int start) const;
  /// A start has ended.
  void add(int start, std::vector<Cycle> cycles);
  const std::vector<Cycle>& all() const { return all_; }

 private:
  const CycleHooks& hooks_;
  const std::vector<Cycle>& resume_;
  std::vector<Cycle> all_;
};

/// What reasons say of a cycle of a restart, or of a stage of a continuation.
std::string restart_name(int number);
std::string stage_name(double speed);
/// That it began again, and why.
std::string restart_note(int number, const std::string& why);
/// That a start could not be optimised, and why.
std::string failed_restart_note(int number, const std::string& why);
/// That the optimum of a slower motion was followed to full speed, and why.
std::string continuation_note(int stages, const std::string& why);
/// That a stage at a share of the speed has no design, and why.
std::string failed_stage_note(double speed, const std::string& why);
/// Whether the end of a restart replaces what there is, which meets not all limits.
bool replaces(const LoopResult& next, const LoopResult& best);
/// What the reason of an infeasible end says of other starts. @param has_speed see
/// optimise_from_starts
std::string on_restarts(const CycleOptions& options, int tried, bool has_speed);

/// Takes the end of another start if it is better, with a note of why there was one. @returns
/// whether no further start is needed
template <class End>
bool take(End next, const std::string& note, double feasibility, End& best) {
  const bool stopped = next.status == CycleStatus::Interrupted;
  const std::string reason = next.reason;
  if (replaces(next, best)) {
    best = std::move(next);
    best.warnings.push_back(note);
  }
  if (stopped) {
    best.status = CycleStatus::Interrupted;
    best.reason = reason;
  }
  return stopped || (best.best && best.best->worst <= feasibility);
}

/// The stages of a continuation, each from the design of the one before, whether that met its
/// limits or not. Their numbers as starts follow those of the restarts.
template <class Optimise, class End>
void continue_in_speed(const StudySpec& study, StartHistory& history, const Optimise& optimise,
                       End& best) {
  const int stages = study.cycle.continuation;
  StudySpec from = study;
  for (int k = 0; k <= stages; ++k) {
    const int start = kMostRestarts + 1 + k;
    const double speed = stage_speed(k, stages);
    End next;
    try {
      next = optimise(from, history.hooks(start, stage_name(speed)), history.resume(start), speed);
    } catch (const std::invalid_argument& error) {
      best.warnings.push_back(failed_stage_note(speed, error.what()));
      return;
    }
    history.add(start, next.history);
    if (k == stages) {
      take(std::move(next), continuation_note(stages, best.reason), study.cycle.feasibility, best);
    } else if (next.status == CycleStatus::Interrupted) {  // a design of another motion
      best.status = next.status;
      best.reason = next.reason;
      return;
    } else if (next.x.size() == 0) {
      best.warnings.push_back(failed_stage_note(speed, next.reason));
      return;
    } else {
      from = starting_at(study, next.x);
    }
  }
}

}  // namespace detail

/// From the start of the study; if that ends Infeasible, from up to study.cycle.restarts others
/// until a design meets all limits, then by a continuation in the speed of the motion in
/// study.cycle.continuation stages. The answer is the design that does, else the one that exceeds
/// them least; its history has the cycles of all starts, `first` is the first design of all. A
/// resumed run goes through the starts that had ended again, with cycle.method "direct" by the same
/// simulations, else without those of their cycles.
/// @param variables gives those of the design; called only if there is a restart
/// @param optimise one start: End(const StudySpec&, const CycleHooks&, const std::vector<Cycle>&,
/// double speed); End is a LoopResult, speed the share of that of the motion
/// @param has_speed whether there is a motion with other speeds; else speed is always 1
template <class Optimise, class Variables>
auto optimise_from_starts(const StudySpec& study, const Variables& variables,
                          const CycleHooks& hooks, const std::vector<Cycle>& resume,
                          const Optimise& optimise, bool has_speed = false) {
  detail::StartHistory history(hooks, resume);
  auto best = optimise(study, history.hooks(0), history.resume(0), 1.0);
  history.add(0, best.history);
  if (best.status != CycleStatus::Infeasible) return best;
  const auto first = best.first;
  int tried = 0;
  for (int k = 1; k <= study.cycle.restarts; ++k) {
    const std::optional<StudySpec> other = restarted(study, variables(), k);
    if (!other) break;
    ++tried;
    decltype(best) next;
    try {
      next = optimise(*other, history.hooks(k, detail::restart_name(k)), history.resume(k), 1.0);
    } catch (const std::invalid_argument& error) {
      best.warnings.push_back(detail::failed_restart_note(k, error.what()));
      continue;
    }
    history.add(k, next.history);
    if (detail::take(std::move(next), detail::restart_note(k, best.reason), study.cycle.feasibility,
                     best))
      break;
  }
  if (has_speed && study.cycle.continuation > 0 && best.status == CycleStatus::Infeasible)
    detail::continue_in_speed(study, history, optimise, best);
  best.first = first;
  best.history = history.all();
  if (best.status == CycleStatus::Infeasible)
    best.reason += detail::on_restarts(study.cycle, tried, has_speed);
  return best;
}

}  // namespace liesl
