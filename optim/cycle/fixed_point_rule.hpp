#pragma once
/// @file
/// The plain ESL method (Choi & Park 2002; thesis section 3.4.3): the static optimum under the
/// loads of a design is the next design, until both agree.

#include "optim/cycle/design_loop.hpp"

namespace liesl {

/// Takes secant steps on design -> static optimum (cycle_rules.hpp). Move limits are halved when
/// designs oscillate or cannot be simulated.
class FixedPointRule final : public StepRule {
 public:
  explicit FixedPointRule(const CycleOptions& options) : move_(options.move_limit) {}

  Step next(CycleRecord& record, const CycleRecord::Analysis& analysis, Cycle& cycle) override;
  Step retreat(CycleRecord& record, const DesignAnalysis& failed,
               const Eigen::VectorXd& x) override;
  Step resume(CycleRecord& record) override;

 private:
  std::optional<CycleEnd> ended(const CycleRecord& record);
  void solve(CycleRecord& record, StaticProblem& problem, Cycle& cycle);

  double move_;
  NlpWarmStart warm_;
};

}  // namespace liesl
