#ifdef LIESL_OPTIM

/// @file
/// A meshed part under fixed loads.
#include <fmt/format.h>

#include "apps/tasks/optimize.hpp"
#include "optim/cycle/solid_task.hpp"
#include "optim/cycle/topology_cycle.hpp"

namespace liesl {

Quantity quantity(SolidResponse r) {
  switch (r) {
    case SolidResponse::Output:
      return {"displacement", "m"};
    case SolidResponse::Compliance:
      return {"compliance", "J"};
    case SolidResponse::Stress:
      return {"stress", "Pa"};
    case SolidResponse::Mass:
      return {"mass", "kg"};
    case SolidResponse::Frequency:
      return {"frequency", "Hz"};
  }
  return {"", ""};
}

namespace {

void describe_steps(output::OptimizeSummary& summary, SolidResponse goal,
                    const std::vector<ShapeStep>& history) {
  summary.history.clear();
  for (const auto& s : history) {
    const bool mass = goal == SolidResponse::Mass;
    summary.history.push_back({s.number,
                               s.check.mass,
                               s.check.worst,
                               std::nullopt,
                               s.load_cases,
                               s.iterations,
                               0,
                               s.seconds,
                               mass ? std::nullopt : std::optional(s.check.goal),
                               {s.x.data(), s.x.data() + s.x.size()}});
  }
  summary.mass_initial = history.front().check.mass;
  summary.mass_final = history.back().check.mass;
  summary.worst_constraint = history.back().check.worst;
}

void describe_limits(output::OptimizeSummary& summary, const SolidTask& task,
                     const ShapeResult& r) {
  const auto &first = r.history.front().check.limits, &last = r.history.back().check.limits;
  for (std::size_t i = 0; i < last.size(); ++i) {
    const bool wall = i >= task.limits.size();
    const Quantity q = wall ? Quantity{"wall", "-"} : quantity(task.limits[i].response);
    summary.constraints.push_back({last[i].name, q.name, q.unit, last[i].limit, first[i].value,
                                   last[i].value, 0, last[i].excess});
  }
}

void describe_result(output::OptimizeSummary& summary, const SolidTask& task,
                     const ShapeResult& r) {
  summary.status = to_string(r.status);
  summary.reason = r.reason;
  if (r.history.empty()) return;
  describe_steps(summary, task.goal, r.history);
  describe_limits(summary, task, r);
  summary.design = design_figures(task.design->variables(), task.design->units(), r.x);
  for (auto step = r.history.rbegin(); step != r.history.rend(); ++step)  // new holes come later
    for (Eigen::Index j = 0; j < std::min(step->x.size(), r.x.size()); ++j)
      summary.design[static_cast<std::size_t>(j)].initial = step->x[j];
  auto& more = summary.more;
  more["objective"] = {{"quantity", quantity(task.goal).name},
                       {"unit", quantity(task.goal).unit},
                       {"initial", r.history.front().check.goal},
                       {"final", r.history.back().check.goal}};
  more["kkt_residual"] = r.stationarity;
  more["load_cases"] = task.cases;
}

/// Since the last hole that was kept.
std::vector<Eigen::VectorXd> designs(const TopologyResult& r) {
  std::vector<Eigen::VectorXd> x;
  for (std::size_t i = r.round; i < r.shape.history.size(); ++i) x.push_back(r.shape.history[i].x);
  return x;
}

output::OptimizeSummary running(const output::OptimizeSummary& summary, SolidResponse goal,
                                const std::vector<ShapeStep>& history) {
  output::OptimizeSummary so_far = summary;
  describe_steps(so_far, goal, history);
  so_far.status = "running";
  so_far.reason = fmt::format("{} steps so far", history.size());
  return so_far;
}

}  // namespace

OptimizeOutcome optimize_part_task(const Study& study, const output::OptimizeSummary& summary,
                                   int nucleate, const OptimizeHooks& given) {
  const int body = study.spec.shapes.begin()->first;
  const SolidResponse goal = study.spec.goal;
  TopologyHooks hooks;
  hooks.keep_going = given.keep_going;
  hooks.on_step = [&](const std::vector<ShapeStep>& history) {
    if (given.on_step) given.on_step(running(summary, goal, history), history);
  };
  hooks.on_hole = given.on_hole;
  TopologyResult r = optimise_topology(study.spec, study.scene.mechanism, body, nucleate, hooks);
  const std::string& name = study.scene.mechanism.bodies[static_cast<std::size_t>(body)].name;
  OptimizeOutcome out;
  out.summary = summary;
  out.status = r.shape.status;
  out.holes = Holes{body_names(study.scene.mechanism),
                    r.holes,
                    r.proposal.nucleus,
                    body,
                    r.proposal.reason,
                    quantity(goal).unit};
  describe_result(out.summary, solid_task(study.spec, *r.part), r.shape);
  describe_holes(out.summary, *out.holes);
  if (r.shape.x.size() == 0) return out;
  PartFields fields{r.shape.fractions, r.shape.displacements, r.shape.von_mises, r.proposal.gain,
                    out.holes->unit + "/m^3"};
  std::vector<Eigen::VectorXd> history = designs(r);
  out.parts.push_back({name, std::move(r.part), std::move(history), std::move(fields), r.outline});
  return out;
}

DerivativeReport part_derivatives_task(const Study& study) {
  const auto& [body, spec] = *study.spec.shapes.begin();
  PartShape part(study.scene.mechanism, body, spec);
  const SolidTask task = solid_task(study.spec, part);
  StaticShape problem(task, part.design.start(), study.spec.cycle.move_cells,
                      study.spec.cycle.move_limit);
  if (!problem.obstacle().empty())
    throw std::runtime_error("the start design has no part: " + problem.obstacle());
  DerivativeCheckOptions options;
  options.every_variable = true;
  return check_derivatives(problem, part.design.start(), options);
}

}  // namespace liesl

#endif
