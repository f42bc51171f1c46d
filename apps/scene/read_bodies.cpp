/// @file
/// Beams and rigid bodies.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "apps/scene/numbering.hpp"
#include "apps/scene/reader.hpp"
#include "mbs/linalg/dense.hpp"
#include "mbs/model/curves.hpp"
#include "mbs/sections/shape_dimensions.hpp"

namespace liesl {

namespace {

constexpr double kTiny = 1e-12;  // m; shorter is no length

/// Dimensions linear between sections at even distances, at the share s of the length.
Section section_between(const std::vector<Section>& at, double s) {
  const double place = s * static_cast<double>(at.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), at.size() - 2);
  const double share = place - static_cast<double>(i);
  Section section = at[i];
  for (const auto name : dimensions(section.shape))
    section.shape = with_dimension(
        section.shape, name,
        (1 - share) * dimension(at[i].shape, name) + share * dimension(at[i + 1].shape, name));
  return section;
}

/// The sections of n elements between those at even distances, at their middles and ends.
void taper(const std::vector<Section>& at, int n, BeamSpec& beam) {
  for (int e = 0; e < n; ++e) {
    beam.sections.push_back(section_between(at, (e + 0.5) / n));
    beam.ends.push_back(
        {section_between(at, static_cast<double>(e) / n), section_between(at, (e + 1.0) / n)});
  }
}

/// Keys of chains of segments where the beam is none.
void check_segment_keys(Reader& reader, const std::string& name, const toml::table& table,
                        const BeamSpec& beam) {
  const bool chain = model_of(beam, reader.scene.mechanism.formalism) == BeamModel::Segments;
  for (const char* key : {"potential", "mass"})
    if (const toml::node* node = table.get(key); node && written(*node) && !chain)
      reader.problems.add(*node, fmt::format("beam '{}' has no '{}'", name, key),
                          "as = \"segments\", or simulation.formalism = \"segments\"",
                          "leave it out");
}

BeamModel beam_model_of(const std::string& as) {
  if (as == "rigid") return BeamModel::Rigid;
  if (as == "modal") return BeamModel::Modal;
  return as == "segments" ? BeamModel::Segments : BeamModel::AsFormalism;
}

/// Reads one beam; `ok` turns false if it cannot be built.
class BeamReader {
 public:
  BeamReader(Reader& reader, const std::string& name, const toml::table& table)
      : reader_(reader), name_(name), table_(table), n_(integer(table, "elements")) {}

  std::optional<BeamSpec> read() {
    BeamSpec beam;
    beam.damping = number(table_, "damping");
    const std::string as = text(table_, "as");
    beam.as = beam_model_of(as);
    if (text(table_, "potential") == "neo_hookean")
      beam.segment.potential = AxialPotential::NeoHookean;
    beam.segment.lumped = text(table_, "mass") == "lumped";
    check_segment_keys(reader_, name_, table_, beam);
    if (table_.contains("modes")) beam.modes = integer(table_, "modes");
    if (beam.as != BeamModel::AsFormalism && beam.as != BeamModel::Segments &&
        reader_.scene.simulation.type != SimulationType::Dynamic)
      reader_.problems.add(*table_.get("as"),
                           fmt::format("beam '{}' as \"{}\" is for motions only", name_, as),
                           "simulation.type = \"dynamic\", or as = \"formalism\"");
    sections(beam);
    material(beam);
    check_axis();
    if (ok_) beam.nodes = nodes();
    if (ok_) points(beam);
    return ok_ ? std::optional(beam) : std::nullopt;
  }

 private:
  void refuse(const toml::node& at, const std::string& what, const std::string& expected,
              const std::string& hint = "") {
    reader_.problems.add(at, fmt::format("beam '{}' {}", name_, what), expected, hint);
    ok_ = false;
  }

  void sections(BeamSpec& beam) {
    const auto names = strings(table_, "section");
    const int runs = static_cast<int>(names.size());
    const bool tapers = boolean(table_, "taper");
    if (runs > n_ + tapers)
      return refuse(*table_.get("section"),
                    fmt::format("has {} sections for {} elements", runs, n_),
                    tapers ? "at most one section a node" : "at most one section an element");
    for (const toml::node* node : names) {
      const auto name = node->value_or(std::string());
      if (!reader_.known(*node, "sections", "section", name) || !reader_.sections.count(name))
        ok_ = false;
    }
    if (!ok_) return;
    if (tapers) return tapered(beam, names);
    for (int e = 0; e < n_; ++e) {
      const auto run = static_cast<std::size_t>(static_cast<long>(e) * runs / n_);
      beam.sections.push_back(reader_.sections.at(names[run]->value_or(std::string())));
    }
  }

  /// Dimensions linear between the sections of the list, at the middle and the ends of each
  /// element.
  void tapered(BeamSpec& beam, const std::vector<const toml::node*>& names) {
    std::vector<Section> at;
    for (const toml::node* node : names)
      at.push_back(reader_.sections.at(node->value_or(std::string())));
    if (at.size() < 2)
      return refuse(*table_.get("taper"), "has 'taper' but one section", "at least two sections",
                    "section = [\"root\", \"tip\"]");
    for (std::size_t i = 0; i < at.size(); ++i) {
      const Section& s = at[i];
      if (dimensions(s.shape).empty())
        return refuse(*names[i], fmt::format("tapers to '{}', which has no dimensions", s.name),
                      "a section with a shape");
      if (s.shape.index() != at[0].shape.index())
        return refuse(*names[i], fmt::format("tapers from '{}' to '{}'", at[0].name, s.name),
                      "sections of one type");
      if (s.shear_factor != at[0].shear_factor || s.torsion_constant != at[0].torsion_constant)
        return refuse(*names[i],
                      fmt::format("tapers between shear factors or torsion constants of '{}' and "
                                  "'{}'",
                                  at[0].name, s.name),
                      "the same in all of them, or none");
    }
    taper(at, n_, beam);
  }

  void points(BeamSpec& beam) {
    const toml::table* given = table_["points"].as_table();
    if (!given) return;
    Mechanism alone;  // to look up ports in
    alone.bodies.push_back({name_, beam, Vec3::Zero(), Vec3::Zero()});
    for (auto&& [key, value] : *given) {
      const std::string point(key.str());
      const toml::table& place = *value.as_table();
      const bool taken = alone.port(name_ + "." + point).has_value();
      if (taken)
        reader_.problems.add(
            key, fmt::format("beam '{}' has a point '{}', which is one of its nodes", name_, point),
            "another name");
      ok_ = ok_ && !taken;
      const auto on =
          alone.port(name_ + "." + Numbering(reader_.root, name_).port(text(place, "on")));
      if (!on)
        refuse(*place.get("on"), fmt::format("has no node '{}'", text(place, "on")),
               fmt::format("start, end, node0 to node{}{}", n_, n_ % 2 == 0 ? ", mid" : ""));
      if (taken || !on) continue;
      beam.points[point] = {on->node, vec3(place, "at")};
    }
  }

  bool all_full(const BeamSpec& beam) const {
    return ok_ && std::all_of(beam.sections.begin(), beam.sections.end(), [](const Section& s) {
             return std::holds_alternative<FullSection>(s.shape);
           });
  }

  bool is_static() const { return reader_.scene.simulation.type == SimulationType::Static; }

  void material(BeamSpec& beam) {
    const bool full = all_full(beam);
    if (full && !is_static()) {
      const toml::table& all = *reader_.root["sections"].as_table();
      for (const toml::node* node : strings(table_, "section")) {
        const toml::table& section = *all.get(node->value_or(std::string()))->as_table();
        if (!section.contains("inertia") ||
            matrix(*section.get("inertia"), 6).topLeftCorner(3, 3).trace() <= 0)
          refuse(section.contains("inertia") ? *section.get("inertia") : section, "has no mass",
                 "an 'inertia' with mass per length (kg/m)", "give it, or simulate \"static\"");
      }
    }
    const toml::node* node = table_.get("material");
    if (!node) {
      if (!full && ok_)
        refuse(table_, "has no material", "the name of a material", "material = ...");
      return;
    }
    const auto name = node->value_or(std::string());
    if (!reader_.known(*node, "materials", "material", name) || !reader_.materials.count(name)) {
      ok_ = false;
      return;
    }
    beam.material = reader_.materials.at(name);
    if (full || is_static() || beam.material.rho > 0) return;
    const toml::table& material = *reader_.root["materials"][name].as_table();
    const toml::node& rho = *material.get("rho");
    ok_ = false;
    const toml::node& at = written(rho) ? rho : static_cast<const toml::node&>(material);
    if (reader_.problems.has(at)) return;  // of another beam
    refuse(at, "has no mass: its material has rho = 0", "a density > 0 (kg/m^3)", "steel: 7850");
  }

  void check_axis() {
    if (table_.contains("from")) return check_straight();
    if (table_.contains("arc")) return check_arc();
    check_points();
  }

  void check_straight() {
    const toml::node* to = table_.get("to");
    if (!to)
      return refuse(table_, "has 'from' but no 'to'", "both ends of the axis", "to = [x, y, z]");
    const Vec3 axis = vec3(*to) - vec3(table_, "from");
    if (axis.norm() < kTiny)
      return refuse(*to, "has zero length: 'from' and 'to' are the same point", "two points");
    check_up(axis);
    check_turn(*to, number(table_, "pre_twist"));
  }

  void check_up(const Vec3& axis) {
    const toml::node* up = table_.get("up");
    if (!up) return;
    const Vec3 given = vec3(*up);
    if (given.norm() < kTiny)
      refuse(*up, "has a zero vector for 'up'", "a direction", "as in [0, 0, 1]");
    else if (axis.cross(given).norm() < 1e-6 * axis.norm() * given.norm())
      refuse(*up, "has 'up' along its axis", "a direction across the axis");
  }

  void check_arc() {
    const toml::table& arc = *table_.get("arc")->as_table();
    const Vec3 axis = direction(reader_, arc, "axis");
    const Vec3 radius = vec3(arc, "from") - vec3(arc, "centre");
    const double angle = number(arc, "angle");
    if (vec3(arc, "axis").norm() == 0) ok_ = false;
    if (radius.norm() < kTiny)
      return refuse(*arc.get("centre"), "has zero length: the arc's centre is its start",
                    "a radius > 0");
    if (std::abs(angle) < kTiny)
      return refuse(*arc.get("angle"), "has zero length: the arc's angle is 0", "an angle (rad)");
    if (std::abs(angle) > 2 * std::numbers::pi + 1e-9)
      return refuse(*arc.get("angle"), "overlaps itself", "an angle of at most 2 pi (rad)",
                    "angles are in rad");
    if (std::abs(radius.dot(axis)) > 1e-6 * radius.norm())
      return refuse(*arc.get("centre"), "has an arc out of its plane",
                    "from - centre normal to the axis");
    check_turn(*arc.get("angle"), std::hypot(angle, number(table_, "pre_twist")));
  }

  void check_points() {
    const toml::array& points = *table_.get("through")->as_array();
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      if ((vec3(points[i + 1]) - vec3(points[i])).norm() < kTiny)
        refuse(points[i + 1], "has zero length between two points of 'through'", "distinct points");
    if (points.size() == 2 && ok_) check_up(vec3(points[1]) - vec3(points[0]));
    check_turn(*table_.get("through"), number(table_, "pre_twist"));
  }

  /// The logarithm of the relative motion of an element is unique below pi.
  void check_turn(const toml::node& at, double angle) {
    const double each = std::abs(angle) / n_;
    if (each < 0.99 * std::numbers::pi) return;
    const int enough = static_cast<int>(std::ceil(std::abs(angle) / (0.5 * std::numbers::pi)));
    refuse(at, fmt::format("turns by {:.3g} rad in an element", each), "less than pi an element",
           fmt::format("elements = {}", enough));
  }

  std::vector<SE3> nodes() {
    try {
      return frames();
    } catch (const std::invalid_argument& error) {
      refuse(table_, std::string("cannot be laid out: ") + error.what(), "a smooth axis");
      return {};
    }
  }

  std::vector<SE3> frames() const {
    const Orientation turn{vec3(table_, "up"), number(table_, "pre_twist")};
    if (table_.contains("from"))
      return straight(vec3(table_, "from"), vec3(table_, "to"), n_, turn);
    if (const toml::node* node = table_.get("arc")) {
      const toml::table& given = *node->as_table();
      const Vec3 from = vec3(given, "from"), centre = vec3(given, "centre");
      const double angle = number(given, "angle");
      const Vec3 axis = vec3(given, "axis") * (angle < 0 ? -1 : 1);
      const double whole = 2 * std::numbers::pi;  // a full circle may be rounded up
      return arc(
          {from, axis.cross(from - centre).normalized(), centre, std::min(std::abs(angle), whole)},
          n_, turn);
    }
    std::vector<Vec3> points;
    for (const toml::node& point : *table_.get("through")->as_array())
      points.push_back(vec3(point));
    return spline(points, n_, turn);
  }

  Reader& reader_;
  const std::string& name_;
  const toml::table& table_;
  int n_;
  bool ok_ = true;
};

/// Says why a symmetric matrix is no inertia of a body, empty if it is one.
std::string defect_of(const Mat3& J) {
  if ((J - J.transpose()).norm() > 1e-9 * J.norm()) return "is not symmetric";
  const Vec3 principal = linalg::symmetric_eigenvalues(J);
  if (principal[0] < -1e-12 * J.norm())
    return fmt::format("is not positive semi-definite: principal values {:.4g}, {:.4g}, {:.4g}",
                       principal[0], principal[1], principal[2]);
  if (principal[2] > (principal[0] + principal[1]) * (1 + 1e-9))
    return fmt::format("is of no body: {:.4g} is more than {:.4g} + {:.4g}", principal[2],
                       principal[0], principal[1]);
  return "";
}

std::optional<RigidSpec> read_rigid(Reader& reader, const std::string& name, toml::table& table) {
  RigidSpec rigid;
  rigid.frame = SE3(SO3::exp(orientation(reader, table)).R, vec3(table, "at"));
  rigid.mass = number(table, "mass");
  rigid.inertia = matrix(*table.get("inertia"), 3);
  rigid.centre = vec3(table, "centre");
  if (toml::table* points = table["points"].as_table())
    for (auto&& [key, value] : *points) {
      rigid.points[std::string(key.str())] = vec3(value);
      if (key.str() == "origin")
        reader.problems.add(key, fmt::format("body '{}' has a point 'origin'", name),
                            "another name", "'origin' is the body's own frame");
    }
  const std::string what = defect_of(rigid.inertia);
  if (what.empty()) return rigid;
  reader.problems.add(
      *table.get("inertia"), fmt::format("the inertia of body '{}' {}", name, what),
      "principal values >= 0, each at most the sum of the others (kg m^2)",
      fmt::format("a ball of radius r has 0.4 m r^2; for r = 0.01 m: {:.3g}", rigid.mass * 4e-5));
  return {};
}

}  // namespace

void read_bodies(Reader& reader) {
  for (const Entry& entry : entries(reader, "bodies")) {
    if (entry.name == "ground") {
      reader.problems.add(*entry.key, "'ground' is the inertial frame",
                          "another name for the body");
      continue;
    }
    if (entry.table->contains("truss")) continue;  // one that could not be expanded
    BodySpec body;
    body.name = entry.name;
    body.velocity = vec3(*entry.table, "velocity");
    body.angular_velocity = vec3(*entry.table, "angular_velocity");
    if (toml::table* beam = (*entry.table)["beam"].as_table()) {
      auto spec = BeamReader(reader, entry.name, *beam).read();
      if (!spec) continue;
      body.kind = std::move(*spec);
    } else if (toml::table* solid = (*entry.table)["solid"].as_table()) {
      auto spec = read_solid(reader, entry.name, *solid);
      if (!spec) continue;
      body.kind = std::move(*spec);
    } else {
      auto spec = read_rigid(reader, entry.name, *(*entry.table)["rigid"].as_table());
      if (!spec) continue;
      body.kind = std::move(*spec);
    }
    reader.scene.mechanism.bodies.push_back(std::move(body));
  }
  const toml::node* table = reader.root.get("bodies");
  if (table && table->is_table() && table->as_table()->empty())
    reader.problems.add(*table, "the scene has no bodies", "at least one body in [bodies]");
}

void check_names(Reader& reader) {
  std::map<std::string, std::string> owner;
  for (const char* group : {"bodies", "joints", "gears", "forces", "loads"})
    for (const Entry& entry : entries(reader, group)) {
      const auto [known, fresh] = owner.emplace(entry.name, group);
      if (!fresh)
        reader.problems.add(
            *entry.key,
            fmt::format("duplicate name '{}' in [{}] and [{}]", entry.name, known->second, group),
            "different names for bodies, joints, forces and loads");
    }
}

}  // namespace liesl
