#pragma once
/// @file
/// Statics of a meshed part whose outline changes, under fixed loads or those of a motion.

#include <limits>

#include "mbs/solids/reduction.hpp"
#include "optim/problems/part_statics.hpp"
#include "optim/problems/solid_task.hpp"

namespace liesl {

/// What a small round hole does to the Lagrangian.
struct HoleDerivative {
  Eigen::VectorXd
      value;            ///< at the centres of the cells, unit of the objective / m^3; of full cells
  std::string missing;  ///< what counts and has no such derivative: stress, frequencies
};

/// One part. Outputs are those of the task, then one for each limit on a compliance or stress.
/// Gradients by adjoints; no second derivatives. Own rows: limits on mass and frequencies, walls.
class MeshStatics final : public PartStatics {
 public:
  /// @param cells bounds are narrowed to where the outline has moved by this many cells
  /// @param share and to this share of a variable's range on both sides of x0
  explicit MeshStatics(const SolidTask& task,
                       double cells = std::numeric_limits<double>::infinity(), double share = 1);

  bool needs_every_case() const override { return task_.objective != SolidResponse::Mass; }
  std::vector<NlpVariable> variables(const Eigen::VectorXd& x0) const override;
  void retain(const std::vector<std::vector<int>>& kept) override;
  std::string solve(const Eigen::VectorXd& x) override;
  const Eigen::MatrixXd& y(int) const override { return y_; }
  const Eigen::MatrixXd& measured(int) const override { return task_.measured; }
  std::vector<Eigen::MatrixXd> output_gradients(int) override;
  PartSlopes slopes(int limit, const std::vector<int>& kept) override;
  double mass() const override { return task_.model->total_mass(fractions_.value); }
  double objective() override;
  void objective_gradient(Eigen::VectorXd& df) override;
  std::vector<NlpConstraint> own_rows() const override;
  std::vector<RowImage> own_images() const override;
  Eigen::VectorXd own_values() override;
  RowMatrix own_gradients() override;
  std::vector<ObjectiveTerm> own_terms() const override;
  double terms_at_start() const override;
  double add_checks(std::vector<LimitCheck>& checks) override;

  /// Solves every case at x by itself, for `statics`; false if there is no part there.
  bool show_all(const Eigen::VectorXd& x);
  const SolidStatics& statics() const { return statics_; }  ///< at the latest x
  /// d(objective + sum lambda_i g_i)/dV of holes with a free edge
  /// (mbs/solids/topological_derivative.hpp) at the latest x. Walls do not see new holes.
  /// @param weights of the outputs (EslProblem::output_weights)
  /// @param own lambda of the own rows, unit of the objective / g
  HoleDerivative hole_derivative(const Eigen::MatrixXd& weights, const Eigen::VectorXd& own) const;

 private:
  const StressNorm& stress(bool with_gradient);
  const FrequencyGradient& frequencies();
  std::vector<const SolidLimit*> own_limits() const;
  ObjectiveTerm term_of(const SolidLimit& limit) const;
  Eigen::MatrixXd extra_gradient(const SolidLimit& limit);

  SolidTask task_;
  const double cells_, share_;
  bool expanded_ = false;        ///< every case is solved: compliance or stress is asked for
  bool solved_ = false;          ///< there is a part at the latest x
  Eigen::MatrixXd combination_;  ///< of the retained cases
  SolidStatics statics_;
  Fractions fractions_;  ///< derivative with respect to the variables
  Eigen::MatrixXd y_;
  std::vector<const SolidLimit*> extra_;  ///< of the outputs after those of the task
  std::optional<StressNorm> stress_;      ///< at the latest x
  bool stress_gradient_ = false;
  RowMatrix wall_gradient_;  ///< found together with the walls
  std::optional<FrequencyGradient> frequencies_;
};

}  // namespace liesl
