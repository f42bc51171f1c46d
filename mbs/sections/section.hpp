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
  /// Shear factors k_y, k_z of `k GA`; 0 = Cowper's value for this shape and Poisson ratio.
  std::array<double, 2> shear_factor = {0, 0};
  /// Torsion constant J in m^4; 0 = the value of the shape (GJ = G J).
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
/// walls that meet, indefinite matrices.
std::string what_is_wrong(const Shape& shape);

/// A, I, J and shear factors. Not for FullSection (throws std::invalid_argument).
SectionGeometry geometry(const Section& section, double nu);

/// K = diag(EA, ky GA, kz GA, GJ, E Iy, E Iz),
/// M = rho diag(A, A, A, Iy + Iz, Iy, Iz)   (DESIGN: `M_s`).
SectionLaw section_law(const Section& section, const Material& material);

/// d section_law / d dimension, exact.
SectionLaw section_law_derivative(const Section& section, const Material& material,
                                  std::string_view dimension);

/// d^2 section_law / d dimension^2, exact.
SectionLaw section_law_second_derivative(const Section& section, const Material& material,
                                         std::string_view dimension);

/// Points of the section where the stress can be largest, and the rows that give it there:
/// [sigma_x; tau_1; tau_2] = S [N, V_y, V_z, M_x, M_y, M_z] (Pa). Axial + bending + torsion;
/// transverse shear enters with its mean over the shear area. sigma_vm^2 = sigma^2 + 3 (tau_1^2 + tau_2^2).
struct StressPoint {
  double y = 0, z = 0;
  Eigen::Matrix<double, 3, 6> S;
};
std::vector<StressPoint> stress_points(const Section& section, double nu);

/// d S / d dimension at the same points.
std::vector<Eigen::Matrix<double, 3, 6>> stress_points_derivative(const Section& section, double nu,
                                                                  std::string_view dimension);

}  // namespace liesl
