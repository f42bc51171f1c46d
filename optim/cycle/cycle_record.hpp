#pragma once
/// @file
/// What every cycle of simulation and sizing keeps: its history, its best design, its effort, and
/// what it says of the design at the end.

#include <functional>
#include <optional>

#include "optim/cycle/cycle_rules.hpp"
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

/// Study, simulator and hooks must outlive it.
template <FrameGroup G>
class CycleRecord {
 public:
  using Run = std::shared_ptr<DesignRun<G>>;

  CycleRecord(const DesignSimulator<G>& simulator, const StudySpec& study, const CycleHooks& hooks,
              int bodies);

  /// Simulates and counts the effort.
  Run simulate(const Eigen::VectorXd& x);
  /// One more cycle. @param before whose loads those of `run` are compared with; null: none
  Cycle& add(const Run& run, const Eigen::VectorXd& x, const Run& before, double move);
  /// Continues an interrupted run: its cycles, its first simulation and its best. @returns its last
  Run restore(const std::vector<Cycle>& resume);

  /// Whether a design is better than another: the lightest that meets the limits, else the least
  /// violation.
  bool better(double worst, double mass, double than_worst, double than_mass) const;
  void keep_if_better(const Run& run, const Eigen::VectorXd& x);
  void keep(const Run& run, const Eigen::VectorXd& x);

  /// The certificate of the best design, where the cycle has it; else `finish` finds it.
  void certify(DynamicOptimality optimality) { result_.optimality = std::move(optimality); }

  bool end(const std::optional<CycleEnd>& end);
  bool asked_to_stop() const { return hooks_.keep_going && !hooks_.keep_going(); }
  CycleResult<G>& result() { return result_; }
  const History& history() const { return result_.history; }

  /// The certificate of the best design, holes where they would pay, and everything else that is
  /// said of it.
  CycleResult<G> finish();

 private:
  void keep_initial(const DesignRun<G>& run);
  void evaluate_certificate();
  void say(const DynamicOptimality& optimality);
  void propose_holes();
  void describe();

  const DesignSimulator<G>& simulator_;
  const StudySpec& study_;
  const CycleHooks& hooks_;
  Run best_;  ///< null: none yet
  Eigen::VectorXd best_x_;
  CycleResult<G> result_;
};

/// The conditions at a design, by sensitivities or, where the motion has none, by differences if
/// `differences` allows them.
template <FrameGroup G>
DynamicOptimality certificate(const DesignSimulator<G>& simulator, const StudySpec& study,
                              const DesignRun<G>& run, const Eigen::VectorXd& x, bool differences,
                              const Progress& progress);

extern template class CycleRecord<SE2>;
extern template class CycleRecord<SE3>;

}  // namespace liesl
