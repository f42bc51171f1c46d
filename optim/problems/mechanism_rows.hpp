#pragma once
/// @file
/// Limits that the static problem of the whole mechanism tells.

#include "optim/problems/mechanism_statics.hpp"
#include "optim/problems/motion_rows.hpp"

namespace liesl {

/// The rows of MotionRows with the values that static problems of the whole mechanism give them
/// (MechanismStatics) instead of those of the analysed design; a CorrectedProblem makes them agree
/// with the motion to first order.
template <FrameGroup G>
class MechanismRows final : public CaselessProblem {
 public:
  /// @param rows at least one  @pre simulator and run outlive this
  /// @throws std::invalid_argument as MechanismStatics does
  MechanismRows(std::unique_ptr<MotionRows> rows, const DesignSimulator<G>& simulator,
                const DesignRun<G>& run, const StudySpec& study);

  int load_cases() const override { return rows_->load_cases(); }
  std::vector<LimitedResponse> responses() const override { return rows_->responses(); }
  std::vector<RowImage> images() const override { return rows_->images(); }
  HessianShape hessian_shape() const override { return HessianShape::None; }
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override;
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override;

 private:
  struct Row {
    ResponseSpec response;
    int record;
    double limit;
  };
  std::unique_ptr<MotionRows> rows_;
  std::vector<Row> of_;
  MechanismStatics<G> statics_;
};

extern template class MechanismRows<SE2>;
extern template class MechanismRows<SE3>;

}  // namespace liesl
