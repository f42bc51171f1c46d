#pragma once
/// @file
/// One degree of freedom on two springs in parallel: k = x1 + 0.9 x2, m = 0.8 x1 + 0.1 x2, cost
/// x1 + x2, force cos t, |u| <= 1. The steady response is u = cos t / (k - m).
/// Source: after M. Stolpe, On the equivalent static loads approach for dynamic response structural
/// optimization, Struct. Multidisc. Optim. 50 (2014).
///
/// Dynamic problem: 1/(0.2 x1 + 0.8 x2) <= 1, optimum (0, 1.25). Static problem of the cycle at
/// (5, 0): load k u = 5, so 5/(x1 + 0.9 x2) <= 1, optimum (5, 0), where the cycle stops.

#include <string>

#include "optim/nlp/problem.hpp"

namespace liesl::test {

class TwoSprings : public Problem {
 public:
  /// |u| = load / (a1 x1 + a2 x2)
  TwoSprings(double load, double a1, double a2) : load_(load), a_(a1, a2) {
    variables_ = {{"x1", 0, 10, 4}, {"x2", 0, 10, 4}};
    constraints_ = {{1, "displacement"}};
  }
  static TwoSprings dynamic() { return {1, 0.2, 0.8}; }
  static TwoSprings equivalent_static() { return {5, 1, 0.9}; }

  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override {
    f = x.sum();
    g[0] = load_ / a_.dot(x) - 1;
  }
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override {
    df.setOnes();
    const double stiffness = a_.dot(x);
    dg.row(0) = -load_ / (stiffness * stiffness) * a_.transpose();
  }

 private:
  double load_;
  Eigen::Vector2d a_;
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_;
};

}  // namespace liesl::test
