#pragma once
/// @file
/// The task of `liesl sensitivity`: derivatives of the responses of a motion by parameters, over
/// time and of functionals. No files, no printing.

#include <functional>
#include <memory>

#include "apps/output/summary.hpp"
#include "apps/scene/scene_key.hpp"
#include "apps/scene/space.hpp"
#include "apps/tasks/sensitivity_problem.hpp"
#include "mbs/solvers/simulation.hpp"

namespace liesl {

class Design;
struct Study;

/// Of a scene by keys as `--set` has them, "sections.rod.diameter".
/// @throws InputError for keys without a number, or without a derivative
SensitivityProblem scene_problem(const SceneText& text, const std::vector<std::string>& keys);
/// Of a study by its variables at their start; its limits are responses, too.
SensitivityProblem study_problem(const Study& study);
#ifdef LIESL_OPTIM
/// The limits of a study, then the responses of one of its scenes that have other names.
std::vector<ResponseSpec> study_responses(const Study& study, const Scene& scene);
/// The same of a motion of a study, at the design x.
/// @param scene of one of its scenarios
SensitivityProblem study_problem(const Study& study, const Scene& scene,
                                 const std::shared_ptr<const Design>& design,
                                 const Eigen::VectorXd& x);
#endif

/// Of the states, for 1e-6 in the gradients: simulations are converged to it, or to what the scene
/// asks for if that is less.
inline constexpr double kSensitivityTolerance = 1e-8;

/// The form that is faster for so many parameters and gradients, by what they cost in
/// docs/sensitivities.md. @returns Direct or Adjoint
SensitivityMethod faster_method(std::size_t parameters, std::size_t functionals);

struct SensitivityOutcome {
  SolveStatus status = SolveStatus::Converged;
  output::RunSummary summary;
  SensitivityMethod method = SensitivityMethod::Direct;  ///< that was used
  output::Sensitivities result;                          ///< empty unless the motion converged
};

/// Converges the motion to kSensitivityTolerance, or to simulation.tolerance if that is less.
/// @throws InputError for a scene that is no motion, or has no responses
/// @throws std::invalid_argument for a motion without sensitivities
SensitivityOutcome sensitivity_task(const SensitivityProblem& problem, const ChosenSpace& space,
                                    const SensitivityRequest& request,
                                    const Progress& progress = {});

/// The gradients against central differences of whole simulations, one variable after another;
/// peaks at the step where they are.
struct SensitivityCheck {
  bool right = false;
  std::string text;  ///< a table, and a verdict
};
struct SensitivityCheckOptions {
  bool fits = false;  ///< polynomials fitted to 120 differences, too: 240 motions a parameter
  std::function<void(double)> progress;  ///< called with the share that is done
};
/// @throws std::runtime_error if the motion does not converge; in a build without optimisation
SensitivityCheck sensitivity_check(const SensitivityProblem& problem, const ChosenSpace& space,
                                   const SensitivityRequest& request,
                                   const SensitivityCheckOptions& options = {});

}  // namespace liesl
