#ifdef LIESL_OPTIM

#include "apps/tasks/optimize.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/tasks/collect.hpp"
#include "apps/tasks/part_summary.hpp"
#include "apps/tasks/run_summary.hpp"
#include "mbs/system/response_value.hpp"
#include "optim/cycle/derivative_check.hpp"
#include "optim/cycle/motion_topology.hpp"

namespace liesl {
namespace {

void describe_cycles(output::OptimizeSummary& summary, const std::vector<Cycle>& history) {
  summary.history.clear();
  for (const auto& c : history)
    summary.history.push_back({c.number,
                               c.mass,
                               c.worst,
                               c.load_change,
                               c.load_cases,
                               c.iterations,
                               c.move,
                               c.seconds,
                               {},
                               {c.x.data(), c.x.data() + c.x.size()},
                               c.worst_constraint,
                               c.worst_time});
}

std::vector<output::ResponseResult> series(const std::vector<LimitSeries>& limits,
                                           const Mechanism& mechanism, const StudySpec& spec) {
  std::vector<output::ResponseResult> out;
  for (size_t i = 0; i < limits.size(); ++i)
    out.push_back(
        {limits[i].name, unit(spec.constraints[i].response, mechanism), 1, limits[i].values});
  return out;
}

std::vector<output::DesignRow> design_rows(const Sizing& sizing, const Mechanism& mechanism,
                                           const Eigen::VectorXd& x) {
  std::vector<output::DesignRow> rows;
  for (int i = 0; i < sizing.size(); ++i)
    for (const auto& at : sizing.elements(i)) {
      const auto& beam = std::get<BeamSpec>(mechanism.bodies[at.body].kind);
      double s = 0;
      for (int e = 0; e < at.element; ++e) s += element_length(beam, e);
      const auto& v = sizing.variables()[i];
      rows.push_back({v.name, mechanism.bodies[at.body].name, at.element, s,
                      s + element_length(beam, at.element), v.start, x[i], v.lower, v.upper, "m",
                      fmt::format("{}", fmt::join(sizing.dimensions(i), "+"))});
    }
  return rows;
}

template <FrameGroup G>
void describe_result(output::OptimizeSummary& summary, const Study& study, const Design& design,
                     const CycleResult<G>& r) {
  describe_cycles(summary, r.history);
  summary.status = to_string(r.status);
  summary.reason = r.reason;
  summary.steps = static_cast<int>(r.steps);
  summary.newton_iterations = r.newton_iterations;
  summary.stepping_s = r.stepping_s;
  summary.mass_initial = r.mass_initial;
  summary.mass_final = r.mass;
  summary.worst_constraint = r.worst;
  summary.load_change = r.load_change;
  const auto& bodies = study.scene.mechanism.bodies;
  for (size_t b = 0; b < r.factorizations.size(); ++b)
    summary.factorizations.emplace_back(bodies[b].name, r.factorizations[b]);
  summary.design = design_figures(design.variables(), design.units(), r.x);
  for (size_t i = 0; i < r.final.size(); ++i) {
    const auto& spec = study.spec.constraints[i].response;
    summary.constraints.push_back(
        {r.final[i].name, name_of(spec.kind), unit(spec, study.scene.mechanism), r.final[i].limit,
         i < r.initial.size() ? r.initial[i].largest : 0, r.final[i].largest, r.final[i].at_time,
         r.final[i].largest / r.final[i].limit - 1});
  }
  auto& identity = summary.more["identity"] = nlohmann::ordered_json::object();
  for (const auto& [body, id] : r.identity)
    identity[bodies[body].name] = {
        {"nonlinear", id.nonlinear}, {"linear", id.linear}, {"cases", id.cases}};
  const KktResidual* kkt =
      r.optimality && r.optimality->residual ? &*r.optimality->residual : nullptr;
  summary.more["kkt_residual"] = kkt ? nlohmann::json(kkt->stationarity) : nlohmann::json(nullptr);
  auto& prices = summary.more["prices"] = nlohmann::ordered_json::object();
  if (r.optimality)
    for (const LimitPrice& p : r.optimality->prices) prices[p.name] = p.price;
  summary.more["kkt"] = r.optimality ? r.optimality->brief() : "not checked";
  summary.warnings.insert(summary.warnings.end(), r.warnings.begin(), r.warnings.end());
}

/// New holes of a study, which is `study` with those that stayed.
template <FrameGroup G>
Holes holes_of(const MotionTopology<G>& rounds, const Study& study) {
  const CycleResult<G>& end = rounds.cycle;
  Holes holes{body_names(study.scene.mechanism), rounds.holes, {}, 0, "", "kg"};
  if (rounds.next) {
    holes.next = rounds.next->hole.nucleus;
    holes.body = rounds.next->body;
  } else if (end.status == CycleStatus::Interrupted) {
    holes.reason = end.reason;
  } else if (!rounds.holes.empty() && !rounds.holes.back().pays) {
    holes.reason =
        "'" + rounds.holes.back().feature + "', the last one tried, does not reduce the objective";
  } else if (!closed(end.status)) {
    holes.reason = "there is no converged cycle to start from";
  } else if (end.proposals.empty()) {
    holes.reason = "no part whose outline changes counts in the objective";
  } else {
    holes.reason = end.proposals.front().hole.reason;
  }
  return holes;
}

/// What is left of part k, whose outline the study changed.
template <FrameGroup G>
PartOutcome part_of(const std::shared_ptr<Design>& design, int k, const Study& study,
                    const CycleResult<G>& r) {
  PartShape& part = design->part(k);
  const BodySpec& final = r.mechanism.bodies[static_cast<std::size_t>(part.body)];
  PartOutcome out{final.name, {design, &part}, {}, {}, std::get<SolidSpec>(final.kind).outline};
  for (const auto& c : r.history) out.history.push_back(design->of_part(k, c.x));
  if (r.history.back().x != r.x) out.history.push_back(design->of_part(k, r.x));
  out.fields = fields_of_motion(study.spec, part, design->of_part(k, r.x), *r.model,
                                r.simulation.trajectory);
  for (const PartProposal& p : r.proposals)
    if (p.body == part.body) {
      out.fields.hole_gain = p.hole.gain;
      out.fields.gain_unit = "kg/m^3";
    }
  return out;
}

/// All that a study of a motion leaves behind. `sizing` is that of the start.
template <FrameGroup G>
void collect_end(const Study& study, const Sizing& sizing, const std::shared_ptr<Design>& design,
                 const CycleResult<G>& r, OptimizeOutcome& out) {
  const Scene& scene = study.scene;
  out.simulated = true;
  out.results = collect(scene, r.mechanism, *r.model, r.simulation.trajectory);
  describe_responses(out.summary, out.results);
  describe_parts(out.summary, r.mechanism, *r.model, r.simulation.trajectory,
                 scene.simulation.type == SimulationType::Dynamic);
  out.initial = {r.times_initial, series(r.initial, scene.mechanism, study.spec)};
  out.final = {r.times, series(r.final, scene.mechanism, study.spec)};
  if (sizing.size() > 0) out.design = design_rows(sizing, scene.mechanism, r.x);
  for (int k = 0; k < design->parts(); ++k) out.parts.push_back(part_of(design, k, study, r));
}

/// The summary of a run that has not ended.
output::OptimizeSummary running(const output::OptimizeSummary& summary,
                                const std::vector<Cycle>& history) {
  output::OptimizeSummary so_far = summary;
  describe_cycles(so_far, history);
  so_far.status = "running";
  so_far.reason = fmt::format("{} cycles so far; continue with --resume", history.size());
  so_far.mass_initial = history.front().mass;
  so_far.mass_final = history.back().mass;
  so_far.worst_constraint = history.back().worst;
  return so_far;
}

template <FrameGroup G>
void optimize_on(const Study& given, const Space<G>& space, int nucleate,
                 const OptimizeHooks& hooks, const std::vector<Cycle>& resume,
                 OptimizeOutcome& out) {
  const Scene& scene = given.scene;
  const Design first(given.spec, scene.mechanism);
  bool with_holes = false;
  CycleHooks cycle;
  cycle.progress = hooks.progress;
  cycle.keep_going = hooks.keep_going;
  cycle.on_cycle = [&](const std::vector<Cycle>& history) {
    if (hooks.on_cycle) hooks.on_cycle(running(out.summary, history), history, !with_holes);
  };
  const auto on_hole = [&](const std::string& feature, const Nucleus& n) {
    with_holes = true;
    if (hooks.on_hole) hooks.on_hole(feature, n);
  };
  const MotionTopology<G> rounds = optimise_motion_topology<G>(
      scene.mechanism, space, scene.simulation, given.spec, nucleate, cycle, on_hole, resume);
  Study study = given;  // with the holes that stayed
  study.spec = rounds.study;
  study.scene.mechanism = rounds.mechanism;
  const auto design = std::make_shared<Design>(study.spec, study.scene.mechanism);
  describe_result(out.summary, study, *design, rounds.cycle);
  for (auto& figure : out.summary.design)
    for (const NlpVariable& v : first.variables())
      if (v.name == figure.name) figure.initial = v.start;
  if (design->parts() > 0) {
    out.holes = holes_of(rounds, study);
    describe_holes(out.summary, *out.holes);
  }
  if (rounds.cycle.model) collect_end(study, first.sizing(), design, rounds.cycle, out);
  out.status = rounds.cycle.status;
}

}  // namespace

OptimizeOutcome optimize_task(const Study& study, const ChosenSpace& space,
                              const output::OptimizeSummary& summary, int nucleate,
                              const OptimizeHooks& hooks, const std::vector<Cycle>& resume) {
  if (!study.spec.loads.empty()) return optimize_part_task(study, summary, nucleate, hooks);
  OptimizeOutcome out;
  out.summary = summary;
  std::visit([&](const auto& s) { optimize_on(study, s, nucleate, hooks, resume, out); },
             space.space);
  return out;
}

namespace {

template <FrameGroup G>
DerivativeReport derivatives_on(const Study& study, const Space<G>& space) {
  return check_study_derivatives<G>(study.scene.mechanism, space, study.scene.simulation,
                                    study.spec);
}

}  // namespace

DerivativeReport derivatives_task(const Study& study, const ChosenSpace& space) {
  if (!study.spec.loads.empty()) return part_derivatives_task(study);
  return std::visit([&](const auto& s) { return derivatives_on(study, s); }, space.space);
}

std::vector<output::DesignFigure> design_figures(const std::vector<NlpVariable>& variables,
                                                 const std::vector<std::string>& units,
                                                 const Eigen::VectorXd& x) {
  std::vector<output::DesignFigure> out;
  for (int j = 0; j < x.size(); ++j) {
    const auto& v = variables[static_cast<std::size_t>(j)];
    out.push_back({v.name, v.start, x[j], v.lower, v.upper, units[static_cast<std::size_t>(j)]});
  }
  return out;
}

}  // namespace liesl

#endif
