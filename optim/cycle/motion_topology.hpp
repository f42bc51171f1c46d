#pragma once
/// @file
/// ESL cycles in rounds: cycle, insert a hole where the topological derivative under the loads of
/// the final motion says that one pays, cycle again. Experimental.

#include "optim/cycle/motion_cycle.hpp"
#include "optim/cycle/topology_cycle.hpp"

namespace liesl {

template <FrameGroup G>
struct MotionTopology {
  StudySpec study;                   ///< with the holes that pay
  Mechanism mechanism;               ///< where the last round that pays began
  CycleResult<G> cycle;              ///< of that round; what is `initial` is of the first
  std::vector<HoleRound> holes;      ///< all that were tried
  std::optional<PartProposal> next;  ///< the hole that would pay most; none: see the cycle's
};

/// @param most holes to insert; 0: only propose. A hole that does not pay is taken out again and
/// ends the rounds; so do an interruption and a cycle without a proposal.
/// @param on_hole before the cycle with a new hole
/// Errors and the other parameters are those of `run_cycle`.
template <FrameGroup G>
MotionTopology<G> optimise_motion_topology(
    const Mechanism& mechanism, const Space<G>& space, const SimulationOptions& simulation,
    const StudySpec& study, int most, const CycleHooks& hooks = {},
    const std::function<void(const std::string& feature, const Nucleus&)>& on_hole = {},
    const std::vector<Cycle>& resume = {});

extern template MotionTopology<SE2> optimise_motion_topology(
    const Mechanism&, const Space<SE2>&, const SimulationOptions&, const StudySpec&, int,
    const CycleHooks&, const std::function<void(const std::string&, const Nucleus&)>&,
    const std::vector<Cycle>&);
extern template MotionTopology<SE3> optimise_motion_topology(
    const Mechanism&, const Space<SE3>&, const SimulationOptions&, const StudySpec&, int,
    const CycleHooks&, const std::function<void(const std::string&, const Nucleus&)>&,
    const std::vector<Cycle>&);

}  // namespace liesl
