#pragma once
/// @file
/// Meshes with interfaces, ready to be the model of a `SolidSpec`.

#include <memory>
#include <utility>

#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/solid_spec.hpp"

namespace liesl::test {

using MeshModel = std::shared_ptr<const SolidModel>;

/// A mesh held rigidly where x is smallest, at the point a of interface "a", and where it is
/// largest, at b.
inline MeshModel mesh_with_ends(SolidMesh mesh, const Material& material, const Vec3& a,
                                const Vec3& b, const SolidModel::Options& options = {}) {
  std::vector<Interface> ends = {{"a", mesh.sets.at("x_min"), a, Tie::Rigid},
                                 {"b", mesh.sets.at("x_max"), b, Tie::Rigid}};
  return std::make_shared<const SolidModel>(std::move(mesh), material, std::move(ends), options);
}

/// The same mesh of another material.
inline MeshModel of_material(const SolidModel& m, const Material& material) {
  return std::make_shared<const SolidModel>(m.mesh(), material, m.interfaces(),
                                            SolidModel::Options{m.thickness(), m.law()});
}

/// The same planar mesh of another thickness.
inline MeshModel of_thickness(const SolidModel& m, double thickness) {
  return std::make_shared<const SolidModel>(m.mesh(), m.material(), m.interfaces(),
                                            SolidModel::Options{thickness, m.law()});
}

}  // namespace liesl::test
