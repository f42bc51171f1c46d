/// @file
/// Meshed parts: material, thickness, modes; whether mesh and outline connect the interfaces.

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "apps/scene/part_reader.hpp"
#include "mbs/solids/connectivity.hpp"
#include "mbs/solids/continuum_check.hpp"
#include "mbs/solids/volume_fraction.hpp"
#include "mbs/system/plane.hpp"

namespace liesl {

namespace {

void read_material(PartReader& part) {
  if (part.table.contains("matrices")) return;
  if (!part.table.contains("material"))
    return part.refuse(part.table, "has a mesh without 'material'", "the name of a material");
  const toml::node& node = *part.table.get("material");
  const auto name = node.value_or(std::string());
  if (!part.reader.known(node, "materials", "material", name) ||
      !part.reader.materials.count(name)) {
    part.ok = false;
    return;
  }
  part.material = part.reader.materials.at(name);
  if (!(part.material.rho > 0))
    part.refuse(node, "has no mass: its material has rho = 0", "a density > 0 (kg/m^3)");
}

void read_thickness(PartReader& part) {
  if (part.matrices) return;
  const toml::node* node = part.table.get("thickness");
  if (part.dim() == 2 && !node)
    part.refuse(part.table, "has a planar mesh without 'thickness'", "a number > 0 (m)");
  if (part.dim() == 3 && node)
    part.refuse(*node, "has a 'thickness', but is meshed in space", "no 'thickness'");
  if (node) part.options.thickness = number(part.table, "thickness");
}

void read_motion(PartReader& part) {
  if (text(part.table, "as") == "continuum") part.solid.as = SolidMotion::Continuum;
  if (text(part.table, "law") == to_string(SolidLaw::NeoHookean))
    part.solid.law = SolidLaw::NeoHookean;
  if (part.solid.as == SolidMotion::Reduced && part.solid.law != SolidLaw::StVenantKirchhoff)
    part.refuse(*part.table.get("law"), "is linear in its frame: it has no other law",
                "as = \"continuum\", or no 'law'");
  const toml::node& modes = *part.table.get("modes");
  if (part.solid.as == SolidMotion::Continuum && written(modes))
    part.refuse(modes, "as a continuum has no modes: all its nodes move", "no 'modes'");
}

constexpr double kLocks = 0.45;  // Poisson's ratio from which cells of displacements are too stiff

/// A part whose nodes all move.
void check_continuum(PartReader& part) {
  if (part.solid.as != SolidMotion::Continuum) return;
  const auto problem = continuum_problem(part.solid);
  if (!problem) {
    const double nu = part.material.nu;
    if (part.dim() == 3 && nu > kLocks)
      part.reader.scene.warnings.push_back(fmt::format(
          "part '{}' is nearly incompressible (nu = {:g}), and its cells are too stiff then: "
          "halve them and compare (`liesl run --verify`)",
          part.name, nu));
    return;
  }
  const auto at = part.table.at_path(problem->key);
  part.refuse(at.node() ? *at.node() : static_cast<const toml::node&>(part.table),
              "as a continuum " + problem->text, problem->expected, problem->hint);
}

void build_model(PartReader& part) {
  try {
    part.solid.model = part.matrices
                           ? std::make_shared<const SolidModel>(std::move(part.mesh),
                                                                *part.matrices, part.interfaces)
                           : std::make_shared<const SolidModel>(std::move(part.mesh), part.material,
                                                                part.interfaces, part.options);
    const SolidModel& model = *part.solid.model;
    const int inner = model.size() - model.rigid_count() * model.ports();
    check_continuum(part);
    if (part.solid.as == SolidMotion::Reduced && part.solid.modes > 0 && part.solid.modes >= inner)
      part.refuse(*part.table.get("modes"),
                  fmt::format("keeps {} modes, its mesh has {} free displacements",
                              part.solid.modes, inner),
                  fmt::format("at most {}", std::max(0, inner - 1)));
    if (part.solid.as == SolidMotion::Continuum) return;  // judged above
    if (const auto cut = cut_interface(model, solid_fractions(part.solid).value))
      part.refuse(key_of(part.table_of("interfaces"), cut->interface),
                  "is not connected: " + cut->text, "material between all interfaces",
                  "see the features of its outline");
  } catch (const std::invalid_argument& error) {
    part.refuse(part.table, std::string("cannot be built: ") + error.what(),
                "a mesh with interfaces");
  }
}

}  // namespace

std::optional<SolidSpec> read_solid(Reader& reader, const std::string& name, toml::table& table) {
  PartReader part{reader, name, table};
  part.solid.frame = SE3(SO3::exp(orientation(part.reader, part.table)).R, vec3(part.table, "at"));
  part.solid.modes = integer(part.table, "modes");
  part.solid.damping = number(part.table, "damping");
  if (const toml::table* ersatz = part.table["ersatz"].as_table())
    part.options.law = {number(*ersatz, "exponent"), number(*ersatz, "ratio")};
  const SimulationOptions& o = part.reader.scene.simulation;
  read_motion(part);
  if (o.type == SimulationType::Static && (o.critical || o.arc_length) &&
      part.solid.as == SolidMotion::Reduced)
    part.reader.scene.warnings.push_back(fmt::format(
        "part '{}' is linear in its frame: it does not buckle by itself; use as = \"continuum\", "
        "several parts in a row, or beams",
        part.name));
  read_material(part);
  read_mesh(part);
  if (!part.ok) return {};
  read_thickness(part);
  read_interfaces(part);
  read_outline(part);
  if (part.ok) build_model(part);
  return part.ok ? std::optional(std::move(part.solid)) : std::nullopt;
}

void check_plane(Reader& reader) {
  const Mechanism& m = reader.scene.mechanism;
  if (reader.problems.count() > 0) return;
  for (const BodySpec& body : m.bodies) {
    const auto* solid = std::get_if<SolidSpec>(&body.kind);
    if (!solid || solid->mesh().dim == 3) continue;
    const PlaneSearch found = find_plane(m);
    const bool asked = reader.scene.simulation.space != SpaceChoice::Spatial;
    if (found.plane && asked) return;
    const toml::table& bodies = *reader.root["bodies"].as_table();
    const toml::table& table = *bodies[body.name]["solid"].as_table();
    reader.problems.add(*table.get(table.contains("mesh") ? "mesh" : "matrices"),
                        fmt::format("part '{}' has a planar mesh, but {}", body.name,
                                    found.plane ? "simulation.space is \"spatial\""
                                                : "the scene is not planar: " + found.reason),
                        "a planar scene, or a mesh in space");
    return;
  }
}

}  // namespace liesl
