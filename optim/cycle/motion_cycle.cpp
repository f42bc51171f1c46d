#include "optim/cycle/motion_cycle.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "optim/cycle/fixed_point_rule.hpp"
#include "optim/cycle/trust_region_rule.hpp"

namespace liesl {
namespace {

template <FrameGroup G>
std::vector<PartProposal> propose_holes(const MotionModel<G>& model, const DesignRun<G>& run,
                                        const Eigen::VectorXd& x) {
  std::vector<PartProposal> out;
  const Design& design = model.design();
  const auto& counted = model.study().mass_of;
  for (int k = 0; k < design.parts(); ++k) {
    const int body = design.part(k).body;
    if (std::find(counted.begin(), counted.end(), body) == counted.end()) continue;
    out.push_back({body, propose_hole(motion_task(model.study(), model.simulator(0), k, run),
                                      model.study().shapes.at(body).walls, design.of_part(k, x))});
  }
  return out;
}

/// How exactly the equivalent loads give back the deformation of the final motion.
template <FrameGroup G>
std::vector<std::pair<int, Identity>> identities(const Design& design, const DesignRun<G>& run,
                                                 const Eigen::VectorXd& x) {
  std::vector<std::pair<int, Identity>> out;
  for (const auto& loads : run.loads)
    out.emplace_back(loads.body, check_identity(*run.model, run.simulation.trajectory, loads));
  for (int k = 0; k < design.parts(); ++k) {
    PartShape& part = design.part(k);
    part.shape->set(part.design.parameters(design.of_part(k, x)));
    const Fractions fractions = volume_fractions(part.model.mesh(), *part.shape);
    for (const auto& loads : run.solid_loads)
      if (loads.body == part.body)
        out.emplace_back(loads.body, check_identity(part.model, fractions.value, loads));
  }
  return out;
}

template <FrameGroup G>
CycleResult<G> described(MotionModel<G>& model, LoopResult loop) {
  CycleResult<G> out;
  static_cast<LoopResult&>(out) = std::move(loop);
  out.effort = model.effort();
  start_with(out, out);
  if (!out.history.empty()) out.load_change = out.history.back().load_change;
  if (!out.best) return out;
  auto& best = dynamic_cast<MotionAnalysis<G>&>(*out.best);
  DesignRun<G>& run = best.runs.front();
  if (closed(out.status) && best.runs.size() == 1) out.proposals = propose_holes(model, run, out.x);
  out.identity = identities(model.design(), run, out.x);
  out.mass = best.mass;
  out.worst = best.worst;
  out.final = best.limits;
  for (const auto& w : run.simulation.report.warnings) out.warnings.push_back(w);
  out.mechanism = run.mechanism;
  out.model = run.model;
  out.simulation = std::move(run.simulation);
  out.best = best.figures();
  return out;
}

template <FrameGroup G>
CycleResult<G> run_with(const std::vector<Scenario<G>>& scenarios, StudySpec study,
                        CycleMethod method, const CycleHooks& hooks,
                        const std::vector<Cycle>& resume) {
  study.cycle.method = method;
  MotionModel<G> model(scenarios, study);
  std::unique_ptr<StepRule> rule;
  if (method == CycleMethod::Esl)
    rule = std::make_unique<FixedPointRule>(study.cycle);
  else
    rule = std::make_unique<TrustRegionRule>(study.cycle);
  return described(model, run_loop(model, *rule, study.cycle, hooks, resume));
}

/// Static images of its limits did not lead a design of sections to an optimum, and cycles are
/// left.
template <FrameGroup G>
bool may_go_on(const StudySpec& study, const CycleResult<G>& r) {
  const bool ended = r.status == CycleStatus::Infeasible || r.status == CycleStatus::Converged;
  const auto& limits = study.constraints;
  return ended && r.best && study.shapes.empty() &&
         static_cast<int>(r.history.size()) < study.cycle.max &&
         std::any_of(limits.begin(), limits.end(),
                     [](const ConstraintSpec& c) { return c.treatment == Treatment::Auto; });
}

/// The study from a design x on, its limits as the maxima of the motion itself.
StudySpec with_maxima(StudySpec study, const Eigen::VectorXd& x, std::size_t cycles) {
  Eigen::Index i = 0;
  for (DesignSpec& d : study.design) {
    d.start.assign(x.data() + i, x.data() + i + d.groups);
    i += d.groups;
  }
  for (ConstantSpec& c : study.constants) c.start = x[i++];
  for (ConstraintSpec& c : study.constraints)
    if (c.treatment == Treatment::Auto) c.treatment = Treatment::Maxima;
  study.cycle.max -= static_cast<int>(cycles);
  return study;
}

/// Goes on from the best design of a cycle whose static images led to no optimum.
template <FrameGroup G>
CycleResult<G> go_on(const std::vector<Scenario<G>>& scenarios, const StudySpec& study,
                     CycleResult<G> before, const CycleHooks& hooks) {
  const History first = before.history;
  const auto joined = [&](const History& more) {
    History all = first;
    for (Cycle c : more) {
      c.number += first.back().number;
      SimulationEffort effort = before.effort;
      c.effort = effort += c.effort;
      all.push_back(std::move(c));
    }
    return all;
  };
  CycleHooks reporting = hooks;
  if (hooks.on_cycle)
    reporting.on_cycle = [&](const History& more) { hooks.on_cycle(joined(more)); };
  CycleResult<G> next = run_with(scenarios, with_maxima(study, before.x, first.size()),
                                 CycleMethod::Esl1, reporting, {});
  const SimulationEffort effort = before.effort;
  const History all = joined(next.history);
  const bool better = next.best && (closed(next.status) || next.worst < before.worst);
  if (better) {
    next.initial = before.initial;
    next.mass_initial = before.mass_initial;
    next.first = before.first;
    next.reason +=
        fmt::format("; from cycle {} on by the maxima of the motion, without static images",
                    first.back().number + 1);
  }
  CycleResult<G>& end = better ? next : before;
  end.history = all;
  end.effort = effort;
  end.effort += next.effort;
  return std::move(end);
}

}  // namespace

template <FrameGroup G>
CycleResult<G> run_cycle(const std::vector<Scenario<G>>& scenarios, const StudySpec& study,
                         const CycleHooks& hooks, const std::vector<Cycle>& resume) {
  const CycleMethod method = study.cycle.method;
  const bool moves = scenarios.front().simulation.type == SimulationType::Dynamic;
  if (method == CycleMethod::Esl || !moves)
    return run_with(scenarios, study, CycleMethod::Esl, hooks, resume);
  if (method != CycleMethod::Auto) return run_with(scenarios, study, method, hooks, resume);
  try {
    CycleResult<G> result = run_with(scenarios, study, CycleMethod::Esl1, hooks, resume);
    return may_go_on(study, result) ? go_on(scenarios, study, std::move(result), hooks) : result;
  } catch (const NoSensitivities& error) {
    CycleResult<G> result = run_with(scenarios, study, CycleMethod::Esl, hooks, resume);
    result.warnings.push_back(
        "the plain ESL cycle ran, because this motion has no sensitivities: " +
        std::string(error.what()));
    return result;
  }
}

template CycleResult<SE2> run_cycle(const std::vector<Scenario<SE2>>&, const StudySpec&,
                                    const CycleHooks&, const std::vector<Cycle>&);
template CycleResult<SE3> run_cycle(const std::vector<Scenario<SE3>>&, const StudySpec&,
                                    const CycleHooks&, const std::vector<Cycle>&);

}  // namespace liesl
