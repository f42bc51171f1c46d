#pragma once
/// @file
/// Springs, dampers and rigid masses in the static problem of a design: they carry no static limit,
/// and masses count.

#include "optim/design/constants.hpp"
#include "optim/problems/static_problem.hpp"

namespace liesl {

/// minimise the counted rigid masses, without constraints, within `move` of the range of each
/// variable about x.
class ConstantsProblem final : public CaselessProblem {
 public:
  ConstantsProblem(const Constants& constants, const std::vector<int>& counted,
                   const Eigen::VectorXd& x, double move);

  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd&) override { f = df_.dot(x); }
  void gradients(const Eigen::VectorXd&, Eigen::VectorXd& df, RowMatrix&) override { df = df_; }

 private:
  Eigen::VectorXd df_;
};

}  // namespace liesl
