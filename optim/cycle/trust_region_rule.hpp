#pragma once
/// @file
/// Steps that end at the optimum of the study itself: problems that agree with it to first order,
/// within trust regions (Alexandrov, Dennis, Lewis, Torczon 1998, "A trust-region framework for
/// managing the use of approximation models", Struct. Optim. 15; for loads of the design: Stolpe,
/// Pollini 2023).

#include <cmath>

#include "optim/cycle/design_loop.hpp"

namespace liesl {

/// From the design x_k and its surrogate (design_model.hpp):
///   minimise  m(x)/m_0 + sigma t  subject to  v^_rn(x)/limit_r - 1 <= t,  t >= 0,
///             |x - x_k| within the radius
/// and analyse the answer. At the first design v^ is what the static problems say, if they tell all
/// limits: far from the optimum the gradients of the motion save no cycle. They follow if that step
/// is rejected, or has nothing to gain. An answer is taken if the merit phi = m/m_0 + sigma max(0,
/// worst violation) falls by a tenth of what was predicted, else the surrogate becomes conservative
/// there; the radius follows the ratio. A surrogate has the values of the design before, too,
/// unless the answer from there was cut off by a bound. Ends Optimal if the KKT conditions hold at
/// x_k and no decrease is predicted that counts; Converged if only the latter; Infeasible if limits
/// are still exceeded then. Throws NoSensitivities as the surrogate does.
class TrustRegionRule final : public StepRule {
 public:
  explicit TrustRegionRule(const CycleOptions& options);

  Step next(CycleRecord& record, const CycleRecord::Analysis& analysis, Cycle& cycle) override;
  Step retreat(CycleRecord& record, const DesignAnalysis& failed,
               const Eigen::VectorXd& x) override;
  Step resume(CycleRecord& record) override;

 private:
  /// phi of an analysis or a cycle.
  template <class Figures>
  double merit(const Figures& a) const;
  double scale() const { return objective_0_ == 0 ? 1 : std::abs(objective_0_); }
  /// Judges the answer by what it really brings: taken? @param merit none: it has no analysis
  bool judge(std::optional<double> merit);
  /// Keeps the records at which a design that is left has its maxima: to these designs may go back.
  void remember(CycleRecord& record, const DesignAnalysis& left);
  /// Makes the surrogate conservative at a design that was rejected.
  void learn(CycleRecord& record, const DesignAnalysis& rejected, const Eigen::VectorXd& x);
  /// Solves and judges again what an interrupted run did from x_k on, and analyses the designs that
  /// it rejected.
  Step repeat(CycleRecord& record, const std::vector<Cycle>& rejected);
  Step propose(CycleRecord& record, Cycle* cycle);
  void make_surrogate(CycleRecord& record);
  /// Gives the surrogate what is known of the designs before x_k.
  void take_history(CycleRecord& record);
  /// What the surrogate is told of an analysis.
  CorrectedProblem::KnownDesign known(CycleRecord& record, const DesignAnalysis& analysis,
                                      const Eigen::VectorXd& x) const;
  /// The next surrogate has gradients of the motion.
  void correct();
  Step trial_step(CycleRecord& record, Cycle* cycle);
  void solve(CycleRecord& record);
  Step without_answer(CycleRecord& record, Cycle* cycle);
  bool on_bound() const;
  /// The end of a design from which nothing that counts is left to gain; none: there is.
  std::optional<CycleEnd> settled(CycleRecord& record, double predicted) const;
  bool is_optimal(const CycleRecord& record) const;
  CycleEnd stalled(CycleRecord& record) const;
  CycleEnd infeasible(CycleRecord& record) const;
  std::string certificate() const;
  std::string place() const;  ///< of the worst limit at x_k: " at t = 0.1 s"

  const double largest_;       ///< radius
  double radius_, built_ = 0;  ///< of the trust region; the one that the surrogate was made for
  double penalty_;             ///< sigma
  double objective_0_ = 0;     ///< m_0; 0: no design yet
  Eigen::VectorXd x_;          ///< x_k
  CycleRecord::Analysis at_;   ///< of x_k
  std::vector<std::set<int>> maxima_;     ///< Cycle::maxima of x_k
  CorrectedProblem::KnownDesign before_;  ///< Cycle::before of x_k; without values: not asked yet
  bool plain_;                            ///< no gradients yet, those of the surrogate among them
  Surrogate surrogate_;                   ///< at x_k
  ElasticAnswer answer_;
  double predicted_ = 0;  ///< decrease of the merit by the answer
  NlpWarmStart warm_;
};

}  // namespace liesl
