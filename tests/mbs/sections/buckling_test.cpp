/// @file
/// Where members buckle: published values, and derivatives against differences.
#include "mbs/sections/buckling.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace liesl::test::buckling_test {
namespace {

const Material kSteel{"steel", 210e9, 0.3, 7850};
const SectionLaw kNone{Eigen::Matrix<double, 6, 6>::Zero(), Eigen::Matrix<double, 6, 6>::Zero()};

TEST(Buckling, EulerLoadOfACircleAndOfTheWeakAxis) {
  const double d = 0.02, L = 1.5, I = M_PI * std::pow(d, 4) / 64;
  const SectionLaw circle = section_law({"c", Circle{d}}, kSteel);
  EXPECT_NEAR(euler_load(circle, kNone, L).value / (M_PI * M_PI * 210e9 * I / (L * L)), 1, 1e-12);
  const double b = 0.03, h = 0.01;
  const double weak = b * h * h * h / 12;
  for (const Shape& shape : {Shape(Rectangle{b, h}), Shape(Rectangle{h, b})})
    EXPECT_NEAR(euler_load(section_law({"r", shape}, kSteel), kNone, L).value /
                    (M_PI * M_PI * 210e9 * weak / (L * L)),
                1, 1e-12);
}

/// A bending stiffness with product of inertia has the smaller principal value.
TEST(Buckling, EulerLoadOfAnObliqueSection) {
  const double a = 3, b = 1, phi = 0.4, c = std::cos(phi), s = std::sin(phi);
  SectionLaw law = kNone;
  law.K(4, 4) = a * c * c + b * s * s;
  law.K(5, 5) = a * s * s + b * c * c;
  law.K(4, 5) = law.K(5, 4) = (a - b) * s * c;
  EXPECT_NEAR(euler_load(law, kNone, M_PI).value, b, 1e-12);
}

/// Timoshenko and Gere 1961, section 11.1: sigma = 0.605 E t/R for nu = 0.3, t << R.
TEST(Buckling, WallOfAThinTube) {
  for (const double t : {1e-4, 1e-3, 5e-3}) {
    const double D = 0.1, R = (D - t) / 2;
    const SectionLaw law = section_law({"t", Tube{D, t}}, kSteel);
    const double sigma = wall_buckling_stress(law, kNone, 210e9, 0.3, 1).value;
    EXPECT_NEAR(sigma / (210e9 * t / R / std::sqrt(3 * 0.91)), 1, 1e-9) << t;
    EXPECT_NEAR(sigma / (0.605 * 210e9 * t / R), 1, 5e-4) << t;
    EXPECT_NEAR(wall_buckling_stress(law, kNone, 210e9, 0.3, 0.25).value / sigma, 0.25, 1e-12);
  }
}

TEST(Buckling, DerivativesAreThoseOfTheValues) {
  const double D = 0.1, t = 2e-3, L = 2;
  const auto law = [&](double diameter, double thickness) {
    return section_law({"t", Tube{diameter, thickness}}, kSteel);
  };
  for (const bool of_diameter : {true, false}) {
    const double h = 1e-5 * (of_diameter ? D : t);
    const SectionLaw plus = of_diameter ? law(D + h, t) : law(D, t + h),
                     minus = of_diameter ? law(D - h, t) : law(D, t - h);
    const SectionLaw by =
        section_law_derivative({"t", Tube{D, t}}, kSteel, of_diameter ? "diameter" : "thickness");
    const auto euler = euler_load(law(D, t), by, L);
    const auto wall = wall_buckling_stress(law(D, t), by, 210e9, 0.3, 0.6);
    const double by_h = (euler_load(plus, kNone, L).value - euler_load(minus, kNone, L).value) /
                        (2 * h),
                 wall_by_h = (wall_buckling_stress(plus, kNone, 210e9, 0.3, 0.6).value -
                              wall_buckling_stress(minus, kNone, 210e9, 0.3, 0.6).value) /
                             (2 * h);
    EXPECT_NEAR(euler.derivative / by_h, 1, 1e-8);
    EXPECT_NEAR(wall.derivative / wall_by_h, 1, 1e-7);
  }
}

}  // namespace
}  // namespace liesl::test::buckling_test
