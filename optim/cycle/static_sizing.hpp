#pragma once
/// @file
/// The static problem of one ESL cycle (thesis eq. 3.24): minimum mass under the load cases of the
/// last simulation, all limits in all retained cases.

#include "esl/load_set.hpp"
#include "esl/static_part.hpp"
#include "mbs/system/response_value.hpp"
#include "optim/design/sizing.hpp"
#include "optim/nlp/problem.hpp"
#include "optim/study/study.hpp"

namespace liesl {

/// What the last simulation says of one design: the loads of the parts and the true responses.
template <FrameGroup G>
struct Analysis {
  Mechanism mechanism;  ///< with the design that was simulated
  const Model<G>* model = nullptr;
  const Trajectory<G>* trajectory = nullptr;
  std::vector<LoadSet> loads;  ///< one for each constrained part
};

/// minimise mass(x) subject to |r_c,n(x)|/limit_c - 1 <= 0. Responses are those of the linear
/// static problem plus the constant that makes them exact at the analysed design,
///   y_n(x) = C^T K(x)^-1 f_n + (y_n^dynamic - C^T K(x0)^-1 f_n),
/// so that a fixed point of the cycle satisfies the limits of the motion itself.
template <FrameGroup G>
class StaticSizing final : public Problem {
 public:
  /// @param x0 the analysed design; bounds are narrowed to x0 (1 -+ move)
  StaticSizing(const Analysis<G>& at, const Sizing& sizing, const StudySpec& study,
               const Eigen::VectorXd& x0, double move);

  /// Checks all load cases at x and adds those that violate a limit by more than `tolerance`.
  /// @returns how many were added
  int add_violated(const Eigen::VectorXd& x, double tolerance);
  int load_cases() const;

  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override;
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override;
  HessianShape hessian_shape() const override {
    return second_derivatives_ ? HessianShape::Dense : HessianShape::None;
  }
  void hessian(const Eigen::VectorXd& x, double sigma, const Eigen::VectorXd& lambda,
               Eigen::MatrixXd& h) override;

 private:
  static constexpr int dim = G::dim;
  using Law = typename StaticPart<G>::Law;
  using StressRows = Eigen::Matrix<double, 3, dim>;

  struct Part {
    int body = 0;
    const LoadSet* loads = nullptr;
    StaticPart<G> problem;
    Eigen::MatrixXd correction;  ///< outputs x all cases
    bool compliance = false;     ///< one more output, after those of the static part
    Eigen::MatrixXd y;           ///< outputs x retained cases, at the latest x
    int outputs() const { return problem.outputs() + compliance; }
    std::vector<int> kept;   ///< numbers of the retained cases
    std::vector<SE3> align;  ///< of the first node of each element
  };
  /// A limit on |outputs first .. first + count) of a part, or on the von Mises stress made of
  /// them.
  struct Limit {
    int constraint = 0, part = 0, first = 0, count = 0;
    int element = -1, point = -1;  ///< stress
  };
  struct RowRef {
    int limit = 0, kept = 0;  ///< which limit in which retained case
  };

  ResponseKind kind_of(const Limit& limit) const {
    return study_.constraints[limit.constraint].response.kind;
  }
  void make_parts(const Analysis<G>& at);
  void add_outputs(const Analysis<G>& at, int part, std::vector<Eigen::MatrixXd>& outputs);
  Eigen::MatrixXd gradient_at_rest(const Analysis<G>& at, const ResponseSpec& response) const;
  Eigen::MatrixXd dynamic_outputs(const Analysis<G>& at, int part) const;
  void screen();
  void retain(const std::vector<std::vector<int>>& cases);
  bool solve(const Eigen::VectorXd& x);
  Law stiffness(const Part& part) const;
  /// Value of a limit for the outputs y (corrected); `slope`: its gradient with respect to y.
  double limit_value(const Limit& limit, const Eigen::VectorXd& y, Eigen::VectorXd* slope) const;
  Eigen::VectorXd outputs_of(const Limit& limit, int kept) const;
  StressRows stress_rows(const Part& part, int element, int point) const;
  void update_outputs();
  void update_stress_of_strain();
  double explicit_stress_slope(const Limit& limit, const Eigen::VectorXd& y, int variable) const;
  std::vector<Law> stiffness_derivatives(const Part& part) const;

  const Sizing& sizing_;
  const StudySpec& study_;
  Mechanism mechanism_;  ///< at the latest x
  const Model<G>& model_;
  Space<G> space_;
  std::vector<Part> parts_;
  std::vector<Limit> limits_;
  std::vector<StressRows> stress_of_strain_;  ///< S K_s by limit, at the latest x
  std::vector<RowRef> rows_;
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_;
  std::vector<std::vector<Eigen::MatrixXd>> dy_;  ///< [part][variable]: outputs x retained cases
  bool second_derivatives_ = true;                ///< not of stresses and compliances
};

extern template class StaticSizing<SE2>;
extern template class StaticSizing<SE3>;

}  // namespace liesl
