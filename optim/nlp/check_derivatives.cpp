#include "optim/nlp/check_derivatives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "optim/nlp/evaluator.hpp"
#include "optim/nlp/fitted_slope.hpp"

namespace liesl {

using Eigen::VectorXd;

std::vector<std::string> DerivativeCheckOptions::errors() const {
  std::vector<std::string> list;
  if (!(largest_step > 0 && largest_step <= 0.5))
    list.push_back(fmt::format("largest_step: expected in (0, 0.5], got {}", largest_step));
  if (steps < 3) list.push_back(fmt::format("steps: expected >= 3, got {}", steps));
  if (!(tolerance > 0 && tolerance < 1))
    list.push_back(fmt::format("tolerance: expected in (0, 1), got {}", tolerance));
  return list;
}

int DerivativeCheckOptions::pairs() const {
  return steps + (fits ? OddFits::kPairs * static_cast<int>(OddFits::kWindows.size()) : 0);
}

namespace {

/// All functions of the problem stacked: f, g, and with a Hessian the gradient of L times D.
struct Stack {
  Problem& problem;
  VectorXd range;
  double sigma = 1;
  VectorXd lambda;
  bool hessian = false;
  bool finite = true;

  int functions() const { return 1 + static_cast<int>(lambda.size()); }
  int size() const { return functions() + (hessian ? static_cast<int>(range.size()) : 0); }

  VectorXd operator()(const VectorXd& x) {
    const auto n = range.size();
    double f = 0;
    VectorXd g = VectorXd::Zero(lambda.size()), df = VectorXd::Zero(n);
    problem.values(x, f, g);
    VectorXd out(size());
    out[0] = f;
    out.segment(1, g.size()) = g;
    if (hessian) {
      RowMatrix dg = RowMatrix::Zero(g.size(), n);
      problem.gradients(x, df, dg);
      out.tail(n) = (sigma * df + dg.transpose() * lambda).cwiseProduct(range);
    }
    finite = out.allFinite();
    return out;
  }
};

/// Derivatives of the stack with respect to x / range, size() x n, as the problem gives them.
Eigen::MatrixXd given_derivatives(const Stack& s, const VectorXd& x) {
  const auto n = s.range.size();
  VectorXd df = VectorXd::Zero(n);
  RowMatrix dg = RowMatrix::Zero(s.lambda.size(), n);
  s.problem.gradients(x, df, dg);
  Eigen::MatrixXd out(s.size(), n);
  out.row(0) = df;
  out.middleRows(1, s.lambda.size()) = dg;
  if (s.hessian) {
    Eigen::MatrixXd h = Eigen::MatrixXd::Zero(n, n);
    s.problem.hessian(x, s.sigma, s.lambda, h);
    const Eigen::MatrixXd full = h.selfadjointView<Eigen::Lower>();
    const bool diagonal = s.problem.hessian_shape() == HessianShape::Diagonal;
    out.bottomRows(n) =
        s.range.asDiagonal() * (diagonal ? Eigen::MatrixXd(h.diagonal().asDiagonal()) : full);
  }
  return out * s.range.asDiagonal();
}

/// Slope of log e over log h from the largest step down to where the error stops falling.
std::optional<double> truncation_slope(const std::vector<double>& h, const std::vector<double>& e) {
  constexpr double kClearOfRoundOff = 100;  // errors used are this many times the smallest
  constexpr double kRoundOff = 1e-11;
  const double floor =
      std::max(*std::min_element(e.begin(), e.end()), kRoundOff / kClearOfRoundOff);
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  int count = 0;
  for (std::size_t k = 0; k < h.size() && std::isfinite(e[k]); ++k) {
    if (e[k] < kClearOfRoundOff * floor) break;
    const double a = std::log(h[k]), b = std::log(e[k]);
    sx += a, sy += b, sxx += a * a, sxy += a * b, ++count;
  }
  // A wrong derivative stays level: its smallest error is the level, and all steps count.
  if (count < 2 && floor > 1e-6) {
    count = 0, sx = sy = sxx = sxy = 0;
    for (std::size_t k = 0; k < h.size() && std::isfinite(e[k]) && e[k] > 0; ++k) {
      const double a = std::log(h[k]), b = std::log(e[k]);
      sx += a, sy += b, sxx += a * a, sxy += a * b, ++count;
    }
  }
  if (count < 2) return std::nullopt;
  return (count * sxy - sx * sy) / (count * sxx - sx * sx);
}

/// Norm of the error of differences that are extrapolated once or twice, of each two neighbours
/// d(h), d(h'): (d(h') (h/h')^2 - d(h))/((h/h')^2 - 1), in the second round with fourth powers; of
/// those that differ least from the two that they come from. @param errors of the differences, by
/// step, whose extrapolation is that of the errors
double extrapolated_error(const std::vector<double>& h, std::vector<VectorXd> errors) {
  constexpr std::size_t kRounds = 2;
  double least = std::numeric_limits<double>::infinity(), error = least;
  for (std::size_t round = 1; round <= kRounds && errors.size() > 1; ++round) {
    for (std::size_t k = 0; k + 1 < errors.size(); ++k) {
      const double power = std::pow(h[k] / h[k + round], 2);
      const VectorXd limit = (power * errors[k + 1] - errors[k]) / (power - 1);
      const double apart = std::max((limit - errors[k]).norm(), (limit - errors[k + 1]).norm());
      if (apart < least) {
        least = apart;
        error = limit.norm();
      }
      errors[k] = limit;
    }
    errors.pop_back();
  }
  return error;
}

/// Left and right derivative of one function: the smallest difference over the steps, those where
/// round-off rules left out. At a kink it does not vanish with the step.
double one_sided_jump(const std::vector<double>& h, const std::vector<double>& gaps) {
  constexpr double kSmallest = 1e-6;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < h.size(); ++k)
    if (h[k] >= kSmallest) least = std::min(least, gaps[k]);
  return std::isfinite(least) ? least : 0;
}

/// Do three steps in a row agree, within a share of the least of them? So do errors where
/// differences have found a derivative, and another one than that given: where it bends they come
/// nearer to it with every step.
bool settled(const std::vector<double>& values, double share) {
  for (std::size_t k = 0; k + 2 < values.size(); ++k) {
    const double a = values[k], b = values[k + 1], c = values[k + 2];
    const double least = std::min({std::abs(a), std::abs(b), std::abs(c)});
    if (std::max({a, b, c}) - std::min({a, b, c}) < share * least) return true;
  }
  return false;
}

constexpr double kSpread = 4;  // of round-off, which differs from point to point

/// Round-off of a function, or more: its second differences over the three smallest steps.
double round_off(const std::vector<double>& h, const std::vector<double>& gaps) {
  double noise = 0;
  for (std::size_t k = h.size() - std::min<std::size_t>(h.size(), 3); k < h.size(); ++k)
    noise = std::max(noise, gaps[k] * h[k]);
  return noise;
}

/// Is round-off all that keeps the differences from the derivative: do errors fall with the square
/// of the step until they are no more than it makes them? A derivative that is wrong, or has a
/// kink, leaves an error that stays level.
bool of_round_off(const std::vector<double>& h, const std::vector<double>& e, double noise) {
  constexpr double kFalls = 0.2;  // from a step to the next: the square of it is 0.1
  const auto hidden = [&](std::size_t k) { return std::abs(e[k]) * h[k] <= kSpread * noise; };
  for (std::size_t k = 0; k < h.size(); ++k) {
    if (hidden(k)) continue;
    if (k + 1 == h.size()) return false;
    if (!hidden(k + 1) && std::abs(e[k + 1]) > kFalls * std::abs(e[k])) return false;
  }
  return true;
}

/// Do left and right derivative differ, by more or less the same over three steps at which this is
/// not round-off?
bool stay_apart(const std::vector<double>& h, const std::vector<double>& gaps, double noise) {
  std::vector<double> clear;
  for (std::size_t k = 0; k < h.size(); ++k)
    if (gaps[k] * h[k] > kSpread * noise) clear.push_back(gaps[k]);
  return settled(clear, 0.5);
}

/// Point from which all steps stay within the bounds.
VectorXd inside(const Problem& problem, VectorXd x, const VectorXd& range, double step) {
  for (int j = 0; j < x.size(); ++j) {
    const auto& v = problem.variables()[static_cast<std::size_t>(j)];
    const double margin = std::min(step * range[j], 0.5 * (v.upper - v.lower));
    x[j] = std::clamp(x[j], v.lower + margin, v.upper - margin);
  }
  return x;
}

class Sweep {
 public:
  Sweep(Stack& stack, const DerivativeCheckOptions& o, DerivativeReport& report)
      : stack_(stack),
        o_(o),
        report_(report),
        here_(stack(report.x)),
        given_(given_derivatives(stack, report.x)) {
    if (!stack.finite) throw std::runtime_error("check_derivatives: a value is not finite at x");
    if (!given_.allFinite())
      throw std::runtime_error("check_derivatives: a derivative is not finite at x");
    norms_ = given_.rowwise().norm();
    for (int i = 0; i < stack.functions(); ++i)
      if (norms_[i] <= kZero * std::abs(here_[i])) norms_[i] = kSmall * std::abs(here_[i]);
    const int n = static_cast<int>(stack.range.size());
    if (stack.hessian) norms_.tail(n).setConstant(given_.bottomRows(n).norm());
  }

  void along(const VectorXd& d, const std::string& name) {
    const VectorXd exact = given_ * d;
    std::vector<double> steps;
    std::vector<VectorXd> errors, gaps;  // by step, each by function
    for (int k = 0; k < o_.steps; ++k) {
      const double h = o_.largest_step * std::pow(10.0, -0.5 * k);
      const auto [before, after] = around(d, h);
      if (before.size() == 0) continue;
      steps.push_back(h);
      errors.push_back((after - before) / (2 * h) - exact);
      gaps.push_back(((after - here_) - (here_ - before)).cwiseAbs() / h);
    }
    const std::vector<FittedSlope> fits = o_.fits ? fitted(d) : std::vector<FittedSlope>();
    DerivativeKink kink{name};
    for (int i = 0; i < stack_.functions(); ++i) {
      add(i, 1, name, steps, errors);
      excuse(i, steps, errors, gaps, kink);
      if (o_.fits) compare(i, fits[static_cast<std::size_t>(i)], exact[i]);
    }
    if (kink.functions > 0) report_.kinks.push_back(kink);
    if (stack_.hessian)
      add(stack_.functions(), static_cast<int>(stack_.range.size()), name, steps, errors);
  }

 private:
  static constexpr double kZero = 1e-9;   // of a value over all ranges: no change
  static constexpr double kSmall = 1e-3;  // of the value, in the place of such a derivative

  std::string function(int row) const {
    if (row == 0) return "objective";
    if (row < stack_.functions())
      return stack_.problem.constraints()[static_cast<std::size_t>(row - 1)].name;
    return "Hessian of the Lagrangian";
  }

  struct Sides {
    VectorXd before, after;
  };

  /// r(x - h D d) and r(x + h D d); of size 0 if a value is not finite.
  Sides around(const VectorXd& d, double h) {
    const VectorXd shift = h * d.cwiseProduct(stack_.range);
    Sides sides;
    sides.after = stack_(report_.x + shift);
    const bool finite = stack_.finite;
    sides.before = stack_(report_.x - shift);
    if (o_.progress) o_.progress(++pairs_);
    if (finite && stack_.finite) return sides;
    ++report_.failed_evaluations;
    return {};
  }

  /// Of each function, the slope of the window whose own standard error is smallest.
  std::vector<FittedSlope> fitted(const VectorXd& d) {
    std::vector<FittedSlope> best(static_cast<std::size_t>(stack_.functions()));
    for (const double window : OddFits::kWindows) {
      if (window > o_.largest_step) continue;  // beyond the bounds
      Eigen::MatrixXd odd(OddFits::kPairs, stack_.functions());
      int finite = 0;
      for (; finite < OddFits::kPairs; ++finite) {
        const Sides sides = around(d, window * fits_.points()[finite]);
        if (sides.before.size() == 0) break;
        odd.row(finite) = (sides.after - sides.before).head(stack_.functions()) / 2;
      }
      if (finite < OddFits::kPairs) continue;
      for (int i = 0; i < stack_.functions(); ++i) {
        const FittedSlope fit = fits_(odd.col(i), window);
        FittedSlope& least = best[static_cast<std::size_t>(i)];
        if (fit.deviation < least.deviation) least = fit;
      }
    }
    return best;
  }

  /// The check that was added last with the slope of a fit.
  void compare(int row, const FittedSlope& fit, double exact) {
    if (!std::isfinite(fit.deviation)) return;
    DerivativeCheck& check = report_.checks.back();
    const double norm = norms_[row] > 0 ? norms_[row] : 1;
    check.fitted_error = std::abs(fit.slope - exact) / norm;
    check.fitted_deviation = fit.deviation / norm;
  }

  void add(int row, int rows, const std::string& name, const std::vector<double>& steps,
           const std::vector<VectorXd>& errors) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    DerivativeCheck c;
    c.function = function(row), c.direction = name;
    c.best_error = c.extrapolated_error = kNone;
    const double norm = norms_[row] > 0 ? norms_[row] : 1;
    std::vector<double> e;
    std::vector<VectorXd> of_rows;
    for (std::size_t k = 0; k < steps.size(); ++k) {
      of_rows.push_back(errors[k].segment(row, rows) / norm);
      e.push_back(of_rows.back().norm());
      if (e.back() >= c.best_error) continue;
      c.best_error = e.back();
      c.best_step = steps[k];
    }
    if (!e.empty()) c.slope = truncation_slope(steps, e);
    c.extrapolated_error = extrapolated_error(steps, std::move(of_rows));
    c.right = c.best_error <= o_.tolerance;
    report_.checks.push_back(std::move(c));
  }

  /// Is the check that was added last wrong because the function has a kink, or round-off?
  void excuse(int row, const std::vector<double>& steps, const std::vector<VectorXd>& errors,
              const std::vector<VectorXd>& gaps, DerivativeKink& kink) {
    constexpr double kFirstOrder = 0.3, kSecondOrder = 1.7;  // slope of an error that falls with h
    DerivativeCheck& check = report_.checks.back();
    if (check.right || steps.empty()) return;
    const double norm = norms_[row] > 0 ? norms_[row] : 1;
    std::vector<double> gap, error;
    for (const VectorXd& g : gaps) gap.push_back(g[row] / norm);
    for (const VectorXd& e : errors) error.push_back(e[row] / norm);
    const double noise = round_off(steps, gap);
    check.round_off = of_round_off(steps, error, noise);
    if (check.round_off) return;
    const double jump = one_sided_jump(steps, gap);
    const bool jumps = jump > 10 * o_.tolerance && stay_apart(steps, gap, noise);
    const bool bends = check.slope && *check.slope > kFirstOrder && *check.slope < kSecondOrder &&
                       !settled(error, 0.1);
    if (!jumps && !bends) return;
    ++kink.functions;
    check.kink = true;
    if (jumps) kink.jump = std::max(kink.jump, jump);
  }

  Stack& stack_;
  const DerivativeCheckOptions& o_;
  DerivativeReport& report_;
  VectorXd here_;
  Eigen::MatrixXd given_;
  VectorXd norms_;
  const OddFits fits_;
  int pairs_ = 0;
};

/// Every variable or one random direction, at report.x.
void sweep_all(Stack& stack, const DerivativeCheckOptions& o, std::mt19937 random,
               DerivativeReport& report) {
  std::uniform_real_distribution<double> around(0.5, 1.5);
  Sweep sweep(stack, o, report);
  const int n = static_cast<int>(report.x.size());
  VectorXd random_direction(n);
  for (int j = 0; j < n; ++j) {
    const auto& v = stack.problem.variables()[static_cast<std::size_t>(j)];
    const bool is_free = v.lower < v.upper;
    random_direction[j] = !is_free ? 0 : (random() % 2 ? 1 : -1) * (around(random) - 0.5);
    if (o.every_variable && is_free) sweep.along(VectorXd::Unit(n, j), v.name);
  }
  if (!o.every_variable) sweep.along(random_direction, "random");
  report.right = std::all_of(report.checks.begin(), report.checks.end(),
                             [](const DerivativeCheck& c) { return c.right || c.round_off; });
}

void refuse_invalid(const Problem& problem, const VectorXd& x, const DerivativeCheckOptions& o) {
  refuse_if("invalid options of the derivative check:", o.errors());
  refuse_if("invalid optimisation problem:", problem_errors(problem));
  const auto n = static_cast<Eigen::Index>(problem.variables().size());
  if (x.size() != n || !x.allFinite())
    throw std::invalid_argument(
        fmt::format("check_derivatives: expected x of {} finite variables, got {} ({})", n,
                    x.size(), x.allFinite() ? "finite" : "not finite"));
}

}  // namespace

DerivativeReport check_derivatives(Problem& problem, const VectorXd& x,
                                   const DerivativeCheckOptions& o) {
  refuse_invalid(problem, x, o);
  std::mt19937 random(o.seed);
  std::uniform_real_distribution<double> around(0.5, 1.5);
  Stack stack{problem, NlpScaling::of_variables(problem), 1, {}, false, true};
  stack.hessian = o.hessian && problem.has_hessian();
  stack.lambda.setOnes(static_cast<Eigen::Index>(problem.constraints().size()));
  for (int i = 0; i < stack.lambda.size(); ++i) {
    const double scale = problem.constraints()[static_cast<std::size_t>(i)].scale;
    stack.lambda[i] = around(random) / (scale > 0 ? scale : 1);
  }
  DerivativeReport report;
  report.x = inside(problem, x, stack.range, o.largest_step);
  sweep_all(stack, o, random, report);
  if (report.kinks.empty()) return report;
  if (!o.avoid_kinks) {
    report.right =
        std::all_of(report.checks.begin(), report.checks.end(),
                    [](const DerivativeCheck& c) { return c.right || c.kink || c.round_off; });
    return report;
  }
  VectorXd shifted = report.x;
  for (int j = 0; j < shifted.size(); ++j) {
    const auto& v = problem.variables()[static_cast<std::size_t>(j)];
    if (v.lower < v.upper)
      shifted[j] += (random() % 2 ? 1 : -1) * around(random) * o.largest_step * stack.range[j];
  }
  DerivativeReport moved;
  moved.x = inside(problem, shifted, stack.range, o.largest_step);
  sweep_all(stack, o, random, moved);
  moved.failed_evaluations += report.failed_evaluations;
  moved.kinks = std::move(report.kinks);
  for (DerivativeCheck& c : moved.checks) c.kink = false;
  return moved;
}

const DerivativeCheck* DerivativeReport::worst() const {
  const auto found =
      std::max_element(checks.begin(), checks.end(),
                       [](const auto& a, const auto& b) { return a.best_error < b.best_error; });
  return found == checks.end() ? nullptr : &*found;
}

namespace {

std::string fitted_columns(const DerivativeCheck& c) {
  return c.fitted_error ? fmt::format(" {:>10.2e} {:>9.1e}", *c.fitted_error, *c.fitted_deviation)
                        : fmt::format(" {:>10} {:>9}", "-", "-");
}

}  // namespace

std::string DerivativeReport::text(int rows) const {
  std::vector<const DerivativeCheck*> order;
  for (const auto& c : checks) order.push_back(&c);
  std::stable_sort(order.begin(), order.end(), [](const auto* a, const auto* b) {
    return a->right != b->right ? b->right : a->best_error > b->best_error;
  });
  std::size_t functions = 8, directions = 9;  // widths of columns
  bool fits = false;
  for (const DerivativeCheck& c : checks) {
    functions = std::max(functions, c.function.size());
    directions = std::max(directions, c.direction.size());
    fits |= c.fitted_error.has_value();
  }
  std::string out =
      fmt::format("{:<{}} {:<{}} {:>10} {:>10} {:>6} {:>12}{}\n", "function", functions,
                  "direction", directions, "error", "at step", "slope", "extrapolated",
                  fits ? fmt::format(" {:>10} {:>9}", "fitted", "+-") : "");
  int wrong = 0, kinked = 0, hidden = 0, unknown = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const DerivativeCheck& c = *order[k];
    const bool compared = std::isfinite(c.best_error);
    wrong += !c.right && !c.kink && !c.round_off && compared;
    unknown += !compared;
    kinked += c.kink;
    hidden += c.round_off;
    if (c.right && static_cast<int>(k) >= rows) continue;
    out += fmt::format("{:<{}} {:<{}} {:>10.2e} {:>10.1e} {:>6} {:>12.2e}{}{}\n", c.function,
                       functions, c.direction, directions, c.best_error, c.best_step,
                       c.slope ? fmt::format("{:.2f}", *c.slope) : "-", c.extrapolated_error,
                       !fits ? "" : fitted_columns(c),
                       c.right       ? ""
                       : !compared   ? "  no difference"
                       : c.kink      ? "  kink, not judged"
                       : c.round_off ? "  round-off, not judged"
                                     : "  WRONG");
  }
  out += fmt::format("{} derivatives checked, {} wrong\n", order.size(), wrong);
  if (unknown > 0)
    out += fmt::format(
        "{} of them could not be compared: at no step were there values on both sides, as where "
        "simulations do not reach their end\n",
        unknown);
  if (hidden > 0)
    out += fmt::format(
        "{} of them have more round-off than their differences may be off by: no difference "
        "tells\n",
        hidden);
  if (kinks.empty()) return out;
  if (kinked > 0)
    return out + fmt::format(
                     "{} of them have a kink at this point, as a peak that another one passes or "
                     "an edge on a grid line: no difference tells\n",
                     kinked);
  out += "at the given point functions have kinks, so they were checked at a nearby point:\n";
  for (const DerivativeKink& k : kinks) {
    out += fmt::format("  along {}: {} functions", k.direction, k.functions);
    out += k.jump > 0 ? fmt::format(", left and right derivative differ by up to {:.2g}\n", k.jump)
                      : ", the derivative bends\n";
  }
  return out +
         "fractions of cells have a kink where an edge or corner of an outline lies on a grid "
         "line; "
         "shift the start or the grid by part of a cell\n";
}

}  // namespace liesl
