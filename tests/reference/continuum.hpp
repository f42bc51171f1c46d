#pragma once
/// @file
/// Meshed parts whose nodes all move.

#include "reference/mechanisms.hpp"
#include "reference/meshed_part.hpp"

namespace liesl::test {

/// A block of length x, height y and depth z from the origin, held rigidly at its ends "a" and "b",
/// about their middles. @param nz 0: quadrilaterals of thickness z
inline SolidSpec continuum_block(const Vec3& size, int nx, int ny, int nz, const Material& material,
                                 SolidLaw law = SolidLaw::StVenantKirchhoff) {
  const Vec3 half(0, size[1] / 2, size[2] / 2), end(size[0], 0, 0);
  SolidSpec s;
  s.model = mesh_with_ends(nz > 0 ? hex_grid(-half, end + half, nx, ny, nz)
                                  : quad_grid((-half).head<2>(), (end + half).head<2>(), nx, ny),
                           material, Vec3::Zero(), end, {size[2], {}});
  s.as = SolidMotion::Continuum;
  s.law = law;
  return s;
}

/// It, clamped at its first end.
inline Mechanism clamped(const SolidSpec& part) {
  Mechanism m;
  m.bodies = {{"part", part}};
  m.joints = {{"clamp", JointType::Fixed, {}, {0, 0}}};
  return m;
}

}  // namespace liesl::test
