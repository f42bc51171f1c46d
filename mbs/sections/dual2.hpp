#pragma once
/// @file
/// Second-order forward-mode differentiation in one variable.

#include <cmath>

namespace liesl {

/// A number that carries its first and second derivative with respect to one variable x
/// (a Taylor series cut after the second term). A formula written once for Dual2 gives value,
/// d/dx and d^2/dx^2, all exact to round-off. Seed the variable with {x, 1, 0}, constants with {c}.
struct Dual2 {
  double v = 0;   ///< value
  double d = 0;   ///< first derivative
  double dd = 0;  ///< second derivative

  constexpr Dual2(double value = 0, double first = 0, double second = 0)
      : v(value), d(first), dd(second) {}
};

constexpr Dual2 operator+(Dual2 a, Dual2 b) { return {a.v + b.v, a.d + b.d, a.dd + b.dd}; }
constexpr Dual2 operator-(Dual2 a, Dual2 b) { return {a.v - b.v, a.d - b.d, a.dd - b.dd}; }
constexpr Dual2 operator-(Dual2 a) { return {-a.v, -a.d, -a.dd}; }

/// (ab)'' = a'' b + 2 a' b' + a b''
constexpr Dual2 operator*(Dual2 a, Dual2 b) {
  return {a.v * b.v, a.d * b.v + a.v * b.d, a.dd * b.v + 2 * a.d * b.d + a.v * b.dd};
}

/// q = a/b from a = q b: q' = (a' - q b')/b, q'' = (a'' - 2 q' b' - q b'')/b
constexpr Dual2 operator/(Dual2 a, Dual2 b) {
  const double q = a.v / b.v;
  const double q1 = (a.d - q * b.d) / b.v;
  return {q, q1, (a.dd - 2 * q1 * b.d - q * b.dd) / b.v};
}

inline Dual2 exp(Dual2 a) {
  const double e = std::exp(a.v);
  return {e, e * a.d, e * (a.dd + a.d * a.d)};
}

inline Dual2 sqrt(Dual2 a) {
  const double s = std::sqrt(a.v), s1 = a.d / (2 * s);
  return {s, s1, (a.dd - 2 * s1 * s1) / (2 * s)};
}

/// a^n for n >= 0.
constexpr Dual2 power(Dual2 a, int n) {
  Dual2 p = 1;
  for (; n > 0; --n) p = p * a;
  return p;
}

}  // namespace liesl
