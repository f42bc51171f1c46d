#ifdef LIESL_OPTIM

#include "apps/tasks/optimize_verified.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "apps/input/problem.hpp"
#include "apps/tasks/verify_part.hpp"
#include "optim/cycle/restarts.hpp"

namespace liesl {
namespace {

constexpr double kForTheDesign =
    0.5;                              // of cycle.feasibility is left to the design on a finer model
constexpr double kSameDesign = 1e-9;  // relative
constexpr int kMostModels = 12;       // each four times as exact: enough for any
// Refinements in a row that leave an error: on a coarse model it may be small by chance, once.
constexpr int kMostStalls = 2;

/// Cycles of the models before, then those of the present one, numbered through.
std::vector<output::CycleRecord> joined(std::vector<output::CycleRecord> before,
                                        const std::vector<output::CycleRecord>& now) {
  before.insert(before.end(), now.begin(), now.end());
  for (std::size_t i = 0; i < before.size(); ++i) before[i].cycle = static_cast<int>(i) + 1;
  return before;
}

/// What a summary says of the start is that of the first model; effort adds up.
void join_summary(const output::OptimizeSummary& first, output::OptimizeSummary& last) {
  last.history = joined(first.history, last.history);
  last.mass_initial = first.mass_initial;
  for (std::size_t i = 0; i < last.design.size(); ++i)
    last.design[i].initial = first.design[i].initial;
  for (auto& limit : last.constraints)
    for (const auto& was : first.constraints)
      if (was.name == limit.name) limit.max_abs_initial = was.max_abs_initial;
  if (last.more.contains("objective") && first.more.contains("objective"))
    last.more["objective"]["initial"] = first.more["objective"]["initial"];
  if (last.more.contains("terms") && first.more.contains("terms"))
    for (auto& [name, term] : last.more["terms"].items())
      term["initial"] = first.more["terms"][name]["initial"];
  last.steps += first.steps;
  last.newton_iterations += first.newton_iterations;
  last.stepping_s += first.stepping_s;
  if (last.more.contains("sensitivities"))
    last.more["sensitivities"] =
        last.more["sensitivities"].get<long>() + first.more.value("sensitivities", 0L);
  for (auto& [body, count] : last.factorizations)
    for (const auto& [name, before] : first.factorizations)
      if (name == body) count += before;
}

/// Designs of a part, a cycle each: those of the models before come first.
void join_designs(const OptimizeOutcome& first, OptimizeOutcome& last) {
  const std::size_t cycles = first.summary.history.size();
  for (PartOutcome& part : last.parts)
    for (const PartOutcome& was : first.parts) {
      if (was.name != part.name) continue;
      const auto count = static_cast<std::ptrdiff_t>(std::min(cycles, was.history.size()));
      part.history.insert(part.history.begin(), was.history.begin(), was.history.begin() + count);
    }
}

/// The same of all that an optimisation leaves behind.
void join_outcome(const OptimizeOutcome& first, OptimizeOutcome& last) {
  join_summary(first.summary, last.summary);
  join_designs(first, last);
  if (!first.initial.empty()) last.initial = first.initial;
  last.loads = joined_loads(first.loads, last.loads, first.summary.history.size());
  for (auto& row : last.design)
    for (const auto& figure : last.summary.design)
      if (figure.name == row.variable) row.initial = figure.initial;
}

/// One study on one model after the other.
class ModelSequence {
 public:
  ModelSequence(const Study& study, const ChosenSpace& space,
                const output::OptimizeSummary& summary, const OptimizeHooks& hooks,
                const VerifiedOptions& options, const ModelHistory& resume)
      : space_(space),
        summary_(summary),
        hooks_(hooks),
        options_(options),
        resume_(resume),
        feasibility_(study.spec.cycle.feasibility),
        now_{{}, study} {}

  VerifiedOptimum run() {
    now_.out = optimize_task(now_.study, space_, summary_, options_.nucleate, hooks_, resume(0));
    if (!options_.verify || !can_be_verified()) return std::move(now_);
    limits_ = verified();
    const bool refines = options_.refine && now_.study.spec.cycle.method != CycleMethod::Esl;
    if (refines)
      for (int model = 1; go_on(model);) ++model;
    warn_of_errors(limits_, feasibility_, now_.study.scene.mechanism, way_to_finer_models(),
                   now_.out.summary.warnings);
    return std::move(now_);
  }

 private:
  RoundHistory resume(std::size_t model) const {
    return model < resume_.size() ? resume_[model] : RoundHistory();
  }

  /// Those of a model that began where the one before has ended now: with other options it may end
  /// elsewhere.
  RoundHistory resume_from_here(std::size_t model) const {
    const RoundHistory cycles = resume(model);
    if (cycles.empty() || cycles.front().empty()) return {};
    const Eigen::VectorXd x = final_design(), &was = cycles.front().front().x;
    return was.size() == x.size() && (was - x).norm() <= kSameDesign * x.norm() ? cycles
                                                                                : RoundHistory();
  }

  Eigen::VectorXd final_design() const {
    const auto& design = now_.out.summary.design;
    Eigen::VectorXd x(static_cast<Eigen::Index>(design.size()));
    for (Eigen::Index j = 0; j < x.size(); ++j) x[j] = design[static_cast<std::size_t>(j)].final;
    return x;
  }

  /// What the user may do to have them; empty: they were tried.
  std::string way_to_finer_models() const {
    if (now_.study.spec.cycle.method == CycleMethod::Esl) return "another cycle.method goes on";
    if (!now_.study.refine) return "cycle.refine = \"auto\" does so";
    return options_.refine ? "" : "a run without new holes does so";
  }

  bool fixed_loads() const { return !now_.study.spec.loads.empty(); }

  std::vector<VerifiedLimit> verified() {
    if (!fixed_loads()) return verify_limits(now_.out, now_.study, hooks_.progress);
    return verify_part(now_.out, now_.study, [this](std::vector<std::string> changes) {
      changes.insert(changes.begin(), changes_.begin(), changes_.end());
      return options_.read(changes);
    });
  }

  bool can_be_verified() const {
    const SimulationOptions& o = now_.study.scene.simulation;
    if (now_.out.status == CycleStatus::Interrupted) return false;
    if (fixed_loads()) return !now_.out.parts.empty();
    return now_.out.simulated && !(o.type == SimulationType::Static && o.arc_length);
  }

  /// Says how refinement ended.
  bool end(bool holds, const std::string& reason) {
    refinement_["holds"] = holds;
    refinement_["reason"] = reason;
    refinement_["steps"] = steps_;
    now_.out.summary.more["refinement"] = refinement_;
    if (!holds && !reason.empty())
      now_.out.summary.warnings.push_back("not certain on the converged model: " + reason);
    return false;
  }

  /// Those whose errors are known are certain.
  bool end_of_known() {
    for (const VerifiedLimit& l : limits_)
      if (!l.known) return end(false, "the error of limit " + l.name + " is not known");
    return end(true, "");
  }

  bool interrupted() {
    if (!hooks_.keep_going || hooks_.keep_going()) return false;
    now_.out.status = CycleStatus::Interrupted;
    now_.out.summary.status = to_string(now_.out.status);
    now_.out.summary.reason = "stopped on request before the design was certain";
    return true;
  }

  /// On the next model. False: this was the last.
  bool go_on(int model) {
    if (interrupted()) return end(false, now_.out.summary.reason);
    if (limits_.empty())  // as the warnings say
      return steps_.empty() ? false : end(false, "the limits of the finer model are not verified");
    if (!closed(now_.out.status))
      return end(false, fmt::format("the study ended with status '{}'", now_.out.summary.status));
    std::vector<VerifiedLimit> known = limits_;
    std::erase_if(known, [](const VerifiedLimit& l) { return !l.known; });
    if (known.empty() || nearest_limit(known).certain(feasibility_)) return end_of_known();
    const VerifiedLimit worst = nearest_limit(known);
    const std::string stays = not_converging(before_, limits_, finer_, feasibility_);
    stalls_ = stays.empty() ? 0 : stalls_ + 1;
    if (stalls_ == kMostStalls) return end(false, stays);
    finer_ = finer_model(now_.study, limits_, feasibility_, changes_, options_.read);
    if (!finer_.exhausted.empty()) return end(false, worst.text() + ", and " + finer_.exhausted);
    if ((finer_.changes.empty() && model > 1) || model == kMostModels)
      return end(false, fmt::format("{}, after {} models", worst.text(), model));
    return optimise_on(model, worst);
  }

  /// Optimises on `finer_` from the present design.
  bool optimise_on(int model, const VerifiedLimit& worst) {
    const std::string what = finer_.changes.empty()
                                 ? "limits met to half of cycle.feasibility"
                                 : fmt::format("{}", fmt::join(finer_.changes, ", "));
    const std::string why = worst.error() > feasibility_
                                ? worst.text()
                                : fmt::format("limit {} may be exceeded by {:.2g} %", worst.name,
                                              100 * (worst.violation + worst.error()));
    steps_.push_back(
        {{"changes", finer_.changes},
         {"because", why},
         {"mass", now_.out.summary.mass_final},
         {"worst_constraint", now_.out.summary.worst_constraint},
         {"worst_constraint_error", now_.out.summary.more.value("worst_constraint_error", 0.0)},
         {"cycles", now_.out.summary.history.size()}});
    if (options_.on_refinement) options_.on_refinement(why + ": " + what);
    changes_.insert(changes_.end(), finer_.changes.begin(), finer_.changes.end());
    VerifiedOptimum next;
    try {
      next.study = read();
      next.out = optimize_task(next.study, choose_space(next.study.scene), summary_, 0, hooks(),
                               resume_from_here(static_cast<std::size_t>(model)));
    } catch (const InputError& error) {
      return end(false, fmt::format("{} cannot be read: {}", what, error.what()));
    } catch (const std::invalid_argument& error) {
      return end(false, fmt::format("{} cannot be optimised: {}", what, error.what()));
    }
    if (!next.out.simulated) return end(false, next.out.summary.reason);
    join_outcome(now_.out, next.out);
    now_ = std::move(next);
    before_ = limits_;
    limits_ =
        now_.out.status == CycleStatus::Interrupted ? std::vector<VerifiedLimit>() : verified();
    return true;
  }

  Study read() const {
    Study study = options_.read(changes_);
    study.spec = starting_at(std::move(study.spec), final_design());
    study.spec.cycle.feasibility = kForTheDesign * feasibility_;
    study.spec.cycle.from_optimum = true;
    return study;
  }

  /// With the cycles of the models before in the summaries "running".
  OptimizeHooks hooks() const {
    OptimizeHooks out = hooks_;
    if (hooks_.on_cycle)
      out.on_cycle = [first = now_.out.summary, call = hooks_.on_cycle](
                         output::OptimizeSummary so_far, const RoundHistory& rounds) {
        so_far.history = joined(first.history, so_far.history);
        so_far.mass_initial = first.mass_initial;
        call(so_far, rounds);
      };
    return out;
  }

  const ChosenSpace& space_;
  const output::OptimizeSummary& summary_;
  const OptimizeHooks& hooks_;
  const VerifiedOptions& options_;
  const ModelHistory& resume_;
  const double feasibility_;
  VerifiedOptimum now_;
  std::vector<VerifiedLimit> limits_, before_;
  FinerModel finer_;
  int stalls_ = 0;  ///< refinements in a row that left an error as large
  std::vector<std::string> changes_;
  nlohmann::ordered_json refinement_ = nlohmann::ordered_json::object(),
                         steps_ = nlohmann::ordered_json::array();
};

}  // namespace

VerifiedOptimum optimize_verified(const Study& study, const ChosenSpace& space,
                                  const output::OptimizeSummary& summary,
                                  const OptimizeHooks& hooks, const VerifiedOptions& options,
                                  const ModelHistory& resume) {
  return ModelSequence(study, space, summary, hooks, options, resume).run();
}

}  // namespace liesl

#endif
