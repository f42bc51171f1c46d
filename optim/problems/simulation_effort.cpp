#include "optim/problems/simulation_effort.hpp"

#include <algorithm>

namespace liesl {

SimulationEffort& SimulationEffort::operator+=(const SimulationEffort& more) {
  steps += more.steps;
  newton_iterations += more.newton_iterations;
  stepping_s += more.stepping_s;
  sensitivities += more.sensitivities;
  factorizations.resize(std::max(factorizations.size(), more.factorizations.size()));
  for (std::size_t b = 0; b < more.factorizations.size(); ++b)
    factorizations[b] += more.factorizations[b];
  return *this;
}

}  // namespace liesl
