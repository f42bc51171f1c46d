/// @file
/// What a study may change: dimensions of sections and their bounds.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/study/study_reader.hpp"
#include "mbs/model/beam_ends.hpp"
#include "mbs/sections/section_errors.hpp"
#include "mbs/sections/shape_dimensions.hpp"

namespace liesl {

namespace {

constexpr double kRelative = 1e-9;  // slack of bounds against round-off

const BeamSpec& beam_of(const StudyReader& reader, int body) {
  const auto& bodies = reader.scene.scene.mechanism.bodies;
  return std::get<BeamSpec>(bodies[static_cast<std::size_t>(body)].kind);
}

const std::vector<Section>& sections_of(const StudyReader& reader, int body) {
  return beam_of(reader, body).sections;
}

const std::string& name_of(const StudyReader& reader, int body) {
  return reader.scene.scene.mechanism.bodies[static_cast<std::size_t>(body)].name;
}

/// Reads one entry of [design].
class DesignReader {
 public:
  DesignReader(StudyReader& reader, const Entry& entry)
      : reader_(reader), problems_(reader.scene.problems), table_(*entry.table) {
    design_.name = entry.name;
    entry_ = &entry;
  }

  std::optional<DesignSpec> read() {
    design_.groups = integer(table_, "groups");
    const auto bounds = numbers(*table_.get("bounds"));
    design_.lower = bounds[0];
    design_.upper = bounds[1];
    if (!(design_.lower > 0)) {
      problems_.add(
          *table_.get("bounds")->as_array()->get(0),
          fmt::format("the least value of '{}' is out of range: {:g}", design_.name, bounds[0]),
          "numbers > 0 (m)");
      ok_ = false;
    }
    if (const toml::node* factors = table_.get("factors"))
      problems_.add(*factors, "'factors' belongs to parameters of an outline", "no 'factors'");
    if (design_.lower >= design_.upper)
      refuse("bounds",
             fmt::format("the bounds of '{}' are [{:g}, {:g}]", design_.name, bounds[0], bounds[1]),
             "[least, largest] with least < largest (m)");
    bodies();
    if (!ok_) return {};
    properties();
    groups();
    start();
    design_.values = read_values(reader_, *entry_, design_.lower, design_.upper);
    return ok_ ? std::optional(design_) : std::nullopt;
  }

 private:
  void refuse(std::string_view key, const std::string& what, const std::string& expected,
              const std::string& hint = "") {
    problems_.add(*table_.get(key), what, expected, hint);
    ok_ = false;
  }

  void bodies() {
    for (const toml::node* node : strings(table_, "of")) {
      if (reader_.scene.trusses.bars.contains(node->value_or(std::string()))) {
        for (const int bar : reader_.scene.bodies_of(*node)) add(bar, *node);
        continue;
      }
      const auto beam = reader_.scene.beam(*node);
      ok_ = ok_ && beam;
      if (beam) add(*beam, *node);
    }
  }

  void add(int beam, const toml::node& node) {
    const auto& list = design_.bodies;
    if (std::find(list.begin(), list.end(), beam) != list.end()) {
      problems_.add(node, fmt::format("beam '{}' is named twice", name_of(reader_, beam)),
                    "each beam once");
      ok_ = false;
    }
    design_.bodies.push_back(beam);
  }

  void properties() {
    for (const toml::node* node : strings(table_, "property")) {
      design_.properties.push_back(node->value_or(std::string()));
      for (const int body : design_.bodies)
        if (!has_dimension(body, design_.properties.back(), *node)) break;
      clash(design_.properties.back(), *node);
    }
  }

  bool has_dimension(int body, const std::string& property, const toml::node& node) {
    for (const Section& section : sections_of(reader_, body)) {
      const auto known = dimensions(section.shape);
      if (std::find(known.begin(), known.end(), property) != known.end()) continue;
      const std::vector<std::string> names(known.begin(), known.end());
      problems_.add(node,
                    fmt::format("section '{}' of beam '{}' has no dimension '{}'", section.name,
                                name_of(reader_, body), property),
                    "a dimension of the section",
                    suggestion(property, names, "'full' sections have none"));
      return ok_ = false;
    }
    return true;
  }

  /// No dimension of a beam may be two variables.
  void clash(const std::string& property, const toml::node& node) {
    for (const DesignSpec& other : reader_.spec.design)
      for (const int body : design_.bodies)
        if (std::count(other.bodies.begin(), other.bodies.end(), body) &&
            std::count(other.properties.begin(), other.properties.end(), property)) {
          problems_.add(node,
                        fmt::format("'{}' of beam '{}' is already varied by '{}'", property,
                                    name_of(reader_, body), other.name),
                        "each dimension once");
          ok_ = false;
          return;
        }
  }

  void groups() {
    for (const int body : design_.bodies) {
      const auto n = static_cast<int>(sections_of(reader_, body).size());
      if (design_.groups > n)
        return refuse("groups",
                      fmt::format("{} groups for the {} elements of beam '{}'", design_.groups, n,
                                  name_of(reader_, body)),
                      "at most one group an element");
    }
  }

  void start() {
    if (!ok_) return;
    const toml::node* node = table_.get("start");
    if (!node) return start_of_scene();
    design_.start = numbers(*node);
    const auto count = static_cast<int>(design_.start.size());
    if (count != 1 && count != design_.groups)
      return refuse("start",
                    fmt::format("'start' has {} values for {} groups", count, design_.groups),
                    "one value, or one a group");
    for (const double x : design_.start)
      if (!inside(x))
        return refuse("start", fmt::format("the start {:g} is outside the bounds", x), range());
  }

  void start_of_scene() {
    for (const int body : design_.bodies)
      for (const Section& section : sections_of(reader_, body))
        for (const std::string& property : design_.properties)
          if (const double x = dimension(section.shape, property); !inside(x))
            return refuse(
                "bounds",
                fmt::format("the start {:g} ('{}' of beam '{}' in the scene) is outside the bounds",
                            x, property, name_of(reader_, body)),
                range(), "give a 'start', or change the scene or the bounds");
  }

  bool inside(double x) const {
    return x >= design_.lower * (1 - kRelative) && x <= design_.upper * (1 + kRelative);
  }
  std::string range() const {
    return fmt::format("a value in [{:g}, {:g}]", design_.lower, design_.upper);
  }

  StudyReader& reader_;
  Problems& problems_;
  const toml::table& table_;
  const Entry* entry_ = nullptr;
  DesignSpec design_;
  bool ok_ = true;
};

/// What is wrong with a section somewhere in the bounds of the designs of its beam, tried at all
/// corners; empty if nothing. Says where in `values`.
std::string defect_in_bounds(const Shape& shape, const std::vector<const DesignSpec*>& designs,
                             std::string& values) {
  const unsigned corners = 1u << std::min<std::size_t>(designs.size(), 10);
  for (unsigned corner = 0; corner < corners; ++corner) {
    Shape trial = shape;
    values.clear();
    for (std::size_t i = 0; i < designs.size(); ++i) {
      const double x = (corner >> i) & 1u ? designs[i]->upper : designs[i]->lower;
      for (const std::string& property : designs[i]->properties) {
        trial = with_dimension(trial, property, x);
        values += fmt::format("{}{} = {:g}", values.empty() ? "" : ", ", property, x);
      }
    }
    if (std::string what = what_is_wrong(trial); !what.empty()) return what;
  }
  return "";
}

/// Steps of one dimension along the linear change of another: no scene can say that.
void check_steps(StudyReader& reader, int body, const std::vector<const DesignSpec*>& designs) {
  const BeamSpec& beam = beam_of(reader, body);
  const auto sizes = [&](std::string_view name) {
    return std::any_of(designs.begin(), designs.end(), [name](const DesignSpec* d) {
      return std::count(d->properties.begin(), d->properties.end(), name) > 0;
    });
  };
  for (const auto name : dimensions(beam.sections.front().shape))
    for (const DesignSpec* design : designs) {
      if (design->groups == 1 || sizes(name) || !tapers(beam, name)) continue;
      return reader.scene.problems.add(
          *(*reader.root["design"][design->name].as_table()).get("groups"),
          fmt::format("'{}' has {} groups on beam '{}', whose '{}' tapers", design->name,
                      design->groups, name_of(reader, body), name),
          "groups = 1", "or size '" + std::string(name) + "' too, which makes steps of its taper");
    }
}

/// Sections have to be valid everywhere within the bounds (walls must not meet).
void check_sections(StudyReader& reader) {
  const auto count = static_cast<int>(reader.scene.scene.mechanism.bodies.size());
  for (int body = 0; body < count; ++body) {
    std::vector<const DesignSpec*> designs;
    for (const DesignSpec& design : reader.spec.design)
      if (std::count(design.bodies.begin(), design.bodies.end(), body)) designs.push_back(&design);
    if (designs.empty()) continue;
    check_steps(reader, body, designs);
    std::vector<Section> sections = sections_of(reader, body);
    for (const auto& ends : beam_of(reader, body).ends)
      sections.insert(sections.end(), ends.begin(), ends.end());
    for (const Section& section : sections) {
      std::string values;
      const std::string what = defect_in_bounds(section.shape, designs, values);
      if (what.empty()) continue;
      const toml::table& table = *reader.root["design"][designs.back()->name].as_table();
      reader.scene.problems.add(
          *table.get("bounds"),
          fmt::format("within the bounds (at {}) section '{}' is no section: {}", values,
                      section.name, what),
          "bounds in which the walls do not meet");
      break;
    }
  }
}

}  // namespace

std::vector<double> read_values(StudyReader& reader, const Entry& entry, double lower,
                                double upper) {
  const toml::node* node = entry.table->get("values");
  if (!node) return {};
  std::vector<double> values = numbers(*node);
  Problems& problems = reader.scene.problems;
  const auto refuse = [&](const std::string& what, const char* expected) {
    problems.add(*node, fmt::format("the catalogue of '{}' {}", entry.name, what), expected);
    return std::vector<double>();
  };
  if (values.empty()) return refuse("is empty", "one value or more");
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0 && !(values[i] > values[i - 1]))
      return refuse(fmt::format("has {:g} after {:g}", values[i], values[i - 1]),
                    "increasing values, each once");
    if (values[i] < lower * (1 - std::copysign(kRelative, lower)) ||
        values[i] > upper * (1 + std::copysign(kRelative, upper)))
      return refuse(
          fmt::format("has {:g}, outside the bounds [{:g}, {:g}]", values[i], lower, upper),
          "values within the bounds");
    values[i] = std::clamp(values[i], lower, upper);
  }
  return values;
}

void read_design(StudyReader& reader) {
  for (const Entry& entry : entries(reader.root, reader.broken, "design"))
    if (entry.table->contains("parameters"))
      read_shape_variable(reader, entry);
    else if (names_constant(reader, *entry.table))
      read_constant(reader, entry);
    else if (auto design = DesignReader(reader, entry).read())
      reader.spec.design.push_back(std::move(*design));
  check_sections(reader);
  const toml::node* table = reader.root.get("design");
  if (table && table->is_table() && table->as_table()->empty())
    reader.scene.problems.add(*table, "the study has no design variables", "an entry in [design]");
}

}  // namespace liesl
