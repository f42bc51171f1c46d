#pragma once
/// @file
/// The static problem of one ESL cycle (thesis eq. 3.24): minimum mass under the load cases of the
/// last simulation, all limits in all retained cases.

#include <array>
#include <map>
#include <optional>

#include "esl/load_set.hpp"
#include "esl/static_part.hpp"
#include "optim/cycle/case_screen.hpp"
#include "optim/cycle/element_stress.hpp"
#include "optim/cycle/part_outputs.hpp"
#include "optim/cycle/static_problem.hpp"
#include "optim/design/sizing.hpp"
#include "optim/study/study.hpp"

namespace liesl {

/// What the last simulation says of one design: the loads of the parts and the true responses.
/// What it points to outlives the problem.
template <FrameGroup G>
struct Analysis {
  Mechanism mechanism;  ///< with the design that was simulated
  const Model<G>* model = nullptr;
  const Trajectory<G>* trajectory = nullptr;
  const std::vector<LoadSet>* loads = nullptr;  ///< one for each constrained beam
};

/// minimise mass(x) of the beams in the objective subject to |r_c,n(x)|/limit_c - 1 <= 0. Responses
/// are those of the linear static problem plus the constant that makes them exact at the analysed
/// design,
///   y_n(x) = C^T K(x)^-1 f_n + (y_n^dynamic - C^T K(x0)^-1 f_n),
/// so that a fixed point of the cycle satisfies the limits of the motion itself.
template <FrameGroup G>
class StaticSizing final : public StaticProblem {
 public:
  /// @param x0 the analysed design; bounds are narrowed to x0 (1 -+ move)
  StaticSizing(const Analysis<G>& at, const Sizing& sizing, const StudySpec& study,
               const Eigen::VectorXd& x0, double move);

  int add_violated(const Eigen::VectorXd& x, double tolerance) override;
  int load_cases() const override;
  std::vector<LimitedResponse> responses() const override;
  std::vector<RowImage> images() const override;

  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return retained_.constraints; }
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
  struct Part {
    int body = 0;
    const BeamChain<G>* beam = nullptr;
    const LoadSet* loads = nullptr;
    PartOutputs outputs;
    StaticPart<G> problem;
    std::vector<SE3> align;                ///< of the first node of each element
    Eigen::MatrixXd correction;            ///< outputs x all cases
    Eigen::MatrixXd y;                     ///< outputs x retained cases, at the latest x
    std::vector<ElementStress<G>> stress;  ///< by element, at the latest x; if stress is limited
    std::vector<int> kept;                 ///< numbers of the retained cases
    Law section;                           ///< section stiffnesses at the latest x
  };

  ResponseKind kind_of(const Limit& limit) const {
    return study_.constraints[limit.constraint].response.kind;
  }
  void make_parts(const Analysis<G>& at);
  void retain_all(Part& part) const;
  std::vector<ScreenedLimit> screened() const;
  ValuesByLimit all_values() const;
  void keep(const CasesByLimit& cases);
  bool solve(const Eigen::VectorXd& x);
  bool solve_parts();
  Law section_stiffness(const Part& part) const;
  Law stiffness(const Part& part) const;
  /// Value of a limit for the outputs y (corrected); `slope`: its gradient with respect to y.
  double limit_value(const Limit& limit, const Eigen::VectorXd& y, Eigen::VectorXd* slope) const;
  Eigen::VectorXd outputs_of(const Limit& limit, int kept) const;
  double limit_of(const Limit& limit) const { return study_.constraints[limit.constraint].limit; }
  bool in_mass(int body) const;
  double mass_slope(const SectionLaw& derivative, SizedElement at) const;

  using StressChange = typename ElementStress<G>::Change;
  using StressChanges = std::map<std::array<int, 3>, StressChange>;  ///< part, element, variable
  StressChanges stress_changes() const;
  void output_gradients();
  using Matrix = typename G::Matrix;
  Matrix section_derivative(const Part& part, int i, SizedElement at) const;
  Matrix stiffness_derivative(const Part& part, int i, SizedElement at) const;
  std::vector<Law> stiffness_derivatives(const Part& part) const;

  using SecondLaws = std::vector<std::vector<std::vector<std::pair<SizedElement, SectionLaw>>>>;
  SecondLaws second_laws() const;
  Eigen::MatrixXd output_weights(int part, const Eigen::VectorXd& lambda, Eigen::MatrixXd& h) const;

  const Sizing& sizing_;
  const StudySpec& study_;
  std::vector<int> counted_;             ///< beams of the objective
  Mechanism mechanism_;                  ///< at the latest x
  std::optional<Model<G>> parts_model_;  ///< where the motion was of another formalism
  const Model<G>& model_;                ///< of the parts: beams of the Lie group formalism
  Space<G> space_;
  std::vector<Part> parts_;
  std::vector<Limit> limits_;
  RetainedCases retained_;
  std::vector<NlpVariable> variables_;
  std::vector<std::vector<Eigen::MatrixXd>> dy_;  ///< [part][variable]: outputs x retained cases
  bool second_derivatives_ = true;                ///< not of stresses and compliances
};

extern template class StaticSizing<SE2>;
extern template class StaticSizing<SE3>;

}  // namespace liesl
