#ifdef LIESL_OPTIM

/// @file
/// A meshed part under fixed loads.
#include <fmt/format.h>

#include "apps/tasks/collect_mesh.hpp"
#include "apps/tasks/fixed_loads.hpp"
#include "apps/tasks/optimize.hpp"
#include "apps/tasks/outline_kinks.hpp"
#include "optim/cycle/catalogue.hpp"
#include "optim/problems/esl_problem.hpp"
#include "optim/problems/mesh_statics.hpp"
#include "optim/study/part_quantity.hpp"

namespace liesl {

Quantity quantity(SolidResponse r) { return {part_quantity(r).name, part_quantity(r).unit}; }

namespace {

void describe_limits(output::OptimizeSummary& summary, const SolidTask& task,
                     const StaticCheck& initial, const StaticCheck& final) {
  for (std::size_t i = 0; i < final.limits.size(); ++i) {
    const bool wall = i >= task.limits.size();
    if (!wall && task.limits[i].weight > 0) continue;
    const Quantity q = wall ? Quantity{"wall", "-"} : quantity(task.limits[i].response);
    const LimitCheck& last = final.limits[i];
    const double first = i < initial.limits.size() ? initial.limits[i].value : last.value;
    summary.constraints.push_back(
        {last.name, q.name, q.unit, last.limit, first, last.value, 0, last.excess});
  }
}

/// The parts of a weighted objective.
void describe_part_terms(output::OptimizeSummary& summary, const SolidTask& task,
                         const StaticCheck& initial, const StaticCheck& final) {
  auto& terms = summary.more["terms"] = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < task.limits.size(); ++i) {
    const SolidLimit& term = task.limits[i];
    if (!(term.weight > 0)) continue;
    const Quantity q = quantity(term.response);
    terms[term.name] = {{"quantity", q.name},
                        {"unit", q.unit},
                        {"weight", term.weight},
                        {"initial", initial.limits[i].value},
                        {"final", final.limits[i].value}};
  }
}

/// What is minimised.
Quantity objective_of(const SolidTask& task) {
  const bool mass_alone = task.objective != SolidResponse::Mass || task.mass_weight == 1;
  return task.weighted() || !mass_alone ? Quantity{"weighted sum", "-"} : quantity(task.objective);
}

/// Of a variable that a new hole brought with it, the start is where it was inserted.
void describe_design(output::OptimizeSummary& summary, const SolidTask& task,
                     const Topology<PartEnd>& rounds) {
  const PartEnd& end = rounds.last.end;
  summary.design = design_figures(task.design->variables(), task.design->units(), end.x);
  const Eigen::VectorXd& first = rounds.first.history.front().x;
  for (Eigen::Index j = 0; j < std::min(first.size(), end.x.size()); ++j)
    summary.design[static_cast<std::size_t>(j)].initial = first[j];
}

void describe_end(output::OptimizeSummary& summary, const Topology<PartEnd>& rounds) {
  const PartEnd& end = rounds.last.end;
  summary.status = to_string(end.status);
  summary.reason = end.reason;
  if (!end.best) return;
  const SolidTask task = solid_task(rounds.last.study, *end.part);
  const StaticCheck& initial = dynamic_cast<const PartAnalysis&>(*rounds.first.first).check;
  describe_cycles(summary, {rounds.before, end.history}, task.objective);
  summary.mass_initial = initial.mass;
  summary.mass_final = end.final.mass;
  summary.worst_constraint = end.final.worst;
  describe_limits(summary, task, initial, end.final);
  describe_design(summary, task, rounds);
  auto& more = summary.more;
  if (task.weighted()) describe_part_terms(summary, task, initial, end.final);
  more["objective"] = {{"quantity", objective_of(task).name},
                       {"unit", objective_of(task).unit},
                       {"initial", initial.objective},
                       {"final", end.final.objective}};
  describe_optimality(summary, end.optimality);
  more["load_cases"] = task.cases;
  summary.warnings.insert(summary.warnings.end(), end.warnings.begin(), end.warnings.end());
}

}  // namespace

OptimizeOutcome optimize_part_task(const Study& study, const output::OptimizeSummary& summary,
                                   int nucleate, const OptimizeHooks& hooks,
                                   const RoundHistory& resume) {
  const int body = study.spec.shapes.begin()->first;
  const SolidResponse objective = study.spec.objective;
  const OptimiseRound<PartEnd> optimise = [body](const StudySpec& spec, const Mechanism& mechanism,
                                                 const CycleHooks& cycle,
                                                 const std::vector<Cycle>& cycles) {
    return optimise_outline(spec, mechanism, body, cycle, cycles);
  };
  Topology<PartEnd> rounds =
      optimise_study<PartEnd>(study.spec, study.scene.mechanism, nucleate, optimise,
                              round_hooks(summary, hooks, objective), resume);
  PartEnd& end = rounds.last.end;
  OptimizeOutcome out;
  out.summary = summary;
  out.status = end.status;
  out.holes = holes_of(rounds, study.scene.mechanism, quantity(objective).unit);
  describe_end(out.summary, rounds);
  describe_catalogue(out.summary, rounds.catalogue);
  const PartShape start(study.scene.mechanism, body, study.spec.shapes.begin()->second);
  const std::string& name = study.scene.mechanism.bodies[static_cast<std::size_t>(body)].name;
  if (rounds.catalogue) {  // the bounds of the study, not those of the last box
    const PartShape whole(rounds.last.mechanism, body, rounds.last.study.shapes.at(body));
    for (std::size_t j = 0; j < out.summary.design.size(); ++j) {
      out.summary.design[j].lower = whole.design.variables()[j].lower;
      out.summary.design[j].upper = whole.design.variables()[j].upper;
    }
  }
  for (auto& text : start_warnings(name, start)) out.summary.warnings.push_back(std::move(text));
  describe_holes(out.summary, *out.holes);
  if (!end.best) return out;
  PartFields fields{end.fractions, end.displacements, end.von_mises, {}, out.holes->unit + "/m^3"};
  if (!end.proposals.empty()) fields.hole_gain = end.proposals.front().hole.gain;
  std::vector<Eigen::VectorXd> history;
  for (const Cycle& c : end.history) history.push_back(c.x);
  if (end.history.back().x != end.x) history.push_back(end.x);
  const BodySpec& final = end.mechanism.bodies[static_cast<std::size_t>(body)];
  describe_fixed_loads(out.summary, study.spec, body, final);
  if (end.displacements.cols() > 0)
    out.results = load_case_results(study.spec.name, final, end.displacements);
  out.parts.push_back({final.name, end.part, std::move(history), std::move(fields),
                       std::get<SolidSpec>(final.kind).outline});
  return out;
}

DerivativeReport part_derivatives_task(const Study& study) {
  const auto& [body, spec] = *study.spec.shapes.begin();
  PartShape part(study.scene.mechanism, body, spec);
  const SolidTask task = solid_task(study.spec, part);
  const CycleOptions& cycle = study.spec.cycle;
  EslProblem problem(std::make_unique<MeshStatics>(task, cycle.move_cells, cycle.move_limit), cycle,
                     part.design.start());
  if (!problem.undefined_reason().empty())
    throw std::runtime_error("the start design has no part: " + problem.undefined_reason());
  DerivativeCheckOptions options;
  options.every_variable = true;
  return check_derivatives(problem, part.design.start(), options);
}

}  // namespace liesl

#endif
