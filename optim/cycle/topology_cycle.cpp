#include "optim/cycle/topology_cycle.hpp"

#include "mbs/linalg/stop_request.hpp"
#include "optim/cycle/restarts.hpp"
#include "optim/study/study_errors.hpp"

namespace liesl {
namespace {

/// The study as it starts from a final design x, whose sections the mechanism has.
void start_from(const Eigen::VectorXd& x, StudySpec& study) {
  study = starting_at(std::move(study), x);
  for (DesignSpec& d : study.design) d.start.clear();
}

}  // namespace

std::optional<PartProposal> best_proposal(const LoopResult& end,
                                          const std::vector<PartProposal>& proposals,
                                          std::string& reason) {
  std::optional<PartProposal> best;
  for (const PartProposal& p : proposals)
    if (p.hole.nucleus && (!best || p.hole.nucleus->gain > best->hole.nucleus->gain)) best = p;
  if (best) return best;
  if (!closed(end.status))
    reason = "there is no optimum to start from: " + end.reason;
  else if (proposals.empty())
    reason = "no part whose outline changes counts in the objective";
  else
    reason = proposals.front().hole.reason;
  return best;
}

std::size_t variable_count(const StudySpec& study) {
  std::size_t count = 0;
  each_entry(study, [&count](const auto& entry) {
    count += static_cast<std::size_t>(variables_of(entry));
  });
  return count;
}

bool is_of(const std::vector<Cycle>& history, const StudySpec& study) {
  return history.empty() ||
         static_cast<std::size_t>(history.front().x.size()) == variable_count(study);
}

HoleRound insert_into(const LoopResult& end, const PartProposal& proposal,
                      const Mechanism& designed, StudySpec& study, Mechanism& mechanism) {
  const int body = proposal.body;
  const Nucleus nucleus = *proposal.hole.nucleus;
  start_from(end.x, study);
  mechanism = designed;
  BodySpec& spec = mechanism.bodies[static_cast<std::size_t>(body)];
  SolidSpec& solid = std::get<SolidSpec>(spec.kind);
  ShapeDesignSpec& design = study.shapes.at(body);
  HoleRound hole{body,    insert_hole(nucleus, solid.mesh(), solid.outline, design),
                 nucleus, end.best->objective,
                 0,       0,
                 false,   {}};
  if (study.shapes.size() > 1)  // names of variables are those of the whole study
    for (ShapeVariableSpec& v : design.variables)
      if (v.name.starts_with(hole.feature + ".")) v.name = spec.name + "." + v.name;
  return hole;
}

bool judge_round(const LoopResult& end, double objective_tolerance, HoleRound& hole) {
  hole.reason = end.reason;
  if (!end.best) return false;
  hole.after = end.best->objective;
  hole.cycles = static_cast<int>(end.history.size());
  hole.kept = closed(end.status) && hole.after < hole.before * (1 - objective_tolerance);
  return hole.kept;
}

namespace {

PartEnd optimise_outline_once(const StudySpec& study, const Mechanism& mechanism, int body,
                              const CycleHooks& hooks, const std::vector<Cycle>& resume) {
  const ShapeDesignSpec& design = checked(study, mechanism).shapes.at(body);
  PartEnd out;
  out.part = std::make_shared<PartShape>(mechanism, body, design);
  const SolidTask task = solid_task(study, *out.part);
  static_cast<PartResult&>(out) = optimise_part(task, hooks, resume);
  out.mechanism = mechanism;
  if (!out.best) return out;
  const Unstopped written;
  out.part->apply(out.x, out.mechanism);
  if (closed(out.status)) out.proposals = {{body, propose_hole(task, design.walls, out.x)}};
  return out;
}

}  // namespace

PartEnd optimise_outline(const StudySpec& study, const Mechanism& mechanism, int body,
                         const CycleHooks& hooks, const std::vector<Cycle>& resume) {
  PartEnd out = optimise_from_starts(
      study, [&] { return Design(study, mechanism).variables(); }, hooks, resume,
      [&](const StudySpec& from, const CycleHooks& h, const std::vector<Cycle>& cycles, double) {
        return optimise_outline_once(from, mechanism, body, h, cycles);
      });
  if (out.first) out.initial = dynamic_cast<const PartAnalysis&>(*out.first).check;
  return out;
}

}  // namespace liesl
