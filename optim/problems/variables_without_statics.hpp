#pragma once
/// @file
/// Variables that no static problem of a part has (VariableGroup::has_statics), constants of the
/// motion among them, in the static problem of a design: they carry no static limit, their mass
/// counts.

#include "optim/problems/static_problem.hpp"

namespace liesl {

/// minimise `by` . x, without constraints, within `move` of the range of each variable about x.
class VariablesWithoutStatics final : public CaselessProblem {
 public:
  /// @param by d(mass)/dx at x, kg per unit of each variable
  VariablesWithoutStatics(const std::vector<NlpVariable>& variables, Eigen::VectorXd by,
                          const Eigen::VectorXd& x, double move);

  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd&) override { f = df_.dot(x); }
  void gradients(const Eigen::VectorXd&, Eigen::VectorXd& df, RowMatrix&) override { df = df_; }

 private:
  Eigen::VectorXd df_;
};

}  // namespace liesl
