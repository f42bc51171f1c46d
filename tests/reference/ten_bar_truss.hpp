#pragma once
/// @file
/// Ten-bar truss, load case 1: bays of 360 in, 100 kip down at nodes 2 and 4, E = 1e7 psi,
/// rho = 0.1 lb/in^3, stresses within +-25 ksi, displacements within +-2 in, areas >= 0.1 in^2.
/// Source: R. T. Haftka & Z. Guerdal, Elements of Structural Optimization (1992); least weight
/// 5060.8537 lb, and a local optimum of 5076.85 lb. Units: in, kip, lb.
///
/// All constraints are linear in the displacements u of K(x) u = P, K = sum x_e k_e b_e b_e^T:
///     r = c^T u,   dr/dx_i = -k_i (b_i^T mu) (b_i^T u),   K mu = c,
///     d2r/dx_i dx_j = k_i k_j [ (b_i^T mu) W_ij (b_j^T u) + (b_j^T mu) W_ij (b_i^T u) ],
/// with W_ij = b_i^T K^-1 b_j.

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <string>

#include "optim/nlp/problem.hpp"

namespace liesl::test {

class TenBarTruss : public Problem {
 public:
  static constexpr double optimum = 5060.8537;
  static constexpr double local_optimum = 5076.85;

  explicit TenBarTruss(HessianShape shape = HessianShape::Dense, double start = 20)
      : shape_(shape) {
    assemble_geometry();
    for (int e = 0; e < kBars; ++e)
      variables_.push_back({"A" + std::to_string(e + 1), 0.1, 40, start});
    for (int d = 0; d < kFree; ++d) add_rows("displacement " + std::to_string(d), d, false);
    for (int e = 0; e < kBars; ++e) add_rows("stress " + std::to_string(e + 1), e, true);
  }

  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  HessianShape hessian_shape() const override { return shape_; }

  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override {
    f = 0.1 * length_.dot(x);
    factor_.compute(b_ * x.cwiseProduct(k_).asDiagonal() * b_.transpose());
    u_ = factor_.solve(load_);
    const Eigen::VectorXd r = output_.transpose() * u_;
    for (int i = 0; i < r.size(); ++i) {
      g[2 * i] = r[i] - 1;
      g[2 * i + 1] = -r[i] - 1;
    }
    if (factor_.info() != Eigen::Success) g.setConstant(std::numeric_limits<double>::quiet_NaN());
  }

  void gradients(const Eigen::VectorXd&, Eigen::VectorXd& df, RowMatrix& dg) override {
    df = 0.1 * length_;
    stretch_ = b_.transpose() * u_;                      // b_e^T u
    adjoint_ = b_.transpose() * factor_.solve(output_);  // b_e^T mu_r
    for (int i = 0; i < output_.cols(); ++i) {
      dg.row(2 * i) = -k_.cwiseProduct(adjoint_.col(i)).cwiseProduct(stretch_).transpose();
      dg.row(2 * i + 1) = -dg.row(2 * i);
    }
  }

  void hessian(const Eigen::VectorXd&, double, const Eigen::VectorXd& lambda,
               Eigen::MatrixXd& h) override {
    Eigen::VectorXd weight(output_.cols());
    for (int i = 0; i < weight.size(); ++i) weight[i] = lambda[2 * i] - lambda[2 * i + 1];
    const Eigen::MatrixXd w = b_.transpose() * factor_.solve(b_);
    const Eigen::VectorXd a = k_.cwiseProduct(adjoint_ * weight), s = k_.cwiseProduct(stretch_);
    h = a.asDiagonal() * w * s.asDiagonal();
    h += Eigen::MatrixXd(h.transpose());
  }

 private:
  static constexpr int kBars = 10, kFree = 8;

  void assemble_geometry() {
    const double node[6][2] = {{720, 360}, {720, 0}, {360, 360}, {360, 0}, {0, 360}, {0, 0}};
    const int bar[kBars][2] = {{5, 3}, {3, 1}, {6, 4}, {4, 2}, {3, 4},
                               {1, 2}, {5, 4}, {6, 3}, {3, 2}, {4, 1}};
    b_.setZero(kFree, kBars);
    length_.resize(kBars);
    for (int e = 0; e < kBars; ++e) {
      const int p = bar[e][0] - 1, q = bar[e][1] - 1;  // nodes 5 and 6 are fixed
      const Eigen::Vector2d d(node[q][0] - node[p][0], node[q][1] - node[p][1]);
      length_[e] = d.norm();
      if (p < 4) b_.col(e).segment<2>(2 * p) -= d / length_[e];
      if (q < 4) b_.col(e).segment<2>(2 * q) += d / length_[e];
    }
    k_ = 1e4 * length_.cwiseInverse();  // E/L in ksi/in
    load_.setZero(kFree);
    load_[3] = load_[7] = -100;
    output_.resize(kFree, 0);
  }

  /// Two rows, r - 1 <= 0 and -r - 1 <= 0, of a displacement or a bar's stress over its limit.
  void add_rows(const std::string& name, int index, bool stress) {
    output_.conservativeResize(Eigen::NoChange, output_.cols() + 1);
    auto c = output_.col(output_.cols() - 1);
    c.setZero();
    if (stress)
      c = k_[index] * b_.col(index) / 25;
    else
      c[index] = 1.0 / 2;
    constraints_.push_back({constraints_.size() + 100, name + " +", 1});
    constraints_.push_back({constraints_.size() + 100, name + " -", 1});
  }

  HessianShape shape_;
  Eigen::MatrixXd b_;       ///< 8 x 10, direction of each bar
  Eigen::MatrixXd output_;  ///< 8 x 18, c of each response over its limit
  Eigen::VectorXd k_, length_, load_, u_, stretch_;
  Eigen::MatrixXd adjoint_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_;
};

}  // namespace liesl::test
