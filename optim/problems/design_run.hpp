#pragma once
/// @file
/// One design of a study, simulated: its motion, its loads and how it fares against the limits.

#include <memory>
#include <string>
#include <vector>

#include "esl/load_set.hpp"
#include "esl/solid_loads.hpp"
#include "mbs/solvers/simulation.hpp"
#include "optim/design/design.hpp"
#include "optim/problems/limit_excess.hpp"
#include "optim/study/study.hpp"

namespace liesl {

/// A limited response over the records: |value| of each.
struct LimitSeries {
  std::string name;
  double limit = 0;
  std::vector<double> values;
  double largest = 0, at_time = 0;
  double measure = 0;  ///< what is compared with the limit: the largest, or what its treatment says
  bool in_objective = false;  ///< no limit: part of the objective
};

/// The lowest of the frequencies that are limited.
struct FrequencyCheck {
  std::string name;
  double least = 0, value = 0;  ///< Hz; NaN where the run says why
  bool in_objective = false;    ///< no limit: part of the objective
};

/// A mass that is limited.
struct MassCheck {
  std::string name;
  double limit = 0, value = 0;  ///< kg
};

/// Everything after `simulation` is empty or zero unless the simulation converged.
template <FrameGroup G>
struct DesignRun : LimitExcesses {
  Mechanism mechanism;              ///< with the design
  std::shared_ptr<Model<G>> model;  ///< of `mechanism`
  double mass = 0;                  ///< of the bodies in the objective, kg
  double duration = 0;              ///< s, of this design
  double pose_time = 0;             ///< simulation.at of statics, s
  double effort = 0;                ///< of the objective: sum of the integrals of squared responses
  Simulation<G> simulation;
  Tape<G> tape;  ///< of a dynamic simulation, for its sensitivities; empty if not asked for
  std::vector<LoadSet> loads;               ///< one for each limited beam
  std::vector<SolidLoadSet> solid_loads;    ///< one for each meshed part whose outline changes
  std::vector<LimitSeries> limits;          ///< one for each constraint
  std::vector<FrequencyCheck> frequencies;  ///< one for each limit
  std::string undefined;                    ///< why a limited frequency has no value; else empty
  std::vector<MassCheck> masses;            ///< one for each limit
  bool statics = false;                     ///< equilibria, no motion

  bool good() const { return status() == SolveStatus::Converged; }
  SolveStatus status() const {
    return undefined.empty() ? simulation.report.status : SolveStatus::Inconsistent;
  }
  const std::string& reason() const {
    return undefined.empty() ? simulation.report.reason : undefined;
  }
  /// Are there equilibria, or a motion on tape, to be differentiated?
  bool differentiable() const { return statics || !tape.checkpoints.empty(); }
  std::vector<double> times() const;    ///< of the records, s
  std::string instant(double t) const;  ///< "t = 0.1 s", of equilibria "load factor 0.1"
};

/// Simulates designs of one study. The mechanism, space and study must outlive it.
template <FrameGroup G>
class DesignSimulator {
 public:
  /// @throws std::invalid_argument for a study that does not fit the mechanism
  DesignSimulator(const Mechanism& mechanism, const Space<G>& space,
                  const SimulationOptions& options, const StudySpec& study);

  const Design& design() const { return design_; }
  const Mechanism& mechanism() const { return mechanism_; }
  const SimulationOptions& options() const { return options_; }
  DesignRun<G> run(const Eigen::VectorXd& x, const Progress& progress = {}) const;

 private:
  void extract(DesignRun<G>& run) const;
  void measure(DesignRun<G>& run) const;
  void measure_frequencies(DesignRun<G>& run) const;
  void measure_masses(DesignRun<G>& run) const;
  void measure_walls(DesignRun<G>& run, const Eigen::VectorXd& x) const;

  const Mechanism& mechanism_;
  const Space<G>& space_;
  const SimulationOptions options_;
  const StudySpec& study_;
  const Design design_;
  const std::vector<int> bodies_;  ///< whose loads are wanted
};

/// Relative change of the loads, that of the part where it is largest (thesis eq. 3.25). @pre both
/// converged, at the same times
template <FrameGroup G>
double load_change(const DesignRun<G>& run, const DesignRun<G>& before);

extern template double load_change(const DesignRun<SE2>&, const DesignRun<SE2>&);
extern template double load_change(const DesignRun<SE3>&, const DesignRun<SE3>&);
extern template struct DesignRun<SE2>;
extern template struct DesignRun<SE3>;
extern template class DesignSimulator<SE2>;
extern template class DesignSimulator<SE3>;

}  // namespace liesl
