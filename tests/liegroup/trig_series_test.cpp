/// The scalar functions of liegroup/trig_series.hpp against long double, and the choice of their
/// switch points.

#include "liegroup/trig_series.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <vector>

namespace liesl::test::trig_series_test {
namespace {

using namespace trig;

using Long = long double;
constexpr double kEps = std::numeric_limits<double>::epsilon();
constexpr Long kPi = std::numbers::pi_v<Long>;

/// z = angle^2 from 1e-24 to max, dense.
std::vector<double> squares_up_to(double max) {
  std::vector<double> z{0};
  for (double a = 1e-12; a < 0.1; a *= 1.3) z.push_back(a * a);
  for (int i = 0; i <= 2000; ++i) z.push_back(0.01 + (max - 0.01) * i / 2000.0);
  return z;
}

Long factorial(int n) { return n < 2 ? 1 : n * factorial(n - 1); }

/// c_k by the series in long double. It loses a factor exp(sqrt(z)) of 5e-20: enough up to z = 45.
Long stumpff_reference(int k, Long z) {
  Long term = 1 / factorial(k), sum = 0;
  for (int i = 0; i < 60; ++i) {
    sum += term;
    term *= -z / ((2 * i + k + 1) * Long(2 * i + k + 2));
  }
  return sum;
}

/// |B_2k|/(2k)! = 2 zeta(2k)/(2 pi)^2k, the coefficients of e.
Long bernoulli_coefficient(int k) {
  Long zeta = k == 1 ? kPi * kPi / 6 : k == 2 ? kPi * kPi * kPi * kPi / 90 : 0;
  for (int n = 3000; k > 2 && n >= 1; --n) zeta += std::pow(Long(n), Long(-2 * k));
  return 2 * zeta / std::pow(2 * kPi, Long(2 * k));
}

struct Reference {
  Long e, de, dde;
};

/// e and derivatives: power series below z = 16 (ratio 0.4), closed form above, where nothing
/// cancels; g = (x/2) cot(x/2), p = (z/4)/sin^2(x/2).
Reference inverse_tangent_reference(Long z) {
  static const std::vector<Long> a = [] {
    std::vector<Long> c;
    for (int k = 1; k <= 60; ++k) c.push_back(bernoulli_coefficient(k));
    return c;
  }();
  if (z < 16) {
    Reference r{};
    for (std::size_t k = a.size(); k-- > 0;) {
      const auto n = static_cast<Long>(k);
      r.e = r.e * z + a[k];
      if (k >= 1) r.de = r.de * z + n * a[k];
      if (k >= 2) r.dde = r.dde * z + n * (n - 1) * a[k];
    }
    return r;
  }
  const Long half = std::sqrt(z) / 2, g = half / std::tan(half);
  const Long p = z / 4 / (std::sin(half) * std::sin(half));
  const Long q = p + g - 2;
  return {(1 - g) / z, q / (2 * z * z), ((p * (1 - g) + (g - p) / 2) / 2 - q) / (z * z * z)};
}

double relative(double value, Long reference) {
  return static_cast<double>(std::abs((value - reference) / reference));
}

/// Largest error of c_1..c_7 relative to c_k(0) = 1/k!, the scale it enters the operators with.
double error_of(const Stumpff7& c, double z) {
  const double value[] = {c.c1, c.c2, c.c3, c.c4, c.c5, c.c6, c.c7};
  Long worst = 0;
  for (int k = 1; k <= 7; ++k)
    worst = std::max(worst, std::abs(value[k - 1] - stumpff_reference(k, z)) * factorial(k));
  return static_cast<double>(worst);
}

double error_of(const Stumpff3& c, double z) {
  const double value[] = {c.c1, c.c2, c.c3};
  Long worst = 0;
  for (int k = 1; k <= 3; ++k)
    worst = std::max(worst, std::abs(value[k - 1] - stumpff_reference(k, z)) * factorial(k));
  return static_cast<double>(worst);
}

TEST(TrigSeries, StumpffAgainstLongDouble) {
  for (double z : squares_up_to(40)) {
    EXPECT_LE(error_of(stumpff3(z), z), 3 * kEps) << z;
    EXPECT_LE(error_of(stumpff7(z), z), 6 * kEps) << z;
  }
}

/// Below the switch c_2 ... c_7 are also relatively exact; c_1 = sin/angle has a zero at pi.
TEST(TrigSeries, StumpffRelative) {
  for (double z : squares_up_to(kStumpffSwitch)) {
    const Stumpff7 c = stumpff7(z);
    const double value[] = {c.c2, c.c3, c.c4, c.c5, c.c6, c.c7};
    for (int k = 2; k <= 7; ++k)
      EXPECT_LE(relative(value[k - 2], stumpff_reference(k, z)), 6 * kEps) << z << " k " << k;
  }
}

/// The switch is not a matter of luck: at 20 % around it both sides hold the tolerance of the sweep
/// above; the closed form fails well below it, the truncated series well above.
TEST(TrigSeries, StumpffSwitch) {
  for (double f = 0.8; f <= 1.2; f += 0.01) {
    const double z = f * kStumpffSwitch;
    EXPECT_LE(error_of(stumpff7_by_series(z), z), 6 * kEps) << z;
    EXPECT_LE(error_of(stumpff7_closed(z), z), 6 * kEps) << z;
  }
  EXPECT_GT(error_of(stumpff7_closed(0.5), 0.5), 100 * kEps);
  EXPECT_GT(error_of(stumpff7_by_series(40), 40), 100 * kEps);
}

/// dc_k/dz = (k c_{k+2} - c_{k+1})/2, the recursion the derivatives of T rely on.
TEST(TrigSeries, StumpffDerivative) {
  for (double z : {1e-6, 0.1, 1.0, 4.0, 9.0, 20.0}) {
    for (int k = 1; k <= 5; ++k) {
      const Long d = 1e-5L * (1 + z);
      const Long slope = (stumpff_reference(k, z + d) - stumpff_reference(k, z - d)) / (2 * d);
      const Long formula = (k * stumpff_reference(k + 2, z) - stumpff_reference(k + 1, z)) / 2;
      EXPECT_NEAR(static_cast<double>(slope), static_cast<double>(formula), 1e-11);
    }
  }
}

TEST(TrigSeries, InverseTangentAgainstLongDouble) {
  for (double z : squares_up_to(39)) {
    const InverseTangentSeries s = inverse_tangent_series(z);
    const Reference r = inverse_tangent_reference(z);
    // Close to the pole z = 4 pi^2 the functions amplify the rounding of z itself.
    const double tol = 5 * kEps * (1 + z / (39.478417604357 - z));
    EXPECT_LE(relative(s.e, r.e), tol) << z;
    EXPECT_LE(relative(inverse_tangent_value(z), r.e), tol) << z;
    EXPECT_LE(relative(s.de, r.de), 2 * tol) << z;
    EXPECT_LE(relative(s.dde, r.dde), 3 * tol) << z;
  }
}

/// The published small-angle coefficients: (1-g)/z and (1/b + g - 2)/z^2 = 2 de/dz.
TEST(TrigSeries, SmallAngleCoefficients) {
  EXPECT_EQ(inverse_tangent_series(0.0).e, 1. / 12);
  EXPECT_NEAR(inverse_tangent_series(0.0).de, 1. / 720, kEps / 720);
  for (double angle : {1e-12, 1e-6, 1e-3, 0.02}) {
    const double z = angle * angle;
    const InverseTangentSeries s = inverse_tangent_series(z);
    EXPECT_NEAR(s.e, 1. / 12 + z / 720 + z * z / 30240, kEps / 4);
    EXPECT_NEAR(2 * s.de, 1. / 360 + z / 7560 + z * z / 201600, 1e-15);
    EXPECT_NEAR(4 * s.dde, 1. / 3780 + z / 50400, 1e-10);
  }
}

TEST(TrigSeries, AngleOverSine) {
  for (double y : squares_up_to(kArcsineSwitch)) {
    const Long s = std::sqrt(Long(y));
    const Long reference = y == 0 ? 1 : std::asin(s) / s;
    EXPECT_LE(relative(angle_over_sine(y), reference), 2 * kEps) << y;
  }
  EXPECT_GT(relative(angle_over_sine(0.25), std::asin(0.5L) / 0.5L), 100 * kEps);
}

TEST(TrigSeries, Polynomial) {
  constexpr std::array<double, 4> even{1, 2, 3, 4};
  constexpr std::array<double, 5> odd{1, 2, 3, 4, 5};
  EXPECT_EQ(polynomial(even, 2.0), 49);
  EXPECT_EQ(polynomial(odd, 2.0), 129);
  EXPECT_EQ(polynomial(derivative(odd), 2.0), 222);
}

}  // namespace
}  // namespace liesl::test::trig_series_test
