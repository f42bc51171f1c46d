#pragma once
/// @file
/// Optimisation in rounds: optimise, insert a hole where the topological derivative says that one
/// reduces the objective, optimise again. Experimental.

#include "mbs/model/mechanism.hpp"
#include "optim/cycle/motion_cycle.hpp"
#include "optim/cycle/part_model.hpp"
#include "optim/design/part_shape.hpp"

namespace liesl {

/// A hole that was tried.
struct HoleRound {
  int body = 0;
  std::string feature;  ///< "new_hole1"
  Nucleus nucleus;
  double before = 0, after = 0;  ///< objective
  int cycles = 0;
  bool kept = false;  ///< all limits are met and the objective fell by more than
                      ///< `cycle.objective_tolerance`
  std::string reason;
};

/// How a search among sizes of catalogues ended (catalogue.hpp).
struct CatalogueReport {
  bool found = false;                    ///< a design of the catalogues that meets the limits
  double continuous = 0;                 ///< objective of the continuous optimum
  double bound = 0;                      ///< no design of the catalogues has a lower objective
  double gap = 0;                        ///< of the objective found above the bound, relative
  double above_continuous = 0;           ///< the same above the continuous optimum
  int designs = 0, boxes = 0;            ///< simulated; searched
  int infeasible = 0, undecided = 0;     ///< boxes
  std::optional<double> kkt_residual{};  ///< of the continuous optimum
  SimulationEffort effort{};             ///< of all boxes
};

/// Where a round begins, and its termination status.
template <class End>
struct Round {
  StudySpec study;      ///< starts where the round begins
  Mechanism mechanism;  ///< there
  End end;
};

/// The cycles of each round so far, those of a hole that was not kept among them.
using RoundHistory = std::vector<std::vector<Cycle>>;

struct TopologyHooks : CycleHooks {
  /// Instead of `on_cycle`.
  std::function<void(const RoundHistory&)> on_round_cycle;
  std::function<void(const std::string& feature, const Nucleus&)> on_hole;
  /// A box of a search in catalogues begins.
  std::function<void(const std::string& branch)> on_box;
};

template <class End>
struct Topology {
  Round<End> last;                   ///< the last round that was kept
  std::vector<Cycle> before;         ///< of the kept rounds before it
  LoopResult first;                  ///< how the first round began: its history and `first`
  std::vector<HoleRound> holes;      ///< all that were tried
  std::optional<PartProposal> next;  ///< the hole that would reduce the objective most
  std::string reason;                ///< why there is none
  std::optional<CatalogueReport> catalogue = {};  ///< of a study whose sizes are of catalogues
  RoundHistory rounds = {};  ///< of all rounds, those of a hole that was not kept among them
};

/// How many variables a study has.
std::size_t variable_count(const StudySpec& study);

/// The hole with the largest gain of all proposals; the reason if there is none.
std::optional<PartProposal> best_proposal(const LoopResult& end,
                                          const std::vector<PartProposal>& proposals,
                                          std::string& reason);

/// May these cycles be of the study? What follows the rounds with holes has other variables.
bool is_of(const std::vector<Cycle>& history, const StudySpec& study);

/// Inserts a hole into study and mechanism, whose variables then start where `end` ended.
/// @param designed the mechanism with the final design
HoleRound insert_into(const LoopResult& end, const PartProposal& proposal,
                      const Mechanism& designed, StudySpec& study, Mechanism& mechanism);

/// Judges the round of a hole: kept?
bool judge_round(const LoopResult& end, double objective_tolerance, HoleRound& hole);

/// One round. @throws std::invalid_argument for bounds that do not fit a hole that has moved
template <class End>
using OptimiseRound = std::function<End(const StudySpec&, const Mechanism&, const CycleHooks&,
                                        const std::vector<Cycle>& resume)>;

/// @param most holes to insert; 0: only propose. A hole that does not reduce the objective is taken
/// out again and ends the rounds; so do an interruption and an optimum without a proposal.
/// @param resume rounds of an interrupted run of the same study
/// End: a LoopResult with `mechanism`, final, and `proposals`
template <class End>
Topology<End> optimise_in_rounds(const StudySpec& study, const Mechanism& mechanism, int most,
                                 const OptimiseRound<End>& optimise, const TopologyHooks& hooks,
                                 const RoundHistory& resume = {}) {
  Topology<End> out{{study, mechanism, {}}, {}, {}, {}, {}, {}};
  RoundHistory& rounds = out.rounds;
  const auto run = [&](Round<End>& round) {
    const std::size_t n = rounds.size();
    rounds.emplace_back();
    CycleHooks cycle = hooks;
    if (n > 0) cycle.of = " of round " + std::to_string(n + 1);
    cycle.on_cycle = [&](const std::vector<Cycle>& history) {
      rounds.back() = history;
      if (hooks.on_round_cycle) hooks.on_round_cycle(rounds);
    };
    const bool known = n < resume.size() && is_of(resume[n], round.study);
    round.end =
        optimise(round.study, round.mechanism, cycle, known ? resume[n] : std::vector<Cycle>());
    rounds.back() = round.end.history;
  };
  run(out.last);
  out.first.history = out.last.end.history;
  out.first.first = out.last.end.first;
  out.next = best_proposal(out.last.end, out.last.end.proposals, out.reason);
  while (static_cast<int>(out.holes.size()) < most && out.next) {
    Round<End> next{out.last.study, out.last.mechanism, {}};
    HoleRound hole =
        insert_into(out.last.end, *out.next, out.last.end.mechanism, next.study, next.mechanism);
    if (hooks.on_hole) hooks.on_hole(hole.feature, hole.nucleus);
    try {
      run(next);
    } catch (const std::invalid_argument& error) {  // bounds that were right before the hole moved
      next.end.reason = error.what();
    }
    const bool kept = judge_round(next.end, study.cycle.objective_tolerance, hole);
    out.holes.push_back(hole);
    if (!kept) {
      out.next.reset();
      out.reason = "'" + hole.feature + "', the last one tried, does not reduce the objective";
      if (next.end.status == CycleStatus::Interrupted) {
        out.last.end.status = next.end.status;
        out.reason = next.end.reason;
        out.last.end.reason =
            next.end.reason + "; this is the design before '" + hole.feature + "'";
      }
      break;
    }
    const auto& history = out.last.end.history;
    out.before.insert(out.before.end(), history.begin(), history.end());
    out.last = std::move(next);
    out.next = best_proposal(out.last.end, out.last.end.proposals, out.reason);
  }
  return out;
}

/// A part under fixed loads, its shape and its final place.
struct PartEnd : PartResult {
  Mechanism mechanism;              ///< final
  std::shared_ptr<PartShape> part;  ///< what was optimised
  std::vector<PartProposal> proposals;
};

/// Optimises the outline of `body` under the loads of the study.
/// @throws std::invalid_argument as PartShape and solid_task do
PartEnd optimise_outline(const StudySpec& study, const Mechanism& mechanism, int body,
                         const CycleHooks& hooks = {}, const std::vector<Cycle>& resume = {});

}  // namespace liesl
