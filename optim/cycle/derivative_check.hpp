#pragma once
/// @file
/// The gradients of a study's first static problem, and of its equilibria, against finite
/// differences.

#include <algorithm>
#include <stdexcept>

#include "optim/nlp/check_derivatives.hpp"
#include "optim/problems/equilibrium_limits.hpp"
#include "optim/problems/motion_problem.hpp"

namespace liesl {

/// Simulates the start design, makes its static problem and sweeps the step of every variable.
/// @throws std::runtime_error if the start design cannot be simulated
template <FrameGroup G>
DerivativeReport check_study_derivatives(const Mechanism& mechanism, const Space<G>& space,
                                         const SimulationOptions& simulation,
                                         const StudySpec& study) {
  const DesignSimulator<G> simulator(mechanism, space, simulation, study);
  const Eigen::VectorXd x = simulator.design().start();
  const DesignRun<G> run = simulator.run(x);
  if (!run.good())
    throw std::runtime_error("the start design cannot be simulated: " + run.reason());
  DerivativeCheckOptions options;
  options.every_variable = true;
  const auto problem = motion_problem(study, simulator, run, x, study.cycle.move_limit);
  return check_derivatives(*problem, x, options);
}

/// Sweeps the step of every variable for the limits of the equilibria of the start design, solved
/// to 1e-12 so that differences tell.
/// @pre simulation.type is Static  @throws std::runtime_error if the start design has no
/// equilibria, std::invalid_argument if the formalism has no sensitivities
template <FrameGroup G>
DerivativeReport check_equilibrium_derivatives(const Mechanism& mechanism, const Space<G>& space,
                                               SimulationOptions simulation,
                                               const StudySpec& study) {
  simulation.tolerance = std::min(simulation.tolerance, 1e-12);
  const DesignSimulator<G> simulator(mechanism, space, simulation, study);
  EquilibriumLimits<G> problem(simulator, study);
  DerivativeCheckOptions options;
  options.every_variable = true;
  return check_derivatives(problem, simulator.design().start(), options);
}

}  // namespace liesl
