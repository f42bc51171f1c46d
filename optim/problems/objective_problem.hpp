#pragma once
/// @file
/// What a study minimises besides mass, near a design: duration and effort of the drives.

#include "optim/problems/static_problem.hpp"

namespace liesl {

/// w_T T + w_e J of the motion at one design: J = sum over responses of int v^2 dt.
struct ObjectiveModel {
  int duration = -1;  ///< variable T; -1: it stays, and does not count
  double weight_duration = 0, weight_effort = 0;
  double effort = 0;
  Eigen::VectorXd by_effort;  ///< dJ/dx
  double extremes = 0;        ///< of largest values and lowest frequencies: rows tell their change
};

/// minimise extremes + w_T T + w_e J exp(sum_i c_i s_i), c = dJ/dx / J at x_k, without constraints;
/// s as in CorrectedProblem: a power of the variables, positive everywhere.
class ObjectiveProblem final : public CaselessProblem {
 public:
  ObjectiveProblem(ObjectiveModel model, const Eigen::VectorXd& x_k,
                   const std::vector<NlpVariable>& variables)
      : CaselessProblem(variables), model_(std::move(model)), x_k_(x_k) {}

  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd&) override;
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix&) override;
  void hessian(const Eigen::VectorXd& x, double sigma, const Eigen::VectorXd&,
               Eigen::MatrixXd& h) override;

 private:
  /// J of the model, its exponent's gradient q and second derivatives (a diagonal).
  struct Effort {
    double value = 0;
    Eigen::VectorXd first, second;
  };
  Effort effort(const Eigen::VectorXd& x) const;

  const ObjectiveModel model_;
  const Eigen::VectorXd x_k_;
};

}  // namespace liesl
