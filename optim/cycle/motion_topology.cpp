#include "optim/cycle/motion_topology.hpp"

namespace liesl {
namespace {

/// The part with the largest gain of all.
std::optional<PartProposal> best_proposal(const std::vector<PartProposal>& proposals) {
  std::optional<PartProposal> best;
  for (const PartProposal& p : proposals)
    if (p.hole.nucleus && (!best || p.hole.nucleus->gain > best->hole.nucleus->gain)) best = p;
  return best;
}

/// The study as it starts from the end of a cycle.
template <FrameGroup G>
StudySpec from_end(StudySpec study, const CycleResult<G>& end) {
  int j = Sizing(study.design, end.mechanism).size();
  for (DesignSpec& d : study.design) d.start.clear();  // as in the mechanism
  for (auto& [body, shape] : study.shapes)
    for (ShapeVariableSpec& v : shape.variables) v.start = end.x[j++];
  return study;
}

/// What was before all holes.
template <FrameGroup G>
void keep_initial(const CycleResult<G>& first, CycleResult<G>& next) {
  next.mass_initial = first.mass_initial;
  next.initial = first.initial;
}

/// The effort of another round counts, too.
template <FrameGroup G>
void add_effort(const CycleResult<G>& round, CycleResult<G>& total) {
  total.effort.steps += round.effort.steps;
  total.effort.newton_iterations += round.effort.newton_iterations;
  total.effort.stepping_s += round.effort.stepping_s;
  for (std::size_t b = 0; b < round.effort.factorizations.size(); ++b)
    total.effort.factorizations[b] += round.effort.factorizations[b];
}

}  // namespace

template <FrameGroup G>
MotionTopology<G> optimise_motion_topology(
    const Mechanism& mechanism, const Space<G>& space, const SimulationOptions& simulation,
    const StudySpec& study, int most, const CycleHooks& hooks,
    const std::function<void(const std::string&, const Nucleus&)>& on_hole,
    const std::vector<Cycle>& resume) {
  MotionTopology<G> best{
      study, mechanism, run_cycle<G>(mechanism, space, simulation, study, hooks, resume), {}, {}};
  best.next = best_proposal(best.cycle.proposals);
  while (static_cast<int>(best.holes.size()) < most && best.next) {
    const Nucleus nucleus = *best.next->hole.nucleus;
    const int body = best.next->body;
    MotionTopology<G> next{
        from_end(best.study, best.cycle), best.cycle.mechanism, {}, best.holes, {}};
    SolidSpec& solid = std::get<SolidSpec>(next.mechanism.bodies[std::size_t(body)].kind);
    HoleRound hole{
        body,    insert_hole(nucleus, solid.mesh, solid.outline, next.study.shapes.at(body)),
        nucleus, best.cycle.mass,
        0,       0,
        false,   {}};
    if (next.study.shapes.size() > 1)  // names of variables are those of the whole study
      for (ShapeVariableSpec& v : next.study.shapes.at(body).variables)
        if (v.name.starts_with(hole.feature + "."))
          v.name = next.mechanism.bodies[std::size_t(body)].name + "." + v.name;
    if (on_hole) on_hole(hole.feature, nucleus);
    try {
      next.cycle = run_cycle<G>(next.mechanism, space, simulation, next.study, hooks);
    } catch (const std::invalid_argument& error) {  // bounds that were right before the hole moved
      next.cycle.reason = error.what();
    }
    hole.after = next.cycle.mass;
    hole.steps = static_cast<int>(next.cycle.history.size());
    hole.reason = next.cycle.reason;
    hole.pays = closed(next.cycle.status) &&
                hole.after < hole.before * (1 - study.cycle.objective_tolerance);
    best.holes.push_back(hole);
    if (!hole.pays) {
      best.next.reset();
      add_effort(next.cycle, best.cycle);
      if (next.cycle.status == CycleStatus::Interrupted) {
        best.cycle.status = next.cycle.status;
        best.cycle.reason =
            next.cycle.reason + "; this is the design before '" + hole.feature + "'";
      }
      break;
    }
    keep_initial(best.cycle, next.cycle);
    add_effort(best.cycle, next.cycle);
    next.holes = best.holes;
    next.next = best_proposal(next.cycle.proposals);
    best = std::move(next);
  }
  return best;
}

template MotionTopology<SE2> optimise_motion_topology(
    const Mechanism&, const Space<SE2>&, const SimulationOptions&, const StudySpec&, int,
    const CycleHooks&, const std::function<void(const std::string&, const Nucleus&)>&,
    const std::vector<Cycle>&);
template MotionTopology<SE3> optimise_motion_topology(
    const Mechanism&, const Space<SE3>&, const SimulationOptions&, const StudySpec&, int,
    const CycleHooks&, const std::function<void(const std::string&, const Nucleus&)>&,
    const std::vector<Cycle>&);

}  // namespace liesl
