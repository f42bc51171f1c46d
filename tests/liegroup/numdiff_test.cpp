/// Central differences and the step sweep: right derivatives are confirmed, wrong ones are not.

#include "liegroup/numdiff.hpp"

#include <gtest/gtest.h>

#include "sampling.hpp"

namespace liesl::test::numdiff_test {
namespace {

TEST(NumDiff, NumbersVectorsAndDynamicSizes) {
  EXPECT_NEAR(central_difference([](double x) { return std::sin(x); }, 0.3)(0), std::cos(0.3),
              1e-10);

  const auto f = [](const Eigen::Vector2d& v) { return Eigen::Vector3d(v[0], v[0] * v[1], v[1]); };
  Eigen::Matrix<double, 3, 2> J;
  J << 1, 0, 5, 2, 0, 1;
  EXPECT_LE(size_of(central_difference(f, Eigen::Vector2d(2, 5)) - J), 1e-9);

  const auto square = [](const Eigen::VectorXd& v) { return Eigen::VectorXd(v.cwiseAbs2()); };
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(4, 1, 4);
  EXPECT_LE(size_of(central_difference(square, x) - Eigen::MatrixXd((2 * x).asDiagonal())), 1e-9);
}

TEST(NumDiff, GroupsOnBothSides) {
  Rng rng(6);
  const SE3 A = SE3::exp(Sampler<SE3>::draw(rng, 0.8, 1.0));
  const SE3 B = SE3::exp(Sampler<SE3>::draw(rng, 0.5, 1.0));
  // (H B)^-1 d(H B) = Ad(B^-1) H^-1 dH;  inverse: -Ad(H)
  EXPECT_LE(size_of(central_difference([&](const SE3& H) { return H * B; }, A) - B.AdInv()), 1e-9);
  EXPECT_LE(size_of(central_difference([](const SE3& H) { return H.inverse(); }, A) + A.Ad()),
            1e-9);
  // position seen from outside: d x = R u
  const auto J = central_difference([](const SE3& H) { return H.x; }, A);
  EXPECT_LE(size_of(J.leftCols<3>() - A.R) + size_of(J.rightCols<3>()), 1e-9);
}

TEST(NumDiff, SweepFindsSlopeTwo) {
  const StepSweep s = step_sweep([](double x) { return std::exp(x); }, 0.5,
                                 Eigen::Matrix<double, 1, 1>(std::exp(0.5)));
  EXPECT_NEAR(s.slope, 2, 0.01);
  EXPECT_GE(s.slope_points, 8);
  EXPECT_LE(s.best_error, 1e-10);
  EXPECT_TRUE(s.confirms(1e-9));
}

TEST(NumDiff, SweepRefusesWrongDerivatives) {
  const auto f = [](double x) { return std::exp(x); };
  for (double error : {1.0, 1e-3, 1e-6, 1e-8}) {
    const Eigen::Matrix<double, 1, 1> wrong(std::exp(0.5) + error);
    EXPECT_FALSE(step_sweep(f, 0.5, wrong).confirms(1e-9)) << error;
  }
}

/// A kink where the derivative is asked for: no slope 2, even if one step looks good.
TEST(NumDiff, SweepRefusesAKink) {
  const auto kink = [](double x) { return x * std::abs(x) + x; };
  EXPECT_FALSE(step_sweep(kink, 0.0, Eigen::Matrix<double, 1, 1>(1.0)).confirms(1e-9));
}

TEST(NumDiff, SweepAcceptsLinearFunctionsAndRefusesNan) {
  const Eigen::Matrix<double, 1, 1> three(3.0);
  EXPECT_TRUE(step_sweep([](double x) { return 3 * x; }, 0.5, three).confirms(1e-9));
  const StepSweep s = step_sweep([](double x) { return std::sqrt(x); }, -1.0, three);
  EXPECT_FALSE(s.confirms(1e-9));
  EXPECT_FALSE(std::isnan(s.best_error) || std::isnan(s.slope));
}

}  // namespace
}  // namespace liesl::test::numdiff_test
