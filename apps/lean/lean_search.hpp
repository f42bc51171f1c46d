#pragma once
/// @file
/// The leanest model of a scene that is good enough for one response.
///
/// A run costs time, so the search goes from cheap to costly and measures only what decides:
///   1. the scene as given; planar if a plane holds it;
///   2. a reference: mesh and step refined together until Richardson's estimate of its error is a
///      fifth of the tolerance, r = |R_ref - R_exact| <= tol / 5;
///   3. beams made rigid one at a time, then those that hardly matter together;
///   4. mesh and step: Richardson's estimates of each say where to start (`cheapest`); from there
///      every number is made coarser until |R - R_ref| <= tol - r fails;
///   5. flexible beams linear with few modes, and tangents, where that is measured to be faster;
///   6. a check on a run twice as fine as the reference, which decided nothing. If it fails, it
///      becomes the reference and 4 to 6 are done again.

#include <functional>
#include <string>
#include <vector>

#include "apps/lean/setting.hpp"
#include "apps/lean/trial.hpp"

namespace liesl {

/// One choice and what it rests on.
struct Decision {
  std::string about;     ///< "space", "reference", "beam crank", "mesh and step", ...
  std::string choice;    ///< "planar", "rigid", ...
  double figure = 0;     ///< measured or estimated, relative to the largest response
  double limit = 0;      ///< what it was compared with; 0: with nothing
  std::string evidence;  ///< one sentence
};

enum class LeanStatus {
  Done,          ///< the tolerance is met on the held-out refinement
  Missed,        ///< it is not, also after refinement
  NotConverged,  ///< no reference: refinement does not settle the response
  Failed         ///< the scene as given does not reach its end
};
/// "done", "tolerance missed", "not converged", "simulation failed"
const char* to_string(LeanStatus status);

struct LeanResult {
  LeanStatus status = LeanStatus::Failed;
  std::string reason;
  Setting given, lean, reference, held_out;
  std::vector<std::string> changes;  ///< "key.path=value" that make the lean model of the scene
  std::vector<Decision> decisions;
  std::vector<std::string> warnings;
  std::string space, space_reason;
  double reference_error = 0;                    ///< Richardson's estimate
  double error = 0, error_given = 0;             ///< against the held-out run
  double time = 0, time_given = 0;               ///< processor time, median of 7 runs, s
  double time_reference = 0, time_held_out = 0;  ///< of their one run each, s
  long corrections = 0, corrections_given = 0;
  int runs = 0;
};

/// Finds the leanest model. `tolerance` in (0, 0.5]; `said` hears each decision as it falls.
/// Statics: only space and mesh are chosen. @throws InputError for modes, arc-length paths and a
/// response that is zero throughout
LeanResult find_lean(Trials& trials, double tolerance,
                     const std::function<void(const Decision&)>& said);

}  // namespace liesl
