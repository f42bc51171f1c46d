#pragma once
/// @file
/// The finer model on which a study goes on, where the errors of its limits are more than it
/// allows.

#include "apps/tasks/verify_limits.hpp"

namespace liesl {

struct FinerModel {
  std::vector<std::string> changes = {};  ///< empty: the model is fine enough, the design is not
  bool mesh = false, step = false;        ///< what gets smaller (order 4 is neither)
  std::string exhausted = {};             ///< why there is no finer model; else empty
};

/// Brings both errors of each limit that is not certain below a quarter of what the study allows:
/// the other half is left to the design. Beams take order 4 first, where they can, then more
/// elements: a factor of (error / allowed)^(1/p), p the order, as a power of two of at most 8.
/// Where more elements or steps than there is room for would be needed even then, there is none.
/// @param before changes that `study` has been read with
FinerModel finer_model(const Study& study, const std::vector<VerifiedLimit>& limits,
                       double feasibility, const std::vector<std::string>& before,
                       const ReadStudy& read);

/// What an earlier refinement should have made smaller and has not; empty: all of it.
/// @param refined what was refined since `before`
std::string not_converging(const std::vector<VerifiedLimit>& before,
                           const std::vector<VerifiedLimit>& now, const FinerModel& refined,
                           double feasibility);

}  // namespace liesl
