#include "optim/problems/objective_problem.hpp"

namespace liesl {

using Eigen::MatrixXd;
using Eigen::VectorXd;

ObjectiveProblem::ObjectiveProblem(ObjectiveModel model, const VectorXd& x_k,
                                   const std::vector<NlpVariable>& variables)
    : CaselessProblem(variables), model_(std::move(model)), x_k_(x_k), b_(model_.by_effort) {
  const int T = model_.duration;
  if (T >= 0) b_[T] -= model_.effort / x_k_[T];
}

ObjectiveProblem::Effort ObjectiveProblem::effort(const VectorXd& x) const {
  Effort e;
  VectorXd s = x - x_k_;
  if (const int T = model_.duration; T >= 0) {
    const double ratio = x_k_[T] / x[T];
    s[T] = 0.5 * x_k_[T] * (1 - ratio * ratio);
    e.stretch = 1 / ratio;
    e.s_first = ratio * ratio * ratio;
    e.s_second = -3 * e.s_first / x[T];
  }
  const VectorXd Cs = model_.curvature * s;
  e.q = model_.effort + b_.dot(s) + s.dot(Cs);
  e.by_s = b_ + 2 * Cs;
  return e;
}

VectorXd ObjectiveProblem::slope(const Effort& e) const {
  VectorXd out = e.by_s;
  if (model_.duration >= 0) out[model_.duration] *= e.s_first;
  return out;
}

void ObjectiveProblem::values(const VectorXd& x, double& f, VectorXd&) {
  const Effort e = effort(x);
  f = model_.extremes + model_.weight_effort * e.stretch * e.q;
  if (model_.duration >= 0) f += model_.weight_duration * x[model_.duration];
}

void ObjectiveProblem::gradients(const VectorXd& x, VectorXd& df, RowMatrix&) {
  const Effort e = effort(x);
  df = model_.weight_effort * e.stretch * slope(e);
  if (const int T = model_.duration; T >= 0)
    df[T] += model_.weight_duration + model_.weight_effort * e.q / x_k_[T];
}

void ObjectiveProblem::hessian(const VectorXd& x, double sigma, const VectorXd&, MatrixXd& h) {
  const Effort e = effort(x);
  MatrixXd add = 2 * e.stretch * model_.curvature;
  if (const int T = model_.duration; T >= 0) {
    add.row(T) *= e.s_first;
    add.col(T) *= e.s_first;
    add(T, T) += e.stretch * e.by_s[T] * e.s_second;
    const VectorXd p = slope(e) / x_k_[T];
    add.row(T) += p.transpose();
    add.col(T) += p;
  }
  h.triangularView<Eigen::Lower>() += sigma * model_.weight_effort * add;
}

}  // namespace liesl
