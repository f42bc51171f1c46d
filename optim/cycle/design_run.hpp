#pragma once
/// @file
/// One design of a study, simulated: its motion, its loads and how it fares against the limits.

#include <memory>
#include <string>
#include <vector>

#include "esl/load_set.hpp"
#include "esl/solid_loads.hpp"
#include "mbs/solvers/simulation.hpp"
#include "optim/design/part_shape.hpp"
#include "optim/design/sizing.hpp"
#include "optim/study/study.hpp"

namespace liesl {

/// A limited response over the records: |value| of each.
struct LimitSeries {
  std::string name;
  double limit = 0;
  std::vector<double> values;
  double largest = 0, at_time = 0;
};

/// Everything after `simulation` is empty or zero unless the simulation converged.
template <FrameGroup G>
struct DesignRun {
  Mechanism mechanism;              ///< with the design
  std::shared_ptr<Model<G>> model;  ///< of `mechanism`
  double mass = 0;                  ///< of the bodies in the objective, kg
  Simulation<G> simulation;
  std::vector<LoadSet> loads;             ///< one for each limited beam
  std::vector<SolidLoadSet> solid_loads;  ///< one for each limited meshed part
  std::vector<LimitSeries> limits;        ///< one for each constraint
  double worst = -1;                      ///< largest |r|/limit - 1 over all records and limits
  double worst_time = 0;                  ///< s
  std::string worst_constraint;

  bool good() const { return simulation.report.status == SolveStatus::Converged; }
  std::vector<double> times() const;  ///< of the records, s
};

/// Simulates designs of one study. The mechanism, space, options and study must outlive it.
template <FrameGroup G>
class DesignSimulator {
 public:
  /// @throws std::invalid_argument for a study that does not fit the mechanism
  DesignSimulator(const Mechanism& mechanism, const Space<G>& space,
                  const SimulationOptions& options, const StudySpec& study);

  const Sizing& sizing() const { return sizing_; }
  /// The part whose outline the study changes, null if it sizes beams.
  PartShape* part() const { return part_.get(); }
  const std::vector<NlpVariable>& variables() const {
    return part_ ? part_->design.variables() : sizing_.variables();
  }
  Eigen::VectorXd start() const;  ///< of the variables
  DesignRun<G> run(const Eigen::VectorXd& x, const Progress& progress = {}) const;

 private:
  void extract(DesignRun<G>& run) const;
  void measure(DesignRun<G>& run) const;
  void measure_walls(DesignRun<G>& run, const Eigen::VectorXd& x) const;

  const Mechanism& mechanism_;
  const Space<G>& space_;
  const SimulationOptions& options_;
  const StudySpec& study_;
  const Sizing sizing_;
  const std::unique_ptr<PartShape> part_;
  const std::vector<int> bodies_;  ///< that carry limits
};

extern template struct DesignRun<SE2>;
extern template struct DesignRun<SE3>;
extern template class DesignSimulator<SE2>;
extern template class DesignSimulator<SE3>;

}  // namespace liesl
