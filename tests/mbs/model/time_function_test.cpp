/// @file
/// Time functions: closed forms, derivatives against differences, shape, threads, memory.

#include "mbs/model/time_function.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <thread>

#include "mbs/allocation_count.hpp"
#include "mbs/step_sweep.hpp"

namespace liesl::test::time_function_test {
namespace {

constexpr double pi = std::numbers::pi;
using Interpolation = TimeFunction::Interpolation;

/// f' and f'' of a function against central differences of f, slope 2.
void expect_derivatives(const TimeFunction& f, double t, double h, double round_off) {
  const auto one = [](double x) -> Eigen::VectorXd { return Eigen::VectorXd::Constant(1, x); };
  const test::VectorOf value = [&](double s) { return one(f(s)); };
  const auto scale = one(1 + std::abs(f(t)) + std::abs(f.rate(t)) + std::abs(f.acceleration(t)));
  test::expect_second_order(test::central_first(value, t), one(f.rate(t)), scale, h, round_off,
                            "rate at " + std::to_string(t));
  test::expect_second_order(test::central_second(value, t), one(f.acceleration(t)), scale, h,
                            100 * round_off, "acceleration at " + std::to_string(t));
}

/// Iterations that diverge ask for it.
TEST(TimeFunction, OfWhatIsNoNumberIsNone) {
  for (const auto how : {Interpolation::Linear, Interpolation::Cubic, Interpolation::Quintic}) {
    const auto f = TimeFunction::table({0, 1, 2}, {0, 1, 4}, how);
    EXPECT_TRUE(std::isnan(f(NAN)));
    EXPECT_TRUE(std::isnan(f.rate(NAN)));
    EXPECT_TRUE(std::isnan(f.acceleration(NAN)));
  }
}

TEST(TimeFunction, ConstantIsTheDefault) {
  EXPECT_EQ(TimeFunction()(3), 0);
  const auto f = TimeFunction::constant(2.5);
  EXPECT_EQ(f(-1), 2.5);
  EXPECT_EQ(f.rate(1), 0);
  EXPECT_TRUE(f.is_constant());
  EXPECT_THROW(TimeFunction::constant(NAN), std::invalid_argument);
}

TEST(TimeFunction, RateStartsFromRestWithACycloidalRamp) {
  const double Omega = 150, T = 0.04;
  const auto f = TimeFunction::rate(Omega, T);
  for (double t : {0.0, 0.01, 0.03}) {
    EXPECT_NEAR(f(t),
                Omega * (t * t / (2 * T) + T * (std::cos(2 * pi * t / T) - 1) / (4 * pi * pi)),
                1e-14);
    EXPECT_NEAR(f.rate(T - t) + f.rate(t), Omega, 1e-11);  // the ramp is symmetric
  }
  EXPECT_NEAR(f(0.12), Omega * (0.12 - T / 2), 1e-13);
  EXPECT_EQ(f.rate(0.12), Omega);
  EXPECT_EQ(f(-0.01), 0);
  for (double t : {0.0, T}) {  // C2 at both ends
    const double e = 1e-7;
    EXPECT_NEAR(f(t + e), f(t - e), 2.1 * Omega * e);
    EXPECT_NEAR(f.rate(t + e), f.rate(t - e), 1e-6);
    EXPECT_NEAR(f.acceleration(t + e), f.acceleration(t - e), 1e-3);
  }
  for (double t : {0.005, 0.02, 0.033, 0.1}) expect_derivatives(f, t, 1e-3, 1e-10);
  EXPECT_FALSE(f.is_constant());
  EXPECT_TRUE(TimeFunction::rate(0, T).is_constant());
}

TEST(TimeFunction, RateWithoutRampIsALine) {
  const auto f = TimeFunction::rate(3, 0);
  EXPECT_EQ(f(2), 6);
  EXPECT_EQ(f(-2), -6);
  EXPECT_EQ(f.rate(0), 3);
  EXPECT_EQ(f.acceleration(0), 0);
  EXPECT_THROW(TimeFunction::rate(3, -1), std::invalid_argument);
}

TEST(TimeFunction, LinearTable) {
  const auto f = TimeFunction::table({0, 2.5, 5}, {0, 200, 0}, Interpolation::Linear);
  EXPECT_DOUBLE_EQ(f(1), 80);
  EXPECT_DOUBLE_EQ(f(4), 80);
  EXPECT_DOUBLE_EQ(f(2.5), 200);
  EXPECT_EQ(f(-1), 0);
  EXPECT_EQ(f(6), 0);
  EXPECT_DOUBLE_EQ(f.rate(1), 80);
  EXPECT_DOUBLE_EQ(f.rate(2.5), -80);  // from the right
  EXPECT_EQ(f.rate(5), 0);
  EXPECT_NEAR(f.acceleration(1), 0, 1e-12);
}

TEST(TimeFunction, CubicTableIsC1WithoutOvershoot) {
  // Data of Akima as used by Fritsch & Carlson: flat, then a steep rise.
  const std::vector<double> t = {0, 2, 3, 5, 6, 8, 9, 11, 12, 14, 15};
  const std::vector<double> y = {10, 10, 10, 10, 10, 10, 10.5, 15, 50, 60, 85};
  const auto f = TimeFunction::table(t, y, Interpolation::Cubic);
  for (std::size_t i = 0; i < t.size(); ++i) EXPECT_NEAR(f(t[i]), y[i], 1e-12);
  for (double s = 0; s < 15; s += 0.01) EXPECT_GE(f(s + 0.01), f(s) - 1e-12) << s;
  for (std::size_t i = 1; i + 1 < t.size(); ++i)
    EXPECT_NEAR(f.rate(t[i] - 1e-9), f.rate(t[i]), 1e-6) << t[i];
  for (double s : {2.3, 8.4, 11.7, 14.2}) expect_derivatives(f, s, 0.05, 1e-9);
  EXPECT_EQ(f(-1), 10);
  EXPECT_EQ(f(20), 85);
  EXPECT_EQ(f.rate(20), 0);
}

TEST(TimeFunction, CubicTableHasFlatExtremes) {
  const auto f = TimeFunction::table({0, 1, 2, 3}, {0, 1, -1, 0}, Interpolation::Cubic);
  EXPECT_EQ(f.rate(1), 0);
  EXPECT_EQ(f.rate(2), 0);
  for (double s = 0; s <= 3; s += 0.01) EXPECT_LE(std::abs(f(s)), 1 + 1e-14);
}

TEST(TimeFunction, CubicTableConvergesOnSmoothMonotoneData) {
  double previous = 0;
  for (int n : {16, 32, 64}) {
    std::vector<double> t, y;
    for (int i = 0; i <= n; ++i) t.push_back(double(i) / n), y.push_back(std::exp(double(i) / n));
    const auto f = TimeFunction::table(t, y, Interpolation::Cubic);
    double error = 0;
    for (double s = 0; s < 1; s += 1e-3) error = std::max(error, std::abs(f(s) - std::exp(s)));
    if (previous > 0) {
      EXPECT_NEAR(std::log2(previous / error), 3, 0.05) << n;
    }
    previous = error;
  }
}

/// Two points: the quintic of a motion from rest to rest, 10 u^3 - 15 u^4 + 6 u^5.
TEST(TimeFunction, QuinticTableOfTwoPoints) {
  const auto f = TimeFunction::table({1, 3}, {2, 5}, Interpolation::Quintic);
  for (double t : {1.2, 2.0, 2.9}) {
    const double u = (t - 1) / 2;
    EXPECT_NEAR(f(t), 2 + 3 * (u * u * u * (10 + u * (-15 + 6 * u))), 1e-14);
    EXPECT_NEAR(f.rate(t), 45 * std::pow(u * (1 - u), 2), 1e-13);
    EXPECT_NEAR(f.acceleration(t), 45 * u * (1 - u) * (1 - 2 * u), 1e-13);
  }
  EXPECT_EQ(f(0), 2);
  EXPECT_EQ(f(4), 5);
  for (double t : {0.0, 1.0, 3.0, 4.0}) {
    EXPECT_EQ(f.rate(t), 0);
    EXPECT_EQ(f.acceleration(t), 0);
  }
}

/// At its inner points the first four derivatives are continuous, those of order three and four by
/// differences of accelerations; at both ends it is at rest.
TEST(TimeFunction, QuinticTableIsC4AndAtRestAtItsEnds) {
  const std::vector<double> t = {0, 0.2, 0.5, 0.9, 1.0, 1.6}, y = {0, 0.3, 0.1, 1, 1.2, 0.4};
  const auto f = TimeFunction::table(t, y, Interpolation::Quintic);
  const double e = 1e-4;
  for (std::size_t i = 0; i < t.size(); ++i) EXPECT_NEAR(f(t[i]), y[i], 1e-14);
  const auto third = [&](double s) {
    return (f.acceleration(s + e) - f.acceleration(s - e)) / (2 * e);
  };
  const auto fourth = [&](double s) {
    return (f.acceleration(s + e) - 2 * f.acceleration(s) + f.acceleration(s - e)) / (e * e);
  };
  double largest = 0;  // of the fourth derivative
  for (double s = 2 * e; s < 1.6 - 2 * e; s += 0.01) largest = std::max(largest, fourth(s));
  for (std::size_t i = 1; i + 1 < t.size(); ++i) {
    EXPECT_NEAR(f.rate(t[i] - 1e-9), f.rate(t[i] + 1e-9), 1e-6) << i;
    EXPECT_NEAR(f.acceleration(t[i] - 1e-9), f.acceleration(t[i] + 1e-9), 1e-5) << i;
    EXPECT_NEAR(third(t[i] - 2 * e), third(t[i] + 2 * e), 5 * e * largest) << i;
    EXPECT_NEAR(fourth(t[i] - 2 * e), fourth(t[i] + 2 * e), 0.02 * largest) << i;
  }
  for (double end : {0.0, 1.6}) {
    EXPECT_NEAR(f.rate(end + (end > 0 ? -1e-7 : 1e-7)), 0, 1e-9);
    EXPECT_NEAR(f.acceleration(end + (end > 0 ? -1e-7 : 1e-7)), 0, 1e-3);
  }
  for (double s : {0.1, 0.31, 0.95, 1.3}) expect_derivatives(f, s, 0.01, 1e-10);
}

/// The derivative by a value is the table of a unit there.
TEST(TimeFunction, QuinticTableIsLinearInItsValues) {
  const std::vector<double> t = {0, 0.2, 0.5, 0.9, 1.6};
  const auto a = TimeFunction::table(t, {0, 1, -2, 0.5, 3}, Interpolation::Quintic),
             b = TimeFunction::table(t, {1, 0, 4, 2, -1}, Interpolation::Quintic),
             sum = TimeFunction::table(t, {2, 1, 6, 4.5, 1}, Interpolation::Quintic);
  for (double s = 0; s < 1.6; s += 0.05) {
    EXPECT_NEAR(sum(s), a(s) + 2 * b(s), 1e-13);
    EXPECT_NEAR(sum.acceleration(s), a.acceleration(s) + 2 * b.acceleration(s), 1e-9);
  }
}

TEST(TimeFunction, QuinticTableConvergesOnSmoothMotions) {
  const auto motion = [](double s) { return s - std::sin(2 * pi * s) / (2 * pi); };
  double previous = 0;
  for (int n : {8, 16, 32}) {
    std::vector<double> t, y;
    for (int i = 0; i <= n; ++i) t.push_back(double(i) / n), y.push_back(motion(t.back()));
    const auto f = TimeFunction::table(t, y, Interpolation::Quintic);
    double error = 0;
    for (double s = 0; s < 1; s += 1e-3) error = std::max(error, std::abs(f(s) - motion(s)));
    if (previous > 0) {
      EXPECT_GT(std::log2(previous / error), 5) << n;
    }
    previous = error;
  }
}

TEST(TimeFunction, AtAShareOfItsSpeed) {
  const auto f = TimeFunction::expression("sin(3*t) + t^2"), slow = f.at_speed(0.25);
  for (double t : {0.1, 0.9, 4.0}) {
    EXPECT_EQ(slow(t), f(t / 4));
    EXPECT_EQ(slow.rate(t), f.rate(t / 4) / 4);
    EXPECT_EQ(slow.acceleration(t), f.acceleration(t / 4) / 16);
  }
  EXPECT_TRUE(TimeFunction::constant(2).at_speed(0.5).is_constant());
  EXPECT_THROW(f.at_speed(0), std::invalid_argument);
}

TEST(TimeFunction, TableRefusesBadPoints) {
  const auto refused = [](std::vector<double> t, std::vector<double> f, const char* word) {
    try {
      TimeFunction::table(t, f, Interpolation::Linear);
      ADD_FAILURE() << word;
    } catch (const std::invalid_argument& e) {
      EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
    }
  };
  refused({0, 1}, {0}, "as many values");
  refused({0}, {0}, "two points");
  refused({0, 1, 1}, {0, 1, 2}, "at point 3");
  refused({0, NAN}, {0, 1}, "finite");
}

TEST(TimeFunction, Expression) {
  const auto f = TimeFunction::expression("2*sin(3*pi*t) + t^2");
  const double w = 3 * pi;
  for (double t : {-0.3, 0.0, 0.7, 40.0}) {
    EXPECT_NEAR(f(t), 2 * std::sin(w * t) + t * t, 1e-12 * (1 + t * t));
    EXPECT_NEAR(f.rate(t), 2 * w * std::cos(w * t) + 2 * t, 2e-8);
    EXPECT_NEAR(f.acceleration(t), -2 * w * w * std::sin(w * t) + 2, 5e-7 * (1 + t * t));
  }
  EXPECT_FALSE(f.is_constant());
  EXPECT_TRUE(TimeFunction::expression("3*pi").is_constant());
  EXPECT_DOUBLE_EQ(TimeFunction::expression("3*pi")(7), 3 * pi);
}

TEST(TimeFunction, ExpressionDerivativesOfFastMotions) {
  const double w = 100;
  const auto f = TimeFunction::expression("sin(100*t)");
  for (double t : {0.1, 0.2, 0.3}) {
    EXPECT_NEAR(f.rate(t), w * std::cos(w * t), 1e-9 * w);
    EXPECT_NEAR(f.acceleration(t), -w * w * std::sin(w * t), 2e-8 * w * w);
  }
}

TEST(TimeFunction, ExpressionWithCondition) {
  const auto f = TimeFunction::expression("t < 1 ? t : 2 - t");
  EXPECT_DOUBLE_EQ(f(0.25), 0.25);
  EXPECT_DOUBLE_EQ(f(1.5), 0.5);
  EXPECT_NEAR(f.rate(0.5), 1, 1e-10);
  EXPECT_NEAR(f.rate(1.5), -1, 1e-10);
}

TEST(TimeFunction, ExpressionThatStartsAtZeroHasOneSidedDerivatives) {
  const auto f = TimeFunction::expression("t*sqrt(t) + 3*t");
  EXPECT_TRUE(std::isfinite(f.acceleration(0)));
  EXPECT_NEAR(f.rate(0), 3, 0.01);
}

TEST(TimeFunction, ExpressionErrorsSayWhatAndWhere) {
  const auto refused = [](const char* text, const char* word) {
    try {
      TimeFunction::expression(text);
      ADD_FAILURE() << text;
    } catch (const std::invalid_argument& e) {
      EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
      EXPECT_NE(std::string(e.what()).find("expected"), std::string::npos) << e.what();
    }
  };
  refused("sin(2*pi*tau)", "tau");
  refused("sin(2*pi*tau)", "character 10");
  refused("1 + ", "character");
  refused("", "expected");
  refused("1,5", "comma");
}

TEST(TimeFunction, CopiesShareAndEvaluateFromManyThreads) {
  const auto f = TimeFunction::expression("t < 0.5 ? sin(pi*t) : cos(pi*t)");
  std::atomic<int> wrong{0};
  std::vector<std::thread> threads;
  for (int k = 0; k < 8; ++k)
    threads.emplace_back([copy = f, k, &wrong] {
      for (int i = 0; i < 5000; ++i) {
        const double t = (i * 8 + k) / 40000.0;
        const double exact = t < 0.5 ? std::sin(pi * t) : std::cos(pi * t);
        if (std::abs(copy(t) - exact) > 1e-12) ++wrong;
      }
    });
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

TEST(TimeFunction, EvaluationsAllocateNothing) {
  const std::vector<TimeFunction> functions = {
      TimeFunction::constant(1), TimeFunction::rate(150, 0.04),
      TimeFunction::table({0, 1, 2}, {0, 1, 0}, Interpolation::Cubic),
      TimeFunction::table({0, 1, 2}, {0, 1, 0}, Interpolation::Quintic),
      TimeFunction::expression("t < 1 ? sin(2*pi*t) : max(t, 3)^2")};
  const long before = test::allocation_count();
  double sum = 0;
  for (const auto& f : functions)
    for (int i = 0; i < 100; ++i) sum += f(0.02 * i) + f.rate(0.02 * i) + f.acceleration(0.02 * i);
  EXPECT_EQ(test::allocation_count(), before);
  EXPECT_TRUE(std::isfinite(sum));
}

}  // namespace
}  // namespace liesl::test::time_function_test
