#pragma once
/// @file
/// What the simulations of a study have cost.

#include <vector>

namespace liesl {

/// Effort of all simulations.
struct SimulationEffort {
  long steps = 0, newton_iterations = 0;
  double stepping_s = 0;
  std::vector<int> factorizations;  ///< by body
  long sensitivities = 0;           ///< motions that were differentiated

  SimulationEffort& operator+=(const SimulationEffort& more);
};

}  // namespace liesl
