#pragma once
/// @file
/// The static problem of one ESL cycle (thesis eq. 3.24) or of fixed loads: a minimum under
/// retained load cases, whatever the parts are made of.

#include <memory>

#include "optim/problems/part_statics.hpp"

namespace liesl {

/// One design, measured in all load cases.
struct StaticCheck {
  double objective = 0;            ///< with all that is weighted
  double mass = 0;                 ///< kg
  std::vector<LimitCheck> limits;  ///< those of the study, then the worst wall if there are walls
  double worst = -1;               ///< largest excess
  std::string worst_limit;
};

/// minimise objective(x) + sum_k w_k limit_k max_n g_kn over the limits with a weight (rows of
/// `objective_terms`; of a frequency -w_k limit_k min) subject to value_l(y_n(x))/limit_l - 1 <= 0
/// in the retained cases n (all cases if the objective depends on them) and the limits of the
/// design alone. Outputs are those of the linear static problem plus the constant that makes them
/// exact at the analysed design x0,
///   y_n(x) = C^T K(x)^-1 f_n + (y_n^dynamic - C^T K(x0)^-1 f_n),
/// so that a fixed point of the cycle satisfies the limits of the motion itself; under fixed loads
/// as they are. Without a part at x there is no value, and `undefined_reason` says why.
class EslProblem final : public StaticProblem {
 public:
  /// @param x0 the analysed design  @param options for the screening of cases
  EslProblem(std::unique_ptr<PartStatics> parts, const CycleOptions& options,
             const Eigen::VectorXd& x0);

  int add_violated(const Eigen::VectorXd& x, double tolerance) override;
  int load_cases() const override;
  std::vector<LimitedResponse> responses() const override;
  /// In the retained cases. @pre before any other x
  std::vector<LimitedResponse> responses_with_slopes() override;
  std::vector<RowImage> images() const override;
  std::vector<ObjectiveTerm> objective_terms() const override;  ///< numbered as the screened limits
  std::string undefined_reason() const override { return undefined_reason_; }

  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override;
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override;
  HessianShape hessian_shape() const override {
    return parts_->has_second() ? HessianShape::Dense : HessianShape::None;
  }
  void hessian(const Eigen::VectorXd& x, double sigma, const Eigen::VectorXd& lambda,
               Eigen::MatrixXd& h) override;

  /// All limits at x in all load cases; nothing if there is no value (see `undefined_reason`).
  std::optional<StaticCheck> check(const Eigen::VectorXd& x);
  /// d(sum_r lambda_r g_r)/dy of a part at the latest x: outputs x retained cases. The order of
  /// `lambda` is that of the constraints.
  Eigen::MatrixXd output_weights(int part, const Eigen::VectorXd& lambda) const;

 private:
  std::vector<std::vector<int>> all_cases() const;  ///< by part
  CasesByLimit first_cases(const CycleOptions& options) const;
  void retain_all();
  void keep(const CasesByLimit& cases);
  bool solve(const Eigen::VectorXd& x);
  ValuesByLimit all_values() const;
  Eigen::VectorXd outputs_of(const CaseLimit& limit, int kept) const;
  void add_curvature(const Eigen::VectorXd& lambda, Eigen::MatrixXd& h) const;

  std::unique_ptr<PartStatics> parts_;
  std::vector<ScreenedLimit> screened_;
  std::vector<Eigen::MatrixXd> correction_;  ///< by part: first outputs x all cases
  ValuesByLimit at_start_;  ///< values of all cases at x0; empty if every case is needed
  RetainedCases retained_;
  std::vector<std::vector<int>> kept_;  ///< by part: numbers of the cases that are solved
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_;
  std::string undefined_reason_;
  std::vector<std::vector<Eigen::MatrixXd>> dy_;  ///< [part][variable], at the latest gradients
};

}  // namespace liesl
