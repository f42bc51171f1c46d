#pragma once
/// @file
/// Geometry and torsion stress of sections as dual numbers: one formula per shape, from which the
/// values and both derivatives of section_law.hpp and stress.hpp follow.

#include <array>
#include <vector>

#include "mbs/sections/dual2.hpp"
#include "mbs/sections/section.hpp"

namespace liesl {

/// SectionGeometry with derivatives.
struct DualGeometry {
  Dual2 A, Iy, Iz, J, ky, kz;
};

/// Geometry of a shape, differentiated by its dimension number `variable` (-1: constant).
/// @throws std::invalid_argument for FullSection.
DualGeometry dual_geometry(const Shape& shape, double nu, int variable);

/// The same with the shear factors and the torsion constant that the section prescribes.
DualGeometry dual_geometry(const Section& section, double nu, int variable);

/// A place on the outline and the shear stresses tau_xy, tau_xz of M_x = 1 N m there [1/m^3].
struct DualStressPoint {
  Dual2 y, z;
  Dual2 torsion_y, torsion_z;
};

/// The stress points of a shape; empty for FullSection.
std::vector<DualStressPoint> dual_stress_points(const Shape& shape, int variable);

}  // namespace liesl
