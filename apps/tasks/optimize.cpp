#ifdef LIESL_OPTIM

#include "apps/tasks/optimize.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "apps/tasks/collect.hpp"
#include "apps/tasks/describe_identity.hpp"
#include "apps/tasks/motion_notes.hpp"
#include "apps/tasks/outline_kinks.hpp"
#include "apps/tasks/part_summary.hpp"
#include "apps/tasks/run_summary.hpp"
#include "apps/tasks/sensitivity.hpp"
#include "apps/tasks/study_motions.hpp"
#include "mbs/system/response_value.hpp"
#include "optim/cycle/catalogue.hpp"
#include "optim/cycle/derivative_check.hpp"

namespace liesl {
namespace {

std::vector<LimitRecords> records(const std::vector<MotionLimits>& motions,
                                  const Mechanism& mechanism, const StudySpec& spec) {
  std::vector<LimitRecords> out;
  for (std::size_t s = 0; s < motions.size(); ++s) {
    out.push_back({spec.scenarios.empty() ? "" : spec.scenarios[s], motions[s].times, {}});
    const auto& limits = motions[s].limits;
    for (std::size_t i = 0; i < limits.size(); ++i)
      out.back().responses.push_back(
          {limits[i].name, unit(spec.constraints[i].response, mechanism), 1, limits[i].values});
  }
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

/// Every limit in every scenario.
template <FrameGroup G>
void describe_limits(output::OptimizeSummary& summary, const Study& study,
                     const CycleResult<G>& r) {
  for (std::size_t s = 0; s < r.final.size(); ++s)
    for (std::size_t i = 0; i < r.final[s].limits.size(); ++i) {
      const LimitSeries& last = r.final[s].limits[i];
      if (last.in_objective) continue;
      const auto& spec = study.spec.constraints[i].response;
      const LimitedResponse which{static_cast<int>(i), spec, static_cast<int>(s)};
      const double initial = s < r.initial.size() ? r.initial[s].limits[i].largest : 0;
      summary.constraints.push_back({limit_name(study.spec, which), name_of(spec.kind),
                                     unit(spec, study.scene.mechanism), last.limit, initial,
                                     last.largest, last.at_time, last.measure / last.limit - 1});
    }
  for (std::size_t s = 0; s < r.final.size(); ++s)
    for (std::size_t i = 0; i < r.final[s].frequencies.size(); ++i) {
      const FrequencyCheck& last = r.final[s].frequencies[i];
      if (last.in_objective) continue;
      const std::string scenario =
          study.spec.scenarios.empty() ? "" : " (" + study.spec.scenarios[s] + ")";
      const double initial = s < r.initial.size() && i < r.initial[s].frequencies.size()
                                 ? r.initial[s].frequencies[i].value
                                 : 0;
      summary.constraints.push_back({last.name + scenario, "frequency", "Hz", last.least, initial,
                                     last.value, 0, 1 - last.value / last.least});
    }
}

template <FrameGroup G>
void describe_masses(output::OptimizeSummary& summary, const CycleResult<G>& r) {
  if (r.final.empty()) return;  // the design alone: the same in all scenarios
  for (std::size_t i = 0; i < r.final.front().masses.size(); ++i) {
    const MassCheck& last = r.final.front().masses[i];
    const bool known = !r.initial.empty() && i < r.initial.front().masses.size();
    summary.constraints.push_back({last.name, "mass", "kg", last.limit,
                                   known ? r.initial.front().masses[i].value : 0, last.value, 0,
                                   last.value / last.limit - 1});
  }
}

/// Limits of meshed parts themselves, in every scenario.
template <FrameGroup G>
void describe_part_limits(output::OptimizeSummary& summary, const Study& study,
                          const CycleResult<G>& r) {
  for (std::size_t s = 0; s < r.final.size(); ++s)
    for (std::size_t i = 0; i < r.final[s].parts.size(); ++i) {
      const auto& [limit, last] = r.final[s].parts[i];
      const std::string scenario =
          study.spec.scenarios.empty() ? "" : " (" + study.spec.scenarios[s] + ")";
      const bool known = s < r.initial.size() && i < r.initial[s].parts.size();
      const Quantity q = quantity(limit.quantity);
      summary.constraints.push_back({limit.name + scenario, q.name, q.unit, last.limit,
                                     known ? r.initial[s].parts[i].value.value : 0, last.value, 0,
                                     last.excess});
    }
}

/// The parts of a weighted objective: largest values and frequencies, over all scenarios.
template <FrameGroup G>
void describe_terms(output::OptimizeSummary& summary, const Study& study, const CycleResult<G>& r) {
  auto& terms = summary.more["terms"] = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < study.spec.constraints.size(); ++i) {
    const ConstraintSpec& c = study.spec.constraints[i];
    if (!(c.weight > 0)) continue;
    double first = 0, last = 0;
    for (const MotionLimits& m : r.initial) first = std::max(first, m.limits[i].measure);
    for (const MotionLimits& m : r.final) last = std::max(last, m.limits[i].measure);
    terms[c.response.name] = {{"quantity", name_of(c.response.kind)},
                              {"unit", unit(c.response, study.scene.mechanism)},
                              {"weight", c.weight},
                              {"initial", first},
                              {"final", last}};
  }
  for (std::size_t i = 0; i < study.spec.frequencies.size(); ++i) {
    const FrequencyLimitSpec& f = study.spec.frequencies[i];
    if (!(f.weight > 0) || r.initial.empty() || r.final.empty()) continue;
    double first = r.initial.front().frequencies[i].value,
           last = r.final.front().frequencies[i].value;
    for (const MotionLimits& m : r.initial) first = std::min(first, m.frequencies[i].value);
    for (const MotionLimits& m : r.final) last = std::min(last, m.frequencies[i].value);
    terms[f.name] = {{"quantity", "frequency"},
                     {"unit", "Hz"},
                     {"weight", f.weight},
                     {"initial", first},
                     {"final", last}};
  }
}

template <FrameGroup G>
void describe_result(output::OptimizeSummary& summary, const Study& study, const Design& design,
                     const CycleResult<G>& r) {
  summary.status = to_string(r.status);
  summary.reason = r.reason;
  summary.steps = static_cast<int>(r.effort.steps);
  summary.newton_iterations = r.effort.newton_iterations;
  summary.stepping_s = r.effort.stepping_s;
  summary.more["sensitivities"] = r.effort.sensitivities;
  summary.mass_initial = r.mass_initial;
  summary.mass_final = r.mass;
  if (!study.spec.motion_objective.only_mass() && r.first && r.best)
    summary.more["objective"] = {{"quantity", "weighted sum"},
                                 {"unit", "-"},
                                 {"initial", r.first->objective},
                                 {"final", r.best->objective}};
  if (study.spec.motion_objective.extremes && r.first && r.best) describe_terms(summary, study, r);
  summary.worst_constraint = r.worst;
  summary.load_change = r.load_change;
  const auto& bodies = study.scene.mechanism.bodies;
  for (size_t b = 0; b < r.effort.factorizations.size(); ++b)
    summary.factorizations.emplace_back(bodies[b].name, r.effort.factorizations[b]);
  summary.design = design_figures(design.variables(), design.units(), r.x);
  if (!study.spec.scenarios.empty()) summary.more["scenarios"] = study.spec.scenarios;
  describe_limits(summary, study, r);
  describe_masses(summary, r);
  describe_part_limits(summary, study, r);
  auto& identity = summary.more["identity"] = nlohmann::ordered_json::object();
  for (const auto& [body, id] : r.identity)
    identity[bodies[body].name] = describe_identity(id, bodies[body].name, summary.warnings);
  describe_optimality(summary, r.optimality);
  summary.warnings.insert(summary.warnings.end(), r.warnings.begin(), r.warnings.end());
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

/// Of the limits and the motion of the final design: a start that strikes, a plane that is left.
template <FrameGroup G>
void note_final_motion(const Study& study, const CycleResult<G>& r,
                       std::vector<std::string>& warnings) {
  Scene limited = study.scene;
  limited.mechanism = r.mechanism;
  limited.responses.clear();
  output::Results results;
  for (std::size_t i = 0; i < r.final.front().limits.size(); ++i) {
    const LimitSeries& last = r.final.front().limits[i];
    limited.responses.push_back(study.spec.constraints[i].response);
    results.responses.push_back(
        {last.name, "", 1, {}, {}, output::Peak{last.largest, last.at_time}});
  }
  for (const auto& notes : {struck_start(limited, *r.model, r.simulation.trajectory, results),
                            leaving_plane(limited, *r.model, r.simulation.trajectory)})
    warnings.insert(warnings.end(), notes.begin(), notes.end());
}

/// What `run` says of the final motion: ranges of parts, strains, energy. A design of a motion that
/// cannot be relied on is Inaccurate, whatever the cycle says.
template <FrameGroup G>
void doubt_final_motion(const Scene& scene, const CycleResult<G>& r, OptimizeOutcome& out) {
  const std::string reason = out.summary.reason;
  SolveStatus status = closed(out.status) ? SolveStatus::Converged : SolveStatus::NotConverged;
  PartRanges<G> ranges(r.mechanism, *r.model);
  ranges.add(r.simulation.trajectory);
  status = describe_ranges(out.summary, scene.simulation, ranges, status);
  status = describe_doubts(out.summary, scene, r.mechanism, out.results, status);
  if (status != SolveStatus::Inaccurate) return;
  out.status = CycleStatus::Inaccurate;
  out.summary.reason += "; of the motion as simulated the design is " +
                        std::string(to_string(r.status)) + " (" + reason + ")";
}

/// Of every step the largest values, the records as often as the scene asks for them.
template <FrameGroup G>
output::Results recorded(const Scene& scene, const CycleResult<G>& r) {
  const int every =
      scene.simulation.type == SimulationType::Dynamic ? scene.simulation.output_every : 1;
  const Trajectory<G>& all = r.simulation.trajectory;
  if (every == 1) return collect(scene, r.mechanism, *r.model, all);
  StepRecorder<G> steps(scene, r.mechanism, *r.model);
  Trajectory<G> kept;
  State<G> s = r.model->initial_state();
  for (int n = 0; n < all.size(); ++n) {
    all.read(n, s);
    const bool record = n % every == 0 || n + 1 == all.size();
    steps(s, record);
    if (record) kept.record(s);
  }
  return collect(scene, r.mechanism, *r.model, kept, &steps);
}

/// Of a single motion: where its worst limit is reached is among the instants of the pictures.
void picture_worst_limit(const Study& study, OptimizeOutcome& out) {
  const auto& limits = out.summary.constraints;
  if (!study.spec.scenarios.empty() || limits.empty() || out.results.times.empty()) return;
  const auto worst =
      std::max_element(limits.begin(), limits.end(),
                       [](const auto& a, const auto& b) { return a.violation < b.violation; });
  out.results.peaks.push_back(out.results.record_near(worst->at_time));
}

/// All that a study of a motion leaves behind. `sizing` is that of the start.
template <FrameGroup G>
void collect_end(const Study& study, const Sizing& sizing, const std::shared_ptr<Design>& design,
                 const CycleResult<G>& r, OptimizeOutcome& out) {
  const Scene& scene = study.scene;
  out.simulated = true;
  out.mechanism = r.mechanism;
  out.results = recorded<G>(scene, r);
  picture_worst_limit(study, out);
  describe_responses(out.summary, out.results);
  describe(out.summary, r.simulation.report.penalty, r.mechanism.penalty.form);
  if (!r.final.empty()) note_final_motion(study, r, out.summary.warnings);
  doubt_final_motion(scene, r, out);
  if (r.status != CycleStatus::Interrupted)  // it may take longer than a cycle
    describe_parts(out.summary, r.mechanism, *r.model, r.simulation.trajectory,
                   scene.simulation.type == SimulationType::Dynamic);
  out.initial = records(r.initial, scene.mechanism, study.spec);
  out.final = records(r.final, scene.mechanism, study.spec);
  if (sizing.size() > 0) out.design = design_rows(sizing, scene.mechanism, r.x);
  for (int k = 0; k < design->parts(); ++k) {
    out.parts.push_back(part_of(design, k, study, r));
    if (r.status != CycleStatus::Converged || (r.optimality && r.optimality->holds())) continue;
    for (auto& text : end_warnings(out.parts.back().name, design->part(k), design->of_part(k, r.x)))
      out.summary.warnings.push_back(std::move(text));
  }
}

template <FrameGroup G>
void optimize_on(const Study& given, const Space<G>& space, int nucleate,
                 const OptimizeHooks& hooks, const RoundHistory& resume, OptimizeOutcome& out) {
  const Scene& scene = given.scene;
  const Design first(given.spec, scene.mechanism);
  for (auto& text : start_warnings(first, scene.mechanism))
    out.summary.warnings.push_back(std::move(text));
  SimulationEffort effort;
  for (std::size_t r = 0; r + 1 < resume.size(); ++r)
    if (!resume[r].empty()) effort += resume[r].back().effort;
  auto motions = motions_of(given, space);
  const OptimiseRound<CycleResult<G>> optimise =
      [&](const StudySpec& study, const Mechanism& mechanism, const CycleHooks& cycle,
          const std::vector<Cycle>& cycles) {
        motions.front().mechanism = mechanism;
        auto end = run_cycle<G>(motions, study, cycle, cycles);
        effort += end.effort;
        return end;
      };
  Topology<CycleResult<G>> rounds =
      optimise_study<CycleResult<G>>(given.spec, scene.mechanism, nucleate, optimise,
                                     round_hooks(out.summary, hooks, SolidResponse::Mass), resume);
  CycleResult<G>& end = rounds.last.end;
  end.effort = rounds.catalogue ? rounds.catalogue->effort : effort;
  start_with(end, rounds.first);
  Study study = given;  // with the holes that stayed
  study.spec = rounds.last.study;
  study.scene.mechanism = rounds.last.mechanism;
  const auto design = std::make_shared<Design>(study.spec, study.scene.mechanism);
  describe_cycles(out.summary, {rounds.before, end.history}, SolidResponse::Mass);
  out.loads = loads_of_cycles({rounds.before, end.history}, study);
  describe_result(out.summary, study, *design, end);
  describe_catalogue(out.summary, rounds.catalogue);
  for (auto& figure : out.summary.design)
    for (const NlpVariable& v : first.variables())
      if (v.name == figure.name) figure.initial = v.start;
  if (design->parts() > 0) {
    out.holes = holes_of(rounds, scene.mechanism, "kg");
    describe_holes(out.summary, *out.holes);
  }
  out.status = end.status;
  if (end.model) collect_end(study, first.sizing(), design, end, out);
}

template <FrameGroup G>
void found_on(const Study& given, const Space<G>& space, const FoundOptimum& found,
              const Progress& progress, OptimizeOutcome& out) {
  Study study = given;
  study.scene.responses = study_responses(given, given.scene);
  const auto design = std::make_shared<Design>(study.spec, study.scene.mechanism);
  for (auto& text : start_warnings(*design, study.scene.mechanism))
    out.summary.warnings.push_back(std::move(text));
  LoopResult loop;
  loop.status = found.status;
  loop.reason = found.reason;
  loop.history = found.history;
  loop.x = found.x;
  const auto motions = motions_of(study, space);
  const CycleResult<G> end = describe_found<G>(motions, study.spec, std::move(loop), progress);
  const RoundHistory rounds(1, end.history);
  describe_cycles(out.summary, rounds, SolidResponse::Mass);
  for (std::size_t i = 0; i < end.history.size(); ++i)  // also where it is the mass
    out.summary.history[i].objective = end.history[i].objective;
  out.loads = loads_of_cycles(rounds, study);
  describe_result(out.summary, study, *design, end);
  for (const output::ConstraintFigure& limit : found.limits) {
    out.summary.constraints.push_back(limit);
    out.summary.worst_constraint = std::max(out.summary.worst_constraint, limit.violation);
  }
  out.status = end.status;
  if (end.model) collect_end(study, design->sizing(), design, end, out);
}

}  // namespace

OptimizeOutcome optimize_task(const Study& study, const ChosenSpace& space,
                              const output::OptimizeSummary& summary, int nucleate,
                              const OptimizeHooks& hooks, const RoundHistory& resume) {
  if (!study.spec.loads.empty()) return optimize_part_task(study, summary, nucleate, hooks, resume);
  OptimizeOutcome out;
  out.summary = summary;
  std::visit([&](const auto& s) { optimize_on(study, s, nucleate, hooks, resume, out); },
             space.space);
  return out;
}

OptimizeOutcome found_task(const Study& study, const ChosenSpace& space,
                           const output::OptimizeSummary& summary, const FoundOptimum& found,
                           const Progress& progress) {
  OptimizeOutcome out;
  out.summary = summary;
  std::visit([&](const auto& s) { found_on(study, s, found, progress, out); }, space.space);
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

DerivativeReport equilibrium_derivatives_task(const Study& study, const ChosenSpace& space) {
  return std::visit(
      [&]<FrameGroup G>(const Space<G>& s) {
        return check_equilibrium_derivatives<G>(study.scene.mechanism, s, study.scene.simulation,
                                                study.spec);
      },
      space.space);
}

std::vector<output::CycleLimit> limits_of(const Cycle& cycle) {
  std::vector<output::CycleLimit> limits;
  for (const LimitExcess& l : cycle.excesses) limits.push_back({l.name, l.excess, l.at});
  return limits;
}

void describe_cycles(output::OptimizeSummary& summary, const RoundHistory& rounds,
                     SolidResponse objective) {
  summary.history.clear();
  int number = 0;
  for (const auto& round : rounds)
    for (const Cycle& c : round)
      summary.history.push_back({++number,
                                 c.mass,
                                 c.worst,
                                 c.load_change,
                                 c.load_cases,
                                 c.iterations,
                                 c.move,
                                 c.seconds,
                                 objective == SolidResponse::Mass && c.objective == c.mass
                                     ? std::nullopt
                                     : std::optional(c.objective),
                                 {c.x.data(), c.x.data() + c.x.size()},
                                 c.worst_constraint,
                                 c.worst_at,
                                 limits_of(c)});
}

void describe_catalogue(output::OptimizeSummary& summary, const std::optional<CatalogueReport>& r) {
  if (!r) return;
  const auto known = [](bool is, double value) {
    return is ? nlohmann::json(value) : nlohmann::json(nullptr);
  };
  summary.more["catalogue"] = {
      {"found", r->found},
      {"gap", known(r->found, r->gap)},
      {"bound", known(r->found, r->bound)},
      {"continuous", r->continuous},
      {"above_continuous", known(r->found, r->above_continuous)},
      {"continuous_kkt_residual", known(r->kkt_residual.has_value(), r->kkt_residual.value_or(0))},
      {"designs", r->designs},
      {"boxes", r->boxes},
      {"infeasible", r->infeasible},
      {"undecided", r->undecided}};
}

void describe_optimality(output::OptimizeSummary& summary,
                         const std::optional<DynamicOptimality>& optimality) {
  const KktResidual* kkt = optimality && optimality->residual ? &*optimality->residual : nullptr;
  summary.more["kkt_residual"] = kkt ? nlohmann::json(kkt->stationarity) : nlohmann::json(nullptr);
  auto& prices = summary.more["prices"] = nlohmann::ordered_json::object();
  const bool exceeds = optimality && optimality->violation;  // what it saves is no design's
  if (optimality && !exceeds)
    for (const LimitPrice& p : optimality->prices) prices[p.name] = p.price;
  summary.more["kkt"] = optimality ? optimality->brief() : "not checked";
  if (!exceeds) return;
  if (kkt) summary.more["kkt"] = optimality->brief() + ", but limits are exceeded";
  const ViolationCertificate& v = *optimality->violation;
  auto limits = nlohmann::ordered_json::object();
  for (const LimitPrice& p : v.held_by) limits[p.name] = p.price;
  summary.more["violation"] = {{"largest", v.violation},
                               {"stationary", v.stationary()},
                               {"residual", v.residual},
                               {"held_by", limits}};
}

TopologyHooks round_hooks(const output::OptimizeSummary& summary, const OptimizeHooks& hooks,
                          SolidResponse objective) {
  TopologyHooks out;
  out.progress = hooks.progress;
  out.keep_going = hooks.keep_going;
  out.on_hole = hooks.on_hole;
  out.on_box = hooks.on_box;
  if (!hooks.on_cycle) return out;
  out.on_round_cycle = [summary, objective, on_cycle = hooks.on_cycle](const RoundHistory& rounds) {
    output::OptimizeSummary so_far = summary;
    describe_cycles(so_far, rounds, objective);
    so_far.status = "running";
    so_far.reason = fmt::format("{} cycles so far; continue with --resume", so_far.history.size());
    so_far.mass_initial = rounds.front().front().mass;
    so_far.mass_final = rounds.back().back().mass;
    so_far.worst_constraint = rounds.back().back().worst;
    on_cycle(so_far, rounds);
  };
  return out;
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
