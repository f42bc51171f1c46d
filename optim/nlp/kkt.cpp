#include "optim/nlp/kkt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "mbs/linalg/dense.hpp"

namespace liesl {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// What one column of the least-squares problem is a multiplier of.
struct Carrier {
  enum Kind { Constraint, Lower, Upper } kind;
  int index;
  double unit;  ///< multiplier in units of the problem per column coefficient
};

struct Columns {
  MatrixXd a;
  std::vector<Carrier> carriers;
};

Columns near_active(const Problem& problem, const NlpPoint& p, const NlpScaling& s,
                    const KktOptions& options) {
  const auto n = static_cast<int>(p.x.size());
  Columns out;
  for (int i = 0; i < p.g.size(); ++i)
    if (p.g[i] >= -options.active * s.g[i])
      out.carriers.push_back({Carrier::Constraint, i, s.f / s.g[i]});
  for (int j = 0; j < n; ++j) {
    const auto& v = problem.variables()[j];
    const double bound = options.active_bound * s.x[j];
    if (p.x[j] - v.lower <= bound) out.carriers.push_back({Carrier::Lower, j, s.f / s.x[j]});
    if (v.upper - p.x[j] <= bound) out.carriers.push_back({Carrier::Upper, j, s.f / s.x[j]});
  }
  out.a.setZero(n, static_cast<int>(out.carriers.size()));
  for (std::size_t k = 0; k < out.carriers.size(); ++k) {
    const auto& c = out.carriers[k];
    auto column = out.a.col(static_cast<int>(k));
    if (c.kind == Carrier::Constraint)
      column = p.dg.row(c.index).transpose().cwiseProduct(s.x) / s.g[c.index];
    else
      column[c.index] = c.kind == Carrier::Lower ? -1 : 1;
  }
  return out;
}

void read_multipliers(const Problem& problem, const NlpPoint& p, const Columns& columns,
                      const VectorXd& z, double f_scale, KktResidual& out) {
  out.lower_multipliers.setZero(p.x.size());
  out.upper_multipliers.setZero(p.x.size());
  for (std::size_t k = 0; k < columns.carriers.size(); ++k) {
    const auto& c = columns.carriers[k];
    const double value = z[static_cast<int>(k)] * c.unit;
    if (c.kind == Carrier::Lower) out.lower_multipliers[c.index] = value;
    if (c.kind == Carrier::Upper) out.upper_multipliers[c.index] = value;
    if (c.kind != Carrier::Constraint) continue;
    ++out.active;
    out.multipliers[problem.constraints()[c.index].id] = value;
    out.complementarity = std::max(out.complementarity, value * std::abs(p.g[c.index]) / f_scale);
  }
}

}  // namespace

std::vector<std::string> KktOptions::errors() const {
  std::vector<std::string> list;
  if (!(active > 0)) list.push_back(fmt::format("active: expected > 0, got {}", active));
  if (!(active_bound > 0))
    list.push_back(fmt::format("active_bound: expected > 0, got {}", active_bound));
  if (!(tolerance > 0 && tolerance < 1))
    list.push_back(fmt::format("tolerance: expected in (0, 1), got {}", tolerance));
  return list;
}

KktResidual kkt_residual(const Problem& problem, const NlpPoint& p, const KktOptions& options) {
  refuse_if("invalid options of the optimality check:", options.errors());
  NlpScaling s = NlpScaling::at(problem, p);
  const VectorXd slope = p.df.cwiseProduct(s.x);
  s.f = std::max(std::abs(p.f), slope.cwiseAbs().maxCoeff());
  if (s.f == 0) s.f = 1;
  const Columns columns = near_active(problem, p, s, options);
  const VectorXd z = nonnegative_least_squares(columns.a, -slope / s.f);
  VectorXd r = slope / s.f;
  if (z.size()) r += columns.a * z;

  KktResidual out;
  int worst = 0;
  out.stationarity = r.cwiseAbs().maxCoeff(&worst);
  out.worst_variable = problem.variables()[worst].name;
  out.worst_slope = r[worst];
  out.feasibility = largest_violation(p.g, s.g);
  if (out.feasibility > 0) {
    p.g.cwiseQuotient(s.g).maxCoeff(&worst);
    out.worst_constraint = problem.constraints()[worst].name;
  }
  read_multipliers(problem, p, columns, z, s.f, out);
  return out;
}

KktResidual kkt_residual(Problem& problem, const VectorXd& x, const KktOptions& options) {
  refuse_if("invalid optimisation problem:", problem_errors(problem));
  const auto n = static_cast<int>(problem.variables().size());
  const auto m = static_cast<int>(problem.constraints().size());
  if (x.size() != n)
    throw std::invalid_argument(
        fmt::format("kkt_residual: expected x of {} variables, got {}", n, x.size()));
  NlpPoint p{x, 0, VectorXd::Zero(m), true, VectorXd::Zero(n), RowMatrix::Zero(m, n)};
  problem.values(p.x, p.f, p.g);
  problem.gradients(p.x, p.df, p.dg);
  if (!std::isfinite(p.f) || !p.g.allFinite() || !p.df.allFinite() || !p.dg.allFinite())
    throw std::runtime_error("kkt_residual: the problem has no finite values and gradients at x");
  return kkt_residual(problem, p, options);
}

std::string KktResidual::brief() const {
  std::string text =
      fmt::format("optimality conditions: stationarity {:.2e} ('{}' should {}), feasibility {:.2e}",
                  stationarity, worst_variable, worst_slope < 0 ? "grow" : "shrink", feasibility);
  if (!worst_constraint.empty()) text += fmt::format(" ('{}')", worst_constraint);
  return text + fmt::format(", complementarity {:.2e}, {} near-active constraints", complementarity,
                            active);
}

namespace {

/// Least squares on the columns in `passive`, zero elsewhere.
VectorXd restricted_solution(const MatrixXd& a, const VectorXd& b,
                             const std::vector<int>& passive) {
  MatrixXd part(a.rows(), static_cast<int>(passive.size()));
  for (std::size_t k = 0; k < passive.size(); ++k)
    part.col(static_cast<int>(k)) = a.col(passive[k]);
  const VectorXd s = linalg::least_squares(part, b);
  VectorXd z = VectorXd::Zero(a.cols());
  for (std::size_t k = 0; k < passive.size(); ++k) z[passive[k]] = s[static_cast<int>(k)];
  return z;
}

/// Longest step from z towards `trial` that keeps z >= 0; variables that reach 0 leave `passive`.
void retreat(VectorXd& z, const VectorXd& trial, std::vector<int>& passive) {
  double alpha = 1;
  for (const int k : passive)
    if (trial[k] <= 0) alpha = std::min(alpha, z[k] / (z[k] - trial[k]));
  int leaving = -1;
  for (const int k : passive) {
    if (trial[k] <= 0 && z[k] / (z[k] - trial[k]) <= alpha) leaving = k;
    z[k] += alpha * (trial[k] - z[k]);
  }
  if (leaving >= 0) z[leaving] = 0;
  std::erase_if(passive, [&](int k) { return z[k] <= 0; });
}

}  // namespace

VectorXd nonnegative_least_squares(const MatrixXd& a, const VectorXd& b) {
  VectorXd z = VectorXd::Zero(a.cols());
  if (a.cols() == 0) return z;
  const VectorXd lengths = a.colwise().norm();
  const double small = 1e-14 * std::max(b.norm(), std::numeric_limits<double>::min());
  std::vector<int> passive;
  std::vector<bool> refused(static_cast<std::size_t>(a.cols()), false);
  for (int round = 0; round < 3 * static_cast<int>(a.cols()) + 10; ++round) {
    const VectorXd w = a.transpose() * (b - a * z);
    int enter = -1;
    double steepest = small;
    for (int k = 0; k < a.cols(); ++k) {
      const bool in = std::find(passive.begin(), passive.end(), k) != passive.end();
      if (in || refused[static_cast<std::size_t>(k)] || lengths[k] == 0) continue;
      if (w[k] / lengths[k] > steepest) steepest = w[k] / lengths[k], enter = k;
    }
    if (enter < 0) break;
    passive.push_back(enter);
    VectorXd trial = restricted_solution(a, b, passive);
    if (trial[enter] <= 0) {  // round-off: this column cannot help now (Lawson & Hanson p. 164)
      passive.pop_back();
      refused[static_cast<std::size_t>(enter)] = true;
      continue;
    }
    std::fill(refused.begin(), refused.end(), false);
    while (!passive.empty() &&
           std::any_of(passive.begin(), passive.end(), [&](int k) { return trial[k] <= 0; })) {
      retreat(z, trial, passive);
      if (!passive.empty()) trial = restricted_solution(a, b, passive);
    }
    for (int k = 0; k < a.cols(); ++k) z[k] = 0;
    for (const int k : passive) z[k] = trial[k];
  }
  return z;
}

}  // namespace liesl
