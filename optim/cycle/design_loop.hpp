#pragma once
/// @file
/// The loop of every study: analyse a design, judge it, choose the next one. What differs between
/// methods is the rule by which the next design is chosen.

#include <functional>
#include <optional>

#include "optim/cycle/cycle_rules.hpp"
#include "optim/cycle/design_model.hpp"

namespace liesl {

struct CycleHooks {
  std::function<void(const std::vector<Cycle>&)> on_cycle;  ///< after each cycle
  Progress progress;                                        ///< during simulations
  std::function<bool()> keep_going;  ///< asked by the optimiser; false = Interrupted
  /// Added to the number of a cycle in reasons where a run has several loops, each with cycles from
  /// 1 on: " of restart 2".
  std::string of;
};

struct LoopResult {
  CycleStatus status = CycleStatus::SimulationFailed;
  std::string reason;
  std::vector<Cycle> history;
  Eigen::VectorXd x;  ///< final design: the best that was analysed; empty: none was
  std::shared_ptr<DesignAnalysis> first, best;  ///< of the start and of x; null: none
  /// Of the final design; none if it was not asked for or there is no design to ask it of.
  std::optional<DynamicOptimality> optimality;
  std::vector<std::string> warnings;
  /// Why a design after the first has no sensitivities, where the loop ended by that; else empty.
  std::string lost = {};
};

/// What a loop has so far: its history, its best design, and why it ends.
class CycleRecord {
 public:
  using Analysis = std::shared_ptr<DesignAnalysis>;

  CycleRecord(DesignModel& model, const CycleOptions& options, const CycleHooks& hooks)
      : model_(model), options_(options), hooks_(hooks) {}

  DesignModel& model() { return model_; }
  const CycleOptions& options() const { return options_; }
  const CycleHooks& hooks() const { return hooks_; }
  const History& history() const { return result_.history; }
  const Eigen::VectorXd& best() const { return result_.x; }  ///< empty: none yet
  bool asked_to_stop() const { return hooks_.keep_going && !hooks_.keep_going(); }
  /// What that ends in: the last cycle so far.
  CycleEnd stopped() const;
  /// That sensitivities are lost ends in: SimulationFailed.
  CycleEnd lost(const NoSensitivities& why);

  Analysis analyse(const Eigen::VectorXd& x) { return model_.analyse(x, hooks_.progress); }
  Cycle& add(const Analysis& analysis, const Eigen::VectorXd& x);
  /// Takes over the cycles of an interrupted run; analyses its first and its best design.
  void restore(const std::vector<Cycle>& resume);
  /// The last cycle is begun again.
  void drop_last() { result_.history.pop_back(); }
  /// As if there had been no interruption: the next design is compared with the last one, and
  /// simulating again counts as no effort.
  void go_on();

  /// Keeps a design if it is the lightest that meets the limits, or violates them least.
  void keep_if_better(const Analysis& analysis, const Eigen::VectorXd& x);
  void keep(const Analysis& analysis, const Eigen::VectorXd& x);
  void warn(std::string text) { result_.warnings.push_back(std::move(text)); }
  /// The optimality conditions of the best design, where the rule has them; none: no more.
  void certify(std::optional<DynamicOptimality> optimality) {
    result_.optimality = std::move(optimality);
  }

  /// @param end why the loop has ended
  LoopResult finish(const CycleEnd& end);

 private:
  bool better(double worst, double objective, double than_worst, double than_objective) const;
  void evaluate_certificate();

  DesignModel& model_;
  const CycleOptions& options_;
  const CycleHooks& hooks_;
  Analysis last_;
  LoopResult result_;
};

/// What follows a design: the next one, or the end.
struct Step {
  Eigen::VectorXd x;
  std::optional<CycleEnd> end;
};

/// How a method goes from design to design.
class StepRule {
 public:
  virtual ~StepRule() = default;
  StepRule() = default;
  StepRule(const StepRule&) = delete;
  StepRule& operator=(const StepRule&) = delete;

  /// After a design that was analysed; `cycle` is its row in the history, to be completed.
  virtual Step next(CycleRecord& record, const CycleRecord::Analysis& analysis, Cycle& cycle) = 0;
  /// After a design that could not be analysed, `failed`.
  virtual Step retreat(CycleRecord& record, const DesignAnalysis& failed,
                       const Eigen::VectorXd& x) = 0;
  /// Goes on where an interrupted run was, whose cycles `record` has restored.
  virtual Step resume(CycleRecord& record) = 0;
};

/// A later design without sensitivities ends it SimulationFailed, as `lost` says.
/// @param resume the cycles of an interrupted run of the same study; empty: from the start
/// @throws NoSensitivities of the first design
LoopResult run_loop(DesignModel& model, StepRule& rule, const CycleOptions& options,
                    const CycleHooks& hooks, const std::vector<Cycle>& resume);

}  // namespace liesl
