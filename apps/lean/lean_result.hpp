#pragma once
/// @file
/// What a search for the leanest model decided and measured.

#include <string>
#include <vector>

#include "apps/lean/setting.hpp"

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

/// Is there a lean model, within the tolerance or not?
inline bool has_model(const LeanResult& r) {
  return r.status == LeanStatus::Done || r.status == LeanStatus::Missed;
}

}  // namespace liesl
