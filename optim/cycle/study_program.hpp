#pragma once
/// @file
/// A study as a nonlinear program: values and gradients of the study itself at any design.

#include "optim/cycle/design_model.hpp"

namespace liesl {

/// Every point is an analysis, its gradients those of the study (DesignModel::surrogate at that
/// point). Rows are numbered in the order of the surrogate's and are the same at every design; a
/// design that cannot be analysed, has other rows or, after the first, no sensitivities, has no
/// value (NaN).
class StudyProgram : public Problem {
 public:
  /// @param move limits of the static problems that the gradients are asked of (cycle.move_limit)
  StudyProgram(DesignModel& model, double move) : model_(model), move_(move) {}

  /// Analyses the design that says which rows there are. @returns as `evaluate`
  /// @throws NoSensitivities
  bool begin(const Eigen::VectorXd& start);
  /// Analyses x, unless it is the latest. @returns whether it has values and gradients
  bool evaluate(const Eigen::VectorXd& x);

  bool good() const { return surrogate_.problem != nullptr; }  ///< at the latest x
  const Eigen::VectorXd& x() const { return x_; }              ///< the latest
  const std::shared_ptr<DesignAnalysis>& analysis() const { return analysis_; }  ///< of x
  const Surrogate& surrogate() const { return surrogate_; }  ///< at x; without a problem: none
  const std::string& failure() const { return failure_; }    ///< why
  bool stopped() const { return stopped_; }                  ///< on request, within a design

  const std::vector<NlpVariable>& variables() const override { return model_.variables(); }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override;
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override;

 protected:
  virtual std::shared_ptr<DesignAnalysis> analyse(const Eigen::VectorXd& x) {
    return model_.analyse(x, {});
  }
  /// Of a design that could be analysed; calls `differentiate`.
  virtual void look_at(const Eigen::VectorXd& x) { differentiate(x); }
  void differentiate(const Eigen::VectorXd& x);

 private:
  DesignModel& model_;
  const double move_;
  std::vector<NlpConstraint> constraints_;
  Eigen::VectorXd x_;
  std::shared_ptr<DesignAnalysis> analysis_;
  Surrogate surrogate_;
  std::string failure_;
  bool begun_ = false, stopped_ = false;
};

}  // namespace liesl
