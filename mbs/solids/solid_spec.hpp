#pragma once
/// @file
/// A meshed part of a mechanism as data.

#include <string>
#include <vector>

#include "liegroup/se3.hpp"
#include "mbs/levelset/shape_spec.hpp"
#include "mbs/sections/section.hpp"
#include "mbs/solids/ersatz.hpp"
#include "mbs/solids/interface.hpp"
#include "mbs/solids/mesh.hpp"

namespace liesl {

class SolidModel;
struct Fractions;

/// Mesh, material, outline and interfaces in the coordinates of the mesh. Its ports are its
/// interfaces; the first of them carries the floating frame. A planar mesh lies in z = 0 and
/// reaches thickness/2 to both sides.
struct SolidSpec {
  SE3 frame = SE3::identity();  ///< of the mesh's coordinates, in the scene
  SolidMesh mesh;
  Material material;
  double thickness = 1;  ///< m, of a planar mesh
  ErsatzLaw law;
  std::vector<Interface> interfaces;  ///< at least one
  levelset::ShapeSpec outline;        ///< without features: all of the mesh is material
  int modes = 8;                      ///< internal modes kept
  double damping = 0;                 ///< stiffness-proportional, s

  /// Frame of an interface where the scene puts it.
  SE3 port(int interface) const;
};

/// The part with its matrices. @throws std::invalid_argument, see SolidModel
SolidModel solid_model(const SolidSpec& solid);
/// How much of each cell is material, with derivatives with respect to the outline's parameters.
/// @throws std::invalid_argument for an outline with an error
Fractions solid_fractions(const SolidSpec& solid);

}  // namespace liesl
