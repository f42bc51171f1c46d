#include "optim/problems/objective_problem.hpp"

#include <algorithm>
#include <cmath>

namespace liesl {

using Eigen::MatrixXd;
using Eigen::VectorXd;

ObjectiveProblem::Effort ObjectiveProblem::effort(const VectorXd& x) const {
  const auto n = x.size();
  Effort e{model_.effort, VectorXd::Zero(n), VectorXd::Zero(n)};
  if (!(model_.effort > 0)) return e;
  double power = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double c = model_.by_effort[i] / model_.effort;
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

void ObjectiveProblem::values(const VectorXd& x, double& f, VectorXd&) {
  f = model_.extremes + model_.weight_effort * effort(x).value;
  if (model_.duration >= 0) f += model_.weight_duration * x[model_.duration];
}

void ObjectiveProblem::gradients(const VectorXd& x, VectorXd& df, RowMatrix&) {
  const Effort e = effort(x);
  df = model_.weight_effort * e.value * e.first;
  if (model_.duration >= 0) df[model_.duration] += model_.weight_duration;
}

void ObjectiveProblem::hessian(const VectorXd& x, double sigma, const VectorXd&, MatrixXd& h) {
  const Effort e = effort(x);
  MatrixXd add = e.first * e.first.transpose();
  add.diagonal() += e.second;
  h.triangularView<Eigen::Lower>() += sigma * model_.weight_effort * e.value * add;
}

}  // namespace liesl
