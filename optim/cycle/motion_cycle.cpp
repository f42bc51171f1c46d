#include "optim/cycle/motion_cycle.hpp"

#include <algorithm>

#include "mbs/linalg/stop_request.hpp"
#include "optim/cycle/continuation.hpp"
#include "optim/cycle/direct_optimum.hpp"
#include "optim/cycle/fixed_point_rule.hpp"
#include "optim/cycle/restarts.hpp"
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

/// @param propose holes in the parts of a design that the loop stands by
template <FrameGroup G>
CycleResult<G> described(MotionModel<G>& model, LoopResult loop, bool propose = true) {
  CycleResult<G> out;
  static_cast<LoopResult&>(out) = std::move(loop);
  out.effort = model.effort();
  start_with(out, out);
  if (!out.history.empty()) out.load_change = out.history.back().load_change;
  if (!out.best) return out;
  const Unstopped written;
  auto& best = dynamic_cast<MotionAnalysis<G>&>(*out.best);
  DesignRun<G>& run = best.runs.front();
  if (propose && closed(out.status) && best.runs.size() == 1)
    out.proposals = propose_holes(model, run, out.x);
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
  if (method == CycleMethod::Direct)
    return described(model, optimise_directly(model, study.cycle, hooks, resume));
  std::unique_ptr<StepRule> rule;
  if (method == CycleMethod::Esl)
    rule = std::make_unique<FixedPointRule>(study.cycle);
  else
    rule = std::make_unique<TrustRegionRule>(study.cycle);
  return described(model, run_loop(model, *rule, study.cycle, hooks, resume));
}

/// Does the plain cycle have all that the study asks for?
bool has_plain_cycle(const StudySpec& study) {
  const bool mechanism =
      std::any_of(study.constraints.begin(), study.constraints.end(),
                  [](const ConstraintSpec& c) { return c.surrogate == SurrogateKind::Mechanism; });
  return !without_statics(study) && study.motion_objective.only_mass() && !mechanism;
}

/// From the start of the study.
template <FrameGroup G>
CycleResult<G> run_once(const std::vector<Scenario<G>>& scenarios, const StudySpec& study,
                        const CycleHooks& hooks, const std::vector<Cycle>& resume) {
  const CycleMethod method = study.cycle.method;
  if (method != CycleMethod::Auto) return run_with(scenarios, study, method, hooks, resume);
  const bool plain = has_plain_cycle(study);
  std::string why;
  try {
    CycleResult<G> result = run_with(scenarios, study, CycleMethod::Esl1, hooks, resume);
    if (result.lost.empty() || !plain) return result;
    why = result.lost;
  } catch (const NoSensitivities& error) {
    if (!plain) throw;
    why = error.what();
  }
  CycleResult<G> result = run_with(scenarios, study, CycleMethod::Esl, hooks, resume);
  result.warnings.push_back("the plain ESL cycle ran, because this motion has no sensitivities: " +
                            why);
  return result;
}

}  // namespace

template <FrameGroup G>
CycleResult<G> run_cycle(const std::vector<Scenario<G>>& scenarios, const StudySpec& study,
                         const CycleHooks& hooks, const std::vector<Cycle>& resume) {
  SimulationEffort effort;
  const Scenario<G>& first = scenarios.front();
  const std::string why = without_speed(study, first.mechanism, first.simulation);
  if (study.cycle.continuation > 0 && !why.empty())
    throw std::invalid_argument("cycle.continuation: " + why);
  auto out = optimise_from_starts(
      study, [&] { return Design(study, first.mechanism).variables(); }, hooks, resume,
      [&](const StudySpec& from, const CycleHooks& h, const std::vector<Cycle>& cycles,
          double speed) {
        auto end = speed < 1 ? run_once(at_speed(scenarios, speed), from, h, cycles)
                             : run_once(scenarios, from, h, cycles);
        effort += end.effort;
        return end;
      },
      why.empty());
  out.effort = effort;
  start_with(out, out);
  return out;
}

namespace {

/// Limits that were measured, and those of others that are not among them.
std::vector<LimitExcess> joined(std::vector<LimitExcess> measured,
                                const std::vector<LimitExcess>& others) {
  for (const LimitExcess& other : others)
    if (std::ranges::find(measured, other.name, &LimitExcess::name) == measured.end())
      measured.push_back(other);
  return measured;
}

}  // namespace

template <FrameGroup G>
CycleResult<G> describe_found(const std::vector<Scenario<G>>& scenarios, StudySpec study,
                              LoopResult found, const Progress& progress) {
  study.cycle.method = CycleMethod::Esl1;  // takes any limit, and extracts loads
  for (ConstraintSpec& c : study.constraints) c.surrogate = SurrogateKind::Auto;
  MotionModel<G> model(scenarios, study);
  const auto analyse = [&](const Eigen::VectorXd& x) {
    const auto analysis = model.analyse(x, progress);
    for (Cycle& cycle : found.history) {
      if (cycle.x != x) continue;
      cycle.loads = analysis->loads;
      if (cycle.worst_constraint == analysis->worst_constraint) cycle.worst_at = analysis->worst_at;
      cycle.excesses = joined(analysis->excesses, cycle.excesses);
    }
    return analysis;
  };
  found.first = analyse(model.start())->figures();
  found.best = analyse(found.x);
  if (!found.best->good()) {
    found.status = CycleStatus::SimulationFailed;
    found.reason = found.best->reason;
    found.best.reset();
  }
  return described(model, std::move(found), false);
}

template CycleResult<SE2> describe_found(const std::vector<Scenario<SE2>>&, StudySpec, LoopResult,
                                         const Progress&);
template CycleResult<SE3> describe_found(const std::vector<Scenario<SE3>>&, StudySpec, LoopResult,
                                         const Progress&);
template CycleResult<SE2> run_cycle(const std::vector<Scenario<SE2>>&, const StudySpec&,
                                    const CycleHooks&, const std::vector<Cycle>&);
template CycleResult<SE3> run_cycle(const std::vector<Scenario<SE3>>&, const StudySpec&,
                                    const CycleHooks&, const std::vector<Cycle>&);

}  // namespace liesl
