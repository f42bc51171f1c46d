#pragma once
/// @file
/// A study as one nonlinear program, for optimisers that are not liesl's own.

#include <memory>

#include "apps/scene/space.hpp"
#include "apps/study/study.hpp"
#include "optim/nlp/problem.hpp"

namespace liesl {

/// Values and gradients of the study itself at any design, with rows that stay.
///   - Fixed loads: each limit in each load case, then what the design alone decides (mass,
///     frequencies, walls).
///   - A motion: each limit at each record, then those of the design alone, as cycle.method =
///     "direct" has them.
/// `study` outlives the program. @throws std::invalid_argument for a study that has no such rows:
/// a weighted objective of largest values, limits of parts in load cases that change
/// @throws std::runtime_error if the start cannot be analysed
std::unique_ptr<Problem> study_nlp(const Study& study, const ChosenSpace& space);

}  // namespace liesl
