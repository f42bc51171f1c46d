#pragma once
/// @file
/// What scales a meshed part, the second body of a machine, as quantities of it.

#include "mbs/sensitivity/machine.hpp"
#include "reference/meshed_part.hpp"

namespace liesl::test {

inline SolidSpec& part(Mechanism& m) { return std::get<SolidSpec>(m.bodies[1].kind); }
inline const SolidSpec& part(const Mechanism& m) { return std::get<SolidSpec>(m.bodies[1].kind); }

/// E, rho, and of a mesh in the plane its thickness.
inline std::vector<Quantity> scales_of_the_part(const Mechanism& m) {
  const auto set = [](double Material::*constant) {
    return [constant](Mechanism& c, double p) {
      Material material = part(c).model->material();
      material.*constant = p;
      part(c).model = of_material(*part(c).model, material);
    };
  };
  const SolidModel& model = *part(m).model;
  const double E = model.material().E, rho = model.material().rho, t = model.thickness();
  std::vector<Quantity> all = {{E, set(&Material::E), {"E", {SolidScale{1, 1 / E, 0}}}},
                               {rho, set(&Material::rho), {"rho", {SolidScale{1, 0, 1 / rho}}}}};
  if (model.mesh().dim == 2)
    all.push_back({t,
                   [](Mechanism& c, double p) { part(c).model = of_thickness(*part(c).model, p); },
                   {"thickness", {SolidScale{1, 0, 0, 1 / t}}}});
  return all;
}

/// Lengths along an axis times a factor.
inline void stretch_rod(Mechanism& m, int axis, double factor) {
  const SolidModel& old = *part(m).model;
  SolidMesh mesh = old.mesh();
  mesh.nodes.row(axis) *= factor;
  auto interfaces = old.interfaces();
  for (Interface& f : interfaces) f.point[axis] *= factor;
  part(m).model =
      std::make_shared<const SolidModel>(std::move(mesh), old.material(), std::move(interfaces),
                                         SolidModel::Options{old.thickness(), old.law()});
}

}  // namespace liesl::test
