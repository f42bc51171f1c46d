#pragma once
/// @file
/// Gradients of the limited responses of a motion by the design variables, record by record.

#include <map>
#include <string>

#include "optim/cycle/design_run.hpp"
#include "optim/cycle/static_problem.hpp"

namespace liesl {

/// v_rn = |y_r(t_n)| of each response r at the records n of the motion, and dv_rn/dx by the direct
/// form of the sensitivities (mbs/sensitivity), exact but for the tolerance of the simulation.
/// Gradients are kept where v_rn is at least `kKept` of the largest value of its limit: less does
/// not bound the design.
template <FrameGroup G>
class MotionGradients {
 public:
  static constexpr double kKept = 0.5;

  /// @param run of the design x, with a tape
  /// @throws std::invalid_argument if this motion has no sensitivities: formalism, start moved
  /// by the joints
  MotionGradients(const Design& design, const DesignRun<G>& run, const Eigen::VectorXd& x,
                  std::vector<LimitedResponse> responses);

  /// Why there are none; empty if all steps were differentiated.
  const std::string& reason() const { return reason_; }
  const std::vector<LimitedResponse>& responses() const { return responses_; }
  int records() const { return static_cast<int>(times_.size()); }
  double time(int record) const { return times_[static_cast<std::size_t>(record)]; }

  double value(int response, int record) const { return value_(response, record); }
  /// By the variables; null where it was not kept.
  const Eigen::VectorXd* gradient(int response, int record) const;
  /// The same, or that at the nearest record that has one, scaled by the values; null: there is
  /// none.
  const Eigen::VectorXd* nearest_gradient(int response, int record, int* at) const;

 private:
  std::vector<LimitedResponse> responses_;
  std::vector<double> times_;
  Eigen::MatrixXd value_;                                 ///< responses x records
  std::vector<std::map<int, Eigen::VectorXd>> gradient_;  ///< by response and record
  std::string reason_;
};

extern template class MotionGradients<SE2>;
extern template class MotionGradients<SE3>;

}  // namespace liesl
