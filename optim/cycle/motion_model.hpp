#pragma once
/// @file
/// A study of one or several motions of one design.

#include "optim/cycle/design_loop.hpp"
#include "optim/problems/esl_problem.hpp"
#include "optim/problems/motion_problem.hpp"
#include "optim/problems/objective_problem.hpp"

namespace liesl {

/// One motion: the same bodies at another speed, with another payload.
template <FrameGroup G>
struct Scenario {
  Mechanism mechanism;
  Space<G> space;
  SimulationOptions simulation;
};

/// A limit of a meshed part itself.
struct PartCheck {
  PartLimitSpec limit;
  LimitCheck value;  ///< in the load case of the motion where it is worst
};

/// Limited responses over one motion.
struct MotionLimits {
  std::vector<double> times;        ///< s
  std::vector<LimitSeries> limits;  ///< one for each constraint
  std::vector<FrequencyCheck> frequencies = {};
  std::vector<MassCheck> masses = {};
  std::vector<PartCheck> parts = {};
};

template <FrameGroup G>
struct MotionAnalysis final : DesignAnalysis {
  std::vector<DesignRun<G>> runs;  ///< by scenario; empty: figures only
  std::vector<MotionLimits> limits;

  std::shared_ptr<DesignAnalysis> figures() const override;
};

template <FrameGroup G>
class MotionModel final : public DesignModel {
 public:
  /// Designs start from the mechanism of the first scenario. Scenarios and study outlive this.
  /// @throws std::invalid_argument for a study that does not fit a mechanism, or limits without a
  /// static image where the method has nothing else
  MotionModel(const std::vector<Scenario<G>>& scenarios, const StudySpec& study);

  const std::vector<NlpVariable>& variables() const override { return design().variables(); }
  Eigen::VectorXd unit(const Eigen::VectorXd& x) const override { return design().unit(x); }
  std::shared_ptr<DesignAnalysis> analyse(const Eigen::VectorXd& x,
                                          const Progress& progress) override;
  std::unique_ptr<StaticProblem> static_problem(const DesignAnalysis& at, const Eigen::VectorXd& x,
                                                double move) const override;
  Surrogate uncorrected(const DesignAnalysis& at, const Eigen::VectorXd& x,
                        double move) const override;
  Surrogate surrogate(const DesignAnalysis& at, const Eigen::VectorXd& x, double move,
                      double active) const override;
  std::vector<Eigen::VectorXd> response_values(
      const DesignAnalysis& at, const std::vector<LimitedResponse>& of) const override;
  DynamicOptimality optimality(const DesignAnalysis& at, const Eigen::VectorXd& x,
                               const Progress& progress) const override;
  std::optional<double> load_change(const DesignAnalysis& now,
                                    const DesignAnalysis& before) const override;

  const StudySpec& study() const { return study_; }
  const Design& design() const { return simulators_.front()->design(); }
  const DesignSimulator<G>& simulator(int scenario) const {
    return *simulators_[static_cast<std::size_t>(scenario)];
  }

 private:
  using Members = std::vector<CombinedProblem::Member>;
  void judge(MotionAnalysis<G>& analysis, const Eigen::VectorXd& x) const;
  void judge_parts(MotionAnalysis<G>& analysis, std::size_t scenario,
                   const Eigen::VectorXd& x) const;
  /// The study with what terms of the objective are at a design as their limits.
  /// @throws NoSensitivities of a term that is 0, which has no relative changes
  StudySpec scaled(const MotionAnalysis<G>& at) const;
  /// The same, of any terms.
  StudySpec with_sizes(const MotionAnalysis<G>& at) const;
  /// The objective that largest values and lowest frequencies are.
  double extremes(const MotionAnalysis<G>& at) const;
  /// Static problems of one scenario; the objective counts in the first.
  Members static_members(const StudySpec& study, std::size_t scenario, const MotionAnalysis<G>& at,
                         const Eigen::VectorXd& x, double move) const;
  ObjectiveModel objective_model(const MotionAnalysis<G>& at, const MotionGradients& effort) const;
  std::unique_ptr<StaticProblem> with_gradients(const MotionAnalysis<G>& at, const StudySpec& study,
                                                const Eigen::VectorXd& x, double move,
                                                MotionGradients& gradients) const;

  StudySpec study_;  ///< with what its method takes from static problems
  std::vector<std::unique_ptr<DesignSimulator<G>>> simulators_;
};

extern template struct MotionAnalysis<SE2>;
extern template struct MotionAnalysis<SE3>;
extern template class MotionModel<SE2>;
extern template class MotionModel<SE3>;

}  // namespace liesl
