#include "optim/problems/corrected_problem.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace liesl {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Of inner cases that the correction may lift above their limit.
constexpr double kLift = 0.02;
constexpr double kRoundOff = 1e-12;  // of the objective
constexpr double kAsymptote = 2;     // of the distance of the farther bound
constexpr double kHeld = 1e-6;       // of a variable: it has no room
constexpr double kCurved = 0.02;     // of the limit: what curvature along one step may tell

/// 1 + p, of powers e^p, of a term 1; beyond p = 1 its Taylor polynomial of second order there: a
/// long step overflows no row.
struct Growth {
  double value, first = 1, second = 0;

  Growth(double p, Approximation approximation) : value(1 + p) {
    if (approximation == Approximation::Additive) value = 1, first = 0;
    if (approximation != Approximation::Power) return;
    value = first = second = std::exp(std::min(p, 1.0));
    if (p <= 1) return;
    const double q = p - 1;
    value = second * (1 + q + 0.5 * q * q);
    first = second * (1 + q);
  }
};

}  // namespace

CorrectedProblem::CorrectedProblem(std::unique_ptr<StaticProblem> inner, MotionGradients gradients,
                                   const VectorXd& x_k, double objective,
                                   Approximations approximations)
    : inner_(std::move(inner)),
      motion_(std::move(gradients)),
      x_k_(x_k),
      approximations_(std::move(approximations)),
      variables_(inner_->variables()) {
  const double lacking = objective - correct_rows();
  if (std::abs(lacking) > kRoundOff * std::abs(objective)) rest_ = lacking;
}

Approximation Approximations::of(const LimitedResponse& response) const {
  const int i = response.constraint;
  const bool has_own = response.part_limit < 0 && i >= 0 && i < static_cast<int>(own.size()) &&
                       own[i] != Approximation::Auto;
  return has_own ? own[i] : general;
}

std::vector<LimitedResponse> CorrectedProblem::responses() const {
  if (motion_.responses() == 0) return inner_->responses();
  std::vector<LimitedResponse> out;
  for (int r = 0; r < motion_.responses(); ++r) out.push_back(motion_.response(r));
  return out;
}

void CorrectedProblem::narrow(double share) {
  const auto& widest = inner_->variables();
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    const double x = x_k_[static_cast<int>(i)];
    variables_[i].lower = x - share * (x - widest[i].lower);
    variables_[i].upper = x + share * (widest[i].upper - x);
  }
}

auto CorrectedProblem::differences(const VectorXd& x) const -> Steps {
  return {x - x_k_, VectorXd::Ones(x.size()), VectorXd::Zero(x.size())};
}

auto CorrectedProblem::logarithms(const VectorXd& x) const -> Steps {
  Steps t = differences(x);
  for (int i = 0; i < x.size(); ++i) {
    if (variables_[static_cast<std::size_t>(i)].lower <= 0 || x_k_[i] <= 0) continue;
    t.s[i] = x_k_[i] * std::log(x[i] / x_k_[i]);
    t.first[i] = x_k_[i] / x[i];
    t.second[i] = -t.first[i] / x[i];
  }
  return t;
}

/// With d = |asymptote - x_k|, t = +- (x - x_k) and q = d/(d - t): s = +- d (q - 1), s' = q^2,
/// s'' = +- 2 q^3/d; beyond the farther bound its Taylor polynomial of second order there: designs
/// that were rejected may lie beyond bounds that have moved since.
auto CorrectedProblem::reciprocals(const VectorXd& x, double side) const -> Steps {
  const auto n = x.size();
  Steps t{VectorXd(n), VectorXd(n), VectorXd(n)};
  for (int i = 0; i < n; ++i) {
    const auto& bounds = variables_[static_cast<std::size_t>(i)];
    const double room = std::max(bounds.upper - x_k_[i], x_k_[i] - bounds.lower),
                 d = kAsymptote * std::max(room, kHeld * std::max(std::abs(x_k_[i]), 1.0)),
                 way = side * (x[i] - x_k_[i]), within = std::min(way, d / kAsymptote),
                 beyond = way - within, q = d / (d - within), second = 2 * q * q * q / d;
    t.s[i] = side * (d * (q - 1) + q * q * beyond + 0.5 * second * beyond * beyond);
    t.first[i] = q * q + second * beyond;
    t.second[i] = side * second;
  }
  return t;
}

auto CorrectedProblem::steps(const VectorXd& x) const -> AllSteps {
  return {differences(x), logarithms(x), reciprocals(x, 1), reciprocals(x, -1)};
}

auto CorrectedProblem::AllSteps::of(Approximation approximation, const VectorXd& c) const -> Steps {
  if (approximation == Approximation::Power) return power;
  if (approximation != Approximation::Mma) return linear;
  const auto rises = c.array() > 0;
  return {rises.select(rising.s, falling.s), rises.select(rising.first, falling.first),
          rises.select(rising.second, falling.second)};
}

VectorXd CorrectedProblem::exponents(const AllSteps& t) const {
  VectorXd p(c_.rows());
  for (int i = 0; i < p.size(); ++i) {
    const auto c = c_.row(i);
    p[i] = approximation_[i] == Approximation::Power ? c.dot(t.power.s)
           : approximation_[i] != Approximation::Mma
               ? c.dot(t.linear.s)
               : c.cwiseMax(0).dot(t.rising.s) + c.cwiseMin(0).dot(t.falling.s);
  }
  return p;
}

/// @pre `inner` has just been made, or has taken cases
/// @returns the objective of `inner` at x_k
double CorrectedProblem::correct_rows() {
  const auto m = static_cast<int>(constraints().size()), n = static_cast<int>(x_k_.size());
  c_.setZero(m, n);
  approximation_.assign(m, Approximation::Power);
  g_.resize(m);
  dg_.resize(m, n);
  double f = 0;
  VectorXd df(n);
  inner_->values(x_k_, f, g_);
  v_k_ = g_.array() + 1;
  if (!g_.allFinite() || motion_.responses() == 0) return f;
  inner_->gradients(x_k_, df, dg_);
  const std::vector<RowImage> image = images();
  for (int i = 0; i < m; ++i) {
    const int response = image[static_cast<std::size_t>(i)].response;
    const int record = image[static_cast<std::size_t>(i)].record;
    const double v_s = v_k_[i];  // of the limit
    if (response < 0 || v_s <= 0) continue;
    int at = 0;
    const VectorXd* dv = motion_.nearest_gradient(response, record, &at);
    if (!dv) continue;
    c_.row(i) = dv->transpose() / motion_.value(response, at) - dg_.row(i) / v_s;
    approximation_[i] = approximations_.of(motion_.response(response));
    if (approximation_[i] == Approximation::Auto)
      approximation_[i] =
          dg_.row(i).isZero(0) ? approximations_.without_image : Approximation::Power;
  }
  return f;
}

VectorXd CorrectedProblem::by_width(const VectorXd& step, int power) const {
  VectorXd out = step;
  const auto& widest = inner_->variables();
  for (int i = 0; i < out.size(); ++i) {
    const auto& bounds = widest[static_cast<std::size_t>(i)];
    const double w = bounds.upper - bounds.lower;
    out[i] = w > 0 ? out[i] / std::pow(w, power) : 0;
  }
  return out;
}

bool CorrectedProblem::reaches(const VectorXd& x) const {
  const auto& widest = inner_->variables();
  for (int i = 0; i < x.size(); ++i) {
    const auto& bounds = widest[static_cast<std::size_t>(i)];
    if (x[i] < bounds.lower || x[i] > bounds.upper) return false;
  }
  return true;
}

void CorrectedProblem::make_conservative(KnownDesign rejected) {
  if (rejected.values.empty() || motion_.responses() == 0) return;
  rejected_.push_back(std::move(rejected));
  curve_rows();
}

void CorrectedProblem::pass_through(KnownDesign before) {
  if (before.values.empty() || motion_.responses() == 0 || !reaches(before.x)) return;
  before_ = std::move(before);
  curve_rows();
}

bool CorrectedProblem::forget_rejected() {
  const bool any = !rejected_.empty();
  rejected_.clear();
  kappa_.resize(0);
  return any;
}

void CorrectedProblem::curve_rows() {
  kappa_.resize(0);
  beta_.resize(0);
  if (before_) {
    const VectorXd step = by_width(before_->x - x_k_, 1);
    const double d = step.squaredNorm();
    u_ = d > 0 ? VectorXd(step / d) : step;
    beta_ = missed(*before_).unaryExpr([](double v) { return std::abs(v) <= kCurved ? v : 0.0; });
  }
  if (rejected_.empty()) return;
  kappa_.setZero(static_cast<Eigen::Index>(constraints().size()));
  for (const KnownDesign& r : rejected_) {
    const double d = by_width(r.x - x_k_, 1).squaredNorm();
    if (d > 0) kappa_ += missed(r).cwiseMax(0) / d;
  }
}

/// The limit that a row is relative to follows from value and v^ at x_k.
VectorXd CorrectedProblem::missed(const KnownDesign& at) {
  VectorXd out = VectorXd::Zero(static_cast<Eigen::Index>(constraints().size())), g = out;
  double f = 0;
  values(at.x, f, g);
  if (!g.allFinite()) return out;
  const std::vector<RowImage> image = images();
  for (int i = 0; i < out.size(); ++i) {
    const int response = image[static_cast<std::size_t>(i)].response;
    const int record = image[static_cast<std::size_t>(i)].record;
    if (response < 0) continue;
    const VectorXd& v = at.values[static_cast<std::size_t>(response)];
    const double at_k = motion_.value(response, record);
    if (record < v.size() && at_k > 0) out[i] = v_k_[i] * v[record] / at_k - 1 - g[i];
  }
  return out;
}

int CorrectedProblem::add_records(const std::vector<std::set<int>>& records) {
  const int added = inner_->add_records(records);
  if (added > 0) {
    correct_rows();
    curve_rows();
  }
  return added;
}

int CorrectedProblem::add_violated(const VectorXd& x, double tolerance) {
  const int added = inner_->add_violated(x, (1 + tolerance) * (1 - kLift) - 1);
  if (added > 0) {
    correct_rows();
    curve_rows();
  }
  return added;
}

void CorrectedProblem::values(const VectorXd& x, double& f, VectorXd& g) {
  inner_->values(x, f, g);
  f += rest_;
  g_ = g;
  const VectorXd power = exponents(steps(x));
  for (int i = 0; i < g.size(); ++i) {
    if (approximation_[i] == Approximation::Additive)
      g[i] += v_k_[i] * power[i];
    else if (power[i] != 0)
      g[i] = (g[i] + 1) * Growth(power[i], approximation_[i]).value - 1;
  }
  if (kappa_.size() > 0) g += kappa_ * by_width(x - x_k_, 1).squaredNorm();
  if (beta_.size() > 0) g += beta_ * std::pow(u_.dot(by_width(x - x_k_, 1)), 2);
}

void CorrectedProblem::gradients(const VectorXd& x, VectorXd& df, RowMatrix& dg) {
  inner_->gradients(x, df, dg);
  dg_ = dg;
  const AllSteps t = steps(x);
  const VectorXd power = exponents(t);
  for (int i = 0; i < dg.rows(); ++i) {
    const VectorXd c = c_.row(i), q = c.cwiseProduct(t.of(approximation_[i], c).first);
    const Growth e(power[i], approximation_[i]);
    dg.row(i) = e.value * dg_.row(i) + (e.first * (g_[i] + 1) + term(i)) * q.transpose();
  }
  if (kappa_.size() > 0) dg += 2 * kappa_ * by_width(x - x_k_, 2).transpose();
  if (beta_.size() > 0)
    dg += 2 * u_.dot(by_width(x - x_k_, 1)) * beta_ * by_width(u_, 1).transpose();
}

/// Of v^ = v_s e(p) + v_k p, dp = q = c s', v_k = 0 but for a term:
///   e d2v_s + e' (dv_s q^T + q dv_s^T + v_s diag(c s'')) + e'' v_s q q^T + v_k diag(c s'').
void CorrectedProblem::hessian(const VectorXd& x, double sigma, const VectorXd& lambda,
                               MatrixXd& h) {
  const AllSteps t = steps(x);
  const VectorXd power = exponents(t);
  VectorXd weight = lambda;
  for (int i = 0; i < lambda.size(); ++i) weight[i] *= Growth(power[i], approximation_[i]).value;
  inner_->hessian(x, sigma, weight, h);
  for (int i = 0; i < lambda.size(); ++i) {
    if (lambda[i] == 0) continue;
    const Growth e(power[i], approximation_[i]);
    const VectorXd c = c_.row(i), dv = dg_.row(i);
    const Steps of_row = t.of(approximation_[i], c);
    const VectorXd q = c.cwiseProduct(of_row.first);
    const double v = g_[i] + 1;
    MatrixXd add = e.first * dv * q.transpose();
    add += e.first * q * dv.transpose() + e.second * v * q * q.transpose();
    add.diagonal() += (e.first * v + term(i)) * c.cwiseProduct(of_row.second);
    h.triangularView<Eigen::Lower>() += lambda[i] * add;
  }
  if (beta_.size() > 0)
    h.triangularView<Eigen::Lower>() +=
        2 * lambda.dot(beta_) * by_width(u_, 1) * by_width(u_, 1).transpose();
  if (kappa_.size() > 0)
    h.diagonal() += 2 * lambda.dot(kappa_) * by_width(VectorXd::Ones(x.size()), 2);
}

}  // namespace liesl
