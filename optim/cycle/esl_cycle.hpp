#pragma once
/// @file
/// The cycle of simulation and static sizing (Choi & Park 2002; thesis section 3.4.3):
/// simulate, extract loads, stop if they agree with those of the cycle before, size, again.

#include <functional>
#include <optional>

#include "optim/cycle/cycle_rules.hpp"
#include "optim/cycle/design_run.hpp"
#include "optim/cycle/dynamic_optimality.hpp"
#include "optim/cycle/nucleation.hpp"

namespace liesl {

/// Where a new hole would pay in a meshed part under the loads of its final motion.
struct PartProposal {
  int body = 0;
  HoleProposal hole;
};

template <FrameGroup G>
struct CycleResult {
  CycleStatus status = CycleStatus::SimulationFailed;
  std::string reason;
  std::vector<Cycle> history;
  Eigen::VectorXd x;  ///< final design: the lightest that meets the limits, else the least bad
  double mass_initial = 0, mass = 0;
  double worst = 0;                   ///< of the final design, over every step of its simulation
  std::optional<double> load_change;  ///< of the last cycle; none if it has nothing to compare with
  std::vector<double> times;
  std::vector<LimitSeries> initial, final;
  std::vector<double> times_initial;
  Mechanism mechanism;                             ///< final
  std::shared_ptr<Model<G>> model;                 ///< final
  Simulation<G> simulation;                        ///< final
  std::vector<std::pair<int, Identity>> identity;  ///< by body, final
  long steps = 0, newton_iterations = 0;           ///< of all simulations
  double stepping_s = 0;
  std::vector<int> factorizations;  ///< by body, all simulations
  std::vector<std::string> warnings;
  /// Of the final design; none if it was not asked for or the cycle found no design to ask it of.
  std::optional<DynamicOptimality> optimality;
  /// Of a converged cycle, one for each meshed part in the objective whose outline changes.
  std::vector<PartProposal> proposals;
};

struct CycleHooks {
  std::function<void(const std::vector<Cycle>&)> on_cycle;  ///< after each cycle
  Progress progress;                                        ///< during simulations
  std::function<bool()> keep_going;  ///< asked by the optimiser; false = Interrupted
};

/// Runs the cycle. `resume`: the cycles of an interrupted run with the same study; goes on with
/// their last answer. @throws std::invalid_argument for a study that does not fit the mechanism
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
