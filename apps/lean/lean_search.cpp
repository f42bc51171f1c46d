#include "apps/lean/lean_search.hpp"

#include <fmt/format.h>

#include "apps/lean/lean_stages.hpp"

namespace liesl {

namespace {

constexpr int kMostChecks = 3;

}  // namespace

LeanResult find_lean(Trials& trials, double tolerance,
                     const std::function<void(const Decision&)>& on_decision) {
  LeanRuns runs(trials, tolerance, on_decision);
  const auto last_evidence = [&] { return runs.result.decisions.back().evidence; };
  if (!run_as_given(runs)) return runs.finish(LeanStatus::Failed, runs.result.reason);
  choose_space(runs);
  if (!find_reference(runs))
    return runs.finish(LeanStatus::NotConverged,
                       "refinement does not settle the response: " + last_evidence() +
                           "; a larger --tolerance may be met, or a start without a jump "
                           "(simulation.start = \"equilibrium\") settles it");
  make_rigid(runs);
  for (int check = 0; check < kMostChecks; ++check) {
    if (!choose_mesh_and_step(runs)) break;
    choose_order(runs);
    choose_segments(runs);
    choose_modes(runs);
    choose_tangent(runs);
    if (check_held_out(runs))
      return runs.finish(LeanStatus::Done,
                         fmt::format("the lean model is within {} of a run twice as fine as its "
                                     "reference: {}",
                                     percent(tolerance), percent(runs.result.error)));
  }
  return runs.finish(LeanStatus::Missed,
                     "no model within the tolerance was found: " + last_evidence());
}

}  // namespace liesl
