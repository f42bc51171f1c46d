#pragma once
/// @file
/// First-order forward-mode differentiation in N variables: a formula written once gives its value
/// and its gradient, exact to round-off.

#include <Eigen/Core>
#include <cmath>

namespace liesl::levelset {

/// v + d . dx. Seed variable i with `Dual<N>::variable(x, i)`, constants with a plain number.
/// At a kink (|x| at 0, max of equals) one of the two sides is taken, never NaN.
template <int N>
struct Dual {
  using Gradient = Eigen::Matrix<double, N, 1>;
  double v = 0;
  Gradient d = Gradient::Zero();

  Dual() = default;
  Dual(double value) : v(value) {}  // NOLINT(google-explicit-constructor): constants in formulas
  Dual(double value, const Gradient& gradient) : v(value), d(gradient) {}
  static Dual variable(double value, int i) { return {value, Gradient::Unit(i)}; }

  friend Dual operator+(const Dual& a, const Dual& b) { return {a.v + b.v, a.d + b.d}; }
  friend Dual operator-(const Dual& a, const Dual& b) { return {a.v - b.v, a.d - b.d}; }
  friend Dual operator-(const Dual& a) { return {-a.v, -a.d}; }
  friend Dual operator*(const Dual& a, const Dual& b) { return {a.v * b.v, b.v * a.d + a.v * b.d}; }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double q = a.v / b.v;
    return {q, (a.d - q * b.d) / b.v};
  }
  friend bool operator<(const Dual& a, const Dual& b) { return a.v < b.v; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.v > b.v; }

  friend Dual abs(const Dual& a) { return a.v < 0 ? -a : a; }
  friend Dual sqrt(const Dual& a) {
    const double r = std::sqrt(a.v);
    return {r, r > 0 ? Gradient(a.d / (2 * r)) : Gradient::Zero()};
  }
  friend Dual cos(const Dual& a) { return {std::cos(a.v), -std::sin(a.v) * a.d}; }
  friend Dual sin(const Dual& a) { return {std::sin(a.v), std::cos(a.v) * a.d}; }
  /// a^b for a >= 0; zero with zero derivatives at a = 0 (right for b > 1).
  friend Dual pow(const Dual& a, const Dual& b) { return pow(a, b, std::pow(a.v, b.v)); }
  /// The same with the value p of a^b.
  friend Dual pow(const Dual& a, const Dual& b, double p) {
    if (!(a.v > 0)) return {0.0};
    return {p, p * (b.v / a.v * a.d + std::log(a.v) * b.d)};
  }
  friend Dual atan2(const Dual& y, const Dual& x) {
    const double rr = x.v * x.v + y.v * y.v;
    return {std::atan2(y.v, x.v),
            rr > 0 ? Gradient((x.v * y.d - y.v * x.d) / rr) : Gradient::Zero()};
  }
};

/// The plain value of a number or of a dual number.
inline double value_of(double x) { return x; }
template <int N>
double value_of(const Dual<N>& x) {
  return x.v;
}

}  // namespace liesl::levelset
