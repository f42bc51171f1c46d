/// @file
/// Where members buckle: published values, and derivatives against differences.
#include "mbs/sections/buckling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "mbs/sections/shape_dimensions.hpp"

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

/// The buckling stress of the wall at a stress point of a shape, and its derivative by a dimension.
WithDerivative wall(const Shape& shape, std::size_t point, double knock_down = 1,
                    const std::string& dimension = "", const Material& material = kSteel) {
  const Section section{"s", shape};
  const SectionLaw law = section_law(section, material);
  const auto points = stress_points(section, material.nu);
  if (dimension.empty())
    return wall_buckling_stress({section, law, kNone, points, {}}, point, material, knock_down);
  const SectionLaw by = section_law_derivative(section, material, dimension);
  const auto by_points = stress_points_derivative(section, material.nu, dimension);
  return wall_buckling_stress({section, law, by, points, by_points}, point, material, knock_down);
}

/// Timoshenko and Gere 1961, section 11.1: sigma = 0.605 E t/R for nu = 0.3, t << R.
TEST(Buckling, WallOfAThinTube) {
  for (const double t : {1e-4, 1e-3, 5e-3}) {
    const double D = 0.1, R = (D - t) / 2;
    const double sigma = wall(Tube{D, t}, 3).value;
    EXPECT_NEAR(sigma / (210e9 * t / R / std::sqrt(3 * 0.91)), 1, 1e-9) << t;
    EXPECT_NEAR(sigma / (0.605 * 210e9 * t / R), 1, 5e-4) << t;
    EXPECT_NEAR(wall(Tube{D, t}, 3, 0.25).value / sigma, 0.25, 1e-12);
  }
}

/// Bryan's plate: 3.6152 E (t/b)^2 for nu = 0.3, of the wider wall as of the narrower one.
TEST(Buckling, WallsOfABox) {
  const double W = 0.2, H = 0.1, t = 0.004;
  const auto points = stress_points({"b", Box{W, H, t}}, 0.3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double b = points[i].S(1, 3) != 0 ? W - t : H - t;  // torsion flows along the wall
    EXPECT_NEAR(wall(Box{W, H, t}, i).value / (210e9 * t * t / (b * b)), 3.61524, 1e-5) << i;
  }
}

/// k of a plate with a free edge is 0.456 at nu = 0.25 (Timoshenko and Gere 1961, section 9.4).
TEST(Buckling, WallsOfAnI) {
  const double b = 0.1, H = 0.2, tf = 0.008, tw = 0.005, nu = 0.25;
  const Material material{"m", 70e9, nu, 2700};
  const Shape shape = ISection{b, H, tf, tw};
  const double plate = M_PI * M_PI * 70e9 / (12 * (1 - nu * nu));
  const auto points = stress_points({"i", shape}, nu);
  ASSERT_EQ(points.size(), 12u);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool web = std::abs(points[i].y) < b / 4;
    const double t = web ? tw : tf, width = web ? H - tf : b / 2;
    EXPECT_NEAR(wall(shape, i, 1, "", material).value / (plate * t * t / (width * width)),
                web ? 4 : 0.456, web ? 1e-9 : 1e-4)
        << i;
  }
}

/// The derivatives of the wall by each dimension are those of the values, at each stress point.
TEST(Buckling, WallsFollowTheirDimensions) {
  for (const Shape& shape : {Shape(Tube{0.1, 2e-3}), Shape(Box{0.2, 0.1, 0.004}),
                             Shape(ISection{0.1, 0.2, 0.008, 0.005})})
    for (const std::string_view name : dimensions(shape)) {
      const double h = 1e-5 * dimension(shape, name);
      const Shape plus = with_dimension(shape, name, dimension(shape, name) + h),
                  minus = with_dimension(shape, name, dimension(shape, name) - h);
      const std::size_t count = stress_points({"s", shape}, 0.3).size();
      for (std::size_t i = 0; i < count; ++i) {
        const double slope = (wall(plus, i, 0.6).value - wall(minus, i, 0.6).value) / (2 * h);
        const auto at = wall(shape, i, 0.6, std::string(name));
        EXPECT_NEAR(at.derivative, slope, 1e-7 * at.value / dimension(shape, name))
            << name << " " << i;
      }
    }
}

TEST(Buckling, EulerLoadFollowsItsDimensions) {
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
    const double by_h =
        (euler_load(plus, kNone, L).value - euler_load(minus, kNone, L).value) / (2 * h);
    EXPECT_NEAR(euler_load(law(D, t), by, L).derivative / by_h, 1, 1e-8);
  }
}

}  // namespace
}  // namespace liesl::test::buckling_test
