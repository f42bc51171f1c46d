#pragma once
/// @file
/// Limits on the natural frequencies of a mechanism in a pose.

#include "mbs/solvers/pose_modes.hpp"
#include "optim/cycle/static_problem.hpp"
#include "optim/design/design.hpp"

namespace liesl {

/// The lowest frequencies of a design, Hz; empty, with the reason, where there are none.
std::vector<double> lowest_frequencies(const Mechanism& designed, const SimulationOptions& options,
                                       const FrequencyLimitSpec& limit, std::string& reason);

/// Rows 1 - f_i/least <= 0 of the lowest frequencies, exact at every x (without second derivatives:
/// frequencies are nearly linear in dimensions of sections). The objective is 0. Those with a
/// weight are rows of a goal, numbered from `first_goal` on.
class FrequencyProblem final : public StaticProblem {
 public:
  FrequencyProblem(const Mechanism& mechanism, const Design& design,
                   const SimulationOptions& options, const std::vector<FrequencyLimitSpec>& limits,
                   const Eigen::VectorXd& x, int first_goal = 0);

  int add_violated(const Eigen::VectorXd&, double) override { return 0; }
  int load_cases() const override { return 0; }
  std::string undefined_reason() const override { return reason_; }
  std::vector<RowGoal> goals() const override { return goals_; }
  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override;
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override;
  HessianShape hessian_shape() const override { return HessianShape::Dense; }
  void hessian(const Eigen::VectorXd&, double, const Eigen::VectorXd&, Eigen::MatrixXd&) override {}

 private:
  /// Rows at x, with gradients if asked for.
  void evaluate(const Eigen::VectorXd& x, Eigen::VectorXd* g, RowMatrix* dg);

  const Mechanism& mechanism_;
  const Design& design_;
  const SimulationOptions options_;
  const std::vector<FrequencyLimitSpec> limits_;
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_;
  std::vector<RowGoal> goals_;
  std::string reason_;
};

}  // namespace liesl
