#pragma once
/// @file
/// Errors of the limits of a final design by mesh and step.

#include "apps/tasks/optimize.hpp"
#include "apps/tasks/verify.hpp"

namespace liesl {

constexpr double kAlike = 1e-3;  ///< of a limit: two simulations of one design

/// Reads the study again with changes "key.path=value". @throws InputError
using ReadStudy = std::function<Study(const std::vector<std::string>& changes)>;

/// A limit on a largest value at the final design; figures relative to the limit.
struct VerifiedLimit {
  std::string name;                                        ///< with its scenario, if there are some
  double violation = 0;                                    ///< measured, as of the summary
  double mesh = 0, step = 0;                               ///< errors, 0 where they are not known
  std::optional<double> mesh_order = {}, step_order = {};  ///< observed
  bool known = true;                                       ///< are both errors?
  double joints = 0;  ///< share by which penalties let joints open

  double error() const { return mesh + step + joints; }
  /// Is it met on the converged model as far as the errors tell?
  bool certain(double feasibility) const { return known && violation + error() <= feasibility; }
  /// "limit bending is known to 1.7 % only: mesh 1.7 %, step 0.001 %"
  std::string text() const;
  /// "a smaller step makes it certain": by what is the larger error, and by what the mechanism has.
  std::string remedy(const Mechanism& mechanism) const;
};

/// The one that may be violated most: of the largest violation + error. @pre there is one
const VerifiedLimit& nearest_limit(const std::vector<VerifiedLimit>& limits);

/// Warns that the limits are not verified. @returns none
std::vector<VerifiedLimit> not_verified(OptimizeOutcome& out, const std::string& why);

/// The limits that a verification finds, and as a share of its limit the error of the nearest one
/// (`worst_constraint_error`, unless an error of it is not known). The optimum stands whatever it
/// throws, a request to stop too: `not_verified`.
std::vector<VerifiedLimit> verified_limits(
    OptimizeOutcome& out, const std::function<std::vector<VerifiedLimit>()>& verification);

/// Runs the final design in every scenario as a scene on finer meshes and steps (`verify`): adds
/// `error_mesh`, `error_step` to the limits and `verification`; of terms of the objective `error`
/// in `terms` and, if all are known, in `objective`. Limits on functionals, p-norms, frequencies
/// and meshed parts are not verified: not known, with a warning.
/// @pre out.simulated
/// @returns one a limit and scenario; empty where there are none or the runs did not reach their
/// end
std::vector<VerifiedLimit> verify_limits(OptimizeOutcome& out, const Study& study,
                                         const Progress& progress = {});

/// Warns of each limit whose error is more than the study allows (cycle.feasibility), where it
/// matters, unless a warning tells of it already. @param way what the user may do; empty: nothing
/// more
void warn_of_errors(const std::vector<VerifiedLimit>& limits, double feasibility,
                    const Mechanism& mechanism, const std::string& way,
                    std::vector<std::string>& warnings);

}  // namespace liesl
