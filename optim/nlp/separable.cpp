#include "optim/nlp/separable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "optim/nlp/evaluator.hpp"
#include "optim/nlp/feasibility.hpp"
#include "optim/nlp/ipopt_driver.hpp"

namespace liesl {

using Eigen::ArrayXd;
using Eigen::VectorXd;

std::vector<std::string> SeparableOptions::errors() const {
  std::vector<std::string> list;
  const auto expect = [&list](bool ok, const char* name, const char* range, double got) {
    if (!ok) list.push_back(fmt::format("{}: expected {}, got {}", name, range, got));
  };
  expect(move > 0 && move <= 1, "move", "in (0, 1]", move);
  expect(first_asymptote > 0, "first_asymptote", "> 0", first_asymptote);
  expect(widen > 1, "widen", "> 1", widen);
  expect(narrow > 0 && narrow < 1, "narrow", "in (0, 1)", narrow);
  expect(nearest_asymptote > 0, "nearest_asymptote", "> 0", nearest_asymptote);
  expect(farthest_asymptote > nearest_asymptote, "farthest_asymptote", "> nearest_asymptote",
         farthest_asymptote);
  expect(max_repeats >= 1, "max_repeats", ">= 1", max_repeats);
  expect(smallest_step > 0, "smallest_step", "> 0", smallest_step);
  return list;
}

namespace {

constexpr double kSmallestRho = 1e-6;

class Sequence {
 public:
  Sequence(Problem& problem, const NlpOptions& options, const SeparableOptions& separable)
      : o_(options), s_(separable), e_(problem, options) {}

  NlpResult run();

 private:
  bool expand();  ///< model data at the current point
  void move_asymptotes();
  /// A trial point from the model; false if the model could not be solved.
  bool solve_model();
  /// Raises rho where the model is below the function at the trial; true if it was nowhere.
  bool conservative();
  bool step();      ///< one iteration
  bool finished();  ///< sets status and reason
  NlpResult result();

  const NlpOptions& o_;
  const SeparableOptions& s_;
  Evaluator e_;
  SeparableModel::Expansion at_;
  VectorXd range_, lower_, upper_;  ///< of y; range 1 where infinite or zero
  VectorXd before_, before2_;       ///< the two previous points
  VectorXd width_;                  ///< distance of the asymptotes
  VectorXd trial_, lambda_;         ///< lambda of all scaled constraints
  NlpWarmStart warm_;
  double model_f_ = 0;
  VectorXd model_g_;  ///< of all constraints; -inf where the model left them out
  double moved_ = 1;
  bool relaxed_ = false;  ///< the model could not be met
  std::vector<NlpViolation> conflict_;
  int iteration_ = 0;
  NlpStatus status_ = NlpStatus::Stopped;
  std::string reason_;
};

bool Sequence::expand() {
  if (!e_.gradients(at_.y)) return false;
  at_.f = e_.F();
  at_.df = e_.dF();
  at_.g = e_.G();
  at_.dg = e_.dG();
  const auto n = static_cast<double>(e_.n());  // Svanberg 2002, eq. 4.6: 0.1/n sum |df_j| range_j
  const auto rho = [&](const VectorXd& slope) {
    return std::max(kSmallestRho, 0.1 / n * slope.cwiseAbs().dot(range_));
  };
  at_.f_rho = s_.conservative ? rho(at_.df) : kSmallestRho;
  at_.g_rho.setConstant(e_.m(), kSmallestRho);
  for (int i = 0; s_.conservative && i < e_.m(); ++i) at_.g_rho[i] = rho(at_.dg.row(i).transpose());
  return true;
}

void Sequence::move_asymptotes() {
  for (int j = 0; j < e_.n(); ++j) {
    if (iteration_ < 2) {
      width_[j] = s_.first_asymptote * range_[j];
    } else {
      const double turn = (at_.y[j] - before_[j]) * (before_[j] - before2_[j]);
      width_[j] *= turn > 0 ? s_.widen : turn < 0 ? s_.narrow : 1;
    }
    width_[j] =
        std::clamp(width_[j], s_.nearest_asymptote * range_[j], s_.farthest_asymptote * range_[j]);
  }
  at_.l = at_.y - width_;
  at_.u = at_.y + width_;
  const VectorXd step = (0.9 * width_).cwiseMin(s_.move * range_);
  at_.alpha = (at_.y - step).cwiseMax(lower_);
  at_.beta = (at_.y + step).cwiseMin(upper_);
}

bool Sequence::solve_model() {
  SeparableModel model(e_.problem(), at_);
  NlpOptions inner;
  inner.tolerance = std::max(1e-12, 0.01 * o_.tolerance);
  inner.feasibility = std::max(1e-12, 0.1 * o_.feasibility);
  inner.acceptable = std::max(1e-6, inner.tolerance);
  inner.explain_infeasible = false;
  inner.time_limit = std::max(1e-3, o_.time_limit - e_.seconds());
  NlpResult r = solve_ipopt(model, inner, warm_.multipliers.empty() ? nullptr : &warm_);
  if (!r.solved()) r = solve_ipopt(model, inner);
  relaxed_ = r.status == NlpStatus::Infeasible;
  lambda_.setZero(e_.m());
  for (std::size_t k = 0; !relaxed_ && k < model.kept().size(); ++k)
    lambda_[model.kept()[k]] = r.multipliers.at(model.constraints()[k].id);
  if (relaxed_) {
    const VectorXd ones = VectorXd::Ones(static_cast<int>(model.kept().size()));
    const LeastViolation least = least_violation(solve_ipopt, model, ones, r.x, r.violation, inner);
    if (!least.solved) reason_ = least.reason;
    if (!least.solved) return false;
    r.x = least.x;
    conflict_ = least.conflict;
  } else if (r.violation > 1e-6 || (!r.solved() && r.status != NlpStatus::IterationLimit)) {
    reason_ = "a separable model could not be solved: " + r.reason;
    return false;
  } else {
    warm_ = r.warm_start();
  }
  trial_ = r.x;
  VectorXd g(static_cast<int>(model.kept().size()));
  model.values(trial_, model_f_, g);
  model_g_.setConstant(e_.m(), -std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < model.kept().size(); ++k)
    model_g_[model.kept()[k]] = g[static_cast<int>(k)];
  return true;
}

bool Sequence::conservative() {
  // d(y) of Svanberg 2002, eq. 3.9: what one unit of rho adds to a model at the trial.
  const ArrayXd up = (at_.u - trial_).array(), low = (trial_ - at_.l).array();
  const double d = ((at_.u - at_.l).array() * (trial_ - at_.y).array().square() / (up * low)).sum();
  const auto raise = [&](double& rho, double value, double model) {
    const double gap = value - model;
    if (gap <= 1e-10 * std::max(1.0, std::abs(value))) return false;
    rho = std::min(10 * rho, 1.1 * (rho + gap / std::max(d, 1e-300)));
    return true;
  };
  bool good = !raise(at_.f_rho, e_.F(), model_f_);
  const VectorXd g = e_.G();
  for (int i = 0; i < e_.m(); ++i) {
    const double model = std::isfinite(model_g_[i]) ? model_g_[i] : std::min(0.0, at_.g[i]);
    if (g[i] > 0 || std::isfinite(model_g_[i])) good &= !raise(at_.g_rho[i], g[i], model);
  }
  return good;
}

bool Sequence::step() {
  bool has_value = true;
  for (int repeat = 0; repeat <= s_.max_repeats; ++repeat) {
    if (!solve_model()) {
      if (!has_value) reason_ = e_.failure();  // what the model was made hard to solve by
      return false;
    }
    has_value = e_.values(trial_);
    if (!has_value) {
      if (e_.broken()) return false;
      at_.f_rho *= 10;  // no value there: a shorter step
      at_.g_rho *= 10;
      at_.alpha = 0.5 * (at_.alpha + at_.y);
      at_.beta = 0.5 * (at_.beta + at_.y);
      if (repeat == s_.max_repeats) reason_ = e_.failure();
      if (repeat == s_.max_repeats) return false;
      continue;
    }
    if (!s_.conservative || conservative()) break;
  }
  moved_ = ((trial_ - at_.y).cwiseQuotient(range_)).cwiseAbs().maxCoeff();
  before2_ = before_;
  before_ = at_.y;
  at_.y = trial_;
  ++iteration_;
  return true;
}

bool Sequence::finished() {
  const VectorXd g = e_.G();
  const double violation = e_.m() ? std::max(0.0, g.maxCoeff()) : 0;
  const double slack = e_.m() ? lambda_.cwiseProduct(g).cwiseAbs().maxCoeff() : 0;
  const double residual = std::max(e_.stationarity(e_.residual(lambda_)), slack);
  const bool feasible = violation <= o_.feasibility;
  if (iteration_ > 0 && !relaxed_ && feasible && residual <= o_.tolerance) {
    status_ = NlpStatus::Converged;
    reason_ = "optimality conditions hold";
    return true;
  }
  if (moved_ > s_.smallest_step) return false;
  reason_ = fmt::format("steps became too small, stationarity {:.1e}", residual);
  if (feasible && residual <= o_.acceptable) status_ = NlpStatus::Acceptable;
  if (!feasible && relaxed_) status_ = NlpStatus::Infeasible;
  return true;
}

NlpResult Sequence::run() {
  NlpResult r;
  if (!e_.usable()) {
    e_.report({start_of(e_.problem()), 0, VectorXd(), false, {}, {}}, r);
    r.stationarity = 1;
    r.reason = "the start cannot be evaluated: " + e_.failure();
    return r;
  }
  lower_ = e_.lower();
  upper_ = e_.upper();
  range_ = upper_ - lower_;
  for (int j = 0; j < e_.n(); ++j)
    if (!(range_[j] > 0 && std::isfinite(range_[j]))) range_[j] = 1;
  at_.y = before_ = before2_ = e_.start();
  width_ = s_.first_asymptote * range_;
  lambda_.setZero(e_.m());
  while (true) {
    if (!expand()) {
      reason_ = e_.failure();
      break;
    }
    if (finished()) break;
    if (iteration_ >= o_.max_iterations || e_.out_of_time()) {
      status_ = NlpStatus::IterationLimit;
      reason_ =
          e_.out_of_time() ? "time is used up" : fmt::format("{} iterations used up", iteration_);
      break;
    }
    if (!e_.proceed(iteration_)) {
      reason_ = e_.failure();
      break;
    }
    move_asymptotes();
    if (!step()) break;
  }
  e_.rethrow();
  return result();
}

NlpResult Sequence::result() {
  NlpResult r;
  r.status = status_;
  r.reason = reason_;
  r.iterations = iteration_;
  const bool last = r.solved() || r.status == NlpStatus::Infeasible;
  const VectorXd y = last ? at_.y : VectorXd(e_.best()->x.cwiseQuotient(e_.scaling().x));
  r.stationarity = 1;
  const NlpScaling& s = e_.scaling();
  r.lower_multipliers.setZero(e_.n());
  r.upper_multipliers.setZero(e_.n());
  if (e_.gradients(y)) {
    const VectorXd residual = e_.residual(lambda_);
    r.stationarity = e_.stationarity(residual);
    for (int j = 0; j < e_.n(); ++j) {
      const double z = residual[j] * s.f / s.x[j];
      if (y[j] - lower_[j] <= 1e-6) r.lower_multipliers[j] = std::max(0.0, z);
      if (upper_[j] - y[j] <= 1e-6) r.upper_multipliers[j] = std::max(0.0, -z);
    }
  }
  e_.rethrow();
  e_.report(last ? e_.point() : *e_.best(), r);
  r.has_multipliers = true;
  for (int i = 0; i < e_.m(); ++i)
    r.multipliers[e_.problem().constraints()[static_cast<std::size_t>(i)].id] =
        lambda_[i] * s.f / s.g[i];
  if (r.status != NlpStatus::Infeasible || !o_.explain_infeasible) return r;
  const LeastViolation least =
      least_violation(solve_ipopt, e_.problem(), s.g, r.x, r.violation, o_);
  r.conflict = least.conflict;
  r.stationarity = 1;
  r.reason = least.reason;
  if (least.conflict.empty()) r.status = NlpStatus::Stopped;
  if (least.solved && least.conflict.empty())
    r.reason = "stuck at a point that violates constraints, though a feasible one exists";
  return r;
}

}  // namespace

NlpResult solve_separable(Problem& problem, const NlpOptions& options,
                          const SeparableOptions& separable) {
  refuse_if("invalid options of the separable models:", separable.errors());
  return Sequence(problem, options, separable).run();
}

}  // namespace liesl
