#pragma once
/// @file
/// An optimisation with the errors of its limits, on finer models until it is certain.

#include "apps/tasks/refine.hpp"

namespace liesl {

/// The cycles of each model so far, by rounds.
using ModelHistory = std::vector<RoundHistory>;

struct VerifiedOptimum {
  OptimizeOutcome out;
  Study study;  ///< on the last model, which `out` is of
};

struct VerifiedOptions {
  bool verify = true;
  bool refine = true;  ///< where the errors of the limits ask for it, but not by method "esl"
  int nucleate = 0;
  ReadStudy read;  ///< of finer models
  /// Called before a study goes on with a finer model: why, and what is finer.
  std::function<void(const std::string& text)> on_refinement;
};

/// optimize_task, then the errors of the limits of its final design (verify_limits). Where
/// a limit is not certain, again from that design on a finer model
/// (finer_model) that has to meet the limits to half of cycle.feasibility, until all are certain:
/// `refinement` of the summary says what was refined and why, and what ended it. The outcome is
/// that of the last model; what is initial in it, that of the first; its history has the cycles of
/// all.
/// @param resume of an interrupted run of the same study
/// @throws as optimize_task
VerifiedOptimum optimize_verified(const Study& study, const ChosenSpace& space,
                                  const output::OptimizeSummary& summary,
                                  const OptimizeHooks& hooks, const VerifiedOptions& options,
                                  const ModelHistory& resume = {});

}  // namespace liesl
