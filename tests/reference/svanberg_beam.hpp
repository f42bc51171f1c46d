#pragma once
/// @file
/// Svanberg's cantilever of five hollow square segments: side x_j, weight 0.0624 sum x_j, tip
/// displacement 61/x_1^3 + 37/x_2^3 + 19/x_3^3 + 7/x_4^3 + 1/x_5^3 <= 1.
/// Source: K. Svanberg, The method of moving asymptotes, Int. J. Numer. Meth. Engng 24 (1987),
/// problem 1; optimum recomputed to 10 digits from the optimality conditions.

#include <array>
#include <cmath>
#include <string>

#include "optim/nlp/problem.hpp"

namespace liesl::test {

class SvanbergBeam : public Problem {
 public:
  static constexpr double optimum = 1.3399563606;
  static constexpr std::array<double, 5> solution{6.016015894, 5.309173857, 4.494329573,
                                                  3.501474970, 2.152665330};

  /// @param unit length of the variables' unit: 1e-3 gives x in thousandths
  /// @param shape HessianShape::None hides the Hessian
  explicit SvanbergBeam(double unit = 1, HessianShape shape = HessianShape::Diagonal,
                        double limit = 1)
      : unit_(unit), shape_(shape), limit_(limit) {
    for (int j = 1; j <= 5; ++j)
      variables_.push_back({"x" + std::to_string(j), 1 / unit, 10 / unit, 5 / unit});
    constraints_.push_back({7, "tip displacement"});
  }

  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  HessianShape hessian_shape() const override { return shape_; }

  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override {
    f = kWeight * unit_ * x.sum();
    g[0] = -limit_;
    for (int j = 0; j < 5; ++j) g[0] += kLoad[j] * std::pow(unit_ * x[j], -3);
  }

  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override {
    df.setConstant(kWeight * unit_);
    for (int j = 0; j < 5; ++j) dg(0, j) = -3 * unit_ * kLoad[j] * std::pow(unit_ * x[j], -4);
  }

  void hessian(const Eigen::VectorXd& x, double, const Eigen::VectorXd& lambda,
               Eigen::MatrixXd& h) override {
    for (int j = 0; j < 5; ++j)
      h(j, j) = lambda[0] * 12 * unit_ * unit_ * kLoad[j] * std::pow(unit_ * x[j], -5);
  }

 private:
  static constexpr double kWeight = 0.0624;
  static constexpr std::array<double, 5> kLoad{61, 37, 19, 7, 1};
  double unit_;
  HessianShape shape_;
  double limit_;
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_;
};

}  // namespace liesl::test
