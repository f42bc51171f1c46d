#include "mbs/sections/buckling.hpp"

#include <cmath>
#include <numbers>

namespace liesl {

namespace {

/// EI of the weak axis; of an oblique section the smaller eigenvalue of the bending stiffness.
WithDerivative weak_bending(const SectionLaw& law, const SectionLaw& by) {
  const double a = law.K(4, 4), b = law.K(5, 5), c = law.K(4, 5);
  const double half = 0.5 * (a - b), root = std::hypot(half, c);
  const double sum = 0.5 * (by.K(4, 4) + by.K(5, 5));
  if (root == 0) return {0.5 * (a + b), std::min(by.K(4, 4), by.K(5, 5))};
  const double half_by = 0.5 * (by.K(4, 4) - by.K(5, 5));
  return {0.5 * (a + b) - root, sum - (half * half_by + c * by.K(4, 5)) / root};
}

}  // namespace

WithDerivative euler_load(const SectionLaw& law, const SectionLaw& by, double length) {
  const WithDerivative EI = weak_bending(law, by);
  const double factor = std::numbers::pi * std::numbers::pi / (length * length);
  return {factor * EI.value, factor * EI.derivative};
}

WithDerivative wall_buckling_stress(const SectionLaw& law, const SectionLaw& by, double E,
                                    double nu, double knock_down) {
  const double EA = law.K(0, 0), EI = law.K(4, 4);
  const double m = EA * EA / (4 * std::numbers::pi * E * EI), root = std::sqrt(1 - m * m);
  const double dm = m * (2 * by.K(0, 0) / EA - by.K(4, 4) / EI);
  const double q = 2 * m / (1 + root);  // t/R
  const double dq = 2 / (1 + root) + 2 * m * m / (root * (1 + root) * (1 + root));
  const double factor = knock_down * E / std::sqrt(3 * (1 - nu * nu));
  return {factor * q, factor * dq * dm};
}

}  // namespace liesl
