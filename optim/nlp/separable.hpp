#pragma once
/// @file
/// Sequential convex separable programming: Svanberg's moving asymptotes (MMA, Int. J. Numer. Meth.
/// Engng 24, 1987) in the globally convergent form (GCMMA / CCSA, SIAM J. Optim. 12, 2002). Needs
/// values and gradients only; good where responses are nearly linear in 1/x, as in sizing.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "optim/nlp/problem.hpp"
#include "optim/nlp/result.hpp"

namespace liesl {

/// In units of the range of a variable where lengths are meant.
struct SeparableOptions {
  double move = 0.5;             ///< largest change of a variable in one iteration, in (0, 1]
  double first_asymptote = 0.5;  ///< distance of the asymptotes in the first two iterations, > 0
  double widen = 1.2;            ///< of that distance while a variable keeps its direction, > 1
  double narrow = 0.7;           ///< when it turns back, in (0, 1)
  double nearest_asymptote = 1e-3, farthest_asymptote = 10;  ///< limits of that distance
  /// Repeat an iteration with more convex models until they are above the functions at the new
  /// point (GCMMA). Without it an iteration costs one evaluation but may cycle.
  bool conservative = true;
  int max_repeats = 10;         ///< of one iteration, >= 1
  double smallest_step = 1e-9;  ///< stop when no variable moves more than this, > 0

  std::vector<std::string> errors() const;
};

/// The model of one iteration, about y_k in [0, 1]-like variables, for F and every G alike:
///
///     F(y) ~ r + sum_j p_j / (u_j - y_j) + q_j / (y_j - l_j),
///     p_j = (u_j - yk_j)^2 (1.001 dF_j^+ + 0.001 dF_j^- + rho),
///     q_j = (yk_j - l_j)^2 (0.001 dF_j^+ + 1.001 dF_j^- + rho),
///
/// with d^+ = max(d, 0), d^- = max(-d, 0) (Svanberg 2002, eq. 3.4 ff.): first order at yk, convex
/// and separable, hence a diagonal Hessian. Constraints that stay below zero in the whole box are
/// left out.
class SeparableModel : public Problem {
 public:
  struct Expansion {
    Eigen::VectorXd y, l, u;      ///< point and asymptotes, l < y < u
    Eigen::VectorXd alpha, beta;  ///< box of the variables, l < alpha <= y <= beta < u
    double f = 0;
    Eigen::VectorXd df, g;
    RowMatrix dg;
    double f_rho = 0;       ///< rho of F, > 0
    Eigen::VectorXd g_rho;  ///< rho of each G, > 0
  };
  SeparableModel(const Problem& original, const Expansion& at);

  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  /// Index in the original of each constraint that was kept.
  const std::vector<int>& kept() const { return kept_; }
  void values(const Eigen::VectorXd& y, double& f, Eigen::VectorXd& g) override;
  void gradients(const Eigen::VectorXd& y, Eigen::VectorXd& df, RowMatrix& dg) override;
  HessianShape hessian_shape() const override { return HessianShape::Diagonal; }
  void hessian(const Eigen::VectorXd& y, double sigma, const Eigen::VectorXd& lambda,
               Eigen::MatrixXd& h) override;

 private:
  Eigen::VectorXd l_, u_;
  double f_constant_ = 0;
  Eigen::VectorXd f_p_, f_q_, g_constant_;
  RowMatrix g_p_, g_q_;  ///< kept constraints x n
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_;
  std::vector<int> kept_;
};

/// Minimises from the start of `problem`; the models are solved by Ipopt. Converges linearly:
/// 1e-6 is a reasonable `tolerance`. If a model cannot be met, its least violation is the step;
/// Infeasible when no step lowers the violation any more. Throws as solve_ipopt does.
NlpResult solve_separable(Problem& problem, const NlpOptions& options = {},
                          const SeparableOptions& separable = {});

}  // namespace liesl
