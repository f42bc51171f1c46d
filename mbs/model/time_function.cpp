/// @file
/// Constant, ramped rate and tables. Expressions: time_expression.cpp; quintic splines:
/// quintic_table.cpp.

#include "mbs/model/time_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "mbs/model/time_function_kind.hpp"

namespace liesl {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

[[noreturn]] void refuse(const std::string& message) { throw std::invalid_argument(message); }

struct Constant final : TimeFunctionKind {
  explicit Constant(double c) : c_(c) {}
  double value(double) const override { return c_; }
  double rate(double) const override { return 0; }
  double acceleration(double) const override { return 0; }
  bool is_constant() const override { return true; }

 private:
  double c_;
};

/// f'' = Omega/T (1 - cos(2 pi t/T)) for 0 <= t < T: the cycloidal ramp from rest to Omega.
struct RampedRate final : TimeFunctionKind {
  RampedRate(double Omega, double T) : Omega_(Omega), T_(T) {}
  double value(double t) const override {
    if (!ramping(t)) return T_ > 0 && t < 0 ? 0 : Omega_ * (t - T_ / 2);
    const double s = std::sin(two_pi * t / T_ / 2);  // cos x - 1 = -2 sin^2(x/2)
    return Omega_ * (t * t / (2 * T_) - 2 * T_ * s * s / (two_pi * two_pi));
  }
  double rate(double t) const override {
    if (!ramping(t)) return T_ > 0 && t < 0 ? 0 : Omega_;
    return Omega_ * (t / T_ - std::sin(two_pi * t / T_) / two_pi);
  }
  double acceleration(double t) const override {
    return ramping(t) ? Omega_ / T_ * (1 - std::cos(two_pi * t / T_)) : 0;
  }
  bool is_constant() const override { return Omega_ == 0; }

 private:
  bool ramping(double t) const { return t >= 0 && t < T_; }
  double Omega_, T_;
};

struct AtSpeed final : TimeFunctionKind {
  AtSpeed(std::shared_ptr<const TimeFunctionKind> f, double speed)
      : f_(std::move(f)), speed_(speed) {}
  double value(double t) const override { return f_->value(speed_ * t); }
  double rate(double t) const override { return speed_ * f_->rate(speed_ * t); }
  double acceleration(double t) const override {
    return speed_ * speed_ * f_->acceleration(speed_ * t);
  }
  bool is_constant() const override { return f_->is_constant(); }
  std::vector<double> knots() const override {
    std::vector<double> t = f_->knots();
    for (double& at : t) at /= speed_;
    return t;
  }

 private:
  std::shared_ptr<const TimeFunctionKind> f_;
  double speed_;
};

/// Piecewise cubic Hermite; a straight line where both slopes are those of the chord.
struct Table final : TimeFunctionKind {
  Table(std::vector<double> t, std::vector<double> f, std::vector<double> left,
        std::vector<double> right)
      : t_(std::move(t)), f_(std::move(f)), left_(std::move(left)), right_(std::move(right)) {}

  double value(double t) const override {
    if (t <= t_.front()) return f_.front();
    if (t >= t_.back()) return f_.back();
    const Cubic c = cubic(t);
    return c.a + c.s * (c.b + c.s * (c.c + c.s * c.d));
  }
  double rate(double t) const override {
    if (outside(t)) return 0;
    const Cubic c = cubic(t);
    return c.b + c.s * (2 * c.c + c.s * 3 * c.d);
  }
  double acceleration(double t) const override {
    if (outside(t)) return 0;
    const Cubic c = cubic(t);
    return 2 * c.c + 6 * c.d * c.s;
  }
  bool is_constant() const override {
    return std::all_of(f_.begin(), f_.end(), [&](double f) { return f == f_.front(); });
  }
  std::vector<double> knots() const override { return t_; }

 private:
  /// a + b s + c s^2 + d s^3, s from the left end of the interval
  struct Cubic {
    double s, a, b, c, d;
  };
  bool outside(double t) const { return t < t_.front() || t >= t_.back(); }

  /// The piece at t, from the right at a point of the table; of NaN, which an iteration that
  /// diverges asks for, NaN. @pre t is inside the table or NaN
  Cubic cubic(double t) const {
    const auto next = std::upper_bound(t_.begin(), t_.end() - 1, t);
    const std::size_t i = std::size_t(next - t_.begin()) - 1;
    const double h = t_[i + 1] - t_[i], chord = (f_[i + 1] - f_[i]) / h;
    const double m0 = left_[i], m1 = right_[i];
    return {t - t_[i], f_[i], m0, (3 * chord - 2 * m0 - m1) / h, (m0 + m1 - 2 * chord) / (h * h)};
  }

  std::vector<double> t_, f_;
  std::vector<double> left_, right_;  // slopes at the two ends of each interval
};

/// Slopes at the points such that the cubic does not overshoot: three-point slopes, zero at local
/// extremes, then scaled into the circle alpha^2 + beta^2 <= 9 of each interval.
/// [F. N. Fritsch, R. E. Carlson, SIAM J. Numer. Anal. 17 (1980) 238-246, alg. 2]
std::vector<double> monotone_slopes(const std::vector<double>& t,
                                    const std::vector<double>& chord) {
  const std::size_t n = chord.size();
  std::vector<double> m(n + 1);
  for (std::size_t i = 1; i < n; ++i) {
    const double before = t[i] - t[i - 1], after = t[i + 1] - t[i];
    if (chord[i - 1] * chord[i] > 0)
      m[i] = (after * chord[i - 1] + before * chord[i]) / (before + after);
  }
  m[0] = n > 1 && chord[0] * chord[1] > 0 ? 2 * chord[0] - m[1] : chord[0];
  m[n] = n > 1 && chord[n - 1] * chord[n - 2] > 0 ? 2 * chord[n - 1] - m[n - 1] : chord[n - 1];
  if (m[0] * chord[0] < 0) m[0] = 0;
  if (m[n] * chord[n - 1] < 0) m[n] = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (chord[i] == 0) {
      m[i] = m[i + 1] = 0;
      continue;
    }
    const double radius = std::hypot(m[i], m[i + 1]) / std::abs(chord[i]);
    if (radius > 3) m[i] *= 3 / radius, m[i + 1] *= 3 / radius;
  }
  return m;
}

void check_table(const std::vector<double>& t, const std::vector<double>& f) {
  if (t.size() != f.size())
    refuse(fmt::format("time table: expected as many values as times, got {} values and {} times",
                       f.size(), t.size()));
  if (t.size() < 2)
    refuse(fmt::format(
        "time table: expected at least two points, got {}; a constant needs no table", t.size()));
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (!std::isfinite(t[i]) || !std::isfinite(f[i]))
      refuse(fmt::format("time table: expected finite numbers, got ({}, {}) at point {}", t[i],
                         f[i], i + 1));
    if (i > 0 && !(t[i] > t[i - 1]))
      refuse(
          fmt::format("time table: expected strictly increasing times, got {} after {} at point "
                      "{}; a step needs "
                      "two times that differ a little",
                      t[i], t[i - 1], i + 1));
  }
}

}  // namespace

TimeFunction TimeFunction::constant(double value) {
  if (!std::isfinite(value))
    refuse(fmt::format("constant function of time: expected a finite number, got {}", value));
  return TimeFunction(std::make_shared<Constant>(value));
}

TimeFunction TimeFunction::rate(double Omega, double T) {
  if (!std::isfinite(Omega))
    refuse(fmt::format("motion at a constant rate: expected a finite rate, got {}", Omega));
  if (!(T >= 0 && std::isfinite(T)))
    refuse(fmt::format("motion at a constant rate: expected a ramp >= 0 s, got {} s", T));
  return TimeFunction(std::make_shared<RampedRate>(Omega, T));
}

TimeFunction TimeFunction::table(std::vector<double> t, std::vector<double> f, Interpolation how) {
  check_table(t, f);
  if (how == Interpolation::Quintic) return TimeFunction(quintic_table(std::move(t), std::move(f)));
  std::vector<double> chord(t.size() - 1);
  for (std::size_t i = 0; i < chord.size(); ++i) chord[i] = (f[i + 1] - f[i]) / (t[i + 1] - t[i]);
  if (how == Interpolation::Linear)
    return TimeFunction(std::make_shared<Table>(std::move(t), std::move(f), chord, chord));
  const auto m = monotone_slopes(t, chord);
  const std::vector<double> left(m.begin(), m.end() - 1), right(m.begin() + 1, m.end());
  return TimeFunction(std::make_shared<Table>(std::move(t), std::move(f), left, right));
}

TimeFunction TimeFunction::at_speed(double speed) const {
  if (!(speed > 0 && std::isfinite(speed)))
    refuse(fmt::format("a share of the speed: expected a number > 0, got {}", speed));
  return TimeFunction(std::make_shared<AtSpeed>(kind_, speed));
}

double TimeFunction::operator()(double t) const { return kind_->value(t); }
std::vector<double> TimeFunction::knots() const { return kind_->knots(); }
double TimeFunction::rate(double t) const { return kind_->rate(t); }
double TimeFunction::acceleration(double t) const { return kind_->acceleration(t); }
bool TimeFunction::is_constant() const { return kind_->is_constant(); }

}  // namespace liesl
