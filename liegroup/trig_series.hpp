#pragma once
/// @file
/// The scalar functions behind exp, log, T and T^-1, all written in z = |w|^2. This is the only
/// place that divides by an angle.
///
/// Both families are evaluated in a form that has no cancellation near z = 0, so that no switch at
/// a small angle is needed:
///  - c_k(z) = sum_i (-z)^i / (2i+k)!  (Stumpff functions: c_1 = sin|w|/|w|,
///    c_2 = (1 - cos|w|)/z, c_3 = (|w| - sin|w|)/|w|^3) start from the series of the two highest
///    and go down with c_k = 1/k! - z c_{k+2}. Their derivative is dc_k/dz = (k c_{k+2} -
///    c_{k+1})/2.
///  - e(z) = (1 - g)/z, g = (|w|/2) cot(|w|/2), is its partial fractions
///    e(z) = sum_{n>=1} 2 / ((2 pi n)^2 - z), all terms positive: the poles n = 1, 2, 3 as they
///    are, the rest as a power series.
/// The remaining switches are at the large end; tests/liegroup/trig_series_test.cpp compares both
/// sides of each with long double.

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace liesl::trig {

/// p(z) = sum_i a[i] z^i, even and odd powers in two independent chains.
template <std::size_t N, class S>
constexpr S polynomial(const std::array<double, N>& a, const S& z) {
  const S zz = z * z;
  S even = 0, odd = 0;
  for (std::size_t i = N + N % 2; i >= 2; i -= 2) {
    even = even * zz + a[i - 2];
    odd = odd * zz + (i - 1 < N ? a[i - 1] : 0.0);
  }
  return even + z * odd;
}

/// Coefficients of dp/dz.
template <std::size_t N>
constexpr std::array<double, N - 1> derivative(const std::array<double, N>& a) {
  std::array<double, N - 1> d{};
  for (std::size_t i = 1; i < N; ++i) d[i - 1] = static_cast<double>(i) * a[i];
  return d;
}

/// Above this z the Stumpff functions come from sin and cos and c_{k+2} = (1/k! - c_k)/z; below
/// from the series. Rotations below 3.2 rad need no library call.
inline constexpr double kStumpffSwitch = 10.24;

/// Terms of the Stumpff series; the first one left out is below 1e-17 of c_k for z < 10.24.
inline constexpr std::size_t kStumpffTerms = 14;

constexpr double inverse_factorial(int n) {
  long double f = 1;
  for (int i = 2; i <= n; ++i) f *= i;
  return static_cast<double>(1 / f);
}

template <int K>
constexpr std::array<double, kStumpffTerms> stumpff_coefficients() {
  std::array<double, kStumpffTerms> a{};
  for (std::size_t i = 0; i < kStumpffTerms; ++i)
    a[i] = (i % 2 ? -1 : 1) * inverse_factorial(2 * static_cast<int>(i) + K);
  return a;
}

/// c_K(z) by its series, 0 <= z <= kStumpffSwitch.
template <int K>
constexpr double stumpff_series(double z) {
  constexpr std::array<double, kStumpffTerms> a = stumpff_coefficients<K>();
  return polynomial(a, z);
}

/// c_1, c_2, c_3: what exp and T need.
struct Stumpff3 {
  double c1, c2, c3;
};

/// By sin and cos; exact functions for z > 0, c_3 loses digits as 6/z.
inline Stumpff3 stumpff3_closed(double z) {
  const double angle = std::sqrt(z);
  const double half = std::sin(0.5 * angle);
  const double c1 = std::sin(angle) / angle;
  return {c1, 2 * half * half / z, (1 - c1) / z};
}

inline Stumpff3 stumpff3_by_series(double z) {
  const double c3 = stumpff_series<3>(z);
  return {1 - z * c3, stumpff_series<2>(z), c3};
}

/// c_1, c_2, c_3 at z >= 0.
inline Stumpff3 stumpff3(double z) {
  return z < kStumpffSwitch ? stumpff3_by_series(z) : stumpff3_closed(z);
}

/// c_1 ... c_7: what the derivatives of T need.
struct Stumpff7 {
  double c1, c2, c3, c4, c5, c6, c7;
};

inline Stumpff7 stumpff7_by_series(double z) {
  const double c7 = stumpff_series<7>(z), c6 = stumpff_series<6>(z);
  const double c5 = 1. / 120 - z * c7, c4 = 1. / 24 - z * c6;
  const double c3 = 1. / 6 - z * c5, c2 = 0.5 - z * c4;
  return {1 - z * c3, c2, c3, c4, c5, c6, c7};
}

inline Stumpff7 stumpff7_closed(double z) {
  const Stumpff3 c = stumpff3_closed(z);
  const double c4 = (0.5 - c.c2) / z, c5 = (1. / 6 - c.c3) / z;
  return {c.c1, c.c2, c.c3, c4, c5, (1. / 24 - c4) / z, (1. / 120 - c5) / z};
}

/// c_1 ... c_7 at z >= 0.
inline Stumpff7 stumpff7(double z) {
  return z < kStumpffSwitch ? stumpff7_by_series(z) : stumpff7_closed(z);
}

/// e(z) and its derivatives by z; e = 1/12 + z/720 + z^2/30240 + ...
template <class S>
struct InverseTangentSeries {
  static_assert(!std::is_integral_v<S>, "0.0, not 0");
  S e, de, dde;
};

/// sum_{n>=4} 2 / ((2 pi n)^2 - z) = sum_k a_k z^k, a_k = 2 sum_{n>=4} (2 pi n)^-(2k+2).
inline constexpr std::array<double, 13> kPartialFractionTail = {
    1.437863891007568332292e-2,  9.595555480779425299978e-6,  1.125714338300260912632e-8,
    1.538897956518107245602e-11, 2.247318965080410444478e-14, 3.394356459763464025873e-17,
    5.223754698482221672546e-20, 8.127414828310521521054e-23, 1.272843048024265504303e-25,
    2.001458998678854293959e-28, 3.155044680287923195827e-31, 4.981335263797585550132e-34,
    7.87255828451072945703e-37};

inline constexpr double kPole1 = 39.47841760435743447534, kPole2 = 4 * kPole1,
                        kPole3 = 9 * kPole1;  // (2 pi n)^2

/// e(z) alone: what log and T^-1 in the plane and of a rotation need.
/// @pre 0 <= z < (2 pi)^2, where T^-1 exists. To rounding over all of it.
template <class S>
S inverse_tangent_value(const S& z) {
  static_assert(!std::is_integral_v<S>, "0.0, not 0");
  return 2 * (1 / (kPole1 - z) + 1 / (kPole2 - z) + 1 / (kPole3 - z)) +
         polynomial(kPartialFractionTail, z);
}

/// @pre 0 <= z < (2 pi)^2, where T^-1 exists. To rounding over all of it.
template <class S>
InverseTangentSeries<S> inverse_tangent_series(const S& z) {
  constexpr auto d_tail = derivative(kPartialFractionTail);
  constexpr auto dd_tail = derivative(d_tail);
  const S r1 = 1 / (kPole1 - z), r2 = 1 / (kPole2 - z), r3 = 1 / (kPole3 - z);
  return {2 * (r1 + r2 + r3) + polynomial(kPartialFractionTail, z),
          2 * (r1 * r1 + r2 * r2 + r3 * r3) + polynomial(d_tail, z),
          4 * (r1 * r1 * r1 + r2 * r2 * r2 + r3 * r3 * r3) + polynomial(dd_tail, z)};
}

/// Up to this sin^2 the ratio angle/sine is its series in sin^2, above it is atan2 and a division.
inline constexpr double kArcsineSwitch = 0.0625;

/// asin(s)/s at y = s^2 <= kArcsineSwitch: sum_k (2k)! / (4^k k!^2 (2k+1)) y^k.
template <class S>
S angle_over_sine(const S& y) {
  static_assert(!std::is_integral_v<S>, "0.0, not 0");
  constexpr std::array<double, 13> a = [] {
    std::array<double, 13> c{};
    long double binomial = 1;  // (2k)! / (4^k k!^2)
    for (std::size_t k = 0; k < c.size(); ++k) {
      const auto n = static_cast<long double>(k);
      c[k] = static_cast<double>(binomial / (2 * n + 1));
      binomial *= (2 * n + 1) / (2 * n + 2);
    }
    return c;
  }();
  return polynomial(a, y);
}

}  // namespace liesl::trig
