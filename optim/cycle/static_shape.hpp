#pragma once
/// @file
/// The static problem of a meshed part (thesis eq. 3.24): its features move, its loads stay.

#include <algorithm>

#include "mbs/solids/reduction.hpp"
#include "mbs/solids/solid_statics.hpp"
#include "mbs/solids/stress_norm.hpp"
#include "optim/cycle/case_screen.hpp"
#include "optim/cycle/static_problem.hpp"
#include "optim/design/shape.hpp"

namespace liesl {

struct SolidLimit {
  std::string name;
  SolidResponse response = SolidResponse::Output;
  int first = 0, count = 1;  ///< Output: columns of C; Frequency: `count`
  double limit = 0;          ///< > 0
  std::optional<LimitedResponse> motion =
      {};  ///< of a motion: what it is the image of; none: fixed loads, mass, frequency
  /// Above 0: no limit, but this times the largest value of its cases (of a frequency minus the
  /// lowest) in the objective; `limit` is then its size at the analysed design.
  double weight = 0;
};

/// A meshed part, what it has to carry and what it has to meet. Nothing is copied but data: what is
/// referred to must outlive the problem.
struct SolidTask {
  const ShapeDesign* design = nullptr;
  levelset::LevelSet* shape = nullptr;
  SolidModel* model = nullptr;
  SolidSupport support;
  Eigen::MatrixXd outputs;         ///< C, q x m
  std::vector<std::string> cases;  ///< what the load cases are called
  Eigen::MatrixXd loads;           ///< q x cases, or q x k, combined by `combination`
  /// k x cases: the loads of the cases are loads * combination, so that outputs take k solutions,
  /// however many cases there are. Empty: `loads` are the cases.
  Eigen::MatrixXd combination;
  /// q x k: the displacements of the motion are basis * combination (SolidLoadSet); empty: none.
  Eigen::MatrixXd basis;
  /// What the motion says of the outputs at the analysed design, m x cases; y is moved by the
  /// constant that makes it agree there, as in StaticSizing. Empty: y as it is.
  Eigen::MatrixXd measured;
  std::vector<SolidLimit> limits;
  SolidResponse objective = SolidResponse::Mass;  ///< Mass; Compliance, the mean of the cases; or
                                                  ///< Stress, their p-mean
  double mass_weight = 1;  ///< of the mass that is the objective; limits with a weight are added
  bool weighted() const {
    return std::any_of(limits.begin(), limits.end(),
                       [](const SolidLimit& l) { return l.weight > 0; });
  }
  StressOptions stress;
  CycleOptions cycle;  ///< for the screening of cases
};

/// A limit of a task at one design: its worst value and the case of it.
struct LimitCheck {
  std::string name;
  double limit = 0, value = 0;  ///< of a frequency the lowest, of a wall 1 and least/thickness
  double excess = 0;            ///< value/limit - 1, of a frequency limit 1 - value/limit
  std::string at;               ///< load case; empty if it has none
  double weight = 0;            ///< above 0: no limit, part of the objective
};

/// One design, measured in all load cases.
struct SolidCheck {
  double objective = 0;            ///< with all that is weighted
  double mass = 0;                 ///< kg
  std::vector<LimitCheck> limits;  ///< those of the task, then the worst wall if there are walls
  double worst = -1;               ///< largest excess
  std::string worst_limit;
};

/// What a small round hole does to the Lagrangian.
struct HoleDerivative {
  Eigen::VectorXd
      value;            ///< at the centres of the cells, unit of the objective / m^3; of full cells
  std::string missing;  ///< what counts and has no such derivative: stress, frequencies
};

/// minimise objective(x) + sum_k w_k limit_k max_n g_kn over the limits with a weight (rows of
/// `goals`; a frequency has -w_k limit_k min), subject to value/limit - 1 <= 0 in the retained
/// cases (all cases if the objective depends on them), mass and frequency limits, and the walls of
/// the design. Gradients by adjoints; no second derivatives. At an x that leaves no part (a cut
/// interface, a defect of the shape) there is no value, and `undefined_reason` says why.
class StaticShape final : public StaticProblem {
 public:
  /// @param x0 the analysed design
  /// @param cells bounds are narrowed to where the outline has moved by this many cells
  /// @param share and to this share of a variable's range on both sides of x0
  StaticShape(const SolidTask& task, const Eigen::VectorXd& x0, double cells, double share = 1);

  int add_violated(const Eigen::VectorXd& x, double tolerance) override;
  int load_cases() const override { return static_cast<int>(retained_.kept[0].size()); }
  std::vector<LimitedResponse> responses() const override;
  /// In the retained cases. @pre before any other x
  std::vector<LimitedResponse> responses_with_slopes() override;
  std::vector<RowImage> images() const override;
  std::vector<RowGoal> goals() const override;  ///< numbered as the limits of the task
  std::string undefined_reason() const override { return undefined_reason_; }

  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override;
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override;

  /// The part at x in all load cases; nothing if there is none (see `undefined_reason`).
  std::optional<SolidCheck> check(const Eigen::VectorXd& x);
  /// Solves every case at x, for `statics`; false if there is no part there.
  bool show_all(const Eigen::VectorXd& x);
  const SolidStatics& statics() const { return statics_; }  ///< at the latest x
  /// d(objective + sum lambda_i g_i)/dV of holes with a free edge
  /// (mbs/solids/topological_derivative.hpp) at the latest x, for multipliers lambda, unit
  /// objective / g. Walls do not see new holes.
  HoleDerivative hole_derivative(const std::map<ConstraintId, double>& multipliers) const;

 private:
  void narrow(const Eigen::VectorXd& x0, double cells, double share);
  bool solve(const Eigen::VectorXd& x);
  std::vector<ScreenedLimit> screened() const;
  ValuesByLimit all_values();
  void keep(const CasesByLimit& cases);
  void keep_all();
  void take_loads();
  void add_rows_without_cases();
  /// Values of a limit by retained case.
  Eigen::VectorXd values_of(const SolidLimit& limit);
  /// d|y|/dy_i of an output limit, cases x outputs.
  Eigen::MatrixXd shares(const SolidLimit& limit) const;
  /// And their gradients, cases x variables.
  Eigen::MatrixXd gradients_of(const SolidLimit& limit);
  Eigen::MatrixXd corrected() const;
  PartSlopes slopes_of(std::size_t screened);
  const StressNorm& stress(bool with_gradient);
  const FrequencyGradient& frequencies();
  double objective();
  double extremes() const;
  LimitCheck check_limit(const SolidLimit& limit);
  std::optional<LimitCheck> check_walls() const;

  SolidTask task_;
  bool expanded_ = false;        ///< every case is solved: compliance or stress is asked for
  Eigen::MatrixXd combination_;  ///< of the retained cases
  std::vector<int> limit_of_;    ///< of the task, by screened limit
  SolidStatics statics_;
  Fractions fractions_;  ///< derivative with respect to the variables
  Eigen::MatrixXd correction_;
  ValuesByLimit at_start_;  ///< values of all cases at x0, by screened limit
  RetainedCases retained_;
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_;
  std::string undefined_reason_;
  std::optional<StressNorm> stress_;  ///< at the latest x
  bool stress_gradient_ = false;
  RowMatrix wall_gradient_;  ///< found together with the walls
  std::optional<FrequencyGradient> frequencies_;
};

}  // namespace liesl
