#include "optim/nlp/evaluator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace liesl {

using Eigen::VectorXd;

namespace {

constexpr std::size_t kKeptPoints = 3;
constexpr double kLargestScaledGradient = 100;
constexpr double kOnBound = 1e-6;

/// "a = 1, b = 2, ..." for messages.
std::string describe(const Problem& problem, const VectorXd& x) {
  constexpr int kShown = 6;
  std::string text;
  for (int j = 0; j < x.size() && j < kShown; ++j)
    text += fmt::format("{}{} = {:.6g}", j ? ", " : "", problem.variables()[j].name, x[j]);
  return x.size() > kShown ? text + ", ..." : text;
}

}  // namespace

VectorXd start_of(const Problem& problem) {
  const auto& v = problem.variables();
  VectorXd x(v.size());
  for (std::size_t j = 0; j < v.size(); ++j) x[j] = std::clamp(v[j].start, v[j].lower, v[j].upper);
  return x;
}

double largest_violation(const VectorXd& g, const VectorXd& scale) {
  double largest = 0;
  for (int i = 0; i < g.size(); ++i) largest = std::max(largest, g[i] / scale[i]);
  return largest;
}

VectorXd NlpScaling::of_variables(const Problem& problem) {
  const auto& v = problem.variables();
  VectorXd scale(v.size());
  for (std::size_t j = 0; j < v.size(); ++j) {
    const double size = std::abs(v[j].start), range = v[j].upper - v[j].lower;
    const bool ranged = std::isfinite(range) && range > 0;
    scale[j] = !ranged ? (size > 0 ? size : 1) : size > 0 ? std::min(range, 1e3 * size) : range;
  }
  return scale;
}

NlpScaling NlpScaling::at(const Problem& problem, const NlpPoint& p) {
  NlpScaling s{of_variables(problem), 1, VectorXd::Ones(p.g.size())};
  const double slope = p.df.cwiseProduct(s.x).cwiseAbs().maxCoeff();
  s.f = std::max(std::abs(p.f), slope / kLargestScaledGradient);
  if (s.f == 0) s.f = 1;
  for (int i = 0; i < p.g.size(); ++i) {
    const double given = problem.constraints()[i].scale;
    const double found =
        std::max(std::abs(p.g[i]), p.dg.row(i).transpose().cwiseProduct(s.x).cwiseAbs().maxCoeff());
    s.g[i] = given > 0 ? given : found > 0 ? found : 1;
  }
  return s;
}

Evaluator::Evaluator(Problem& problem, const NlpOptions& options)
    : problem_(problem), options_(options) {
  refuse_if("invalid options of the optimiser:", options.errors());
  refuse_if("invalid optimisation problem:", problem_errors(problem));
  scaling_.x = NlpScaling::of_variables(problem);
  no_point_.setConstant(n(), std::numeric_limits<double>::quiet_NaN());
  current_ = differentiated_ = failed_at_ = no_point_;
  const VectorXd x = start_of(problem);
  usable_ = guard([&] { return gradients_at(x); });
  rethrow();
  if (!usable_) return;
  scaling_ = NlpScaling::at(problem, point());
  best_.reset();
  remember(point());
}

VectorXd Evaluator::lower() const {
  VectorXd y(n());
  for (int j = 0; j < n(); ++j) y[j] = problem_.variables()[j].lower / scaling_.x[j];
  return y;
}

VectorXd Evaluator::upper() const {
  VectorXd y(n());
  for (int j = 0; j < n(); ++j) y[j] = problem_.variables()[j].upper / scaling_.x[j];
  return y;
}

VectorXd Evaluator::start() const { return start_of(problem_).cwiseQuotient(scaling_.x); }

VectorXd Evaluator::unscaled(const VectorXd& y) const {
  VectorXd x = y.cwiseProduct(scaling_.x);
  for (int j = 0; j < n(); ++j)
    x[j] = std::clamp(x[j], problem_.variables()[j].lower, problem_.variables()[j].upper);
  return x;
}

bool Evaluator::values(const VectorXd& y) {
  return guard([&] { return values_at(unscaled(y)); });
}

bool Evaluator::gradients(const VectorXd& y) {
  return guard([&] { return gradients_at(unscaled(y)); });
}

bool Evaluator::hessian(const VectorXd& y, double sigma, const VectorXd& lambda) {
  return guard([&] {
    const VectorXd x = unscaled(y);
    if (!gradients_at(x)) return false;
    if (differentiated_ != x && !bring_back(points_.front(), true)) return false;
    hessian_.setZero(n(), n());
    problem_.hessian(x, sigma / scaling_.f, lambda.cwiseQuotient(scaling_.g), hessian_);
    if (problem_.hessian_shape() == HessianShape::Diagonal)
      hessian_ = VectorXd(hessian_.diagonal()).asDiagonal();
    hessian_ = scaling_.x.asDiagonal() * hessian_ * scaling_.x.asDiagonal();
    if (hessian_.triangularView<Eigen::Lower>().toDenseMatrix().allFinite()) return true;
    failure_ = fmt::format("the Hessian is not finite at {}", describe(problem_, x));
    return false;
  });
}

bool Evaluator::values_at(const VectorXd& x) {
  const auto known =
      std::find_if(points_.begin(), points_.end(), [&](const NlpPoint& p) { return p.x == x; });
  if (known != points_.end()) {
    points_.splice(points_.begin(), points_, known);
    return true;
  }
  if (failed_at_ == x || given_up()) return false;
  if (!x.allFinite()) {
    failure_ = "the optimiser asked for a point that is not finite";
    return false;
  }
  NlpPoint p;
  p.x = x;
  p.g.setZero(m());
  if (!bring_back(p, false)) return false;
  points_.push_front(std::move(p));
  if (points_.size() > kKeptPoints) points_.pop_back();
  remember(points_.front());
  return true;
}

bool Evaluator::gradients_at(const VectorXd& x) {
  if (!values_at(x)) return false;
  NlpPoint& p = points_.front();
  if (p.has_gradients) return true;
  return bring_back(p, true);
}

bool Evaluator::bring_back(NlpPoint& p, bool with_gradients) {
  NlpPoint fresh{p.x, 0, VectorXd::Zero(m()), false, {}, {}};
  if (current_ != p.x) {
    ++evaluations_;
    current_ = p.x;
    problem_.values(p.x, fresh.f, fresh.g);
    if (!finite_values(fresh)) {
      failed_at_ = p.x;
      current_ = no_point_;
      ++failures_in_a_row_;
      return false;
    }
    failures_in_a_row_ = 0;
    p.f = fresh.f;
    p.g = fresh.g;
  }
  if (!with_gradients) return true;
  fresh.df.setZero(n());
  fresh.dg.setZero(m(), n());
  ++gradient_evaluations_;
  differentiated_ = p.x;
  problem_.gradients(p.x, fresh.df, fresh.dg);
  if (!finite_gradients(fresh)) return false;
  p.df.swap(fresh.df);
  p.dg.swap(fresh.dg);
  p.has_gradients = true;
  return true;
}

bool Evaluator::finite_values(const NlpPoint& p) {
  if (std::isfinite(p.f) && p.g.allFinite()) return true;
  ++failed_;
  std::string what = "the objective";
  double value = p.f;
  for (int i = 0; std::isfinite(value) && i < m(); ++i) {
    what = fmt::format("constraint '{}'", problem_.constraints()[i].name);
    value = p.g[i];
  }
  failure_ = fmt::format("{} is {} at {}", what, value, describe(problem_, p.x));
  return false;
}

bool Evaluator::finite_gradients(const NlpPoint& p) {
  if (p.df.allFinite() && p.dg.allFinite()) return true;
  ++failed_;
  std::string what = "the objective";
  for (int i = 0; p.df.allFinite() && i < m(); ++i)
    if (!p.dg.row(i).allFinite())
      what = fmt::format("constraint '{}'", problem_.constraints()[i].name);
  failure_ = fmt::format("the gradient of {} is not finite at {}", what, describe(problem_, p.x));
  return false;
}

void Evaluator::remember(const NlpPoint& p) {
  if (scaling_.g.size() != m()) return;  // the start, before there is a scaling
  const double v = largest_violation(p.g, scaling_.g);
  const bool feasible = v <= options_.feasibility;
  const bool best_feasible = best_ && best_violation_ <= options_.feasibility;
  const bool better = !best_ || (feasible && (!best_feasible || p.f < best_->f)) ||
                      (!feasible && !best_feasible && v < best_violation_);
  if (!better) return;
  best_ = NlpPoint{p.x, p.f, p.g, false, {}, {}};
  best_violation_ = v;
}

void Evaluator::dG(double* row_major) const {
  Eigen::Map<RowMatrix> out(row_major, m(), n());
  out.noalias() = scaling_.g.cwiseInverse().asDiagonal() * point().dg;
  out.array().rowwise() *= scaling_.x.transpose().array();
}

RowMatrix Evaluator::dG() const {
  RowMatrix out(m(), n());
  dG(out.data());
  return out;
}

double Evaluator::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

std::string Evaluator::with_failure(const std::string& reason) const {
  if (failure_.empty() || reason.find(failure_) != std::string::npos) return reason;
  return reason + "; " + failure_;
}

bool Evaluator::proceed(int iteration) {
  if (broken() || given_up() || out_of_time()) return false;
  if (!options_.progress) return true;
  const NlpPoint& p = point();
  return guard([&] {
    if (options_.progress({iteration, p.f, largest_violation(p.g, scaling_.g)})) return true;
    failure_ = "stopped as asked";
    return false;
  });
}

void Evaluator::report(const NlpPoint& p, NlpResult& result) const {
  result.x = p.x;
  result.f = p.f;
  result.g = p.g;
  result.violation = largest_violation(p.g, scaling_.g);
  result.evaluations = evaluations_;
  result.gradient_evaluations = gradient_evaluations_;
  result.failed_evaluations = failed_;
  result.time = seconds();
}

VectorXd Evaluator::residual(const VectorXd& lambda) const {
  VectorXd r = dF();
  if (m() > 0) r += dG().transpose() * lambda;
  return r;
}

double Evaluator::stationarity(const VectorXd& r) const {
  const VectorXd y = point().x.cwiseQuotient(scaling_.x), lo = lower(), up = upper();
  double largest = 0;
  for (int j = 0; j < n(); ++j) {
    const bool carried =
        (y[j] - lo[j] <= kOnBound && r[j] > 0) || (up[j] - y[j] <= kOnBound && r[j] < 0);
    if (!carried) largest = std::max(largest, std::abs(r[j]));
  }
  return largest;
}

}  // namespace liesl
