#pragma once
/// @file
/// How nearly the constraints of a problem can be met together:
///
///     minimise t   subject to   g_i(x) / scale_i <= t,   lower <= x <= upper,   t >= 0.
///
/// t = 0: a feasible point, well inside if there is an inside. t > 0 (locally least): the
/// constraints with a multiplier are the ones that contradict each other.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "optim/nlp/problem.hpp"
#include "optim/nlp/result.hpp"

namespace liesl {

/// The problem above; the last variable is t. The wrapped problem must outlive it.
class LeastViolationProblem : public Problem {
 public:
  /// @param scale of the constraints of `inner`, all > 0
  /// @param start of its variables
  LeastViolationProblem(Problem& inner, Eigen::VectorXd scale, const Eigen::VectorXd& start,
                        double start_violation);

  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override;
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override;
  HessianShape hessian_shape() const override { return inner_.hessian_shape(); }
  void hessian(const Eigen::VectorXd& x, double sigma, const Eigen::VectorXd& lambda,
               Eigen::MatrixXd& h) override;

 private:
  Problem& inner_;
  Eigen::VectorXd scale_;
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_;
};

struct LeastViolation {
  bool solved = false;   ///< the problem above was solved
  double violation = 0;  ///< t, scaled
  Eigen::VectorXd x;
  std::vector<NlpViolation> conflict;  ///< empty if t is within the feasibility tolerance
  int iterations = 0;
  std::string reason;  ///< sentence that names the conflict, or why it is unknown
};

/// Solved by Ipopt from `start`, which has the scaled violation `start_violation`.
LeastViolation least_violation(Problem& problem, const Eigen::VectorXd& scale,
                               const Eigen::VectorXd& start, double start_violation,
                               const NlpOptions& options);

}  // namespace liesl
