#pragma once
/// @file
/// Materials and cross-sections of beams as data.
///
/// Section axes: x along the beam, y and z in the section. Order of components
/// [eps_x, gamma_y, gamma_z, kappa_x, kappa_y, kappa_z] and [N, V_y, V_z, M_x, M_y, M_z].

#include <Eigen/Core>
#include <array>
#include <string>
#include <variant>

namespace liesl {

/// Isotropic linear-elastic material. SI: Pa, -, kg/m^3.
struct Material {
  std::string name;
  double E = 0;
  double nu = 0;
  double rho = 0;
  double G() const { return E / (2 * (1 + nu)); }
};

/// Shapes; all lengths in m. `width` along y, `height` along z.
struct Circle {
  double diameter = 0;
};
struct Tube {
  double diameter = 0;  ///< outer
  double thickness = 0;
};
struct Rectangle {
  double width = 0;
  double height = 0;
};
struct Box {
  double width = 0;   ///< outer
  double height = 0;  ///< outer
  double thickness = 0;
};
/// Two flanges (parallel to y, at z = +-(height - flange_thickness)/2) and a web along z.
struct ISection {
  double width = 0;
  double height = 0;
  double flange_thickness = 0;
  double web_thickness = 0;
};
/// Given matrices; has no dimensions to design and no stresses.
struct FullSection {
  Eigen::Matrix<double, 6, 6> stiffness;  ///< N, N m, N m^2
  Eigen::Matrix<double, 6, 6> inertia;    ///< kg/m, kg, kg m
};
using Shape = std::variant<Circle, Tube, Rectangle, Box, ISection, FullSection>;

/// A shape and what it does not determine.
struct Section {
  std::string name;
  Shape shape;
  /// Shear factors k_y, k_z of `k GA`; 0 = Cowper's value for this shape and Poisson ratio:
  /// circle 6(1+nu)/(7+6nu), rectangle 10(1+nu)/(12+11nu), tube, box and I by their formulas
  /// (G. R. Cowper, J. Appl. Mech. 33 (1966) 335-340). A prescribed value is a constant to the
  /// derivatives of section_law.hpp.
  std::array<double, 2> shear_factor = {0, 0};
  /// Torsion constant J in m^4; 0 = the value of the shape (GJ = G J). A prescribed value is a
  /// constant to the derivatives of section_law.hpp and leaves the stress points as they are.
  double torsion_constant = 0;
};

}  // namespace liesl
