#pragma once
/// @file
/// Where the stress of a section is evaluated, and the rows that give it there.

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "mbs/sections/section.hpp"

namespace liesl {

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
