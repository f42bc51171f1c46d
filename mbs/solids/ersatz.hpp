#pragma once
/// @file
/// What a partly filled cell is made of.

#include <cmath>

namespace liesl {

/// Stiffness of a cell with fraction v, relative to the full one: s = ratio + (1 - ratio) f(v) with
/// f(v) = v^exponent; mass is v. Empty cells keep `ratio` (ersatz material; Allaire, Jouve, Toader
/// 2004), so that the stiffness matrix stays regular and holes may merge or vanish. The defaults
/// are the best of those measured in tests/mbs/solids/ersatz_test.cpp (docs/performance.md).
struct ErsatzLaw {
  double exponent = 1.4;  ///< >= 1
  double ratio = 1e-6;    ///< in (0, 1)

  double stiffness(double v) const { return ratio + (1 - ratio) * std::pow(v, exponent); }
  /// ds/dv
  double slope(double v) const {
    return (1 - ratio) * exponent * (exponent == 1 ? 1 : std::pow(v, exponent - 1));
  }
};

}  // namespace liesl
