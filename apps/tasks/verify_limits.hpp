#pragma once
/// @file
/// Errors of the limits of a final design by mesh and step.

#include "apps/study/study.hpp"
#include "apps/tasks/verify.hpp"

namespace liesl {

/// Runs the final design as a scene on finer meshes and steps (`verify`): adds `error_mesh`,
/// `error_step` to the limits of the first scenario, `verification` and, as a share of its limit,
/// the largest of these errors (`worst_constraint_error`), with a warning where that is more than
/// the study allows (cycle.feasibility). What is left out (limits on
/// functionals, p-norms, frequencies and meshed parts, scenarios after the first) is a warning.
/// @param design the scene at the final design, as written to design.toml
void verify_limits(const std::string& design, const Study& study, output::OptimizeSummary& summary,
                   const Progress& progress = {});

}  // namespace liesl
