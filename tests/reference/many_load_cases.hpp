#pragma once
/// @file
/// A sizing problem of the shape that equivalent static loads give: n variables, m load cases,
///     minimise sum_j x_j   subject to   sum_j a_ij / x_j - 1 <= 0,
/// a_ij = (1 + cos(phase_i + 2 pi j / n)) / 10 + noise, so that many cases are nearly active.

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "optim/nlp/problem.hpp"

namespace liesl::test {

class ManyLoadCases : public Problem {
 public:
  ManyLoadCases(int n, int m, HessianShape shape = HessianShape::Dense) : shape_(shape), a_(m, n) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> noise(0, 0.02);
    for (int i = 0; i < m; ++i) {
      const double phase = 6 * std::numbers::pi * i / m;
      for (int j = 0; j < n; ++j)
        a_(i, j) = 0.1 * (1 + std::cos(phase + 2 * std::numbers::pi * j / n)) + noise(random);
      constraints_.push_back({static_cast<ConstraintId>(i), "case " + std::to_string(i), 1});
    }
    for (int j = 0; j < n; ++j) variables_.push_back({"x" + std::to_string(j), 0.1, 20, 8});
  }

  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  HessianShape hessian_shape() const override { return shape_; }

  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override {
    f = x.sum();
    g = (a_ * x.cwiseInverse()).array() - 1;
  }
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override {
    df.setOnes();
    dg = -a_ * x.array().square().inverse().matrix().asDiagonal();
  }
  void hessian(const Eigen::VectorXd& x, double, const Eigen::VectorXd& lambda,
               Eigen::MatrixXd& h) override {
    h.diagonal() = 2 * (a_.transpose() * lambda).cwiseQuotient(x.array().cube().matrix());
  }

 private:
  HessianShape shape_;
  RowMatrix a_;
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_;
};

}  // namespace liesl::test
