#pragma once
/// @file
/// Scalar functions of time that drive joints and scale loads.

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace liesl {

struct TimeFunctionKind;

/// A function of time with its first and second derivative. Immutable, cheap to copy,
/// safe to evaluate from several threads, allocates nothing in an evaluation (an expression: once
/// for each further thread that evaluates at the same moment).
class TimeFunction {
 public:
  /// f = value. @throws std::invalid_argument if not finite
  static TimeFunction constant(double value);
  /// Motion at a constant rate that starts from rest with a cycloidal ramp of duration T:
  /// f = Omega [t^2/(2T) + T (cos(2 pi t/T) - 1)/(4 pi^2)] for t < T, then Omega (t - T/2).
  /// At rest for t < 0. T = 0: f = Omega t for every t.
  /// @throws std::invalid_argument if T < 0 or a number is not finite
  static TimeFunction rate(double Omega, double T);
  /// Through the points (t_i, f_i), t strictly increasing, at least two. Linear; a C1 piecewise
  /// cubic without overshoot (Fritsch & Carlson 1980); or a C4 quintic spline whose rate and
  /// acceleration are 0 at both ends, the interpolant with the least int f'''^2: it may overshoot,
  /// and it is linear in the values f_i. Constant outside the table. Derivatives at a point of the
  /// table are those from the right; the linear one has no acceleration.
  /// @throws std::invalid_argument
  enum class Interpolation { Linear, Cubic, Quintic };
  static TimeFunction table(std::vector<double> t, std::vector<double> f, Interpolation how);
  /// muParser expression of `t` in s (`pi` is known), e.g. "sin(2*pi*t)", "t < 1 ? t : 1".
  /// Derivatives by fourth-order central differences with steps of 2^-13 s (rate) and 2^-12 s
  /// (acceleration): relative errors below 1e-9 and 1e-7 for motions of 1 to 100 rad/s; a kink is
  /// smeared over twice the step. @throws std::invalid_argument with muParser's message and
  /// position.
  static TimeFunction expression(const std::string& text);

  /// t -> f(speed t). @throws std::invalid_argument unless speed > 0
  TimeFunction at_speed(double speed) const;

  TimeFunction() : TimeFunction(constant(0)) {}
  double operator()(double t) const;
  double rate(double t) const;          ///< first derivative
  double acceleration(double t) const;  ///< second derivative
  bool is_constant() const;
  /// Times of the points of a table, s; else none.
  std::vector<double> knots() const;

 private:
  explicit TimeFunction(std::shared_ptr<const TimeFunctionKind> kind) : kind_(std::move(kind)) {}
  std::shared_ptr<const TimeFunctionKind> kind_;
};

}  // namespace liesl
