#pragma once
/// @file
/// Where members buckle, in closed form of their sections, with derivatives by the section law.

#include "mbs/sections/section_law.hpp"

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

/// Stress at which the wall of a round tube under axial compression buckles, Pa:
///   sigma = knock_down E t / (R sqrt(3 (1 - nu^2))),
/// R the mean radius of the wall. Classical value (Lorenz 1908, Timoshenko 1910; Timoshenko and
/// Gere 1961, eq. 11-2) for knock_down = 1; real tubes reach a fraction. t/R follows from the area
/// A and the second moment I of the tube: m = A^2/(4 pi I), t/R = 2 (1 - sqrt(1 - m^2))/m.
/// @pre the law is that of a tube
WithDerivative wall_buckling_stress(const SectionLaw& law, const SectionLaw& by, double E,
                                    double nu, double knock_down);

}  // namespace liesl
