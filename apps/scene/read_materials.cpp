/// @file
/// Simulation options, materials and sections.
#include <fmt/format.h>

#include <algorithm>

#include "apps/scene/reader.hpp"
#include "mbs/linalg/dense.hpp"
#include "mbs/sections/section_errors.hpp"

namespace liesl {

namespace {

SimulationType type_of(const std::string& text) {
  if (text == "static") return SimulationType::Static;
  return text == "modes" ? SimulationType::Modes : SimulationType::Dynamic;
}

Formalism formalism_of(const std::string& name) {
  for (auto f : {Formalism::R3SO3, Formalism::Classical, Formalism::Floating, Formalism::Rigid,
                 Formalism::Segments})
    if (name == to_string(f)) return f;
  return Formalism::SE3;
}

PenaltySpec penalty_of(const toml::table& table, double step) {
  PenaltySpec spec;
  const std::string form = text(table, "constraints");
  for (auto f : {ConstraintForm::Penalty, ConstraintForm::Augmented})
    if (form == to_string(f)) spec.form = f;
  if (spec.form == ConstraintForm::Multipliers) return spec;
  spec.displacement = number(table, "penalty");
  spec.rotation = number(table, "penalty_rotation");
  spec.damping = number(table, "penalty_damping");
  spec.step = step;
  return spec;
}

/// What is for motions only.
void check_not_dynamic(Reader& reader, const toml::table& table) {
  const Mechanism& m = reader.scene.mechanism;
  if (m.formalism == Formalism::Floating || m.formalism == Formalism::Rigid)
    reader.problems.add(
        *table.get("formalism"),
        fmt::format("'simulation.formalism' = \"{}\" is for motions only", to_string(m.formalism)),
        "simulation.type = \"dynamic\", or formalism se3, r3so3 or classical");
  if (m.penalty.form != ConstraintForm::Multipliers)
    reader.problems.add(*table.get("constraints"),
                        fmt::format("'simulation.constraints' = \"{}\" is for motions only",
                                    to_string(m.penalty.form)),
                        "simulation.type = \"dynamic\", or constraints = \"multipliers\"");
}

TangentStrategy tangent_of(const std::string& name) {
  if (name == "constant") return TangentStrategy::Constant;
  if (name == "adaptive") return TangentStrategy::Adaptive;
  if (name == "exact") return TangentStrategy::Exact;
  return TangentStrategy::Auto;
}

SpaceChoice space_of(const std::string& text) {
  if (text == "planar") return SpaceChoice::Planar;
  return text == "spatial" ? SpaceChoice::Spatial : SpaceChoice::Auto;
}

/// What is wrong with a 6x6 matrix of a full section, empty if nothing.
std::string defect_of_matrix(const Eigen::MatrixXd& M) {
  const double size = M.cwiseAbs().maxCoeff();
  if ((M - M.transpose()).cwiseAbs().maxCoeff() > 1e-9 * size) return "is not symmetric";
  const double least = linalg::symmetric_eigenvalues(M)[0];
  if (least <= 0) return fmt::format("has an eigenvalue of {:.3g}", least);
  return "";
}

/// Why the inertia of a section is of no distribution of mass, empty if it may be: about the centre
/// of mass no principal value is larger than the sum of the others.
std::string impossible(const Eigen::MatrixXd& M) {
  const double m = M(0, 0);
  const Eigen::Matrix3d coupling = M.bottomLeftCorner<3, 3>();
  const Eigen::Matrix3d J = M.bottomRightCorner<3, 3>() - coupling * coupling.transpose() / m;
  const Eigen::VectorXd p = linalg::symmetric_eigenvalues(J);
  if (p[2] <= (p[0] + p[1]) * (1 + 1e-9)) return "";
  return fmt::format("is of no section: {:.4g} is more than {:.4g} + {:.4g} kg m", p[2], p[0],
                     p[1]);
}

FullSection full_section(Reader& reader, const toml::table& table) {
  FullSection full;
  full.stiffness = matrix(*table.get("stiffness"), 6);
  full.inertia.setZero();
  const std::string symmetric = "a symmetric, positive definite matrix";
  if (const auto what = defect_of_matrix(full.stiffness); !what.empty())
    reader.problems.add(*table.get("stiffness"), fmt::format("'stiffness' {}", what), symmetric,
                        "directions that shall not move want a large stiffness, not none");
  if (const toml::node* inertia = table.get("inertia")) {
    full.inertia = matrix(*inertia, 6);
    if (const auto what = defect_of_matrix(full.inertia); !what.empty())
      reader.problems.add(*inertia, fmt::format("'inertia' {}", what), symmetric);
    else if (const auto why = impossible(full.inertia); !why.empty())
      reader.problems.add(*inertia, fmt::format("'inertia' {}", why),
                          "rotational inertias each at most the sum of the others",
                          "of an area I_y, I_z the diagonal is rho [A, A, A, I_y + I_z, I_y, I_z]");
  }
  return full;
}

Shape shape_of(Reader& reader, const toml::table& table) {
  const std::string type = text(table, "type");
  const auto length = [&](std::string_view key) { return number(table, key); };
  if (type == "circle") return Circle{length("diameter")};
  if (type == "tube") return Tube{length("diameter"), length("thickness")};
  if (type == "rectangle") return Rectangle{length("width"), length("height")};
  if (type == "box") return Box{length("width"), length("height"), length("thickness")};
  if (type == "i")
    return ISection{length("width"), length("height"), length("flange_thickness"),
                    length("web_thickness")};
  return full_section(reader, table);
}

/// The value that most likely causes what is wrong with a shape.
const toml::node& culprit(const toml::table& table) {
  for (const char* key : {"thickness", "flange_thickness", "web_thickness", "stiffness"})
    if (const toml::node* node = table.get(key)) return *node;
  return table;
}

/// An update that the formalism cannot take is refused.
void read_update(Reader& reader, const toml::table& table) {
  const std::string update = text(table, "update");
  Mechanism& mechanism = reader.scene.mechanism;
  if (update == "se3") mechanism.update = NodeUpdate::Screw;
  if (update == "r3so3") mechanism.update = NodeUpdate::R3SO3;
  if (mechanism.update == NodeUpdate::AsFormalism) return;
  const Formalism f = mechanism.formalism;
  if (f == Formalism::Classical || f == Formalism::Floating || f == Formalism::Segments)
    reader.problems.add(*table.get("update"),
                        fmt::format("'simulation.update' = \"{}\" in the formalism {}", update,
                                    to_string(mechanism.formalism)),
                        "\"formalism\", or formalism se3, r3so3 or rigid");
  else if (reader.scene.simulation.type != SimulationType::Dynamic)
    reader.problems.add(*table.get("update"), "'simulation.update' is for motions only",
                        "simulation.type = \"dynamic\"");
}

/// What has nodes that are no frames; empty: it has none.
std::string other_nodes(const BodySpec& body) {
  if (const auto* beam = std::get_if<BeamSpec>(&body.kind)) {
    if (beam->as == BeamModel::Segments) return "beam '" + body.name + "' is a chain of segments";
    if (beam->as == BeamModel::Modal) return "beam '" + body.name + "' has modes";
  }
  if (const auto* solid = std::get_if<SolidSpec>(&body.kind)) {
    if (solid->as == SolidMotion::Continuum)
      return "all nodes of the mesh of '" + body.name + "' move";
    if (solid->modes > 0) return "part '" + body.name + "' has modes";
  }
  return {};
}

}  // namespace

void check_update(Reader& reader) {
  const Mechanism& mechanism = reader.scene.mechanism;
  if (mechanism.update != NodeUpdate::R3SO3 || mechanism.formalism != Formalism::SE3) return;
  for (const BodySpec& body : mechanism.bodies)
    if (const std::string others = other_nodes(body); !others.empty()) {
      reader.problems.add(
          *reader.root["simulation"]["update"].node(),
          "'simulation.update' = \"r3so3\" moves nodes that are frames, and " + others,
          "\"formalism\" or \"se3\"");
      return;
    }
}

void read_simulation(Reader& reader) {
  toml::table* table = reader.root["simulation"].as_table();
  if (!table) return;
  SimulationOptions& o = reader.scene.simulation;
  o.type = type_of(text(*table, "type"));
  o.space = space_of(text(*table, "space"));
  reader.scene.mechanism.formalism = formalism_of(text(*table, "formalism"));
  o.tangent = tangent_of(text(*table, "tangent"));
  read_update(reader, *table);
  if (reader.broken.contains("simulation")) return;
  o.rescale = boolean(*table, "rescale");
  o.duration = number(*table, "duration");
  o.step = number(*table, "step");
  o.rho_inf = number(*table, "rho_inf");
  o.tolerance = number(*table, "tolerance");
  o.max_iterations = integer(*table, "max_iterations");
  o.adaptive = boolean(*table, "adaptive");
  o.error_tolerance = number(*table, "error_tolerance");
  o.step_min = number(*table, "step_min");
  o.output_every = integer(*table, "output_every");
  o.start =
      text(*table, "start") == "equilibrium" ? StartChoice::Equilibrium : StartChoice::Assembled;
  o.at = number(*table, "at");
  o.load_steps = integer(*table, "load_steps");
  o.arc_length = boolean(*table, "arc_length");
  o.max_load = number(*table, "max_load");
  o.critical = boolean(*table, "critical");
  o.modes = integer(*table, "modes");
  const Formalism formalism = reader.scene.mechanism.formalism;
  reader.scene.mechanism.penalty = penalty_of(*table, o.step);
  if (o.type != SimulationType::Dynamic) return check_not_dynamic(reader, *table);
  if (o.start == StartChoice::Equilibrium &&
      (formalism == Formalism::Floating || formalism == Formalism::Rigid))
    reader.problems.add(*table->get("start"),
                        fmt::format("there are no statics of 'simulation.formalism' = \"{}\"",
                                    to_string(formalism)),
                        "simulation.start = \"assembled\", or formalism se3, r3so3 or classical");
  if (o.start == StartChoice::Equilibrium &&
      reader.scene.mechanism.penalty.form == ConstraintForm::Augmented)
    reader.problems.add(*table->get("start"),
                        "an equilibrium at the start with 'simulation.constraints' = \"augmented\"",
                        "simulation.constraints = \"multipliers\" or \"penalty\"",
                        "rows that repeat others leave its forces open");
  const toml::node& step = *table->get("step");
  const toml::node& duration = *table->get("duration");
  if (o.step > o.duration)
    reader.problems.add(
        written(step) ? step : duration,
        fmt::format("'simulation.step' ({:g} s) is longer than the duration", o.step),
        fmt::format("a step of at most {:g} s", o.duration));
  if (o.step_min > o.step)
    reader.problems.add(*table->get("step_min"),
                        fmt::format("'simulation.step_min' ({:g} s) is above the step", o.step_min),
                        fmt::format("at most {:g} s", o.step));
}

void read_materials(Reader& reader) {
  for (const Entry& entry : entries(reader, "materials"))
    reader.materials[entry.name] = {entry.name, number(*entry.table, "E"),
                                    number(*entry.table, "nu"), number(*entry.table, "rho")};
  for (const Entry& entry : entries(reader, "sections")) {
    const int before = reader.problems.count();
    Section section{entry.name, shape_of(reader, *entry.table), {0, 0}, 0};
    if (const toml::node* factor = entry.table->get("shear_factor")) {
      const auto k = numbers(*factor);
      section.shear_factor = {k.front(), k.back()};
    }
    section.torsion_constant = number(*entry.table, "torsion_constant");
    const bool full = std::holds_alternative<FullSection>(section.shape);  // checked above
    if (const std::string what = full ? "" : what_is_wrong(section.shape);
        !what.empty() && reader.problems.count() == before)
      reader.problems.add(culprit(*entry.table), fmt::format("section '{}': {}", entry.name, what),
                          "a section of positive material");
    reader.sections[entry.name] = section;
  }
}

}  // namespace liesl
