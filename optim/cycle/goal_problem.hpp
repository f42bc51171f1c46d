#pragma once
/// @file
/// What a study minimises besides mass, near a design: duration and effort of the drives.

#include "optim/cycle/static_problem.hpp"

namespace liesl {

/// w_T T + w_e J of the motion at one design: J = sum over responses of int v^2 dt.
struct MotionGoal {
  int duration = -1;  ///< variable T; -1: it stays, and does not count
  double weight_duration = 0, weight_effort = 0;
  double effort = 0;
  Eigen::VectorXd by_effort;  ///< dJ/dx
  double extremes = 0;        ///< of largest values and lowest frequencies: rows tell their change
};

/// minimise extremes + w_T T + w_e J exp(sum_i c_i s_i), c = dJ/dx / J at x_k, without constraints;
/// s as in CorrectedProblem: a power of the variables, positive everywhere.
class GoalProblem final : public StaticProblem {
 public:
  GoalProblem(MotionGoal goal, const Eigen::VectorXd& x_k,
              const std::vector<NlpVariable>& variables)
      : goal_(std::move(goal)), x_k_(x_k), variables_(variables) {}

  int add_violated(const Eigen::VectorXd&, double) override { return 0; }
  int load_cases() const override { return 0; }
  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return none_; }
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd&) override;
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix&) override;
  HessianShape hessian_shape() const override { return HessianShape::Dense; }
  void hessian(const Eigen::VectorXd& x, double sigma, const Eigen::VectorXd&,
               Eigen::MatrixXd& h) override;

 private:
  /// J of the model, its exponent's gradient q and second derivatives (a diagonal).
  struct Effort {
    double value = 0;
    Eigen::VectorXd first, second;
  };
  Effort effort(const Eigen::VectorXd& x) const;

  const MotionGoal goal_;
  const Eigen::VectorXd x_k_;
  const std::vector<NlpVariable> variables_;
  const std::vector<NlpConstraint> none_;
};

}  // namespace liesl
