#pragma once
/// @file
/// One simulation with its sensitivities: histories of responses, dy/dp over time, and gradients of
/// functionals by either form.

#include "apps/tasks/sensitivity_problem.hpp"
#include "mbs/sensitivity/response_sensitivity.hpp"
#include "mbs/solvers/simulation.hpp"

namespace liesl {

/// A simulated motion with the responses at every accepted step.
template <FrameGroup G>
struct TapedMotion {
  Mechanism mechanism;
  Model<G> model;
  Tape<G> tape;
  Simulation<G> simulation;
  Eigen::VectorXd times;                   ///< of all steps, s
  std::vector<double> recorded;            ///< of the records, s
  std::vector<Eigen::MatrixXd> histories;  ///< by response, components x steps

  TapedMotion(const Mechanism& of, const Space<G>& space, const SimulationOptions& options,
              const std::vector<ResponseSpec>& responses, const Progress& progress = {});
  bool good() const { return simulation.report.status == SolveStatus::Converged; }
};

/// The value of a functional of a response of the motion.
/// @param peak see `evaluate`
template <FrameGroup G>
FunctionalValue functional_value(const TapedMotion<G>& motion, std::size_t response,
                                 const FunctionalSpec& functional, int peak = -1);

/// Fills dy/dp over time (direct form only) and the gradients. @returns the termination status
template <FrameGroup G>
SensitivityEnd differentiate(const TapedMotion<G>& motion, const SensitivityProblem& problem,
                             const SensitivityRequest& request, SensitivityMethod method,
                             output::Sensitivities& out);

extern template struct TapedMotion<SE2>;
extern template struct TapedMotion<SE3>;
extern template FunctionalValue functional_value(const TapedMotion<SE2>&, std::size_t,
                                                 const FunctionalSpec&, int);
extern template FunctionalValue functional_value(const TapedMotion<SE3>&, std::size_t,
                                                 const FunctionalSpec&, int);
extern template SensitivityEnd differentiate(const TapedMotion<SE2>&, const SensitivityProblem&,
                                             const SensitivityRequest&, SensitivityMethod,
                                             output::Sensitivities&);
extern template SensitivityEnd differentiate(const TapedMotion<SE3>&, const SensitivityProblem&,
                                             const SensitivityRequest&, SensitivityMethod,
                                             output::Sensitivities&);

}  // namespace liesl
