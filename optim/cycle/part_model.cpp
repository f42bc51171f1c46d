#include "optim/cycle/part_model.hpp"

#include "mbs/linalg/stop_request.hpp"
#include "optim/cycle/trust_region_rule.hpp"
#include "optim/problems/mesh_statics.hpp"

namespace liesl {

using Eigen::VectorXd;

VectorXd PartModel::unit(const VectorXd& x) const {
  VectorXd unit(x.size());
  for (int j = 0; j < x.size(); ++j) unit[j] = range_of(variables()[static_cast<std::size_t>(j)]);
  return unit;
}

std::shared_ptr<DesignAnalysis> PartModel::analyse(const VectorXd& x, const Progress&) {
  auto out = std::make_shared<PartAnalysis>();
  EslProblem problem(std::make_unique<MeshStatics>(task_), task_.cycle, x);
  auto check = problem.check(x);
  if (!check) {
    out->status = SolveStatus::Inconsistent;
    out->reason = problem.undefined_reason();
    return out;
  }
  out->check = std::move(*check);
  out->objective = out->check.objective;
  out->mass = out->check.mass;
  for (const LimitCheck& l : out->check.limits)
    if (!(l.weight > 0)) out->add({l.name, l.excess, l.at});
  return out;
}

SolidTask PartModel::scaled(const DesignAnalysis& at) const {
  SolidTask task = task_;
  const StaticCheck& check = dynamic_cast<const PartAnalysis&>(at).check;
  for (std::size_t i = 0; i < task.limits.size(); ++i) {
    SolidLimit& term = task.limits[i];
    if (!(term.weight > 0)) continue;
    term.limit = check.limits[i].value;
    if (!(term.limit > 0))
      throw NoSensitivities("'" + term.name + "' of the objective is 0 in all load cases");
  }
  return task;
}

std::unique_ptr<StaticProblem> PartModel::static_problem(const DesignAnalysis& at,
                                                         const VectorXd& x, double move) const {
  const double cells = task_.cycle.move_cells * move / task_.cycle.move_limit;
  return std::make_unique<EslProblem>(std::make_unique<MeshStatics>(scaled(at), cells, move),
                                      task_.cycle, x);
}

Surrogate PartModel::surrogate(const DesignAnalysis& at, const VectorXd& x, double move,
                               double active) const {
  Surrogate out;
  auto statics = static_problem(at, x, move);
  out.optimality = check_optimality({}, variables(), x, {}, *statics, active);
  if (at.worst > task_.cycle.feasibility)
    out.optimality.violation = check_violation({}, variables(), x, {}, *statics, at.worst, active);
  out.problem =
      std::make_unique<CorrectedProblem>(std::move(statics), MotionGradients(), x, at.objective);
  return out;
}

DynamicOptimality PartModel::optimality(const DesignAnalysis& at, const VectorXd& x,
                                        const Progress&) const {
  return surrogate(at, x, task_.cycle.move_limit, kNearActive).optimality;
}

PartResult optimise_part(const SolidTask& task, const CycleHooks& hooks,
                         const std::vector<Cycle>& resume) {
  PartModel model(task);
  TrustRegionRule rule(task.cycle);
  PartResult out;
  static_cast<LoopResult&>(out) = run_loop(model, rule, task.cycle, hooks, resume);
  if (!out.best) return out;
  out.initial = dynamic_cast<const PartAnalysis&>(*out.first).check;
  out.final = dynamic_cast<const PartAnalysis&>(*out.best).check;
  const Unstopped written;
  MeshStatics part(task);
  part.show_all(out.x);
  out.fractions = part.statics().fractions();
  out.displacements = part.statics().u();
  out.von_mises = von_mises(part.statics(), task.stress.relaxation);
  return out;
}

}  // namespace liesl
