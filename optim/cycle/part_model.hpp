#pragma once
/// @file
/// Studies of one meshed part under fixed loads.

#include "optim/cycle/design_loop.hpp"
#include "optim/cycle/nucleation.hpp"
#include "optim/problems/esl_problem.hpp"
#include "optim/problems/solid_task.hpp"

namespace liesl {

struct PartAnalysis final : DesignAnalysis {
  StaticCheck check;

  std::shared_ptr<DesignAnalysis> figures() const override {
    return std::make_shared<PartAnalysis>(*this);
  }
};

/// The problem that approximates the study is the study itself, within move limits: the outline
/// moves by task.cycle.move_cells cells at most, a variable by task.cycle.move_limit of its range.
class PartModel final : public DesignModel {
 public:
  explicit PartModel(const SolidTask& task) : task_(task) {}

  const std::vector<NlpVariable>& variables() const override { return task_.design->variables(); }
  Eigen::VectorXd unit(const Eigen::VectorXd& x) const override;
  std::shared_ptr<DesignAnalysis> analyse(const Eigen::VectorXd& x, const Progress&) override;
  std::unique_ptr<StaticProblem> static_problem(const DesignAnalysis&, const Eigen::VectorXd& x,
                                                double move) const override;
  Surrogate surrogate(const DesignAnalysis&, const Eigen::VectorXd& x, double move,
                      double active) const override;
  DynamicOptimality optimality(const DesignAnalysis& at, const Eigen::VectorXd& x,
                               const Progress&) const override;
  std::optional<double> load_change(const DesignAnalysis&, const DesignAnalysis&) const override {
    return {};
  }

 private:
  /// The task with what terms of the objective are at a design as their limits.
  SolidTask scaled(const DesignAnalysis& at) const;

  const SolidTask& task_;
};

struct PartResult : LoopResult {
  StaticCheck initial, final;
  Eigen::VectorXd fractions;      ///< of the final design
  Eigen::MatrixXd displacements;  ///< of the nodes in all cases, node freedoms x cases, m
  Eigen::MatrixXd von_mises;      ///< relaxed, at the centres, cells x cases, Pa
};

/// From the start of task.design to the final design, by trust regions.
/// @param resume the cycles of an interrupted run of the same task
PartResult optimise_part(const SolidTask& task, const CycleHooks& hooks = {},
                         const std::vector<Cycle>& resume = {});

}  // namespace liesl
