#pragma once
/// @file
/// The fully coupled method (thesis section 3.3): no static problem between two simulations.

#include <memory>

#include "optim/cycle/static_problem.hpp"

namespace liesl {

/// A static problem whose rows of the motion are constant, as they are at x_k: what is left is the
/// objective, walls and limits of the parts. CorrectedProblem gives the rows their gradients.
class CoupledProblem final : public StaticProblem {
 public:
  /// @param inner at x_k
  CoupledProblem(std::unique_ptr<StaticProblem> inner, const Eigen::VectorXd& x_k);

  int add_violated(const Eigen::VectorXd& x, double tolerance) override;
  int load_cases() const override { return inner_->load_cases(); }
  std::vector<LimitedResponse> responses() const override { return inner_->responses(); }
  std::vector<RowImage> images() const override { return inner_->images(); }
  std::string obstacle() const override { return inner_->obstacle(); }

  const std::vector<NlpVariable>& variables() const override { return inner_->variables(); }
  const std::vector<NlpConstraint>& constraints() const override { return inner_->constraints(); }
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override;
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override;
  HessianShape hessian_shape() const override { return inner_->hessian_shape(); }
  void hessian(const Eigen::VectorXd& x, double sigma, const Eigen::VectorXd& lambda,
               Eigen::MatrixXd& h) override;

 private:
  void take_rows();

  std::unique_ptr<StaticProblem> inner_;
  const Eigen::VectorXd x_k_;
  Eigen::VectorXd g_k_;         ///< at x_k
  std::vector<bool> constant_;  ///< by row
};

}  // namespace liesl
