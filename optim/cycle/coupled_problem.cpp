#include "optim/cycle/coupled_problem.hpp"

namespace liesl {

using Eigen::VectorXd;

CoupledProblem::CoupledProblem(std::unique_ptr<StaticProblem> inner, const VectorXd& x_k)
    : inner_(std::move(inner)), x_k_(x_k) {
  take_rows();
}

void CoupledProblem::take_rows() {
  double f = 0;
  g_k_.resize(static_cast<Eigen::Index>(constraints().size()));
  inner_->values(x_k_, f, g_k_);
  constant_.clear();
  for (const RowImage& image : images()) constant_.push_back(image.response >= 0);
}

int CoupledProblem::add_violated(const VectorXd& x, double tolerance) {
  const int added = inner_->add_violated(x, tolerance);
  if (added > 0) take_rows();
  return added;
}

void CoupledProblem::values(const VectorXd& x, double& f, VectorXd& g) {
  inner_->values(x, f, g);
  for (Eigen::Index i = 0; i < g.size(); ++i)
    if (constant_[static_cast<std::size_t>(i)]) g[i] = g_k_[i];
}

void CoupledProblem::gradients(const VectorXd& x, VectorXd& df, RowMatrix& dg) {
  inner_->gradients(x, df, dg);
  for (Eigen::Index i = 0; i < dg.rows(); ++i)
    if (constant_[static_cast<std::size_t>(i)]) dg.row(i).setZero();
}

void CoupledProblem::hessian(const VectorXd& x, double sigma, const VectorXd& lambda,
                             Eigen::MatrixXd& h) {
  VectorXd others = lambda;
  for (Eigen::Index i = 0; i < lambda.size(); ++i)
    if (constant_[static_cast<std::size_t>(i)]) others[i] = 0;
  inner_->hessian(x, sigma, others, h);
}

}  // namespace liesl
