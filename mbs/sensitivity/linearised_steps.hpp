#pragma once
/// @file
/// Linearisations of the steps of a motion, several at a time: each follows from the two states of
/// its step alone, so that only the solutions with them have to wait for each other.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mbs/sensitivity/step_sensitivity.hpp"

namespace liesl {

/// How it ended: `reason` is empty if all steps were differentiated.
struct SensitivityEnd {
  std::string reason;
  bool complete() const { return reason.empty(); }
};

/// Successive steps, from states[k] to states[k + 1] of size h[k].
template <FrameGroup G>
struct Steps {
  std::vector<State<G>> states;
  std::vector<double> h;  ///< s
};

template <FrameGroup G>
class LinearisedSteps {
 public:
  /// @throws std::invalid_argument as StepSensitivity
  LinearisedSteps(const Model<G>& model, double rho_inf);

  /// Called with step k, linearised; false: its equations have no finite solution.
  using Take = std::function<bool(StepSensitivity<G>& step, size_t k)>;
  /// Linearises and factors the steps on the threads of the process, and calls `take` for each in
  /// their order, or from the last to the first, one call at a time. The results are the same
  /// whatever the number of threads: which factors a step takes its pivots from follows from its
  /// number.
  SensitivityEnd run(const Steps<G>& steps, bool backwards, const Take& take);

  /// For the start of the motion, which is linearised by itself.
  StepSensitivity<G>& start() { return *lanes_.front(); }

 private:
  SensitivityEnd linearise(const Steps<G>& steps, size_t k, StepSensitivity<G>& lane) const;
  SensitivityEnd solve(const Steps<G>& steps, size_t k, StepSensitivity<G>& lane,
                       const Take& take) const;

  std::vector<std::unique_ptr<StepSensitivity<G>>> lanes_;  ///< steps at once
  size_t done_ = 0;                                         ///< steps of earlier runs
};

extern template class LinearisedSteps<SE2>;
extern template class LinearisedSteps<SE3>;

}  // namespace liesl
