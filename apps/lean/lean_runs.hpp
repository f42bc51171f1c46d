#pragma once
/// @file
/// What the stages of a search for the leanest model share: measured runs, the reference that they
/// are compared with, the model so far.

#include <functional>
#include <string>

#include "apps/lean/lean_result.hpp"
#include "apps/lean/trial.hpp"

namespace liesl {

/// Share of the tolerance that is left to the error of the reference.
inline constexpr double kReferenceShare = 0.2;

/// The runs of one search. `result` collects what is decided, `lean` is the model so far.
class LeanRuns {
 public:
  LeanRuns(Trials& trials, double tolerance,
           const std::function<void(const Decision&)>& on_decision)
      : trials_(trials), tolerance_(tolerance), on_decision_(on_decision) {}

  LeanResult result;
  Setting lean;

  double tolerance() const { return tolerance_; }
  /// What the error of the reference leaves of the tolerance.
  double budget() const { return tolerance_ - result.reference_error; }
  bool dynamic() const { return result.given.steps > 0; }

  const Trial& trial(const Setting& s) { return trials_.run(changes(s, result.given)); }
  /// The scene with the changes of a setting. @throws InputError
  Scene scene(const Setting& s) const { return trials_.scene(changes(s, result.given)); }
  Trials::Times times(const Setting& a, const Setting& b) {
    return trials_.times(changes(a, result.given), changes(b, result.given));
  }
  std::string fault(const Setting& s) { return trials_.fault(changes(s, result.given)); }
  /// Relative distance of the responses of two settings; infinite if one does not run.
  double distance(const Setting& s, const Setting& from);
  /// From the reference.
  double error(const Setting& s) { return distance(s, result.reference); }
  /// Steps that the integrator has to halve are not the steps of the setting.
  bool whole_steps(const Setting& s) { return trial(s).rejected <= trial(result.given).rejected; }
  /// Within the budget, in whole steps.
  bool good(const Setting& s) { return whole_steps(s) && error(s) <= budget(); }
  /// Why a setting is not good, or how good it is.
  std::string verdict(const Setting& s);

  void decide(Decision decision);
  /// The scene as given: no changes yet.
  Scene given_scene() const { return trials_.scene({}); }
  /// The result with a status, the changes and the number of runs.
  LeanResult finish(LeanStatus status, const std::string& reason);

 private:
  Trials& trials_;
  double tolerance_;
  const std::function<void(const Decision&)>& on_decision_;
};

/// "0.123 %", "-" if there is none.
std::string percent(double x);
/// "400 steps of 0.001 s, rod 4 elements".
std::string text_of(const Setting& s);

}  // namespace liesl
