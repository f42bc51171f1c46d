#pragma once
/// @file
/// The limited responses of a study's equilibria, with their sensitivities.

#include "optim/nlp/problem.hpp"
#include "optim/problems/design_run.hpp"

namespace liesl {

/// g_r = |y_r| / limit - 1 of each limit at the load step where it is largest at the start design;
/// dg by `static_sensitivity`. The objective is 0. Every value is a run.
template <FrameGroup G>
class EquilibriumLimits final : public Problem {
 public:
  /// @pre the simulator is of equilibria and outlives this
  /// @throws std::runtime_error if the start design has no equilibria
  EquilibriumLimits(const DesignSimulator<G>& simulator, const StudySpec& study);

  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  /// NaN where a design has no equilibria.
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override;
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override;

 private:
  const DesignSimulator<G>& simulator_;
  const StudySpec& study_;
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_;
  std::vector<int> record_;  ///< by constraint
  DesignRun<G> run_;         ///< of the latest values
};

extern template class EquilibriumLimits<SE2>;
extern template class EquilibriumLimits<SE3>;

}  // namespace liesl
