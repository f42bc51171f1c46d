#pragma once
/// @file
/// The task of `liesl optimize`: from a study to its final design with figures, records and parts.
/// No files, no printing.

#include "apps/output/csv_writer.hpp"
#include "apps/output/results.hpp"
#include "apps/output/summary.hpp"
#include "apps/scene/space.hpp"
#include "apps/study/study.hpp"
#include "apps/tasks/cycle_loads.hpp"
#include "apps/tasks/holes.hpp"
#include "apps/tasks/part_fields.hpp"
#include "optim/cycle/topology_cycle.hpp"
#include "optim/nlp/check_derivatives.hpp"

namespace liesl {

/// Limited responses over a motion.
struct LimitRecords {
  std::string scenario;  ///< empty: the only one
  std::vector<double> times;
  std::vector<output::ResponseResult> responses;
};

struct OptimizeOutcome {
  CycleStatus status = CycleStatus::Converged;
  output::OptimizeSummary summary;
  bool simulated = false;                    ///< there is a final motion: records and limits of it
  output::Results results;                   ///< of the final motion; the load cases of a part
  std::vector<LimitRecords> initial, final;  ///< of the first and the final motions, by scenario
  std::vector<output::DesignRow> design;     ///< of beam sections
  Mechanism mechanism;                       ///< at the final design, of a motion
  std::vector<PartOutcome> parts;
  std::vector<LoadsOfCycle> loads;  ///< of a motion, in the order of the cycles
  std::optional<Holes> holes;       ///< of studies of outlines
};

/// Called while a task runs. The summary of an unfinished task has the status "running".
struct OptimizeHooks {
  Progress progress;
  std::function<bool()> keep_going;
  /// After each cycle, with those of all rounds.
  std::function<void(const output::OptimizeSummary&, const RoundHistory&)> on_cycle;
  std::function<void(const std::string& feature, const Nucleus&)> on_hole;
  std::function<void(const std::string& branch)> on_box;  ///< of a search in catalogues
};

/// Optimises under the loads of the motion, or under fixed ones if the study has them.
/// @param summary what is known before  @param nucleate new holes at most
/// @param resume rounds of an interrupted run of the same study
/// @throws std::invalid_argument for designs that do not fit the mechanism
OptimizeOutcome optimize_task(const Study& study, const ChosenSpace& space,
                              const output::OptimizeSummary& summary, int nucleate,
                              const OptimizeHooks& hooks, const RoundHistory& resume = {});

/// An optimum that functions of one's own have led to, not a cycle.
struct FoundOptimum {
  CycleStatus status = CycleStatus::Converged;
  std::string reason;
  Eigen::VectorXd x;           ///< final design
  std::vector<Cycle> history;  ///< not empty; number, x, mass, objective, worst, worst_constraint,
                               ///< excesses, seconds
  std::vector<output::ConstraintFigure> limits;  ///< of one's own, beside those of the study
};

/// What optimize_task leaves of such a design, from a simulation of the start and of the design.
/// The limits of the study are responses, too. @pre the study has a motion
OptimizeOutcome found_task(const Study& study, const ChosenSpace& space,
                           const output::OptimizeSummary& summary, const FoundOptimum& found,
                           const Progress& progress = {});

/// Gradients of the first static problem against finite differences.
DerivativeReport derivatives_task(const Study& study, const ChosenSpace& space);
/// Those of the limits of equilibria. @pre simulation.type is Static, without fixed loads
DerivativeReport equilibrium_derivatives_task(const Study& study, const ChosenSpace& space);

/// Name and unit of a quantity of a meshed part.
struct Quantity {
  const char *name, *unit;
};
Quantity quantity(SolidResponse response);

// Under fixed loads; see above.
OptimizeOutcome optimize_part_task(const Study& study, const output::OptimizeSummary& summary,
                                   int nucleate, const OptimizeHooks& hooks,
                                   const RoundHistory& resume);
DerivativeReport part_derivatives_task(const Study& study);

/// Fills in the cycles so far, numbered through.
void describe_cycles(output::OptimizeSummary& summary, const RoundHistory& rounds,
                     SolidResponse objective);
/// Fills in what a search in catalogues has proven; nothing if there was none.
void describe_catalogue(output::OptimizeSummary& summary,
                        const std::optional<CatalogueReport>& report);
/// Fills in the residual of the KKT conditions and what the limits cost.
void describe_optimality(output::OptimizeSummary& summary,
                         const std::optional<DynamicOptimality>& optimality);
/// The hooks of rounds: a summary "running" after each cycle.
TopologyHooks round_hooks(const output::OptimizeSummary& summary, const OptimizeHooks& hooks,
                          SolidResponse objective);
/// The figures of new holes.
template <class End>
Holes holes_of(const Topology<End>& rounds, const Mechanism& mechanism, const std::string& unit) {
  Holes holes{body_names(mechanism), rounds.holes, {}, 0, rounds.reason, unit};
  if (!rounds.next) return holes;
  holes.next = rounds.next->hole.nucleus;
  holes.body = rounds.next->body;
  return holes;
}

/// The variables of a design, from the start to x (empty: none).
std::vector<output::DesignFigure> design_figures(const std::vector<NlpVariable>& variables,
                                                 const std::vector<std::string>& units,
                                                 const Eigen::VectorXd& x);

}  // namespace liesl
