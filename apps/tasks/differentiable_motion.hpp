#pragma once
/// @file
/// A motion that is simulated once and differentiated as often as asked.

#include <memory>
#include <variant>

#include "apps/tasks/motion_gradient.hpp"
#include "apps/tasks/run.hpp"

namespace liesl {

/// n records, P parameters, responses of C components each. Converged as in sensitivity_task.
/// Wherever `progress` is given: false stops, with output::Interrupted from the derivatives.
class DifferentiableMotion {
 public:
  /// @throws std::invalid_argument as sensitivity_task
  DifferentiableMotion(SensitivityProblem problem, const ChosenSpace& space,
                       const Progress& progress = {});

  const SensitivityProblem& problem() const { return problem_; }
  /// As of run_task.
  const RunOutcome& outcome() const { return outcome_; }
  bool good() const { return outcome_.status == SolveStatus::Converged; }

  /// dy/dp at the records by the direct form: of each response n x C x P.
  /// @throws std::runtime_error for a motion that did not converge, or a step without derivatives
  std::vector<std::vector<double>> derivatives(const Progress& progress = {}) const;

  /// sum over responses, records and components of w dy/dp, by the adjoint form: P numbers.
  /// @param weights of each response n x C, or empty: zero  @throws as derivatives
  Eigen::VectorXd pull_back(const std::vector<std::vector<double>>& weights,
                            const Progress& progress = {}) const;

 private:
  template <FrameGroup G>
  using Taped = std::unique_ptr<TapedMotion<G>>;

  template <FrameGroup G>
  void simulate(const Space<G>& space, const SimulationOptions& options, const Progress& progress);
  template <FrameGroup G>
  std::vector<std::vector<double>> derivatives_of(const TapedMotion<G>& motion,
                                                  const Progress& progress) const;
  template <FrameGroup G>
  Eigen::VectorXd pull_back_of(const TapedMotion<G>& motion,
                               const std::vector<std::vector<double>>& weights,
                               const Progress& progress) const;
  void require_good() const;

  SensitivityProblem problem_;
  RunOutcome outcome_;
  std::variant<Taped<SE2>, Taped<SE3>> motion_;
};

}  // namespace liesl
