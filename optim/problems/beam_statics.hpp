#pragma once
/// @file
/// Statics of sized beams under the loads of a motion.

#include <map>

#include "esl/load_set.hpp"
#include "esl/static_part.hpp"
#include "optim/design/sizing.hpp"
#include "optim/problems/element_stress.hpp"
#include "optim/problems/part_outputs.hpp"
#include "optim/problems/part_statics.hpp"

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

/// A part a constrained beam; the objective is the mass of the beams in that of the study. Second
/// derivatives unless a stress or a compliance is limited.
template <FrameGroup G>
class BeamStatics final : public PartStatics {
 public:
  /// @param move bounds are narrowed to x0 (1 -+ move)
  BeamStatics(const Analysis<G>& at, const Sizing& sizing, const StudySpec& study, double move);

  std::vector<NlpVariable> variables(const Eigen::VectorXd& x0) const override;
  void retain(const std::vector<std::vector<int>>& kept) override;
  std::string solve(const Eigen::VectorXd& x) override;
  const Eigen::MatrixXd& y(int part) const override { return parts_[part].y; }
  const Eigen::MatrixXd& measured(int part) const override { return parts_[part].measured; }
  std::vector<Eigen::MatrixXd> output_gradients(int part) override;
  double value(int limit, const Eigen::VectorXd& y, Eigen::VectorXd* slope) const override;
  double explicit_slope(int limit, const Eigen::VectorXd& y, int variable) const override;
  double mass() const override { return mass_of(mechanism_, counted_); }
  void objective_gradient(Eigen::VectorXd& df) override;
  bool has_second() const override { return second_derivatives_; }
  void add_second(double sigma, const std::vector<Eigen::MatrixXd>& weights,
                  Eigen::MatrixXd& h) const override;

 private:
  using Matrix = typename G::Matrix;
  using Law = typename StaticPart<G>::Law;
  using StressChange = typename ElementStress<G>::Change;
  struct Part {
    int body = 0;
    const BeamChain<G>* beam = nullptr;
    const LoadSet* loads = nullptr;
    PartOutputs outputs;
    StaticPart<G> problem;
    std::vector<SE3> align;                ///< of the first node of each element
    Eigen::MatrixXd measured;              ///< outputs x all cases
    Eigen::MatrixXd y;                     ///< outputs x retained cases, at the latest x
    std::vector<ElementStress<G>> stress;  ///< by element, at the latest x; if stress is limited
    /// What a variable does to an element's stress, at the latest gradients.
    std::map<std::pair<int, int>, StressChange> changes;
    Law section;  ///< section stiffnesses at the latest x
  };

  void make_part(const Analysis<G>& at, const LoadSet& loads);
  void add_limits(const PartOutputs& outputs, int body);
  std::string solve_part(Part& part) const;
  const BeamSpec& beam_of(const Part& part) const {
    return std::get<BeamSpec>(mechanism_.bodies[part.body].kind);
  }
  Law section_stiffness(const Part& part) const;
  bool in_mass(int body) const;
  double mass_slope(const SectionLaw& derivative, SizedElement at) const;
  Matrix section_derivative(const Part& part, int i, SizedElement at) const;
  Matrix stiffness_derivative(const Part& part, int i, SizedElement at) const;
  std::vector<Law> stiffness_derivatives(const Part& part) const;
  StressChange stress_change(const Part& part, int i, SizedElement at) const;
  using SecondLaws = std::vector<std::vector<std::vector<std::pair<SizedElement, SectionLaw>>>>;
  SecondLaws second_laws() const;

  const Sizing& sizing_;
  const StudySpec& study_;
  const double move_;
  std::vector<int> counted_;             ///< beams of the objective
  Mechanism mechanism_;                  ///< at the latest x
  std::optional<Model<G>> parts_model_;  ///< where the motion was of another formalism
  const Model<G>& model_;                ///< of the parts: beams of the Lie group formalism
  Space<G> space_;
  std::vector<Part> parts_;
  std::vector<Limit> outputs_of_limit_;
  bool second_derivatives_ = true;
};

extern template class BeamStatics<SE2>;
extern template class BeamStatics<SE3>;

}  // namespace liesl
