#pragma once
/// @file
/// What is wrong with a study, whoever made it.

#include "mbs/model/mechanism.hpp"
#include "optim/study/study.hpp"

namespace liesl {

/// All of it, with place, expected and got: bodies that the mechanism does not have or that are of
/// another kind, bounds, groups, dimensions that a section does not have, starts, limits, options
/// of the cycle. Empty: sound as far as can be said without building the parts.
std::vector<std::string> study_errors(const StudySpec& study, const Mechanism& mechanism);

/// @throws std::invalid_argument that lists all errors @returns the study
const StudySpec& checked(const StudySpec& study, const Mechanism& mechanism);

}  // namespace liesl
