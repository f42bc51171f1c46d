#pragma once
/// @file
/// Errors of the limits of a part under fixed loads, by its cells.

#include "apps/tasks/verify_limits.hpp"

namespace liesl {

/// Analyses the final outline, as it is, on twice the cells in each direction and, where they can
/// be halved, on half of them, whose difference shows the order. With R of the given grid and R_f
/// of the finer one, p the order (1: an outline passes through cells),
///
///   error = |R - R_f| / (1 - 2^-p),
///
/// that of the fraction law and of the elements. Adds `error_mesh` to the limits, `verification`,
/// the errors of the objective and its terms, and `worst_constraint_error`.
/// @param read of the study with other cells
/// @returns one a limit; empty, with a warning that says why, where the part has no finer grid or
/// the outline leaves no part on one
std::vector<VerifiedLimit> verify_part(OptimizeOutcome& out, const Study& study,
                                       const ReadStudy& read);

}  // namespace liesl
