/// @file
/// Meshed parts: mesh, interfaces, outline.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "apps/mesh/gmsh_mesh.hpp"
#include "apps/scene/outline_text.hpp"
#include "apps/scene/reader.hpp"
#include "mbs/solids/connectivity.hpp"
#include "mbs/solids/interface_map.hpp"
#include "mbs/solids/volume_fraction.hpp"
#include "mbs/system/plane.hpp"

namespace liesl {

namespace {

namespace fs = std::filesystem;
using levelset::FeatureKind;
using levelset::FeatureSpec;

constexpr double kMostCells = 1e6;
constexpr double kSlack = 1e-9;  // of a region's size: nodes on its edge are inside

/// Where an entry of a table inside of a body is written.
const toml::key& key_of(const toml::table& table, const std::string& name) {
  return table.find(name)->first;
}

/// Reads one part; `ok_` turns false if it cannot be built.
class SolidReader {
 public:
  SolidReader(Reader& reader, const std::string& name, toml::table& table)
      : reader_(reader), name_(name), table_(table) {}

  std::optional<SolidSpec> read() {
    solid_.frame = SE3(SO3::exp(vec3(table_, "orientation")).R, vec3(table_, "at"));
    solid_.modes = integer(table_, "modes");
    solid_.damping = number(table_, "damping");
    if (const toml::table* ersatz = table_["ersatz"].as_table())
      solid_.law = {number(*ersatz, "exponent"), number(*ersatz, "ratio")};
    const SimulationOptions& o = reader_.scene.simulation;
    if (o.type == SimulationType::Static && (o.critical || o.arc_length))
      reader_.scene.warnings.push_back(fmt::format(
          "part '{}' is linear in its frame: it does not buckle by itself; use several parts in a "
          "row, or beams",
          name_));
    material();
    mesh();
    if (!ok_) return {};
    thickness();
    interfaces();
    outline();
    if (ok_) connection();
    return ok_ ? std::optional(std::move(solid_)) : std::nullopt;
  }

 private:
  template <class Place>
  void refuse(const Place& at, const std::string& what, const std::string& expected,
              const std::string& hint = "") {
    reader_.problems.add(at, fmt::format("part '{}' {}", name_, what), expected, hint);
    ok_ = false;
  }

  toml::table& table_of(const char* key) { return *table_.get(key)->as_table(); }
  int dim() const { return solid_.mesh.dim; }

  void material() {
    const toml::node& node = *table_.get("material");
    const auto name = node.value_or(std::string());
    if (!reader_.known(node, "materials", "material", name) || !reader_.materials.count(name)) {
      ok_ = false;
      return;
    }
    solid_.material = reader_.materials.at(name);
    if (!(solid_.material.rho > 0))
      refuse(node, "has no mass: its material has rho = 0", "a density > 0 (kg/m^3)");
  }

  /// A point in the coordinates of the mesh, [x, y] or [x, y, z].
  std::optional<Vec3> point(const toml::table& table, const char* key, int dim) {
    const auto given = numbers(*table.get(key));
    if (static_cast<int>(given.size()) == dim)
      return Vec3(given[0], given[1], dim == 3 ? given[2] : 0);
    refuse(*table.get(key), fmt::format("has {} numbers in '{}'", given.size(), key),
           dim == 2 ? "[x, y]: the mesh is planar" : "[x, y, z]: the mesh is in space");
    return {};
  }

  void mesh() {
    const toml::table& mesh = table_of("mesh");
    if (const toml::node* file = mesh.get("file")) return mesh_file(*file);
    for (const char* key : {"to", "cells"})
      if (!mesh.get(key))
        return refuse(mesh, fmt::format("has a grid without '{}'", key), "'from', 'to' and 'cells'",
                      "as in mesh = { from = [0, 0], to = [0.2, 0.03], cells = [100, 15] }");
    const int dim = static_cast<int>(numbers(*mesh.get("from")).size());
    const auto from = point(mesh, "from", dim), to = point(mesh, "to", dim),
               cells = point(mesh, "cells", dim);
    if (!from || !to || !cells) return;
    double count = 1;
    for (int i = 0; i < dim; ++i) {
      if (!((*to)[i] > (*from)[i]))
        return refuse(*mesh.get("to"), "has an empty grid", "'to' above 'from' in each direction");
      if ((*cells)[i] != std::floor((*cells)[i]))
        return refuse(*mesh.get("cells"), "has a number of cells that is not whole", "integers");
      count *= (*cells)[i];
    }
    if (count > kMostCells)
      return refuse(*mesh.get("cells"), fmt::format("has {:.3g} cells", count),
                    fmt::format("at most {:.0e}", kMostCells));
    const Eigen::Vector3i n = cells->cast<int>();
    solid_.mesh = dim == 2 ? quad_grid(from->head<2>(), to->head<2>(), n[0], n[1])
                           : hex_grid(*from, *to, n[0], n[1], n[2]);
  }

  void mesh_file(const toml::node& node) {
    const fs::path given(node.value_or(std::string()));
    const fs::path path =
        given.is_absolute() ? given : fs::path(reader_.scene.file).parent_path() / given;
    try {
      const std::string text = load_text(path, "a Gmsh mesh");
      solid_.mesh = read_gmsh(path.lexically_normal().string(), text);
      reader_.scene.input += text;
    } catch (const InputError& error) {
      ok_ = false;
      for (const InputProblem& problem : error.problems)
        if (problem.line > 0)
          reader_.problems.add(problem);
        else
          refuse(node, "has no mesh: " + problem.file + ": " + problem.what, problem.expected,
                 "paths are relative to the scene");
    }
  }

  void thickness() {
    const toml::node* node = table_.get("thickness");
    if (dim() == 2 && !node)
      refuse(table_, "has a planar mesh without 'thickness'", "a number > 0 (m)");
    if (dim() == 3 && node)
      refuse(*node, "has a 'thickness', but is meshed in space", "no 'thickness'");
    if (node) solid_.thickness = number(table_, "thickness");
  }

  // --- interfaces -------------------------------------------------------------------------------

  void interfaces() {
    toml::table& all = table_of("interfaces");
    for (const Entry& entry : entries_of(all)) {
      Interface interface;
      interface.name = entry.name;
      interface.tie = text(*entry.table, "tie") == "rigid" ? Tie::Rigid : Tie::Averaged;
      const toml::node* region = find_nodes(*entry.table, interface);
      if (!region) continue;
      if (entry.table->contains("point"))
        if (const auto at = point(*entry.table, "point", dim())) interface.point = *at;
      solid_.interfaces.push_back(interface);
      try {
        interface_map(solid_.mesh, solid_.interfaces);
      } catch (const std::invalid_argument& error) {
        solid_.interfaces.pop_back();
        refuse(*region, fmt::format("cannot be held: {}", error.what()),
               dim() == 2 ? "two nodes or more that no other interface has"
                          : "three nodes or more, not in a line, that no other interface has",
               fmt::format("the cells are about {:.3g} m wide", cell_width()));
      }
    }
    if (all.empty()) refuse(all, "has no interfaces", "at least one");
  }

  double cell_width() const { return std::pow(solid_.mesh.cell_size(0), 1.0 / dim()); }

  /// Fills in nodes and point; the value that says which, nothing if something is wrong.
  const toml::node* find_nodes(const toml::table& table, Interface& interface) {
    const SolidMesh& mesh = solid_.mesh;
    if (const toml::node* set = table.get("set")) {
      const auto found = mesh.sets.find(set->value_or(std::string()));
      if (found == mesh.sets.end()) {
        std::vector<std::string> known;
        for (const auto& [name, nodes] : mesh.sets) known.push_back(name);
        refuse(*set, fmt::format("has no set of nodes '{}'", set->value_or(std::string())),
               "a side of the grid or a physical group",
               suggestion(set->value_or(std::string()), known));
        return nullptr;
      }
      interface.nodes = found->second;
      for (const int node : interface.nodes)
        interface.point += mesh.nodes.col(node) / static_cast<double>(interface.nodes.size());
      return set;
    }
    const bool round = table.contains("circle");
    const toml::node& node = *table.get(round ? "circle" : "box");
    return (round ? in_circle(*node.as_table(), interface) : in_box(*node.as_table(), interface))
               ? &node
               : nullptr;
  }

  bool in_circle(const toml::table& circle, Interface& interface) {
    const auto centre = point(circle, "centre", dim());
    if (!centre) return false;
    const double radius = number(circle, "radius"), inner = number(circle, "inner");
    if (inner >= radius) {
      refuse(*circle.get("inner"), "has an empty ring", "'inner' below 'radius'");
      return false;
    }
    if (dim() == 2 && written(*circle.get("axis"))) {
      refuse(*circle.get("axis"), "has an 'axis' of a circle in a planar mesh", "no 'axis'");
      return false;
    }
    const Vec3 axis = dim() == 2 ? Vec3(Vec3::UnitZ()) : direction(reader_, circle, "axis");
    interface.nodes = nodes_where(solid_.mesh, [&](const Vec3& x) {
      const double r = axis.cross(x - *centre).norm();
      return r <= radius * (1 + kSlack) && r >= inner * (1 - kSlack);
    });
    interface.point = *centre;
    return true;
  }

  bool in_box(const toml::table& box, Interface& interface) {
    const auto from = point(box, "from", dim()), to = point(box, "to", dim());
    if (!from || !to) return false;
    const Vec3 low = from->cwiseMin(*to), high = from->cwiseMax(*to);
    const double slack = kSlack * (high - low).norm();
    interface.nodes = nodes_where(solid_.mesh, [&](const Vec3& x) {
      return (x - low).minCoeff() >= -slack && (high - x).minCoeff() >= -slack;
    });
    interface.point = 0.5 * (low + high);
    return true;
  }

  // --- outline ----------------------------------------------------------------------------------

  void outline() {
    if (!table_.contains("outline")) return;
    toml::table& all = table_of("outline");
    solid_.outline.dim = dim();
    for (const Entry& entry : entries_of(all)) {
      if (const auto feature = read_feature(entry))
        solid_.outline.features.push_back(*feature);
      else
        ok_ = false;
    }
    if (all.empty()) refuse(all, "has an outline without features", "at least one feature");
    if (!ok_) return;
    for (const auto& flaw : flaws(solid_.outline))
      refuse(key_of(all, flaw.feature),
             fmt::format("has an outline whose feature '{}' {}", flaw.feature, flaw.text),
             flaw.text.starts_with("makes no shape") ? "numbers that make a shape"
                                                     : "one tree of features and operations");
    if (!ok_) return;
    for (const FeatureSpec& f : solid_.outline.features)
      if (!is_operation(f.kind) &&
          volume_fractions(solid_.mesh, *make_feature(f, dim())).value.maxCoeff() == 0)
        refuse(key_of(all, f.name),
               fmt::format("has a feature '{}' that is wholly outside of the mesh", f.name),
               "a feature that fills some of a cell",
               "it may also be much smaller than a cell; positions are in the coordinates of the "
               "mesh");
  }

  /// In the order of FeatureKind.
  static FeatureKind kind_of_feature(const toml::table& table) {
    const auto& kinds = feature_words();
    const auto found = std::find(kinds.begin(), kinds.end(), text(table, "type"));
    return static_cast<FeatureKind>(found - kinds.begin());
  }

  std::optional<FeatureSpec> read_feature(const Entry& entry) {
    const toml::table& table = *entry.table;
    FeatureSpec f{entry.name, kind_of_feature(table), {}, {}};
    if (is_operation(f.kind)) {
      for (const toml::node* node : strings(table, "of"))
        f.operands.push_back(node->value_or(std::string()));
      if (table.contains("radius")) f.values.push_back(number(table, "radius"));
      if (f.kind != FeatureKind::Mirror) return f;
    }
    for (const char* key : {"z", "rx", "ry", "rz", "angle"})
      if (const toml::node* node = table.get(key);
          node && (dim() == 2) != (std::string_view(key) == "angle")) {
        refuse(*node,
               fmt::format("has '{}' in a feature of a {} mesh", key,
                           dim() == 2 ? "planar" : "spatial"),
               dim() == 2 ? "x, y and angle" : "x, y, z and rx, ry, rz");
        return {};
      }
    for (const auto& parameter : levelset::feature_parameters(f.kind, dim()))
      f.values.push_back(number(table, parameter.name));
    if (const toml::node* points = table.get("points"))
      for (const toml::node& row : *points->as_array())
        for (const double x : numbers(row)) f.values.push_back(x);
    if (const toml::node* weights = table.get("weights")) {
      const auto w = numbers(*weights);
      if (w.size() != table.get("points")->as_array()->size()) {
        refuse(*weights, fmt::format("has {} weights in '{}'", w.size(), f.name),
               fmt::format("{}, one a point", table.get("points")->as_array()->size()));
        return {};
      }
      f.values.insert(f.values.end(), w.begin(), w.end());
    }
    return f;
  }

  void connection() {
    try {
      const SolidModel model = solid_model(solid_);
      const int inner = model.size() - model.rigid_count() * model.ports();
      if (solid_.modes >= inner)
        refuse(
            *table_.get("modes"),
            fmt::format("keeps {} modes, its mesh has {} free displacements", solid_.modes, inner),
            fmt::format("at most {}", std::max(0, inner - 1)));
      if (const auto cut = cut_interface(model, solid_fractions(solid_).value))
        refuse(key_of(table_of("interfaces"), cut->interface), "is not connected: " + cut->text,
               "material between all interfaces", "see the features of its outline");
    } catch (const std::invalid_argument& error) {
      refuse(table_, std::string("cannot be built: ") + error.what(), "a mesh with interfaces");
    }
  }

  Reader& reader_;
  const std::string& name_;
  toml::table& table_;
  SolidSpec solid_;
  bool ok_ = true;
};

}  // namespace

std::optional<SolidSpec> read_solid(Reader& reader, const std::string& name, toml::table& table) {
  return SolidReader(reader, name, table).read();
}

void check_plane(Reader& reader) {
  const Mechanism& m = reader.scene.mechanism;
  if (reader.problems.count() > 0) return;
  for (const BodySpec& body : m.bodies) {
    const auto* solid = std::get_if<SolidSpec>(&body.kind);
    if (!solid || solid->mesh.dim == 3) continue;
    const PlaneSearch found = find_plane(m);
    const bool asked = reader.scene.simulation.space != SpaceChoice::Spatial;
    if (found.plane && asked) return;
    const toml::table& bodies = *reader.root["bodies"].as_table();
    const toml::node& mesh = *bodies[body.name]["solid"]["mesh"].node();
    reader.problems.add(mesh,
                        fmt::format("part '{}' has a planar mesh, but {}", body.name,
                                    found.plane ? "simulation.space is \"spatial\""
                                                : "the scene is not planar: " + found.reason),
                        "a planar scene, or a mesh in space");
    return;
  }
}

}  // namespace liesl
