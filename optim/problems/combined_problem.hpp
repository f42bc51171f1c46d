#pragma once
/// @file
/// Static problems of several parts as one: their constraints side by side, their objectives added.

#include <memory>

#include "optim/problems/static_problem.hpp"

namespace liesl {

/// minimise sum_k w_k f_k(x_k) subject to g_k(x_k) <= 0, where x_k is a segment of x: that of a
/// part, or all of x for what is said of the whole design. Members that share variables share the
/// narrowest of their bounds. Second derivatives if every member has them.
class CombinedProblem final : public StaticProblem {
 public:
  struct Member {
    std::unique_ptr<StaticProblem> problem;
    double weight = 1;  ///< of its objective; 0: its mass does not count
    int first = 0;      ///< where its variables begin in x
  };
  /// @pre the members cover x
  explicit CombinedProblem(std::vector<Member> members);

  int add_violated(const Eigen::VectorXd& x, double tolerance) override;
  int add_records(const std::vector<std::set<int>>& records) override;
  int load_cases() const override;
  std::vector<LimitedResponse> responses() const override;
  std::vector<RowImage> images() const override;
  std::vector<ObjectiveTerm> objective_terms() const override;
  std::string undefined_reason() const override;  ///< the first of a member

  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override;
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override;
  HessianShape hessian_shape() const override;
  void hessian(const Eigen::VectorXd& x, double sigma, const Eigen::VectorXd& lambda,
               Eigen::MatrixXd& h) override;

 private:
  struct Place {
    int x = 0, variables = 0;      ///< first variable, how many
    int row = 0, constraints = 0;  ///< first constraint, how many
  };
  void take_variables();
  void take_constraints();

  std::vector<Member> members_;
  std::vector<Place> places_;
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_;
};

/// The members as one problem: a single one as it is.
std::unique_ptr<StaticProblem> combined(std::vector<CombinedProblem::Member> members);

}  // namespace liesl
