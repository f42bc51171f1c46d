#pragma once
/// @file
/// Studies whose sizes are of catalogues: the continuous optimum, with new holes if these are asked
/// for, then branch and bound, each box an optimisation of the study itself, each design checked by
/// its motion.

#include <algorithm>

#include "optim/cycle/catalogue_tree.hpp"
#include "optim/cycle/restarts.hpp"
#include "optim/cycle/topology_cycle.hpp"

namespace liesl {

/// The variables of a study in the order of Design::variables(), with their catalogues.
std::vector<CatalogueVariable> catalogue_variables(const StudySpec& study,
                                                   const std::vector<NlpVariable>& variables);

/// All designs of a study.
DesignBox all_designs(const std::vector<NlpVariable>& variables);

/// The study within a box, from its start.
StudySpec within_box(StudySpec study, const DesignBox& box);

/// Allowed relative violation of a limit in a box: that of the study; where all variables are fixed
/// 1e-6 at most. The continuous optimum that bounds a design meets the limits, too, and a design
/// that exceeds them by more could be below it.
double allowed_in(const DesignBox& box, const CycleOptions& options);

/// The study with any sizes within the bounds, and with the catalogues of `of` for the variables
/// that it has in common with it: those before the variables of new holes.
StudySpec without_catalogues(StudySpec study);
StudySpec with_catalogues(StudySpec study, const StudySpec& of);

/// What the cycles of a round cost, those of each start.
SimulationEffort effort_of(const History& round);

/// Fills in what a search has found: numbers, status and a sentence.
/// @param continuous how the continuous study ended  @param stopped why it ended early; empty: it
/// did not
void conclude(const CatalogueTree& tree, const CycleOptions& options, const LoopResult& continuous,
              const CycleEnd& stopped, bool all_of_catalogues, CatalogueReport& report,
              LoopResult& end);

namespace detail {

/// Runs the rounds of a search, or takes them from an interrupted run.
template <class End>
class CatalogueRounds {
 public:
  CatalogueRounds(const StudySpec& study, const Mechanism& mechanism,
                  const OptimiseRound<End>& optimise, const TopologyHooks& hooks,
                  const RoundHistory& resume)
      : study_(study), mechanism_(mechanism), optimise_(optimise), hooks_(hooks), resume_(resume) {}

  const RoundHistory& histories() const { return rounds_; }
  /// The next round; its end only where it had to be optimised.
  std::optional<End> run(const DesignBox& box) {
    const std::size_t n = rounds_.size();
    if (n < resume_.size() && !is_of(resume_[n], box)) resume_.resize(n);
    const bool over = is_over(n, box);
    rounds_.push_back(n < resume_.size() ? resume_[n] : History());
    if (over) return {};
    resume_.resize(std::min(resume_.size(), n + 1));  // what follows depends on how this one ends
    if (hooks_.on_box && !box.branch.empty()) hooks_.on_box(box.branch);
    if (n == 0) return again(n, box);
    try {
      return again(n, box);
    } catch (const NoSensitivities&) {
      return {};  // of the first design of a later box, which stays undecided
    }
  }
  /// Round n with its model and motion, from the cycles that there are.
  End again(std::size_t n, const DesignBox& box) {
    CycleHooks cycle = hooks_;
    if (!box.branch.empty()) cycle.of = " of the box " + box.branch;
    cycle.on_cycle = [this, n](const std::vector<Cycle>& history) {
      rounds_[n] = history;
      if (!hooks_.on_round_cycle) return;
      RoundHistory all = rounds_;
      if (all.size() < resume_.size())
        all.insert(all.end(), resume_.begin() + static_cast<std::ptrdiff_t>(all.size()),
                   resume_.end());
      hooks_.on_round_cycle(all);
    };
    End end = optimise_(within_box(study_, box), mechanism_, cycle, rounds_[n]);
    rounds_[n] = end.history;  // with how it ended, which a resumed round knows here only
    return end;
  }

 private:
  /// With other tolerances than those of the interrupted run, other boxes may come.
  static bool is_of(const History& round, const DesignBox& box) {
    return round.empty() || round.front().x.isApprox(box.start, 1e-12);
  }
  /// Had round n of the interrupted run ended? One at its cycle limit goes on if that is higher
  /// now, an infeasible one if there is another start.
  bool is_over(std::size_t n, const DesignBox& box) const {
    if (n >= resume_.size()) return false;
    const History& round = resume_[n];
    if (round.empty() || !round.back().end) return n + 1 < resume_.size();
    const int start = round.back().start;
    if (*round.back().end == CycleStatus::CycleLimit)
      return std::count_if(round.begin(), round.end(), [start](const Cycle& c) {
               return c.start == start;
             }) >= study_.cycle.max;
    return *round.back().end != CycleStatus::Infeasible || !starts_again(start + 1, box);
  }
  bool starts_again(int number, const DesignBox& box) const {
    if (number > study_.cycle.restarts) return false;
    std::vector<NlpVariable> variables;
    for (Eigen::Index i = 0; i < box.start.size(); ++i)
      variables.push_back({"", box.lower[i], box.upper[i], box.start[i]});
    return restarted(within_box(study_, box), variables, number).has_value();
  }

  const StudySpec& study_;
  const Mechanism& mechanism_;
  const OptimiseRound<End>& optimise_;
  const TopologyHooks& hooks_;
  RoundHistory resume_;
  RoundHistory rounds_;
};

}  // namespace detail

/// Searches the designs of the catalogues of a study. The first round is the continuous study; if
/// it does not end by its own rules, it is the answer. `last` is the best design of the catalogues
/// (none: the continuous optimum, status Infeasible), `before` the cycles of all other rounds.
/// @param resume rounds of an interrupted run of the same study: those that had ended are taken as
/// they are
template <class End>
Topology<End> search_catalogue(const StudySpec& study, const Mechanism& mechanism,
                               const OptimiseRound<End>& optimise, const TopologyHooks& hooks,
                               const RoundHistory& resume = {}) {
  const std::vector<NlpVariable> variables = Design(study, mechanism).variables();
  const auto catalogues = catalogue_variables(study, variables);
  CatalogueTree tree(catalogues, all_designs(variables), study.cycle.gap);
  detail::CatalogueRounds<End> rounds(study, mechanism, optimise, hooks, resume);
  Topology<End> out{{study, mechanism, {}}, {}, {}, {}, {}, {}, CatalogueReport{}};
  const DesignBox whole = *tree.next();
  std::optional<End> root = rounds.run(whole);
  if (!root) root = rounds.again(0, whole);
  out.first.history = root->history;
  out.first.first = root->first;
  out.last.end = std::move(*root);
  out.reason = "holes are tried before the catalogues are searched: --nucleate N";
  if (!closed(out.last.end.status)) {
    out.last.end.reason =
        "the catalogues were not searched, since the continuous study comes first: " +
        out.last.end.reason;
    out.catalogue.reset();
    return out;
  }
  LoopResult continuous = out.last.end;
  out.catalogue->continuous = continuous.best->objective;
  tree.tell(box_answer(rounds.histories().front(), allowed_in(whole, study.cycle)));
  std::size_t best = 0;
  std::optional<std::pair<DesignBox, std::optional<End>>> found;
  CycleEnd stopped;
  int designs = static_cast<int>(rounds.histories().front().size());
  while (stopped.reason.empty()) {
    const std::optional<DesignBox> box = tree.next();
    if (!box) break;
    std::optional<End> end = rounds.run(*box);
    const History& history = rounds.histories().back();
    designs += static_cast<int>(history.size());
    if (end && end->status == CycleStatus::Interrupted)
      stopped = {end->status, end->reason};
    else if (tree.tell(box_answer(history, allowed_in(*box, study.cycle)))) {
      best = rounds.histories().size() - 1;
      found.emplace(*box, std::move(end));
    }
    if (stopped.reason.empty() && designs >= study.cycle.max_designs &&
        tree.gap() > study.cycle.gap)
      stopped = {CycleStatus::CycleLimit,
                 std::to_string(study.cycle.max_designs) + " designs are used up"};
  }
  if (found)
    out.last.end = found->second ? std::move(*found->second) : rounds.again(best, found->first);
  out.catalogue->boxes = static_cast<int>(rounds.histories().size());
  for (std::size_t r = 0; r < rounds.histories().size(); ++r) {
    const History& history = rounds.histories()[r];
    out.catalogue->effort += effort_of(history);
    if (r != best) out.before.insert(out.before.end(), history.begin(), history.end());
  }
  out.catalogue->designs = designs;
  const bool all = std::none_of(catalogues.begin(), catalogues.end(),
                                [](const CatalogueVariable& v) { return v.values.empty(); });
  conclude(tree, study.cycle, continuous, stopped, all, *out.catalogue, out.last.end);
  return out;
}

/// In rounds with `most` new holes, as if sizes were free, then by the catalogues of the study with
/// the holes that were kept.
template <class End>
Topology<End> search_with_holes(const StudySpec& study, const Mechanism& mechanism, int most,
                                const OptimiseRound<End>& optimise, const TopologyHooks& hooks,
                                const RoundHistory& resume) {
  Topology<End> holes =
      optimise_in_rounds<End>(without_catalogues(study), mechanism, most, optimise, hooks, resume);
  if (!closed(holes.last.end.status)) return holes;
  TopologyHooks search = hooks;
  if (hooks.on_round_cycle)
    search.on_round_cycle = [&](const RoundHistory& boxes) {
      RoundHistory all = holes.rounds;
      all.insert(all.end(), boxes.begin(), boxes.end());
      hooks.on_round_cycle(all);
    };
  const auto known = resume.begin() + std::min(std::ssize(resume), std::ssize(holes.rounds));
  const StudySpec found = with_catalogues(starting_at(holes.last.study, holes.last.end.x), study);
  Topology<End> out = search_catalogue<End>(found, holes.last.end.mechanism, optimise, search,
                                            RoundHistory(known, resume.end()));
  const History& kept = holes.last.end.history;
  holes.before.insert(holes.before.end(), kept.begin(), kept.end());
  out.before.insert(out.before.begin(), holes.before.begin(), holes.before.end());
  if (out.catalogue)
    for (const History& round : holes.rounds) out.catalogue->effort += effort_of(round);
  out.first = std::move(holes.first);
  out.holes = std::move(holes.holes);
  out.reason = std::move(holes.reason);
  return out;
}

/// By catalogues if the study has any, else in rounds with new holes, `most` of them; with both if
/// both are asked for.
template <class End>
Topology<End> optimise_study(const StudySpec& study, const Mechanism& mechanism, int most,
                             const OptimiseRound<End>& optimise, const TopologyHooks& hooks,
                             const RoundHistory& resume = {}) {
  if (has_catalogue(study) && most > 0)
    return search_with_holes<End>(study, mechanism, most, optimise, hooks, resume);
  if (has_catalogue(study)) return search_catalogue<End>(study, mechanism, optimise, hooks, resume);
  return optimise_in_rounds<End>(study, mechanism, most, optimise, hooks, resume);
}

}  // namespace liesl
