#include "optim/cycle/topology_cycle.hpp"

#include <stdexcept>

#include "optim/cycle/solid_task.hpp"
#include "optim/study/study_errors.hpp"

namespace liesl {
namespace {

/// A study of one outline, its mechanism at the latest design, and what came of them.
struct Round {
  StudySpec study;
  Mechanism mechanism;
  std::unique_ptr<PartShape> part;
  ShapeResult shape;
  HoleProposal proposal;

  SolidSpec& solid() {
    return std::get<SolidSpec>(mechanism.bodies[static_cast<std::size_t>(part->body)].kind);
  }
  const SolidCheck& last() const { return shape.history.back().check; }
};

class TopologyCycle {
 public:
  TopologyCycle(int body, const TopologyHooks& hooks) : body_(body), hooks_(hooks) {}

  TopologyResult run(const StudySpec& study, const Mechanism& mechanism, int most) {
    Round best{study, mechanism, {}, {}, {}};
    optimise(best);
    while (static_cast<int>(holes_.size()) < most && best.proposal.nucleus) {
      Round next{best.study, best.mechanism, {}, {}, {}};
      if (try_hole(best, next)) {
        best = std::move(next);
        continue;
      }
      const std::string& hole = holes_.back().feature;
      best.proposal.nucleus.reset();
      best.proposal.reason = "'" + hole + "', the last one tried, does not pay";
      if (next.shape.status == CycleStatus::Interrupted) {
        best.shape.status = next.shape.status;
        best.shape.reason = next.shape.reason + "; this is the design before '" + hole + "'";
        best.proposal.reason = next.shape.reason;
      }
      break;
    }
    TopologyResult out;
    if (best.shape.x.size() > 0) out.outline = best.solid().outline;
    out.part = std::move(best.part);
    out.round = before_.size();
    best.shape.history = joined(best.shape.history);
    out.shape = std::move(best.shape);
    out.holes = std::move(holes_);
    out.proposal = std::move(best.proposal);
    return out;
  }

 private:
  /// Optimises a round, leaves its mechanism at the final design and asks for the next hole.
  void optimise(Round& r) {
    ShapeDesignSpec& design = r.study.shapes.at(body_);
    r.part = std::make_unique<PartShape>(r.mechanism, body_, design);
    const SolidTask task = solid_task(r.study, *r.part);
    ShapeHooks hooks{{}, hooks_.keep_going};
    if (hooks_.on_step)
      hooks.on_step = [this](const std::vector<ShapeStep>& steps) {
        hooks_.on_step(joined(steps));
      };
    r.shape = optimise_shape(task, {r.study.cycle.move_cells, r.study.cycle.move_limit}, hooks);
    if (r.shape.x.size() == 0) {
      r.proposal.reason = r.shape.reason;
      return;
    }
    r.part->apply(r.shape.x, r.mechanism);
    for (std::size_t j = 0; j < design.variables.size(); ++j)
      design.variables[j].start = r.shape.x[static_cast<Eigen::Index>(j)];
    if (r.shape.status == CycleStatus::Converged)
      r.proposal = propose_hole(task, design.walls, r.shape.x);
    else
      r.proposal.reason = "there is no optimum to start from: " + r.shape.reason;
  }

  /// Does `next`, which is `best` with its proposal, pay? Then the steps of `best` are kept.
  bool try_hole(Round& best, Round& next) {
    const Nucleus nucleus = *best.proposal.nucleus;
    SolidSpec& solid =
        std::get<SolidSpec>(next.mechanism.bodies[static_cast<std::size_t>(body_)].kind);
    HoleRound hole{
        body_,   insert_hole(nucleus, solid.mesh, solid.outline, next.study.shapes.at(body_)),
        nucleus, best.last().goal,
        0,       0,
        false,   {}};
    if (hooks_.on_hole) hooks_.on_hole(hole.feature, nucleus);
    const std::size_t earlier = before_.size();
    before_.insert(before_.end(), best.shape.history.begin(), best.shape.history.end());
    try {
      optimise(next);
    } catch (const std::invalid_argument& error) {  // bounds that were right before the hole moved
      next.shape.reason = error.what();
    }
    if (!next.shape.history.empty()) {
      hole.after = next.last().goal;
      hole.steps = static_cast<int>(next.shape.history.size());
      const double least = hole.before * (1 - next.study.cycle.objective_tolerance);
      hole.pays = next.shape.status == CycleStatus::Converged && hole.after < least;
    }
    hole.reason = next.shape.reason;
    if (!hole.pays) before_.resize(earlier);
    holes_.push_back(hole);
    return hole.pays;
  }

  /// The steps of the rounds before and of this one, numbered through.
  std::vector<ShapeStep> joined(const std::vector<ShapeStep>& steps) const {
    std::vector<ShapeStep> all = before_;
    all.insert(all.end(), steps.begin(), steps.end());
    for (std::size_t i = 0; i < all.size(); ++i) all[i].number = static_cast<int>(i) + 1;
    return all;
  }

  int body_;
  const TopologyHooks& hooks_;
  std::vector<ShapeStep> before_;  ///< of the rounds before
  std::vector<HoleRound> holes_;
};

}  // namespace

TopologyResult optimise_topology(const StudySpec& study, const Mechanism& mechanism, int body,
                                 int most, const TopologyHooks& hooks) {
  return TopologyCycle(body, hooks).run(checked(study, mechanism), mechanism, most);
}

}  // namespace liesl
