#pragma once
/// @file
/// A problem whose constraints may be exceeded at a price, so that it always has a solution:
///
///     minimise w (f(x) + sum_k w_k s_k) + sigma t   subject to   g_i(x) / scale_i <= t,
///     g_j(x) <= s_k for the rows j of term k,   lower <= x <= upper,   t >= 0:
///
/// w_k times the largest g of term k is part of the objective (epigraph form).
/// For sigma above the sum of the multipliers t = 0 wherever the constraints can be met: an exact
/// penalty (Fletcher, Practical Methods of Optimization, 1987, ch. 12.3).

#include "optim/nlp/problem.hpp"

namespace liesl {

/// Rows whose largest g is part of the objective.
struct Epigraph {
  double weight = 0;  ///< w_k, > 0
  std::vector<int> rows;
  double start = 0;  ///< their largest g at the start
};

/// The problem above; the variables are x, the s_k, and t. The wrapped problem must outlive it.
class ElasticProblem final : public Problem {
 public:
  struct Weights {
    double objective = 1;  ///< w, per unit of f
    double penalty = 1;    ///< sigma, > 0
  };
  /// @param scale of the constraints of `inner`, all > 0
  /// @param start of its variables  @param start_violation largest g/scale there, >= 0
  ElasticProblem(Problem& inner, Weights weights, Eigen::VectorXd scale,
                 const Eigen::VectorXd& start, double start_violation,
                 std::vector<Epigraph> terms = {});

  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override;
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override;
  HessianShape hessian_shape() const override { return inner_.hessian_shape(); }
  void hessian(const Eigen::VectorXd& x, double sigma, const Eigen::VectorXd& lambda,
               Eigen::MatrixXd& h) override;

 private:
  Problem& inner_;
  const Weights weights_;
  const Eigen::VectorXd scale_;
  const std::vector<Epigraph> terms_;
  std::vector<Eigen::Index> bound_;  ///< the variable that bounds a row: t, or its s_k
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_;
};

}  // namespace liesl
