#pragma once
/// @file
/// What a loop asks of a study, whether its loads follow from motions or stay: how a design fares,
/// and problems that approximate the study near one.

#include <memory>
#include <string>
#include <vector>

#include "mbs/solvers/report.hpp"
#include "optim/cycle/dynamic_optimality.hpp"
#include "optim/problems/corrected_problem.hpp"
#include "optim/problems/cycle_loads.hpp"
#include "optim/problems/limit_excess.hpp"
#include "optim/problems/simulation_effort.hpp"

namespace liesl {

/// How a design fares. Numbers have a meaning only if it is good.
struct DesignAnalysis : LimitExcesses {
  virtual ~DesignAnalysis() = default;

  SolveStatus status = SolveStatus::Converged;
  std::string reason;             ///< why it is not good
  double objective = 0;           ///< unit of the study's objective
  double mass = 0;                ///< kg
  std::vector<CycleLoads> loads;  ///< of a motion, the few that tell most

  /// The same without what only the next designs need: motions.
  virtual std::shared_ptr<DesignAnalysis> figures() const = 0;
  bool good() const { return status == SolveStatus::Converged; }
};

/// The study near a design: a problem that agrees with it there to first order.
struct Surrogate {
  std::unique_ptr<CorrectedProblem> problem;  ///< null: there are no gradients
  DynamicOptimality optimality;               ///< of the study at that design, or why there is none
};

class DesignModel {
 public:
  virtual ~DesignModel() = default;
  DesignModel() = default;
  DesignModel(const DesignModel&) = delete;
  DesignModel& operator=(const DesignModel&) = delete;

  virtual const std::vector<NlpVariable>& variables() const = 0;
  /// What a change of each variable is measured by; empty: all by the size of x.
  virtual Eigen::VectorXd unit(const Eigen::VectorXd& x) const = 0;
  Eigen::VectorXd start() const {
    Eigen::VectorXd x(static_cast<Eigen::Index>(variables().size()));
    for (Eigen::Index i = 0; i < x.size(); ++i)
      x[i] = variables()[static_cast<std::size_t>(i)].start;
    return x;
  }

  /// @param progress of simulations
  virtual std::shared_ptr<DesignAnalysis> analyse(const Eigen::VectorXd& x,
                                                  const Progress& progress) = 0;
  /// The study under the loads of an analysed design x, which stay as they are, within move limits.
  virtual std::unique_ptr<StaticProblem> static_problem(const DesignAnalysis& at,
                                                        const Eigen::VectorXd& x,
                                                        double move) const = 0;
  /// That problem where it tells every limit and the objective, in the place of a surrogate whose
  /// gradients are not worth their time yet: without optimality conditions. Else no problem.
  /// @throws NoSensitivities if there will be none
  virtual Surrogate uncorrected(const DesignAnalysis&, const Eigen::VectorXd& /*x*/,
                                double /*move*/) const {
    return {};
  }
  /// @param active limits this near may carry a multiplier
  /// @throws NoSensitivities
  virtual Surrogate surrogate(const DesignAnalysis& at, const Eigen::VectorXd& x, double move,
                              double active) const = 0;
  /// |values| of responses over the records of an analysed design, as rows of a surrogate have
  /// them; empty where they are not known.
  virtual std::vector<Eigen::VectorXd> response_values(const DesignAnalysis&,
                                                       const std::vector<LimitedResponse>&) const {
    return {};
  }
  /// The optimality conditions at x where the loop has not evaluated them.
  virtual DynamicOptimality optimality(const DesignAnalysis& at, const Eigen::VectorXd& x,
                                       const Progress& progress) const = 0;
  /// Relative change of the loads between two designs; none if they cannot be compared, or stay.
  virtual std::optional<double> load_change(const DesignAnalysis& now,
                                            const DesignAnalysis& before) const = 0;

  const SimulationEffort& effort() const { return effort_; }
  /// A resumed loop has the effort of the interrupted one, not that of simulating again.
  void take_over(SimulationEffort effort) { effort_ = std::move(effort); }

 protected:
  mutable SimulationEffort effort_;  ///< surrogates count their gradients
};

/// The motion cannot be differentiated.
struct NoSensitivities : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// It can, but limits with `surrogate = "mechanism"` have no static problem: the mechanism moves
/// with its drives held.
struct NoStaticsOfMechanism : NoSensitivities {
  using NoSensitivities::NoSensitivities;
};

}  // namespace liesl
