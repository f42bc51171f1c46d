#pragma once
/// @file
/// Studies of motions, from the start to the final design.

#include "optim/cycle/motion_model.hpp"
#include "optim/cycle/nucleation.hpp"

namespace liesl {

/// `x` is the final design: the lightest that meets the limits, else the least bad. What belongs to
/// a motion is that of the first scenario.
template <FrameGroup G>
struct CycleResult : LoopResult {
  double mass_initial = 0, mass = 0;
  double worst = 0;                   ///< of the final design, over every step of all simulations
  std::optional<double> load_change;  ///< of the last cycle; none if it has nothing to compare with
  std::vector<MotionLimits> initial, final;        ///< by scenario
  Mechanism mechanism;                             ///< final
  std::shared_ptr<Model<G>> model;                 ///< final; null: no design could be simulated
  Simulation<G> simulation;                        ///< final
  std::vector<std::pair<int, Identity>> identity;  ///< by body, final
  SimulationEffort effort;
  /// Of a converged cycle of one motion, one for each meshed part in the objective whose outline
  /// changes.
  std::vector<PartProposal> proposals;
};

/// What was before earlier rounds: the start of the first one.
template <FrameGroup G>
void start_with(CycleResult<G>& result, const LoopResult& first) {
  if (!first.first) return;
  result.mass_initial = first.first->mass;
  result.initial = dynamic_cast<const MotionAnalysis<G>&>(*first.first).limits;
}

/// Runs the study by the method that study.cycle.method asks for (trust_region_rule.hpp,
/// fixed_point_rule.hpp). `resume`: the cycles of an interrupted run with the same study.
/// @param scenarios one or more with the same bodies; more need sensitivities
/// @throws std::invalid_argument for a study that does not fit the mechanism, or a motion that has
/// no sensitivities where they are asked for
template <FrameGroup G>
CycleResult<G> run_cycle(const std::vector<Scenario<G>>& scenarios, const StudySpec& study,
                         const CycleHooks& hooks = {}, const std::vector<Cycle>& resume = {});

/// Of one motion.
template <FrameGroup G>
CycleResult<G> run_cycle(const Mechanism& mechanism, const Space<G>& space,
                         const SimulationOptions& simulation, const StudySpec& study,
                         const CycleHooks& hooks = {}, const std::vector<Cycle>& resume = {}) {
  return run_cycle<G>({{mechanism, space, simulation}}, study, hooks, resume);
}

/// What run_cycle leaves, of a design x that something else has found (functions of one's own in
/// Python). Simulates the start and x; cycles of these two have their loads then.
/// @param found status, reason, x and history; SimulationFailed if the motion of x has no end
/// @throws std::invalid_argument for a study that does not fit the mechanism
template <FrameGroup G>
CycleResult<G> describe_found(const std::vector<Scenario<G>>& scenarios, StudySpec study,
                              LoopResult found, const Progress& progress = {});

extern template CycleResult<SE2> describe_found(const std::vector<Scenario<SE2>>&, StudySpec,
                                                LoopResult, const Progress&);
extern template CycleResult<SE3> describe_found(const std::vector<Scenario<SE3>>&, StudySpec,
                                                LoopResult, const Progress&);
extern template CycleResult<SE2> run_cycle(const std::vector<Scenario<SE2>>&, const StudySpec&,
                                           const CycleHooks&, const std::vector<Cycle>&);
extern template CycleResult<SE3> run_cycle(const std::vector<Scenario<SE3>>&, const StudySpec&,
                                           const CycleHooks&, const std::vector<Cycle>&);

}  // namespace liesl
