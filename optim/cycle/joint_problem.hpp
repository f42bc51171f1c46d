#pragma once
/// @file
/// Static problems of several parts as one: their variables and constraints side by side, their
/// objectives added.

#include <memory>

#include "optim/cycle/static_problem.hpp"

namespace liesl {

/// minimise sum_k w_k f_k(x_k) subject to g_k(x_k) <= 0 with x = (x_1, x_2, ...). The parts meet in
/// the optimiser only: each load belongs to one part. No second derivatives.
class JointProblem final : public StaticProblem {
 public:
  struct Member {
    std::unique_ptr<StaticProblem> problem;
    double weight = 1;  ///< of its objective; 0: its mass does not count
  };
  explicit JointProblem(std::vector<Member> members);

  int add_violated(const Eigen::VectorXd& x, double tolerance) override;
  int load_cases() const override;
  std::vector<LimitedResponse> responses() const override;
  std::vector<RowImage> images() const override;
  std::string obstacle() const override;  ///< the first of a member

  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override;
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override;

 private:
  struct Place {
    int x = 0, variables = 0;      ///< first variable, how many
    int row = 0, constraints = 0;  ///< first constraint, how many
  };
  void take_constraints();

  std::vector<Member> members_;
  std::vector<Place> places_;
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_;
};

}  // namespace liesl
