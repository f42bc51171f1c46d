#pragma once
/// @file
/// The fully coupled method without any approximation (thesis section 3.3): the optimiser is given
/// the study itself.

#include "optim/cycle/design_loop.hpp"

namespace liesl {

/// Minimises the study by cycle.optimizer: every point that it asks for is an analysis, its
/// gradients those of the study (DesignModel::surrogate at that point). No static problem, no
/// surrogate, no trust region; curvature by the optimiser's own quasi-Newton updates. Where no
/// design has met the limits in half of cycle.max analyses, or the optimiser gives up, the largest
/// violation is minimised instead (elastic.hpp), and the study again from a design that meets them.
///
/// Ends Optimal if the KKT conditions hold at the answer, Converged if the optimiser stops at a
/// design that meets the limits and they do not, CycleLimit after cycle.max analyses, Infeasible if
/// limits are still exceeded. Throws NoSensitivities as the gradients do.
/// @param resume cycles of an interrupted run. What an optimiser knows of earlier points cannot be
/// stored: a run that goes on analyses the same designs again, and ends at the same one.
LoopResult optimise_directly(DesignModel& model, const CycleOptions& options,
                             const CycleHooks& hooks, const std::vector<Cycle>& resume);

}  // namespace liesl
