#include "optim/nlp/elastic.hpp"

#include <algorithm>
#include <limits>

namespace liesl {

using Eigen::VectorXd;

ElasticProblem::ElasticProblem(Problem& inner, Weights weights, VectorXd scale,
                               const VectorXd& start, double start_violation)
    : inner_(inner), weights_(weights), scale_(std::move(scale)), variables_(inner.variables()) {
  for (std::size_t j = 0; j < variables_.size(); ++j)
    variables_[j].start = start[static_cast<int>(j)];
  variables_.push_back({"largest violation", 0, std::numeric_limits<double>::infinity(),
                        std::max(1.1 * start_violation, 1e-3)});
  for (const auto& c : inner.constraints()) constraints_.push_back({c.id, c.name, 1});
}

void ElasticProblem::values(const VectorXd& x, double& f, VectorXd& g) {
  const auto n = x.size() - 1;
  inner_.values(x.head(n), f, g);
  g = (g.array() / scale_.array() - x[n]).matrix();
  f = weights_.objective * f + weights_.penalty * x[n];
}

void ElasticProblem::gradients(const VectorXd& x, VectorXd& df, RowMatrix& dg) {
  const auto n = x.size() - 1;
  RowMatrix inner_dg(dg.rows(), n);
  VectorXd inner_df(n);
  inner_.gradients(x.head(n), inner_df, inner_dg);
  dg.leftCols(n) = scale_.cwiseInverse().asDiagonal() * inner_dg;
  dg.col(n).setConstant(-1);
  df.head(n) = weights_.objective * inner_df;
  df[n] = weights_.penalty;
}

void ElasticProblem::hessian(const VectorXd& x, double sigma, const VectorXd& lambda,
                             Eigen::MatrixXd& h) {
  const auto n = x.size() - 1;
  Eigen::MatrixXd inner_h = Eigen::MatrixXd::Zero(n, n);
  inner_.hessian(x.head(n), sigma * weights_.objective, lambda.cwiseQuotient(scale_), inner_h);
  h.topLeftCorner(n, n) = inner_h;
}

}  // namespace liesl
