#pragma once
/// @file
/// A static problem that agrees with the motion to first order at the analysed design.

#include <memory>
#include <optional>

#include "optim/problems/motion_gradients.hpp"

namespace liesl {

/// Which of these continues a response.
struct Approximations {
  Approximation general = Approximation::Auto;
  std::vector<Approximation> own = {};  ///< by constraint of the study; Auto: the general one
  /// What Auto is of a response without a static image; of one with an image it is Power.
  Approximation without_image = Approximation::Mma;

  Approximation of(const LimitedResponse& response) const;
};

/// The static problem sees how sections carry constant loads, not how the loads follow the design.
/// Each row v_s(x) that is the image of a response v of the motion is corrected by
///   v^(x) = v_s(x) prod_i exp(c_i s_i(x)),   c = dv/dx / v - dv_s/dx / v_s  at x_k,
///   s_i = x_ki ln(x_i/x_ki) where the variable is positive, else x_i - x_ki,
/// so that value and gradient at x_k are those of the motion (AMMO: Alexandrov, Lewis 2001,
/// "First-order model management", Optim. Eng. 2), and exact where loads are powers of the
/// dimensions, v^ > 0 everywhere; or by 1 + c . (x - x_k); or, as in the method of moving
/// asymptotes (K. Svanberg 1987, Int. J. Numer. Methods Eng. 24), by 1 + c . s, convex where v_s is
/// constant, of
///   s_i = (U_i - x_ki)^2 [1/(U_i - x_i) - 1/(U_i - x_ki)]   if c_i > 0,
///   s_i = (x_ki - L_i)^2 [1/(x_ki - L_i) - 1/(x_i - L_i)]   else,
/// U_i and L_i twice as far from x_k as the farther bound, so that they move with the trust region,
/// and s_i a parabola beyond that bound;
/// or by a term, v^ = v_s(x) + b . (x - x_k), b = dv/dx - dv_s/dx at x_k.
/// A row without size has no correction. A start of variables may be that of the
/// study, beyond the bounds: within them is what is nearest to it (start_of).
///
/// A design x_t near x_k that was rejected makes rows conservative (K. Svanberg 2002, "A class of
/// globally convergent optimization methods based on conservative convex separable approximations",
/// SIAM J. Optim. 12): each gets a term kappa d(x),
///   d = sum_i ((x_i - x_ki)/w_i)^2,   w the widths of the bounds of the static problem,
/// with the least kappa >= 0 for which v^(x_t) is not below v(x_t); value and gradient at x_k stay.
///
/// The design x_b that x_k followed after may tell rows their curvature between both (L. Wang,
/// R. V. Grandhi 1995, "Improved two-point function approximation for design optimization", AIAA J.
/// 33): each that misses v(x_b) by 2 % of its limit at most gets a term
///   beta (u . (x - x_k)/w)^2,   u . (x_b - x_k)/w = 1,   u along (x_b - x_k)/w,
/// beta = v(x_b) - v^(x_b), so that it passes through v(x_b).
class CorrectedProblem final : public StaticProblem {
 public:
  /// @param inner at x_k; its rows are re-corrected when it takes more cases
  /// @param gradients of the motion at x_k, of inner.responses(); of no response: rows stay those
  /// of `inner`
  /// @param objective at x_k: `inner` may lack the mass of what no variable changes
  CorrectedProblem(std::unique_ptr<StaticProblem> inner, MotionGradients gradients,
                   const Eigen::VectorXd& x_k, double objective,
                   Approximations approximations = {});

  /// Values v of the responses at another design than x_k, by response and record; an empty series
  /// is not known.
  struct KnownDesign {
    Eigen::VectorXd x;
    std::vector<Eigen::VectorXd> values;
  };
  /// Makes rows conservative at x_t.
  void make_conservative(KnownDesign rejected);
  /// Lets rows pass through the values at x_b, if it is within the bounds of `inner`.
  void pass_through(KnownDesign before);

  /// Takes these terms off again. @returns whether there were any
  bool forget_rejected();

  /// Narrows the bounds to this share, in (0, 1], of those of `inner` about x_k.
  void narrow(double share);

  int add_violated(const Eigen::VectorXd& x, double tolerance) override;
  int add_records(const std::vector<std::set<int>>& records) override;
  int load_cases() const override { return inner_->load_cases(); }
  /// Those of the motion, with their scenarios; without one those of `inner`.
  std::vector<LimitedResponse> responses() const override;
  std::vector<RowImage> images() const override { return inner_->images(); }
  std::vector<ObjectiveTerm> objective_terms() const override { return inner_->objective_terms(); }
  std::string undefined_reason() const override { return inner_->undefined_reason(); }

  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return inner_->constraints(); }
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override;
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override;
  HessianShape hessian_shape() const override { return inner_->hessian_shape(); }
  void hessian(const Eigen::VectorXd& x, double sigma, const Eigen::VectorXd& lambda,
               Eigen::MatrixXd& h) override;

 private:
  /// s, s' and s'' by variable.
  struct Steps {
    Eigen::VectorXd s, first, second;
  };
  /// What rows go by: differences, logarithms, reciprocals where c is positive, and where not.
  struct AllSteps {
    Steps linear, power, rising, falling;
    Steps of(Approximation approximation, const Eigen::VectorXd& c) const;
  };
  AllSteps steps(const Eigen::VectorXd& x) const;
  Steps differences(const Eigen::VectorXd& x) const;
  Steps logarithms(const Eigen::VectorXd& x) const;
  /// @param side 1: between x and U, -1: between L and x
  Steps reciprocals(const Eigen::VectorXd& x, double side) const;
  Eigen::VectorXd exponents(const AllSteps& t) const;
  double correct_rows();
  /// Is x within the bounds of `inner`, beyond which moving asymptotes tell nothing?
  bool reaches(const Eigen::VectorXd& x) const;
  /// beta and kappa of all rows, anew.
  void curve_rows();
  /// v - v^ of each row at a design, of its limit; 0 where v is not known.
  Eigen::VectorXd missed(const KnownDesign& at);
  /// step_i/w_i^power, 0 where w_i is.
  Eigen::VectorXd by_width(const Eigen::VectorXd& step, int power) const;
  /// Of a row: what p = c . s is multiplied by, beside its place in the factor.
  double term(int row) const {
    return approximation_[row] == Approximation::Additive ? v_k_[row] : 0;
  }

  std::unique_ptr<StaticProblem> inner_;
  const MotionGradients motion_;
  const Eigen::VectorXd x_k_;
  const Approximations approximations_;
  std::vector<NlpVariable> variables_;
  double rest_ = 0;                           ///< of the objective, which `inner` lacks
  RowMatrix c_;                               ///< rows x variables
  std::vector<Approximation> approximation_;  ///< by row, none Auto
  Eigen::VectorXd v_k_;                       ///< g + 1 of `inner` at x_k
  std::vector<KnownDesign> rejected_;
  Eigen::VectorXd kappa_;  ///< by row; empty: no design was rejected
  std::optional<KnownDesign> before_;
  Eigen::VectorXd beta_, u_;  ///< by row, by variable; empty: no design before is known
  Eigen::VectorXd g_;         ///< of `inner`, at the latest x
  RowMatrix dg_;              ///< of `inner`, at the latest x
};

}  // namespace liesl
