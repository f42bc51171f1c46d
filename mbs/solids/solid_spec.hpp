#pragma once
/// @file
/// A meshed part of a mechanism as data.

#include <memory>
#include <vector>

#include "liegroup/se3.hpp"
#include "mbs/levelset/shape_spec.hpp"
#include "mbs/solids/interface.hpp"
#include "mbs/solids/mesh.hpp"
#include "mbs/solids/solid_law.hpp"

namespace liesl {

class SolidModel;
struct Fractions;

/// What a meshed part is simulated as.
enum class SolidMotion {
  Reduced,   ///< interfaces and modes in a floating frame, linear in it
  Continuum  ///< all nodes of the mesh
};

/// The mesh with its material and interfaces (`model`), in coordinates of its own, and the outline
/// of the part in it. Its ports are its interfaces; the first of them carries the floating frame. A
/// planar mesh lies in z = 0 and reaches thickness/2 to both sides.
struct SolidSpec {
  SE3 frame = SE3::identity();              ///< of the mesh's coordinates, in the scene
  std::shared_ptr<const SolidModel> model;  ///< with at least one interface; shared by copies
  levelset::ShapeSpec outline;              ///< without features: all of the mesh is material
  int modes = 8;                            ///< internal modes kept
  double damping = 0;                       ///< stiffness-proportional, s
  SolidMotion as = SolidMotion::Reduced;
  SolidLaw law = SolidLaw::StVenantKirchhoff;  ///< of a continuum

  const SolidMesh& mesh() const;
  const std::vector<Interface>& interfaces() const;
  /// Frame of an interface where the scene puts it.
  SE3 port(int interface) const;
};

/// How much of each cell is material, with derivatives with respect to the outline's parameters.
/// @throws std::invalid_argument for an outline with an error
Fractions solid_fractions(const SolidSpec& solid);

}  // namespace liesl
