#pragma once
/// @file
/// The cycle of simulation and static sizing (Choi & Park 2002; thesis section 3.4.3):
/// simulate, extract loads, stop if they agree with those of the cycle before, size, again.

#include "optim/cycle/cycle_record.hpp"

namespace liesl {

/// Runs the cycle that study.cycle.method asks for: this one, or that of trust_region_cycle.hpp.
/// `resume`: the cycles of an interrupted run with the same study; continues from their last.
/// @throws std::invalid_argument for a study that does not fit the mechanism, or a motion that has
/// no sensitivities where they are asked for
template <FrameGroup G>
CycleResult<G> run_cycle(const Mechanism& mechanism, const Space<G>& space,
                         const SimulationOptions& simulation, const StudySpec& study,
                         const CycleHooks& hooks = {}, const std::vector<Cycle>& resume = {});

extern template CycleResult<SE2> run_cycle(const Mechanism&, const Space<SE2>&,
                                           const SimulationOptions&, const StudySpec&,
                                           const CycleHooks&, const std::vector<Cycle>&);
extern template CycleResult<SE3> run_cycle(const Mechanism&, const Space<SE3>&,
                                           const SimulationOptions&, const StudySpec&,
                                           const CycleHooks&, const std::vector<Cycle>&);

}  // namespace liesl
