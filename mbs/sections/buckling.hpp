#pragma once
/// @file
/// Where members buckle, in closed form of their sections, with derivatives by the section law.

#include <span>

#include "mbs/sections/section_law.hpp"
#include "mbs/sections/stress.hpp"

namespace liesl {

/// A number and what a change of the section law makes of it.
struct WithDerivative {
  double value = 0, derivative = 0;
};

/// Euler load pi^2 EI/(K L)^2 of a member that is hinged at its ends (K = 1), N; EI the smaller one
/// of the two principal axes of the section, without shear. Source: L. Euler 1744; Timoshenko and
/// Gere, Theory of Elastic Stability, 1961, eq. 2-1, 2-4.
/// @param by derivative of the law  @param length K L, m
WithDerivative euler_load(const SectionLaw& law, const SectionLaw& by, double length);

/// A section as far as its walls are known from it: their dimensions follow from the section law
/// and from the stress rows S (mbs/sections/stress.hpp), their derivatives from those of both.
struct WalledSection {
  const Section& section;
  const SectionLaw &law, &by;
  std::span<const StressPoint> points;                     ///< of the section, in their order
  std::span<const Eigen::Matrix<double, 3, 6>> by_points;  ///< derivatives of S; empty: none
};

/// Tubes, boxes and I: shapes of walls.
bool has_walls(const Shape& shape);

/// Stress at which the wall that a stress point lies on buckles under axial compression, Pa, times
/// `knock_down`:
///   tube     sigma = E t/(R sqrt(3 (1 - nu^2)))                          R of the middle surface
///   plate    sigma = k pi^2 E/(12 (1 - nu^2)) (t/b)^2                    b between middle lines
///   box      k = 4: plates hinged along both edges
///   I        web k = 4; halves of the flanges k = 6 (1 - nu)/pi^2: hinged along the web, one edge
///            free
/// of long walls. The stress is taken as uniform across the wall, which is on the safe side where
/// it falls off, and walls do not hold each other. Classical values; real tubes reach a fraction.
/// Sources: Lorenz 1908, Timoshenko 1910, Bryan 1891; Timoshenko and Gere, Theory of Elastic
/// Stability, 1961, eq. 11-2 (tube), section 9.2 (k = 4), section 9.4 (free edge).
/// @pre has_walls
WithDerivative wall_buckling_stress(const WalledSection& s, std::size_t point,
                                    const Material& material, double knock_down);

}  // namespace liesl
