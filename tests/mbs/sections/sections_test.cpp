/// @file
/// Geometry, stiffness and inertia of sections: closed forms, quadrature, a second solution of the
/// torsion problem, derivatives against differences.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "mbs/sections/prandtl_torsion.hpp"
#include "mbs/sections/section_errors.hpp"
#include "mbs/sections/section_law.hpp"
#include "mbs/sections/shape_dimensions.hpp"
#include "mbs/step_sweep.hpp"

namespace liesl::test::sections_test {
namespace {

constexpr double pi = std::numbers::pi;
const Material steel{"steel", 210e9, 0.3, 7850};

const std::vector<Section> shapes = {{"circle", Circle{0.02}},
                                     {"tube", Tube{0.03, 0.004}},
                                     {"wide", Rectangle{0.05, 0.02}},
                                     {"tall", Rectangle{0.02, 0.03}},
                                     {"square", Rectangle{0.03, 0.03}},
                                     {"box", Box{0.06, 0.04, 0.003}},
                                     {"I", ISection{0.05, 0.1, 0.006, 0.004}}};

TEST(SectionGeometry, ClosedForms) {
  const auto c = geometry({"c", Circle{2}}, 0.3);
  EXPECT_NEAR(c.A, pi, 1e-15);
  EXPECT_NEAR(c.Iy, pi / 4, 1e-15);
  EXPECT_NEAR(c.J, pi / 2, 1e-15);
  const auto t = geometry({"t", Tube{2, 0.25}}, 0.3);
  const double bore = 0.75;
  EXPECT_NEAR(t.A, pi * (1 - bore * bore), 1e-14);
  EXPECT_NEAR(t.Iz, pi / 4 * (1 - std::pow(bore, 4)), 1e-14);
  EXPECT_NEAR(t.J, pi / 2 * (1 - std::pow(bore, 4)), 1e-14);
  const auto r = geometry({"r", Rectangle{2, 3}}, 0.3);
  EXPECT_NEAR(r.Iy, 2 * 27 / 12.0, 1e-14);
  EXPECT_NEAR(r.Iz, 3 * 8 / 12.0, 1e-14);
}

/// A, I_y and I_z by counting the cells of a fine grid that lie in the section.
TEST(SectionGeometry, AgreesWithGridIntegration) {
  const auto inside = [](const Shape& shape, double y, double z) {
    y = std::abs(y), z = std::abs(z);
    const double r = std::hypot(y, z);
    if (auto* s = std::get_if<Circle>(&shape)) return r < s->diameter / 2;
    if (auto* s = std::get_if<Tube>(&shape))
      return r < s->diameter / 2 && r > s->diameter / 2 - s->thickness;
    if (auto* s = std::get_if<Rectangle>(&shape)) return y < s->width / 2 && z < s->height / 2;
    if (auto* s = std::get_if<Box>(&shape))
      return y < s->width / 2 && z < s->height / 2 &&
             (y > s->width / 2 - s->thickness || z > s->height / 2 - s->thickness);
    const auto& s = std::get<ISection>(shape);
    return z < s.height / 2 &&
           (z > s.height / 2 - s.flange_thickness ? y < s.width / 2 : y < s.web_thickness / 2);
  };
  for (const auto& section : shapes) {
    const int n = 1500;
    const double size = 0.11, cell = size / n;
    double A = 0, Iy = 0, Iz = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const double y = (i + 0.5) * cell - size / 2, z = (j + 0.5) * cell - size / 2;
        if (!inside(section.shape, y, z)) continue;
        A += 1, Iy += z * z, Iz += y * y;
      }
    const auto g = geometry(section, 0.3);
    EXPECT_NEAR(A * cell * cell / g.A, 1, 0.02) << section.name;
    EXPECT_NEAR(Iy * cell * cell / g.Iy, 1, 0.02) << section.name;
    EXPECT_NEAR(Iz * cell * cell / g.Iz, 1, 0.02) << section.name;
  }
}

TEST(ShearFactor, CowperTable) {
  for (double nu : {0.0, 0.3, 0.5}) {
    EXPECT_NEAR(geometry({"", Circle{0.02}}, nu).ky, 6 * (1 + nu) / (7 + 6 * nu), 1e-15);
    EXPECT_NEAR(geometry({"", Rectangle{0.02, 0.1}}, nu).kz, 10 * (1 + nu) / (12 + 11 * nu), 1e-15);
    // Rows of the table for thin walls: round tube, square tube.
    EXPECT_NEAR(geometry({"", Tube{1, 1e-4}}, nu).kz, 2 * (1 + nu) / (4 + 3 * nu), 1e-7);
    EXPECT_NEAR(geometry({"", Tube{1, 0.4999}}, nu).kz, 6 * (1 + nu) / (7 + 6 * nu), 1e-6);
    EXPECT_NEAR(geometry({"", Box{0.1, 0.1, 0.002}}, nu).ky, 20 * (1 + nu) / (48 + 39 * nu), 1e-14);
    // A web alone is a rectangle.
    EXPECT_NEAR(geometry({"", ISection{0.0401, 1, 1e-6, 0.04}}, nu).kz,
                10 * (1 + nu) / (12 + 11 * nu), 1e-4);
  }
}

/// k = I^2/(A int (Q/t)^2 dA) of a thin-walled section: Cowper's value at nu = 0. `web` counts the
/// webs of thickness tw; the flanges carry shear from their free ends (I) or middles (box).
double energy_shear_factor(double b, double h, double tf, double tw, int webs) {
  const double width = b / 2, A = webs * h * tw + 2 * b * tf;
  const double I = webs * tw * h * h * h / 12 + 2 * b * tf * h * h / 4;
  double sum = 0;
  const int n = 4000;
  for (int i = 0; i < n; ++i) {
    const double s = (i + 0.5) / n * width;  // four half flanges
    sum += 4 * tf * std::pow(h / 2 * s, 2) * width / n;
    const double z = ((i + 0.5) / n - 0.5) * h;
    const double Q = 2 * width * tf * h / 2 / webs + tw * (h * h / 4 - z * z) / 2;
    sum += webs * tw * std::pow(Q / tw, 2) * h / n;
  }
  return I * I / (A * sum);
}

TEST(ShearFactor, ThinWallsAgreeWithShearFlowEnergyAtZeroPoisson) {
  const ISection i{0.05, 0.1, 0.006, 0.004};
  EXPECT_NEAR(geometry({"", i}, 0).kz, energy_shear_factor(0.05, 0.094, 0.006, 0.004, 1), 1e-6);
  const Box box{0.06, 0.04, 0.003};
  EXPECT_NEAR(geometry({"", box}, 0).kz, energy_shear_factor(0.057, 0.037, 0.003, 0.003, 2), 1e-6);
  EXPECT_NEAR(geometry({"", box}, 0).ky, energy_shear_factor(0.037, 0.057, 0.003, 0.003, 2), 1e-6);
}

TEST(TorsionConstant, Rectangle) {
  EXPECT_NEAR(geometry({"", Rectangle{1, 1}}, 0).J, 0.1405770, 1e-7);
  EXPECT_NEAR(geometry({"", Rectangle{2, 1}}, 0).J, 2 * 0.2286817, 1e-6);  // Timoshenko's table
  const double t = 1e-3;  // strip: a b^3/3 (1 - 0.630249 b/a)
  EXPECT_NEAR(geometry({"", Rectangle{t, 1}}, 0).J / (t * t * t / 3), 1 - 0.630249 * t, 1e-9);
  EXPECT_DOUBLE_EQ(geometry({"", Rectangle{2, 5}}, 0).J, geometry({"", Rectangle{5, 2}}, 0).J);
  // no kink where width and height change roles
  const double below = geometry({"", Rectangle{1 - 1e-9, 1}}, 0).J;
  EXPECT_NEAR(geometry({"", Rectangle{1 + 1e-9, 1}}, 0).J - below, 2e-9 * 0.1405770 * 2, 1e-13);
}

/// The discrete J has an error C h^2; extrapolated from two grids.
double discrete_J(double W, double H, double wall, double cell) {
  const double coarse = test::PrandtlTorsion(W, H, wall, cell).J();
  const double fine = test::PrandtlTorsion(W, H, wall, cell / 2).J();
  return fine + (fine - coarse) / 3;
}

TEST(TorsionConstant, AgreesWithPrandtlByFiniteDifferences) {
  for (double a : {1.0, 2.0, 5.0})
    EXPECT_NEAR(geometry({"", Rectangle{1, a}}, 0).J / discrete_J(1, a, 0, 1.0 / 32), 1, 3e-5);
  // Bredt is a thin-wall formula, low by what the docstring of box() says.
  EXPECT_NEAR(geometry({"", Box{1, 1, 0.05}}, 0).J / discrete_J(1, 1, 0.05, 1.0 / 160), 0.976,
              1e-3);
  EXPECT_NEAR(geometry({"", Box{1, 1, 0.125}}, 0).J / discrete_J(1, 1, 0.125, 1.0 / 160), 0.929,
              1e-3);
}

TEST(TorsionConstant, ThinWalls) {
  const double W = 0.06, H = 0.04, t = 1e-5;  // Bredt: 4 A_m^2 t / length of the centre line
  EXPECT_NEAR(geometry({"", Box{W, H, t}}, 0).J /
                  (4 * std::pow((W - t) * (H - t), 2) * t / (2 * (W + H - 2 * t))),
              1, 1e-12);
  EXPECT_NEAR(geometry({"", ISection{0.05, 0.1, 0.006, 0.004}}, 0).J,
              (2 * 0.05 * std::pow(0.006, 3) + 0.088 * std::pow(0.004, 3)) / 3, 1e-22);
}

TEST(SectionLaw, IsDiagonalOfTheGeometry) {
  Section s{"rod", Circle{0.01}};
  s.shear_factor = {0.9, 0.8};
  const auto law = section_law(s, steel);
  const double A = pi * 1e-4 / 4, I = pi * 1e-8 / 64, G = 210e9 / 2.6;
  Eigen::Matrix<double, 6, 1> K, M;
  K << 210e9 * A, 0.9 * G * A, 0.8 * G * A, G * 2 * I, 210e9 * I, 210e9 * I;
  M << A, A, A, 2 * I, I, I;
  EXPECT_TRUE(law.K.isApprox(K.asDiagonal().toDenseMatrix(), 1e-14));
  EXPECT_TRUE(law.M.isApprox((7850 * M).asDiagonal().toDenseMatrix(), 1e-14));
}

TEST(SectionLaw, PrescribedTorsionConstantReplacesTheShape) {
  Section s{"strip", Rectangle{0.6, 30}};
  s.torsion_constant = 30 * 0.216 / 3;
  EXPECT_DOUBLE_EQ(section_law(s, steel).K(3, 3), steel.G() * 2.16);
  EXPECT_EQ(section_law_derivative(s, steel, "width").K(3, 3), 0);
}

TEST(SectionLaw, FullSectionIsTakenAsGiven) {
  FullSection full{Eigen::Matrix<double, 6, 6>::Identity() * 3,
                   Eigen::Matrix<double, 6, 6>::Identity() * 2};
  full.stiffness(0, 5) = full.stiffness(5, 0) = 0.5;
  const auto law = section_law({"f", full}, steel);
  EXPECT_EQ(law.K, full.stiffness);
  EXPECT_EQ(law.M, full.inertia);
  EXPECT_THROW(geometry({"f", full}, 0.3), std::invalid_argument);
  EXPECT_THROW(section_law_derivative({"f", full}, steel, "diameter"), std::invalid_argument);
  EXPECT_TRUE(dimensions(full).empty());
}

Eigen::VectorXd diagonals(const SectionLaw& law) {
  Eigen::VectorXd v(12);
  v << law.K.diagonal(), law.M.diagonal();
  return v;
}

TEST(SectionLaw, DerivativesAreTheLimitOfDifferencesWithSlopeTwo) {
  for (const auto& section : shapes)
    for (const auto name : dimensions(section.shape)) {
      const double x = dimension(section.shape, name);
      const test::VectorOf law = [&](double value) {
        Section changed = section;
        changed.shape = with_dimension(section.shape, name, value);
        return diagonals(section_law(changed, steel));
      };
      const auto first = diagonals(section_law_derivative(section, steel, name));
      const auto second = diagonals(section_law_second_derivative(section, steel, name));
      const std::string what = section.name + "." + std::string(name);
      test::expect_second_order(test::central_first(law, x), first, law(x) / x, x / 32, 1e-9, what);
      test::expect_second_order(test::central_second(law, x), second, law(x) / (x * x), x / 32,
                                1e-8, what + " (second)");
    }
}

/// K and M have the dimension of length^2 and length^4: Euler's theorem on homogeneous functions.
TEST(SectionLaw, DerivativesObeyEulersTheorem) {
  for (const auto& section : shapes) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(12), degree(12);
    for (const auto name : dimensions(section.shape))
      sum +=
          dimension(section.shape, name) * diagonals(section_law_derivative(section, steel, name));
    degree << 2, 2, 2, 4, 4, 4, 2, 2, 2, 4, 4, 4;
    const auto law = diagonals(section_law(section, steel));
    EXPECT_LT((sum.cwiseQuotient(law) - degree).cwiseAbs().maxCoeff(), 1e-12) << section.name;
  }
}

TEST(Dimensions, AreReadAndChangedByName) {
  const Shape box = Box{0.06, 0.04, 0.003};
  EXPECT_EQ(dimension(box, "height"), 0.04);
  const Shape thicker = with_dimension(box, "thickness", 0.005);
  EXPECT_EQ(dimension(thicker, "thickness"), 0.005);
  EXPECT_EQ(dimension(thicker, "width"), 0.06);
  try {
    dimension(box, "diameter");
    FAIL();
  } catch (const std::invalid_argument& e) {
    EXPECT_NE(std::string(e.what()).find("width, height, thickness"), std::string::npos);
    EXPECT_NE(std::string(e.what()).find("diameter"), std::string::npos);
  }
}

TEST(WhatIsWrong, NamesTheDimensionAndTheLimit) {
  for (const auto& section : shapes) EXPECT_EQ(what_is_wrong(section), "");
  const auto wrong = [](const Shape& s, const char* word) {
    const auto text = what_is_wrong(s);
    EXPECT_NE(text.find(word), std::string::npos) << text;
    EXPECT_NE(text.find("expected"), std::string::npos) << text;
  };
  wrong(Circle{0}, "diameter");
  wrong(Circle{std::nan("")}, "diameter");
  wrong(Tube{0.02, 0.01}, "diameter/2");
  wrong(Rectangle{0.02, -1}, "height");
  wrong(Box{0.02, 0.05, 0.011}, "width/2");
  wrong(ISection{0.05, 0.1, 0.05, 0.004}, "height/2");
  wrong(ISection{0.05, 0.1, 0.005, 0.06}, "web_thickness");
  FullSection full{Eigen::Matrix<double, 6, 6>::Identity(),
                   Eigen::Matrix<double, 6, 6>::Identity()};
  EXPECT_EQ(what_is_wrong(Shape(full)), "");
  full.stiffness(1, 2) = 0.5;
  wrong(full, "symmetric stiffness");
  full.stiffness(2, 1) = 0.5;
  EXPECT_EQ(what_is_wrong(Shape(full)), "");
  full.inertia(0, 5) = full.inertia(5, 0) = 2;
  wrong(full, "positive definite inertia");
}

TEST(WhatIsWrong, SectionAndMaterial) {
  Section s{"rod", Circle{0.01}};
  s.shear_factor = {-1, 0};
  EXPECT_NE(what_is_wrong(s).find("shear factors"), std::string::npos);
  s.shear_factor = {0, 0};
  s.torsion_constant = -1;
  EXPECT_NE(what_is_wrong(s).find("torsion_constant"), std::string::npos);
  EXPECT_EQ(what_is_wrong(steel), "");
  EXPECT_NE(what_is_wrong(Material{"m", 1, 0.6, 1}).find("nu"), std::string::npos);
  EXPECT_NE(what_is_wrong(Material{"m", 0, 0.3, 1}).find("E > 0"), std::string::npos);
}

}  // namespace
}  // namespace liesl::test::sections_test
