#pragma once
/// @file
/// Closed form of a bar that turns about its end.

#include <cmath>

namespace liesl::test {

/// A bar that turns about its end, k = w L sqrt(rho/E): linear, it gets longer by tan(k)/k - 1;
/// with P = E l (l^2 - 1)/2 the first integral P l - W + rho w^2 x^2/2 is that of its free end.
inline double spun_length(double k2) {
  const auto length_at_rest = [k2](double end) {
    double sum = 0;
    constexpr int n = 2000;
    for (int i = 0; i < n; ++i) {
      const double x = end * (i + 0.5) / n, c = 0.5 * k2 * (end * end - x * x);
      const double m = (-0.5 + std::sqrt(0.25 + 1.5 * c)) / 0.75;  // l^2 - 1
      sum += end / n / std::sqrt(1 + m);
    }
    return sum;
  };
  double low = 1, high = 2;
  for (int i = 0; i < 60; ++i)
    (length_at_rest(0.5 * (low + high)) < 1 ? low : high) = 0.5 * (low + high);
  return low;
}

}  // namespace liesl::test
