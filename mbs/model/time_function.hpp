#pragma once
/// @file
/// Scalar functions of time that drive joints and scale loads.

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace liesl {

/// A function of time with its first and second derivative. Immutable, cheap to copy,
/// safe to evaluate from several threads, allocates nothing in an evaluation.
class TimeFunction {
 public:
  /// f = value
  static TimeFunction constant(double value);
  /// Motion at a constant rate that starts from rest with a cycloidal ramp of duration T:
  /// f = Omega [t^2/(2T) + T (cos(2 pi t/T) - 1)/(4 pi^2)] for t < T, then Omega (t - T/2).
  /// T = 0: f = Omega t.
  static TimeFunction rate(double Omega, double T);
  /// Through the points (t_i, f_i), t strictly increasing, at least two. Linear, or a C1 piecewise
  /// cubic without overshoot (Fritsch & Carlson 1980). Constant outside the table.
  /// @throws std::invalid_argument
  enum class Interpolation { Linear, Cubic };
  static TimeFunction table(std::vector<double> t, std::vector<double> f, Interpolation how);
  /// muParser expression of `t` (`pi` is known), e.g. "sin(2*pi*t)". Derivatives by fourth-order
  /// central differences. @throws std::invalid_argument with muParser's message and position.
  static TimeFunction expression(const std::string& text);

  TimeFunction() : TimeFunction(constant(0)) {}
  double operator()(double t) const;
  double rate(double t) const;          ///< first derivative
  double acceleration(double t) const;  ///< second derivative
  bool is_constant() const;

  struct Kind;

 private:
  explicit TimeFunction(std::shared_ptr<const Kind> kind) : kind_(std::move(kind)) {}
  std::shared_ptr<const Kind> kind_;
};

}  // namespace liesl
