#include "optim/cycle/goal_problem.hpp"

#include <algorithm>
#include <cmath>

namespace liesl {

using Eigen::MatrixXd;
using Eigen::VectorXd;

GoalProblem::Effort GoalProblem::effort(const VectorXd& x) const {
  const auto n = x.size();
  Effort e{goal_.effort, VectorXd::Zero(n), VectorXd::Zero(n)};
  if (!(goal_.effort > 0)) return e;
  double power = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double c = goal_.by_effort[i] / goal_.effort;
    if (variables_[static_cast<std::size_t>(i)].lower > 0 && x_k_[i] > 0) {
      power += c * x_k_[i] * std::log(x[i] / x_k_[i]);
      e.first[i] = c * x_k_[i] / x[i];
      e.second[i] = -e.first[i] / x[i];
    } else {
      power += c * (x[i] - x_k_[i]);
      e.first[i] = c;
    }
  }
  e.value *= std::exp(power);
  return e;
}

void GoalProblem::values(const VectorXd& x, double& f, VectorXd&) {
  f = goal_.extremes + goal_.weight_effort * effort(x).value;
  if (goal_.duration >= 0) f += goal_.weight_duration * x[goal_.duration];
}

void GoalProblem::gradients(const VectorXd& x, VectorXd& df, RowMatrix&) {
  const Effort e = effort(x);
  df = goal_.weight_effort * e.value * e.first;
  if (goal_.duration >= 0) df[goal_.duration] += goal_.weight_duration;
}

void GoalProblem::hessian(const VectorXd& x, double sigma, const VectorXd&, MatrixXd& h) {
  const Effort e = effort(x);
  MatrixXd add = e.first * e.first.transpose();
  add.diagonal() += e.second;
  h.triangularView<Eigen::Lower>() += sigma * goal_.weight_effort * e.value * add;
}

}  // namespace liesl
