#pragma once
/// @file
/// The gradients of a study's first static problem against finite differences.

#include <stdexcept>

#include "mbs/solvers/simulation.hpp"
#include "optim/cycle/static_sizing.hpp"
#include "optim/nlp/check_derivatives.hpp"

namespace liesl {

/// Simulates the start design, makes its static problem and sweeps the step of every variable.
/// @throws std::runtime_error if the start design cannot be simulated
template <FrameGroup G>
DerivativeReport check_study_derivatives(const Mechanism& mechanism, const Space<G>& space,
                                         const SimulationOptions& simulation,
                                         const StudySpec& study) {
  const Sizing sizing(study.design, mechanism);
  Eigen::VectorXd x(sizing.size());
  for (int i = 0; i < x.size(); ++i) x[i] = sizing.variables()[i].start;
  const Mechanism sized = sizing.apply(mechanism, x);
  Model<G> model = Model<G>::build(sized, space);
  const Simulation<G> run = run_simulation(model, simulation);
  if (run.report.status != SolveStatus::Converged)
    throw std::runtime_error("the start design cannot be simulated: " + run.report.reason);
  const std::vector<LoadSet> loads = [&] {
    std::vector<LoadSet> sets;
    for (const int body : limited_bodies(study))
      sets.push_back(extract_loads(model, run.trajectory, body));
    return sets;
  }();
  const Analysis<G> at{sized, &model, &run.trajectory, loads};
  StaticSizing<G> problem(at, sizing, study, x, study.cycle.move_limit);
  DerivativeCheckOptions options;
  options.every_variable = true;
  return check_derivatives(problem, x, options);
}

}  // namespace liesl
