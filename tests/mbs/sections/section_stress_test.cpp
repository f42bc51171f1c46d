/// @file
/// Stress points: textbook values, a second solution of the torsion problem, equilibrium, and how
/// much larger the stress between the points can be.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "mbs/sections/prandtl_torsion.hpp"
#include "mbs/sections/section_law.hpp"
#include "mbs/sections/shape_dimensions.hpp"
#include "mbs/sections/stress.hpp"
#include "mbs/step_sweep.hpp"

namespace liesl::test::section_stress_test {
namespace {

constexpr double pi = std::numbers::pi;
using Load = Eigen::Matrix<double, 6, 1>;  // N, V_y, V_z, M_x, M_y, M_z

const std::vector<Section> shapes = {
    {"circle", Circle{0.02}},        {"tube", Tube{0.03, 0.004}},
    {"wide", Rectangle{0.05, 0.02}}, {"tall", Rectangle{0.02, 0.03}},
    {"box", Box{0.06, 0.04, 0.003}}, {"I", ISection{0.05, 0.1, 0.006, 0.004}}};

double mises(const Eigen::Vector3d& s) {
  return std::sqrt(s[0] * s[0] + 3 * (s[1] * s[1] + s[2] * s[2]));
}

double largest_mises(const Section& section, const Load& load) {
  double largest = 0;
  for (const auto& p : stress_points(section, 0.3)) largest = std::max(largest, mises(p.S * load));
  return largest;
}

/// The point nearest to (y, z).
StressPoint at(const Section& section, double y, double z) {
  auto points = stress_points(section, 0.3);
  return *std::min_element(points.begin(), points.end(), [&](const auto& a, const auto& b) {
    return std::hypot(a.y - y, a.z - z) < std::hypot(b.y - y, b.z - z);
  });
}

TEST(StressPoints, BendingAndAxialStressAreLinearOverTheSection) {
  Load load;
  load << 1000, 0, 0, 0, 30, -20;
  for (const auto& section : shapes) {
    const auto g = geometry(section, 0.3);
    for (const auto& p : stress_points(section, 0.3)) {
      const double expected = 1000 / g.A + 30 * p.z / g.Iy + 20 * p.y / g.Iz;
      EXPECT_NEAR((p.S * load)[0] / expected, 1, 1e-12) << section.name;
    }
  }
}

TEST(StressPoints, TextbookValues) {
  const double d = 0.02, M = 7;
  Load bending = Load::Zero(), torsion = Load::Zero(), shear = Load::Zero();
  bending[5] = torsion[3] = M, shear[1] = 900;
  EXPECT_NEAR(largest_mises({"", Circle{d}}, bending), 32 * M / (pi * d * d * d), 1e-6);
  EXPECT_NEAR(largest_mises({"", Circle{d}}, torsion), std::sqrt(3) * 16 * M / (pi * d * d * d),
              1e-6);
  const auto g = geometry({"", Circle{d}}, 0.3);
  EXPECT_NEAR(largest_mises({"", Circle{d}}, shear), std::sqrt(3) * 900 / (g.ky * g.A), 1e-6);
  EXPECT_NEAR(largest_mises({"", Rectangle{0.02, 0.03}}, bending), 6 * M / (0.03 * 0.02 * 0.02),
              1e-6);
  // Square: tau = 0.675 G theta' a, J = 0.1406 a^4 (Timoshenko & Goodier, art. 109).
  EXPECT_NEAR(largest_mises({"", Rectangle{1, 1}}, torsion),
              std::sqrt(3) * M * 0.675314 / 0.1405770, 1e-4);
  // Closed thin wall: q = M/(2 A_m).
  EXPECT_NEAR(largest_mises({"", Box{0.06, 0.04, 0.003}}, torsion),
              std::sqrt(3) * M / (2 * 0.057 * 0.037 * 0.003), 1e-6);
  // Open thin wall: M t/J at the thickest plate.
  const Section i{"", ISection{0.05, 0.1, 0.006, 0.004}};
  EXPECT_NEAR(largest_mises(i, torsion), std::sqrt(3) * M * 0.006 / geometry(i, 0).J, 1e-6);
}

TEST(StressPoints, TorsionOfRectanglesAgreesWithPrandtlByFiniteDifferences) {
  Load torsion = Load::Zero();
  torsion[3] = 1;
  for (double a : {1.0, 2.0, 5.0}) {
    const test::PrandtlTorsion exact(a, 1, 0, 1.0 / 80);
    const Section wide{"", Rectangle{a, 1}}, tall{"", Rectangle{1, a}};
    for (double f : {0.0, 0.5, 0.8}) {
      const double bottom = exact.slope_bottom(f) / exact.J();
      const double left = exact.slope_left(f) / exact.J();
      const auto p = at(wide, f * a / 2, -0.5), q = at(wide, -a / 2, f / 2);
      EXPECT_NEAR((p.S * torsion)[1] / bottom, 1, 5e-4) << a << " long side at " << f;
      EXPECT_NEAR((q.S * torsion)[2] / -left, 1, 5e-4) << a << " short side at " << f;
      // The tall section is the wide one turned by 90 degrees.
      EXPECT_NEAR((at(tall, 0.5, f * a / 2).S * torsion)[2], (p.S * torsion)[1], 1e-12);
      EXPECT_NEAR((at(tall, f / 2, -a / 2).S * torsion)[1], -(q.S * torsion)[2], 1e-12);
    }
    EXPECT_EQ((at(wide, a / 2, 0.5).S * torsion).norm(), 0);  // corners carry no torsion
  }
}

/// The shear flow of the box must add up to the torque: sum over walls of tau t length distance.
TEST(StressPoints, TorsionOfTheBoxIsInEquilibrium) {
  const double W = 0.06, H = 0.04, t = 0.003;
  double torque = 0;
  for (const auto& p : stress_points({"", Box{W, H, t}}, 0.3)) {
    // each corner stands for half of either wall that it ends
    torque -= p.S(1, 3) * t * (W - t) / 2 * std::copysign((H - t) / 2, p.z);
    torque += p.S(2, 3) * t * (H - t) / 2 * std::copysign((W - t) / 2, p.y);
  }
  EXPECT_NEAR(torque, 1, 1e-12);
}

TEST(StressPoints, RimUnderestimatesBendingByAtMostTwoPercent) {
  const Section tube{"", Tube{0.03, 0.004}};
  const auto g = geometry(tube, 0.3);
  double worst = 1;
  for (int i = 0; i < 360; ++i) {
    const double angle = i * pi / 180;
    Load load = Load::Zero();
    load[3] = 2, load[4] = 10 * std::cos(angle), load[5] = 10 * std::sin(angle);
    const double exact = mises({10 * 0.015 / g.Iy, 2 * 0.015 / g.J, 0});
    worst = std::min(worst, largest_mises(tube, load) / exact);
  }
  EXPECT_GT(worst, std::cos(pi / 16) - 1e-12);
  EXPECT_LT(worst, 0.99);  // the bound is reached
}

/// Torsion stress on a long side by the series of the textbook, for M_x = 1.
double long_side_torsion(double a, double b, double J, double x) {
  double sum = 0;
  for (int n = 1; n < 4000; n += 2) {
    const double top = n * pi * x / b, bottom = n * pi * a / (2 * b);
    sum += (std::exp(top - bottom) + std::exp(-top - bottom)) / (1 + std::exp(-2 * bottom)) / n / n;
  }
  return b / J * (1 - 8 / (pi * pi) * sum);
}

TEST(StressPoints, RectangleMissesLittleBetweenItsPoints) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (double a : {1.0, 1.5, 3.0, 10.0}) {
    const Section section{"", Rectangle{a, 1}};
    const auto g = geometry(section, 0.3);
    double worst = 1;
    std::vector<double> torsion;
    for (int i = 0; i <= 200; ++i)
      torsion.push_back(long_side_torsion(a, 1, g.J, (i / 100.0 - 1) * a / 2));
    for (int trial = 0; trial < 2000; ++trial) {
      Load load;
      load << normal(random) * g.A, 0, 0, normal(random) * g.J, normal(random) * g.Iy,
          normal(random) * 2 * g.Iz / a;
      double exact = 0;
      for (int i = 0; i <= 200; ++i)
        for (double z : {-0.5, 0.5}) {
          const double y = (i / 100.0 - 1) * a / 2;
          const double sigma = load[0] / g.A + load[4] * z / g.Iy - load[5] * y / g.Iz;
          exact = std::max(exact, mises({sigma, load[3] * torsion[std::size_t(i)], 0}));
        }
      worst = std::min(worst, largest_mises(section, load) / exact);
    }
    EXPECT_GT(worst, 1 / (a > 5 ? 1.04 : 1.025)) << a;
    EXPECT_LT(worst, 1 - 1e-4) << a;
  }
}

TEST(StressPoints, DerivativesAreTheLimitOfDifferencesWithSlopeTwo) {
  for (const auto& section : shapes)
    for (const auto name : dimensions(section.shape)) {
      const double x = dimension(section.shape, name);
      const auto exact = stress_points_derivative(section, 0.3, name);
      const auto points = stress_points(section, 0.3);
      ASSERT_EQ(exact.size(), points.size());
      for (std::size_t i = 0; i < points.size(); ++i) {
        const test::VectorOf rows = [&](double value) -> Eigen::VectorXd {
          Section changed = section;
          changed.shape = with_dimension(section.shape, name, value);
          return stress_points(changed, 0.3)[i].S.reshaped();
        };
        Eigen::VectorXd scale = points[i].S.cwiseAbs().reshaped() / x;
        scale = scale.array() + 1e-3 * scale.maxCoeff();
        test::expect_second_order(test::central_first(rows, x), exact[i].reshaped(), scale, x / 32,
                                  1e-9, section.name + "." + std::string(name));
      }
    }
}

TEST(StressPoints, PrescribedTorsionConstantLeavesTheStress) {
  Section section{"", Rectangle{0.02, 0.03}};
  const auto before = stress_points(section, 0.3);
  section.torsion_constant = 1;
  EXPECT_EQ(stress_points(section, 0.3)[3].S, before[3].S);
}

TEST(StressPoints, FullSectionHasNone) {
  const FullSection full{Eigen::Matrix<double, 6, 6>::Identity(),
                         Eigen::Matrix<double, 6, 6>::Identity()};
  EXPECT_TRUE(stress_points({"", full}, 0.3).empty());
  EXPECT_THROW(stress_points_derivative({"", full}, 0.3, "width"), std::invalid_argument);
}

}  // namespace
}  // namespace liesl::test::section_stress_test
