#pragma once
/// @file
/// The gradients of a study's first static problem against finite differences.

#include <stdexcept>

#include "optim/cycle/design_run.hpp"
#include "optim/cycle/motion_problem.hpp"
#include "optim/nlp/check_derivatives.hpp"

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

}  // namespace liesl
