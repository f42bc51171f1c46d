#pragma once
/// @file
/// Limits on the mass of bodies in studies of motions.

#include "optim/cycle/static_problem.hpp"
#include "optim/design/design.hpp"

namespace liesl {

/// Rows mass/limit - 1 <= 0, exact at every x (without second derivatives). The objective is 0.
class MassProblem final : public StaticProblem {
 public:
  MassProblem(const Mechanism& mechanism, const Design& design,
              const std::vector<MassLimitSpec>& limits, const Eigen::VectorXd& x);

  int add_violated(const Eigen::VectorXd&, double) override { return 0; }
  int load_cases() const override { return 0; }
  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override;
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override;
  HessianShape hessian_shape() const override { return HessianShape::Dense; }
  void hessian(const Eigen::VectorXd&, double, const Eigen::VectorXd&, Eigen::MatrixXd&) override {}

 private:
  const Mechanism& mechanism_;
  const Design& design_;
  const std::vector<MassLimitSpec> limits_;
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_;
};

}  // namespace liesl
