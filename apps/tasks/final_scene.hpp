#pragma once
/// @file
/// The final design of an optimisation as a scene that runs.

#include "apps/study/study.hpp"
#include "apps/tasks/optimize.hpp"

namespace liesl {

/// The scene of a scenario, by its number, at the final design (design_scene). @pre out.simulated
std::string final_scene(const OptimizeOutcome& out, const Study& study, std::size_t scenario = 0);

}  // namespace liesl
