#pragma once
/// @file
/// Springs, dampers and rigid masses in the static problem of a design: they carry no static limit,
/// and masses count.

#include "optim/cycle/static_problem.hpp"
#include "optim/design/constants.hpp"

namespace liesl {

/// minimise the counted rigid masses, without constraints, within `move` of the range of each
/// variable about x.
class ConstantsProblem final : public StaticProblem {
 public:
  ConstantsProblem(const Constants& constants, const std::vector<int>& counted,
                   const Eigen::VectorXd& x, double move);

  int add_violated(const Eigen::VectorXd&, double) override { return 0; }
  int load_cases() const override { return 0; }
  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return none_; }
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd&) override { f = df_.dot(x); }
  void gradients(const Eigen::VectorXd&, Eigen::VectorXd& df, RowMatrix&) override { df = df_; }
  HessianShape hessian_shape() const override { return HessianShape::Dense; }
  void hessian(const Eigen::VectorXd&, double, const Eigen::VectorXd&, Eigen::MatrixXd&) override {}

 private:
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> none_;
  Eigen::VectorXd df_;
};

}  // namespace liesl
