#pragma once
/// @file
/// Stiffness and inertia of sections, and their derivatives by the dimensions of the shape.

#include <Eigen/Core>
#include <string_view>

#include "mbs/sections/section.hpp"

namespace liesl {

/// What the beam needs of a section: `K` (stiffness) and `M` (inertia per length).
struct SectionLaw {
  Eigen::Matrix<double, 6, 6> K;
  Eigen::Matrix<double, 6, 6> M;
};

/// Geometry of a section: A [m^2], I_y, I_z, J [m^4], shear factors.
struct SectionGeometry {
  double A = 0, Iy = 0, Iz = 0, J = 0, ky = 0, kz = 0;
};

/// A, I_y = int z^2 dA, I_z = int y^2 dA, J and shear factors. J of circle, tube and rectangle is
/// exact to round-off, of a box Bredt's (thin walls), of an I the sum of s t^3/3 over its plates.
/// @throws std::invalid_argument for FullSection.
SectionGeometry geometry(const Section& section, double nu);

/// K = diag(EA, ky GA, kz GA, GJ, E Iy, E Iz),
/// M = rho diag(A, A, A, Iy + Iz, Iy, Iz)  (the `M_s` of docs/theory.md).
SectionLaw section_law(const Section& section, const Material& material);

/// d section_law / d dimension, exact. @throws std::invalid_argument for an unknown name.
SectionLaw section_law_derivative(const Section& section, const Material& material,
                                  std::string_view dimension);

/// d^2 section_law / d dimension^2, exact. @throws std::invalid_argument for an unknown name.
SectionLaw section_law_second_derivative(const Section& section, const Material& material,
                                         std::string_view dimension);

}  // namespace liesl
