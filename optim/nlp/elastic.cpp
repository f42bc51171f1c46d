#include "optim/nlp/elastic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace liesl {

using Eigen::VectorXd;

ElasticProblem::ElasticProblem(Problem& inner, Weights weights, VectorXd scale,
                               const VectorXd& start, double start_violation,
                               std::vector<Epigraph> terms)
    : inner_(inner),
      weights_(weights),
      scale_(std::move(scale)),
      terms_(std::move(terms)),
      variables_(inner.variables()) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < variables_.size(); ++j)
    variables_[j].start = start[static_cast<int>(j)];
  const auto last = static_cast<Eigen::Index>(variables_.size() + terms_.size());
  bound_.assign(inner.constraints().size(), last);
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    for (const int row : terms_[k].rows)
      bound_[static_cast<std::size_t>(row)] = static_cast<Eigen::Index>(variables_.size());
    variables_.push_back({fmt::format("term {}", k), -kInfinity, kInfinity, terms_[k].start});
  }
  std::string name = "largest violation";  // of a problem that is elastic itself, once more
  while (std::any_of(variables_.begin(), variables_.end(),
                     [&](const NlpVariable& v) { return v.name == name; }))
    name += " again";
  variables_.push_back({name, 0, kInfinity, std::max(1.1 * start_violation, 1e-3)});
  for (const auto& c : inner.constraints()) constraints_.push_back({c.id, c.name, 1});
}

void ElasticProblem::values(const VectorXd& x, double& f, VectorXd& g) {
  const auto n = static_cast<Eigen::Index>(inner_.variables().size()), last = x.size() - 1;
  inner_.values(x.head(n), f, g);
  g = (g.array() / scale_.array()).matrix();
  for (Eigen::Index i = 0; i < g.size(); ++i) g[i] -= x[bound_[static_cast<std::size_t>(i)]];
  for (std::size_t k = 0; k < terms_.size(); ++k)
    f += terms_[k].weight * x[n + static_cast<Eigen::Index>(k)];
  f = weights_.objective * f + weights_.penalty * x[last];
}

void ElasticProblem::gradients(const VectorXd& x, VectorXd& df, RowMatrix& dg) {
  const auto n = static_cast<Eigen::Index>(inner_.variables().size()), last = x.size() - 1;
  RowMatrix inner_dg(dg.rows(), n);
  VectorXd inner_df(n);
  inner_.gradients(x.head(n), inner_df, inner_dg);
  dg.setZero();
  dg.leftCols(n) = scale_.cwiseInverse().asDiagonal() * inner_dg;
  for (Eigen::Index i = 0; i < dg.rows(); ++i) dg(i, bound_[static_cast<std::size_t>(i)]) = -1;
  df.head(n) = weights_.objective * inner_df;
  for (std::size_t k = 0; k < terms_.size(); ++k)
    df[n + static_cast<Eigen::Index>(k)] = weights_.objective * terms_[k].weight;
  df[last] = weights_.penalty;
}

void ElasticProblem::hessian(const VectorXd& x, double sigma, const VectorXd& lambda,
                             Eigen::MatrixXd& h) {
  const auto n = static_cast<Eigen::Index>(inner_.variables().size());
  Eigen::MatrixXd inner_h = Eigen::MatrixXd::Zero(n, n);
  inner_.hessian(x.head(n), sigma * weights_.objective, lambda.cwiseQuotient(scale_), inner_h);
  h.topLeftCorner(n, n) = inner_h;
}

}  // namespace liesl
