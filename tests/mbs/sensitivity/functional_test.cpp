/// @file
/// Functionals of histories: closed forms, bounds, homogeneity, derivatives against differences.

#include "mbs/sensitivity/functional.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace liesl::test::functional_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

const std::vector<FunctionalSpec>& all() {
  static const std::vector<FunctionalSpec> specs{
      {FunctionalKind::Peak, 0}, {FunctionalKind::At, 0.3},  {FunctionalKind::Integral, 0},
      {FunctionalKind::Mean, 0}, {FunctionalKind::Rms, 0},   {FunctionalKind::PNorm, 8},
      {FunctionalKind::Ks, 500}, {FunctionalKind::PNorm, 1},
  };
  return specs;
}

VectorXd times(int n) {
  VectorXd t(n);
  for (int i = 0; i < n; ++i) t[i] = double(i) / (n - 1) + 0.02 * std::sin(5.0 * i / n);
  return t;
}

MatrixXd random_history(int components, int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return MatrixXd::NullaryExpr(components, n, [&] { return uniform(random); });
}

TEST(Functional, DerivativesAreThoseOfDifferences) {
  for (const int components : {1, 2, 3}) {
    const MatrixXd y = random_history(components, 12, 7);
    const VectorXd t = times(12);
    for (const FunctionalSpec& spec : all()) {
      const FunctionalValue at = evaluate(spec, t, y);
      for (int i = 0; i < y.size(); ++i) {
        const auto moved = [&](double by) {
          MatrixXd z = y;
          z.data()[i] += by;
          return evaluate(spec, t, z).value;
        };
        const double h = 1e-5;
        const double difference =
            (8 * (moved(h) - moved(-h)) - (moved(2 * h) - moved(-2 * h))) / (12 * h);
        EXPECT_NEAR(at.by_y.data()[i], difference, 1e-9) << to_string(spec) << ", value " << i;
      }
    }
  }
}

/// J(c y) = c J(y) for c > 0, and so dJ/dy . y = J.
TEST(Functional, AreHomogeneous) {
  for (const int components : {1, 3}) {
    const MatrixXd y = random_history(components, 30, 3);
    const VectorXd t = times(30);
    for (const FunctionalSpec& spec : all()) {
      const FunctionalValue at = evaluate(spec, t, y);
      EXPECT_NEAR(evaluate(spec, t, 3.5 * y).value, 3.5 * at.value, 1e-12) << to_string(spec);
      EXPECT_NEAR(at.by_y.cwiseProduct(y).sum(), at.value, 1e-12) << to_string(spec);
    }
  }
}

TEST(Functional, OfASine) {
  const int n = 4001;
  const VectorXd t = VectorXd::LinSpaced(n, 0, 1);
  const MatrixXd y = (2 * M_PI * t.array()).sin().matrix().transpose() * 3;
  const auto value = [&](FunctionalKind kind, double number = 0) {
    return evaluate({kind, number}, t, y).value;
  };
  EXPECT_NEAR(value(FunctionalKind::Peak), 3, 1e-12);
  EXPECT_NEAR(value(FunctionalKind::At, 0.75), -3, 1e-12);
  EXPECT_NEAR(value(FunctionalKind::Integral), 0, 1e-12);
  EXPECT_NEAR(value(FunctionalKind::Rms), 3 / std::sqrt(2.), 1e-9);
  EXPECT_NEAR(value(FunctionalKind::PNorm, 4), 3 * std::pow(3. / 8, 0.25), 1e-9);
  const double ks = value(FunctionalKind::Ks, 500);
  EXPECT_GE(ks, 3);
  EXPECT_LE(ks, 3 * (1 + std::log(n) / 500));
  EXPECT_EQ(evaluate({FunctionalKind::Peak, 0}, t, y).step, 1000);
}

/// The integral converges with the second order of the trapezoidal rule.
TEST(Functional, IntegralHasOrderTwo) {
  const auto error = [](int n) {
    const VectorXd t = VectorXd::LinSpaced(n + 1, 0, 1);
    const MatrixXd y = t.array().exp().matrix().transpose();
    return std::abs(evaluate({FunctionalKind::Integral, 0}, t, y).value - (std::exp(1.) - 1));
  };
  EXPECT_NEAR(std::log2(error(50) / error(100)), 2, 0.01);
}

TEST(Functional, OfNothingIsZeroAndFinite) {
  const VectorXd t = times(5);
  for (const FunctionalSpec& spec : all()) {
    const FunctionalValue at = evaluate(spec, t, MatrixXd::Zero(3, 5));
    EXPECT_EQ(at.value, 0) << to_string(spec);
    EXPECT_TRUE(at.by_y.allFinite()) << to_string(spec);
  }
}

/// A start without a step: of one record, and of several at one time, means are those of the
/// values.
TEST(Functional, OfNoDurationIsThatOfTheValues) {
  const auto value = [](FunctionalKind kind, const MatrixXd& y) {
    return evaluate({kind, kind == FunctionalKind::PNorm ? 8. : 0.}, VectorXd::Zero(y.cols()), y)
        .value;
  };
  const MatrixXd one = Eigen::Vector2d(3, 4);
  EXPECT_NEAR(value(FunctionalKind::Mean, one), 5, 1e-15);
  EXPECT_NEAR(value(FunctionalKind::Rms, one), 5, 1e-15);
  EXPECT_NEAR(value(FunctionalKind::PNorm, one), 5, 1e-15);
  EXPECT_EQ(value(FunctionalKind::Integral, one), 0);
  EXPECT_NEAR(value(FunctionalKind::Rms, Eigen::RowVector2d(1, 7)), 5, 1e-15);
  for (const FunctionalSpec& spec : all()) {
    const FunctionalValue at = evaluate(spec, VectorXd::Zero(1), one);
    EXPECT_TRUE(at.by_y.allFinite()) << to_string(spec);
    EXPECT_NEAR(at.by_y.cwiseProduct(one).sum(), at.value, 1e-14) << to_string(spec);
  }
}

TEST(Functional, IsReadAsItIsWritten) {
  for (const FunctionalSpec& spec : all()) {
    const auto read = functional_of(to_string(spec));
    ASSERT_TRUE(read) << to_string(spec);
    EXPECT_EQ(read->kind, spec.kind);
    EXPECT_EQ(read->number, spec.number);
  }
  for (const char* wrong : {"peek", "p", "p=0.5", "ks=-1", "at=x", "peak=3", "at=nan", ""})
    EXPECT_FALSE(functional_of(wrong)) << wrong;
}

}  // namespace
}  // namespace liesl::test::functional_test
