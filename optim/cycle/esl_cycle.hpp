#pragma once
/// @file
/// The cycle of simulation and static sizing (Choi & Park 2002; thesis section 3.4.3):
/// simulate, extract loads, stop if they agree with those of the cycle before, size, again.

#include <functional>
#include <optional>

#include "optim/cycle/design_run.hpp"
#include "optim/cycle/dynamic_optimality.hpp"

namespace liesl {

enum class CycleStatus {
  Converged,         ///< loads, mass and limits agree with the design
  CycleLimit,        ///< as many cycles as allowed
  Oscillating,       ///< the designs go to and fro; the best one is returned
  Infeasible,        ///< a limit cannot be met within the bounds; the reason says which
  SimulationFailed,  ///< no simulation of a design succeeded
  Interrupted        ///< the caller asked to stop
};
const char* to_string(CycleStatus status);

/// One cycle: the design that was simulated and what followed.
struct Cycle {
  int number = 0;
  Eigen::VectorXd x;  ///< simulated design, m
  double mass = 0;    ///< kg
  double worst = 0;   ///< largest |r|/limit - 1 over all steps and limits
  std::string worst_constraint;
  double worst_time = 0;              ///< s
  std::optional<double> load_change;  ///< against the cycle before
  int load_cases = 0;                 ///< retained by the screening
  int iterations = 0;                 ///< of the optimiser
  double move = 0;                    ///< move limit of the answer
  double seconds = 0;
  Eigen::VectorXd answer;  ///< optimum of the static problem; empty in the last cycle
  Eigen::VectorXd next;    ///< what is simulated next: the answer, accelerated
};

template <FrameGroup G>
struct CycleResult {
  CycleStatus status = CycleStatus::SimulationFailed;
  std::string reason;
  std::vector<Cycle> history;
  Eigen::VectorXd x;  ///< final design: the lightest that meets the limits, else the least bad
  double mass_initial = 0, mass = 0;
  double worst = 0;        ///< of the final design, over every step of its simulation
  double load_change = 0;  ///< of the last cycle
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
