#pragma once
/// @file
/// Other starts of a study whose cycle ends infeasible: no step from there brings it nearer to its
/// limits, which is said of that design and not of all.

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

namespace detail {

/// The cycles of all starts so far, as one history.
class StartHistory {
 public:
  StartHistory(const CycleHooks& hooks, const std::vector<Cycle>& resume)
      : hooks_(hooks), resume_(resume) {}

  /// Hooks of a start; `on_cycle` sees the cycles of those before it, too.
  CycleHooks hooks(int start) const;
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

/// That it began again, and why.
std::string restart_note(int number, const std::string& why);
/// That a start could not be optimised, and why.
std::string failed_restart_note(int number, const std::string& why);
/// Whether the end of a restart replaces what there is, which meets not all limits.
bool replaces(const LoopResult& next, const LoopResult& best);
/// What the reason of an infeasible end says of other starts.
std::string on_restarts(int allowed, int tried);

}  // namespace detail

/// From the start of the study; if that ends Infeasible, from up to study.cycle.restarts others
/// until a design meets all limits. The answer is the design that does, else the one that exceeds
/// them least; its history has the cycles of all starts, `first` is the first design of all. A
/// resumed run goes through the starts that had ended again, with cycle.method "direct" by the same
/// simulations, else without those of their cycles.
/// @param variables gives those of the design; called only if there is a restart
/// @param optimise one start: End(const StudySpec&, const CycleHooks&, const std::vector<Cycle>&);
/// End is a LoopResult
template <class Optimise, class Variables>
auto optimise_from_starts(const StudySpec& study, const Variables& variables,
                          const CycleHooks& hooks, const std::vector<Cycle>& resume,
                          const Optimise& optimise) {
  detail::StartHistory history(hooks, resume);
  auto best = optimise(study, history.hooks(0), history.resume(0));
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
      next = optimise(*other, history.hooks(k), history.resume(k));
    } catch (const std::invalid_argument& error) {
      best.warnings.push_back(detail::failed_restart_note(k, error.what()));
      continue;
    }
    history.add(k, next.history);
    const std::string why = best.reason;
    const bool stopped = next.status == CycleStatus::Interrupted;
    const std::string reason = next.reason;
    if (detail::replaces(next, best)) {
      best = std::move(next);
      best.warnings.push_back(detail::restart_note(k, why));
    }
    if (stopped) {
      best.status = CycleStatus::Interrupted;
      best.reason = reason;
    }
    if (stopped || best.best->worst <= study.cycle.feasibility) break;
  }
  best.first = first;
  best.history = history.all();
  if (best.status == CycleStatus::Infeasible)
    best.reason += detail::on_restarts(study.cycle.restarts, tried);
  return best;
}

}  // namespace liesl
