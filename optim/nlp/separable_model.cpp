#include <algorithm>

#include "optim/nlp/separable.hpp"

namespace liesl {

using Eigen::ArrayXd;
using Eigen::VectorXd;

namespace {

/// p and q of one function from its gradient and rho.
void coefficients(const SeparableModel::Expansion& at, const ArrayXd& slope, double rho, ArrayXd& p,
                  ArrayXd& q) {
  const ArrayXd rise = slope.max(0), fall = (-slope).max(0);
  p = (at.u - at.y).array().square() * (1.001 * rise + 0.001 * fall + rho);
  q = (at.y - at.l).array().square() * (0.001 * rise + 1.001 * fall + rho);
}

}  // namespace

SeparableModel::SeparableModel(const Problem& original, const Expansion& at)
    : l_(at.l), u_(at.u), variables_(original.variables()) {
  const auto n = at.y.size();
  for (int j = 0; j < n; ++j) {
    auto& v = variables_[static_cast<std::size_t>(j)];
    v.lower = at.alpha[j];
    v.upper = at.beta[j];
    v.start = at.y[j];
  }
  const ArrayXd to_u = (at.u - at.y).array().inverse(), to_l = (at.y - at.l).array().inverse();
  const ArrayXd u_low = (at.u - at.alpha).array().inverse(),
                l_low = (at.alpha - at.l).array().inverse();
  const ArrayXd u_up = (at.u - at.beta).array().inverse(),
                l_up = (at.beta - at.l).array().inverse();
  ArrayXd p, q;
  coefficients(at, at.df.array(), at.f_rho, p, q);
  f_constant_ = at.f - (p * to_u + q * to_l).sum();
  f_p_ = p;
  f_q_ = q;

  g_p_.resize(at.g.size(), n);
  g_q_.resize(at.g.size(), n);
  g_constant_.resize(at.g.size());
  int rows = 0;
  for (int i = 0; i < at.g.size(); ++i) {
    coefficients(at, at.dg.row(i).transpose().array(), at.g_rho[i], p, q);
    const double constant = at.g[i] - (p * to_u + q * to_l).sum();
    // Convex in each variable: largest at an end of the box.
    const double largest = constant + (p * u_low + q * l_low).max(p * u_up + q * l_up).sum();
    if (largest < 0) continue;
    g_constant_[rows] = constant;
    g_p_.row(rows) = p;
    g_q_.row(rows) = q;
    const auto& c = original.constraints()[static_cast<std::size_t>(i)];
    constraints_.push_back({c.id, c.name, 1});
    kept_.push_back(i);
    ++rows;
  }
  g_constant_.conservativeResize(rows);
  g_p_.conservativeResize(rows, n);
  g_q_.conservativeResize(rows, n);
}

void SeparableModel::values(const VectorXd& y, double& f, VectorXd& g) {
  const VectorXd to_u = (u_ - y).cwiseInverse(), to_l = (y - l_).cwiseInverse();
  f = f_constant_ + f_p_.dot(to_u) + f_q_.dot(to_l);
  g = g_constant_ + g_p_ * to_u + g_q_ * to_l;
}

void SeparableModel::gradients(const VectorXd& y, VectorXd& df, RowMatrix& dg) {
  const VectorXd to_u = (u_ - y).array().square().inverse(),
                 to_l = (y - l_).array().square().inverse();
  df = f_p_.cwiseProduct(to_u) - f_q_.cwiseProduct(to_l);
  dg = g_p_ * to_u.asDiagonal();
  dg -= g_q_ * to_l.asDiagonal();
}

void SeparableModel::hessian(const VectorXd& y, double sigma, const VectorXd& lambda,
                             Eigen::MatrixXd& h) {
  const ArrayXd to_u = (u_ - y).array().cube().inverse(), to_l = (y - l_).array().cube().inverse();
  const ArrayXd p = sigma * f_p_ + g_p_.transpose() * lambda;
  const ArrayXd q = sigma * f_q_ + g_q_.transpose() * lambda;
  h.diagonal() = 2 * (p * to_u + q * to_l);
}

}  // namespace liesl
