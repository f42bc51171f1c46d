#pragma once
/// @file
/// Meshed parts whose nodes all move.

#include <stdexcept>

#include "mbs/solids/volume_fraction.hpp"
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

/// Cuts a round hole along z into a part, in the axes of its mesh.
inline void cut_hole(SolidSpec& part, double x, double y, double radius) {
  using levelset::FeatureKind;
  const bool flat = part.mesh().dim == 2;
  const auto placed = [flat](double at_x, double at_y) {
    std::vector<double> values = {at_x, at_y, 0};
    if (!flat) values.resize(6, 0.0);
    return values;
  };
  std::vector<double> circle = placed(x, y);
  circle.push_back(radius);
  part.outline = {part.mesh().dim,
                  {{"plate", FeatureKind::HalfSpace, placed(1e3, 0), {}},
                   {"hole", FeatureKind::Circle, circle, {}},
                   {"all", FeatureKind::Difference, {}, {"plate", "hole"}}}};
}

/// Values of the outline in the order of its parameters, and the number of one of them.
inline Eigen::VectorXd outline_values(const SolidSpec& part) {
  return levelset::make_shape(part.outline)->start();
}
inline int outline_number(const SolidSpec& part, const std::string& name) {
  const auto shape = levelset::make_shape(part.outline);
  for (int i = 0; i < shape->size(); ++i)
    if (shape->parameters()[static_cast<std::size_t>(i)].name == name) return i;
  throw std::invalid_argument("the outline has no '" + name + "'");
}

/// Sets a number of the outline; d(fractions of the cells)/d(that number).
inline void set_outline(SolidSpec& part, const std::string& name, double value) {
  Eigen::VectorXd p = outline_values(part);
  p[outline_number(part, name)] = value;
  levelset::set_values(part.outline, p);
}
inline Eigen::VectorXd fractions_by(const SolidSpec& part, const std::string& name) {
  return Eigen::MatrixXd(solid_fractions(part).derivative).col(outline_number(part, name));
}

/// It, clamped at its first end.
inline Mechanism clamped(const SolidSpec& part) {
  Mechanism m;
  m.bodies = {{"part", part}};
  m.joints = {{"clamp", JointType::Fixed, {}, {0, 0}}};
  return m;
}

}  // namespace liesl::test
