#ifdef LIESL_OPTIM  // what the design varies is applied by optim

#include "apps/study/design_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "apps/input/document.hpp"
#include "apps/input/ordered_text.hpp"
#include "apps/scene/outline_text.hpp"
#include "apps/scene/trusses.hpp"
#include "mbs/model/beam_ends.hpp"
#include "mbs/sections/shape_dimensions.hpp"
#include "optim/design/drive_tables.hpp"

namespace liesl {

namespace {

/// The table of a section with other dimensions.
toml::table section_table(const toml::table& sections, const Section& section) {
  toml::table table;
  if (const toml::table* given = sections[section.name].as_table()) table = *given;
  for (const auto name : dimensions(section.shape))
    table.insert_or_assign(name, dimension(section.shape, name));
  return table;
}

/// The fewest names, each for as many neighbours: of "a a b b" they are "a b", which a beam with
/// fewer elements can have, too.
toml::array shortest_list(const std::vector<std::string>& names) {
  std::size_t length = names.size();
  const auto runs = [&] {
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i] != names[i - i % length]) return false;
    return names.size() % length == 0;
  };
  while (!runs()) --length;
  toml::array list;
  for (std::size_t i = 0; i < names.size(); i += length) list.push_back(names[i]);
  return list;
}

/// Gives every element of a beam its section, of a taper every node; equal ones share an entry.
void write_sections(toml::table& scene, const BodySpec& body) {
  const BeamSpec& spec = std::get<BeamSpec>(body.kind);
  const bool taper = tapers(spec);
  std::vector<Section> all = spec.sections;
  if (taper) {
    all = {spec.ends.front().front()};
    for (const auto& ends : spec.ends) all.push_back(ends.back());
  }
  toml::table& sections = *scene["sections"].as_table();
  std::vector<std::string> names;
  std::map<std::string, std::string> known;  // text of a section -> its name
  int number = 0;
  for (const Section& section : all) {
    const toml::table table = section_table(sections, section);
    std::ostringstream text;
    text << table;
    std::string& name = known[text.str()];
    if (name.empty()) {
      do name = fmt::format("{}_{}", body.name, ++number);
      while (sections.contains(name));
      sections.insert(name, table);
    }
    names.push_back(name);
  }
  toml::table& beam = *scene["bodies"][body.name]["beam"].as_table();
  toml::array list;
  if (taper)
    for (const std::string& name : names) list.push_back(name);
  else
    list = shortest_list(names);
  beam.insert_or_assign("section", std::move(list));
  if (!taper) beam.erase("taper");
}

/// Nodes of trusses become the ports of their bars.
void write_ports(toml::node& node, const std::map<std::string, std::string>& ports) {
  if (auto* table = node.as_table())
    for (auto&& [key, value] : *table) write_ports(value, ports);
  if (auto* array = node.as_array())
    for (toml::node& value : *array) write_ports(value, ports);
  if (auto* text = node.as_string())
    if (const auto port = ports.find(text->get()); port != ports.end()) *text = port->second;
}

/// The number of a constant, where the scene has it.
void write_constant(toml::table& scene, const ConstantSpec& c, Mechanism final) {
  const double value = constant_of(c, final);
  if (c.quantity == ConstantQuantity::Mass) {
    const std::string& body = final.bodies[static_cast<std::size_t>(c.body)].name;
    scene["bodies"][body]["rigid"].as_table()->insert_or_assign("mass", value);
    return;
  }
  const char* const keys[] = {"stiffness", "damping", "rest"};  // in the order of ConstantQuantity
  const std::string& force = final.forces[static_cast<std::size_t>(c.force)].name;
  scene["forces"][force].as_table()->insert_or_assign(keys[static_cast<int>(c.quantity)], value);
}

/// The tables of the drives and the duration, where the scene has them.
void write_motion(toml::table& scene, const StudySpec& spec, const Mechanism& final,
                  const std::map<std::string, double>& values) {
  std::vector<double> x;
  for (const ConstantSpec& c : spec.constants) x.push_back(values.at(c.name));
  for (const DriveTable& table : drive_tables(spec.constants, spec.drives, spec.duration, x)) {
    toml::array rows;
    for (std::size_t i = 0; i < table.t.size(); ++i)
      rows.push_back(toml::array{table.t[i], table.q[i]});
    const int joint = final.drives[static_cast<std::size_t>(table.drive)].joint;
    const std::string& name = final.joints[static_cast<std::size_t>(joint)].name;
    scene["joints"][name]["drive"].as_table()->insert_or_assign("table", std::move(rows));
  }
  if (!(spec.duration > 0)) return;
  toml::table& simulation = *scene["simulation"].as_table();
  const double duration = duration_of(spec.constants, spec.duration, x);
  const double step = simulation["step"].value_or(SimulationOptions().step);
  simulation.insert_or_assign("duration", duration);
  simulation.insert_or_assign("step", step * duration / spec.duration);
}

void write_outline(toml::table& scene, const std::string& part,
                   const levelset::ShapeSpec& outline) {
  Document document = parse_document(outline_text(part, outline), "the outline");
  const toml::table& table = *document.root["bodies"][part]["solid"]["outline"].as_table();
  scene["bodies"][part]["solid"].as_table()->insert_or_assign("outline", table);
}

/// A run of the design is converged as far as the optimisation converged its motions.
void write_tolerance(toml::table& scene, CycleMethod method) {
  constexpr double kOfDesigns = 1e-8;
  const double given = scene["simulation"]["tolerance"].value_or(SimulationOptions().tolerance);
  if (given <= kOfDesigns || method == CycleMethod::Esl) return;
  toml::table& simulation = *scene.insert("simulation", toml::table{}).first->second.as_table();
  simulation.insert_or_assign("tolerance", kOfDesigns);
}

}  // namespace

std::string design_scene(const Study& study, const Mechanism& final,
                         const std::map<std::string, levelset::ShapeSpec>& outlines,
                         const std::map<std::string, double>& values, std::size_t scenario) {
  Document document = parse_document(study.scene_texts.at(scenario), study.scene.file);
  Problems none(study.scene.file);
  const TrussNames trusses = expand_trusses(document.root, {}, none);
  for (const char* table : {"loads", "joints", "forces", "responses"})  // bars have sections now
    if (toml::node* node = document.root.get(table)) write_ports(*node, trusses.nodes);
  std::set<int> sized;
  for (const DesignSpec& d : study.spec.design) sized.insert(d.bodies.begin(), d.bodies.end());
  for (const int body : sized)
    write_sections(document.root, final.bodies[static_cast<std::size_t>(body)]);
  for (const ConstantSpec& c : study.spec.constants)
    if (c.quantity < ConstantQuantity::DriveValue) write_constant(document.root, c, final);
  write_motion(document.root, study.spec, final, values);
  for (const auto& [part, outline] : outlines) write_outline(document.root, part, outline);
  write_tolerance(document.root, study.spec.cycle.method);
  if (!document.root.contains("name")) document.root.insert("name", final.name);  // of the file
  return fmt::format("# The final design of the study '{}'. SI units.\n\n{}", study.spec.name,
                     ordered_text(document.root));
}

}  // namespace liesl

#endif
