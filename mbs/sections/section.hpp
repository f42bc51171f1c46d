#pragma once
/// @file
/// Materials and cross-sections of beams: stiffness, inertia, their derivatives, stresses.
///
/// Section axes: x along the beam, y and z in the section. Order of components
/// [eps_x, gamma_y, gamma_z, kappa_x, kappa_y, kappa_z] and [N, V_y, V_z, M_x, M_y, M_z].

#include <Eigen/Core>
#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

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

/// Shape + what the shape alone does not say.
struct Section {
  std::string name;
  Shape shape;
  /// Shear factors k_y, k_z of `k GA`; 0 = Cowper's value for this shape and Poisson ratio:
  /// circle 6(1+nu)/(7+6nu), rectangle 10(1+nu)/(12+11nu), tube, box and I by their formulas
  /// (G. R. Cowper, J. Appl. Mech. 33 (1966) 335-340). A prescribed value is a constant to the
  /// derivatives below.
  std::array<double, 2> shear_factor = {0, 0};
  /// Torsion constant J in m^4; 0 = the value of the shape (GJ = G J). A prescribed value is a
  /// constant to the derivatives below and leaves the stress points as they are.
  double torsion_constant = 0;
};

/// What the beam needs of a section: `K` (stiffness) and `M` (inertia per length).
struct SectionLaw {
  Eigen::Matrix<double, 6, 6> K;
  Eigen::Matrix<double, 6, 6> M;
};

/// Geometry of a section: A [m^2], I_y, I_z, J [m^4], shear factors.
struct SectionGeometry {
  double A = 0, Iy = 0, Iz = 0, J = 0, ky = 0, kz = 0;
};

/// Names of the dimensions of a shape ("diameter", "thickness", ...); empty for FullSection.
std::vector<std::string_view> dimensions(const Shape& shape);

/// Value of a named dimension. @throws std::invalid_argument for an unknown name.
double dimension(const Shape& shape, std::string_view name);

/// The same shape with one dimension changed. @throws std::invalid_argument for an unknown name.
Shape with_dimension(Shape shape, std::string_view name, double value);

/// What is wrong with the shape as a piece of matter (empty = nothing): non-positive lengths,
/// walls that meet, indefinite matrices. One sentence: expected, got, hint.
std::string what_is_wrong(const Shape& shape);

/// The same for a section: its shape, shear factors and torsion constant.
std::string what_is_wrong(const Section& section);

/// The same for a material: E > 0, -1 < nu <= 0.5, rho > 0.
std::string what_is_wrong(const Material& material);

/// A, I_y = int z^2 dA, I_z = int y^2 dA, J and shear factors. J of circle, tube and rectangle is
/// exact to round-off, of a box Bredt's (thin walls), of an I the sum of s t^3/3 over its plates.
/// @throws std::invalid_argument for FullSection.
SectionGeometry geometry(const Section& section, double nu);

/// K = diag(EA, ky GA, kz GA, GJ, E Iy, E Iz),
/// M = rho diag(A, A, A, Iy + Iz, Iy, Iz)   (DESIGN: `M_s`).
SectionLaw section_law(const Section& section, const Material& material);

/// d section_law / d dimension, exact. @throws std::invalid_argument for an unknown name.
SectionLaw section_law_derivative(const Section& section, const Material& material,
                                  std::string_view dimension);

/// d^2 section_law / d dimension^2, exact. @throws std::invalid_argument for an unknown name.
SectionLaw section_law_second_derivative(const Section& section, const Material& material,
                                         std::string_view dimension);

/// Points of the section where the stress can be largest, and the rows that give it there:
/// [sigma_x; tau_xy; tau_xz] = S [N, V_y, V_z, M_x, M_y, M_z] (Pa). Axial + bending + torsion;
/// transverse shear enters with its mean over the shear area.
///   sigma_x = N/A + M_y z/I_y - M_z y/I_z,  tau_xy = V_y/(k_y A) + M_x (..),  tau_xz likewise
///   sigma_vm^2 = sigma_x^2 + 3 (tau_xy^2 + tau_xz^2)
/// Circle and tube: 16 points of the outer rim; the stress between two points is at most
/// 1/cos(pi/16) = 1.0196 times the larger of the two under bending and torsion. Rectangle: 24
/// points (corners; middle, 1/2 and 4/5 of each half side) with the exact torsion stress; between
/// them at most 1.025 times for side ratios up to 5, 1.04 up to 10, 1.10 up to 30, reached only
/// when bending and torsion are of one size. Box: 8, I: 12, the maxima of their thin-wall stress
/// fields.
struct StressPoint {
  double y = 0, z = 0;            ///< m
  Eigen::Matrix<double, 3, 6> S;  ///< Pa per N and N m
};

/// The stress points of a section; none for FullSection.
std::vector<StressPoint> stress_points(const Section& section, double nu);

/// d S / d dimension at the same points, which move with the outline.
/// @throws std::invalid_argument for an unknown name.
std::vector<Eigen::Matrix<double, 3, 6>> stress_points_derivative(const Section& section, double nu,
                                                                  std::string_view dimension);

}  // namespace liesl
