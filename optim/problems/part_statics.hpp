#pragma once
/// @file
/// Statics of the parts that one group of design variables changes, sized beams or a meshed part:
/// loads, responses and their gradients, as an EslProblem asks for them.

#include <optional>

#include "optim/problems/case_screen.hpp"
#include "optim/problems/static_problem.hpp"

namespace liesl {

/// value(y) <= limit of outputs first .. first + count of a part, in every load case.
struct CaseLimit {
  std::string name;  ///< of its rows, "NAME at CASE"
  ScreenedLimit screened;
  int first = 0, count = 1;
  std::optional<LimitedResponse> motion = {};  ///< what it is the image of; none: fixed loads
  /// Above 0: no limit, but this times the largest value of its cases in the objective; the limit
  /// is then its size at the analysed design.
  double weight = 0;
};

/// A limit of a problem at one design: its worst value and the case of it.
struct LimitCheck {
  std::string name;
  double limit = 0, value = 0;  ///< of a frequency the lowest, of a wall 1 and least/thickness
  double excess = 0;            ///< value/limit - 1, of a frequency limit 1 - value/limit
  std::string at;               ///< load case; empty if it has none
  double weight = 0;            ///< above 0: no limit, part of the objective
};

/// Contract: `retain` and `solve` come before what is asked of a design; derivatives are those at
/// the latest design.
class PartStatics {
 public:
  PartStatics() = default;
  PartStatics(const PartStatics&) = delete;
  PartStatics& operator=(const PartStatics&) = delete;
  virtual ~PartStatics() = default;

  const std::vector<CaseLimit>& limits() const { return limits_; }
  /// What the load cases are called, by part.
  const std::vector<std::vector<std::string>>& cases() const { return cases_; }
  /// The objective depends on all of them.
  virtual bool needs_every_case() const { return false; }
  /// The design variables with their bounds narrowed about x0. @pre x0 is the latest design
  virtual std::vector<NlpVariable> variables(const Eigen::VectorXd& x0) const = 0;

  /// Solves these cases from the next `solve` on. @param kept by part, in this order
  virtual void retain(const std::vector<std::vector<int>>& kept) = 0;
  /// Outputs of the retained cases at x. @returns why there are none ("interface 'pin' is cut off
  /// ..."); empty if there are
  virtual std::string solve(const Eigen::VectorXd& x) = 0;

  /// Outputs x retained cases.
  virtual const Eigen::MatrixXd& y(int part) const = 0;
  /// The first outputs as the motion has them at the analysed design, x all cases; no rows: none.
  virtual const Eigen::MatrixXd& measured(int part) const = 0;
  /// dy/dx_i by variable, outputs x retained cases.
  virtual std::vector<Eigen::MatrixXd> output_gradients(int part) = 0;
  /// What a limit bounds, of its outputs y: |y| unless said otherwise; `slope`: gradient by y.
  virtual double value(int limit, const Eigen::VectorXd& y, Eigen::VectorXd* slope) const {
    (void)limit;
    const double v = y.norm();
    if (slope) *slope = v > 0 ? Eigen::VectorXd(y / v) : Eigen::VectorXd::Zero(y.size());
    return v;
  }
  /// d value/dx_i at fixed outputs.
  virtual double explicit_slope(int, const Eigen::VectorXd&, int) const { return 0; }

  /// Of a limit of a part itself over its motion, in the retained cases `kept` of the latest
  /// design; without `value`. @pre the limit's motion has a part_limit
  virtual PartSlopes slopes(int limit, const std::vector<int>& kept) {
    (void)limit, (void)kept;
    return {};
  }

  virtual double mass() const = 0;  ///< kg, of what counts
  /// Without what is weighted.
  virtual double objective() { return mass(); }
  virtual void objective_gradient(Eigen::VectorXd& df) = 0;

  virtual bool has_second() const { return false; }
  /// h += sigma d2f/dx2 + sum over parts, outputs and retained cases of weight * d2y/dx2.
  /// @pre has_second: all values are norms; first derivatives have been asked for
  virtual void add_second(double sigma, const std::vector<Eigen::MatrixXd>& weights,
                          Eigen::MatrixXd& h) const {
    (void)sigma, (void)weights, (void)h;
  }

  /// Limits of the design alone: mass, frequencies, walls.
  virtual std::vector<NlpConstraint> own_rows() const { return {}; }
  virtual std::vector<RowImage> own_images() const { return {}; }
  virtual Eigen::VectorXd own_values() { return {}; }
  virtual RowMatrix own_gradients() { return {}; }
  /// One a row; empty: all are limits. Numbers as those of the screened limits.
  virtual std::vector<ObjectiveTerm> own_terms() const { return {}; }
  /// What the weighted quantities were at the analysed design, times their weights; their rows tell
  /// the change.
  virtual double terms_at_start() const { return 0; }
  /// Adds them to those by load case, in the order of the study. @returns what they add to the
  /// objective
  virtual double add_checks(std::vector<LimitCheck>&) { return 0; }

 protected:
  std::vector<CaseLimit> limits_;  ///< filled by the constructor, as the cases
  std::vector<std::vector<std::string>> cases_;
};

}  // namespace liesl
