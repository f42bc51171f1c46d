/// @file
/// Variables of the motion itself: values of the tables of drives, the duration.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "apps/scene/read_functions.hpp"
#include "apps/study/study_reader.hpp"
#include "mbs/model/joint_kind.hpp"
#include "mbs/solvers/stretched.hpp"

namespace liesl {
namespace {

constexpr std::string_view kRow = "drive.table.", kRows = "drive.table";

std::string only(const toml::table& table, const char* key) {
  const auto nodes = strings(table, key);
  return nodes.size() == 1 ? nodes.front()->value_or(std::string()) : std::string();
}

int joint_named(const Mechanism& mechanism, const std::string& name) {
  for (std::size_t j = 0; j < mechanism.joints.size(); ++j)
    if (mechanism.joints[j].name == name) return static_cast<int>(j);
  return -1;
}

/// The table of the only drive of a joint in the scene; null if it has none.
const toml::table* drive_of(const StudyReader& reader, const std::string& joint) {
  const auto drive = reader.scene.root["joints"][joint]["drive"];
  return drive.as_table() && drive["table"].is_array() ? drive.as_table() : nullptr;
}

/// Number in StudySpec::drives of the table of a drive of the mechanism; read if it is new.
int table_of(StudyReader& reader, int drive, const toml::table& from) {
  auto& drives = reader.spec.drives;
  for (std::size_t k = 0; k < drives.size(); ++k)
    if (drives[k].drive == drive) return static_cast<int>(k);
  DriveTable table{drive, {}, {}, interpolation_named(text(from, "interpolation"))};
  for (const toml::node& row : *from["table"].as_array()) {
    const auto values = numbers(row);
    table.t.push_back(values[0]);
    table.q.push_back(values[1]);
  }
  drives.push_back(std::move(table));
  return static_cast<int>(drives.size()) - 1;
}

/// Bounds and start about a value of the scene, said if they contradict each other.
bool read_bounds(StudyReader& reader, const toml::table& table, double value, ConstantSpec& c) {
  Problems& problems = reader.scene.problems;
  const auto bounds = numbers(*table.get("bounds"));
  c.lower = bounds[0];
  c.upper = bounds[1];
  c.start = value;
  const int before = problems.count();
  const toml::node& at = *table.get("bounds");
  if (c.lower >= c.upper)
    problems.add(at, fmt::format("the bounds of '{}' are [{:g}, {:g}]", c.name, c.lower, c.upper),
                 "[least, largest] with least < largest");
  if (c.quantity == ConstantQuantity::Duration && !(c.lower > 0))
    problems.add(at, fmt::format("the least value of '{}' is out of range: {:g}", c.name, c.lower),
                 "durations > 0 (s)");
  const toml::node* start = table.get("start");
  if (start) c.start = numbers(*start).front();
  if (problems.count() == before && !(*c.start >= c.lower && *c.start <= c.upper))
    problems.add(start ? *start : at,
                 fmt::format("the start {:g} of '{}' is outside the bounds", *c.start, c.name),
                 fmt::format("a value in [{:g}, {:g}]", c.lower, c.upper),
                 start ? "" : "give a 'start', or change the scene or the bounds");
  return problems.count() == before;
}

/// "drive.table.3" -> 3; -1 (and said) if it is no row of the table, or the value at the start.
int row_of(StudyReader& reader, const toml::node& node, const std::string& joint,
           const DriveTable& table) {
  const int first = table.t.front() >= 0 ? 1 : 0, rows = static_cast<int>(table.t.size());
  const std::string property = node.value_or(std::string());
  int row = -1;
  const char* const begin = property.data() + std::min(property.size(), kRow.size());
  const char* const end = property.data() + property.size();
  const auto read = std::from_chars(begin, end, row);
  if (begin != end && read.ec == std::errc() && read.ptr == end && row >= first && row < rows)
    return row;
  reader.scene.problems.add(
      node,
      fmt::format("'{}' is no row of the table of the drive on '{}' that can vary", property,
                  joint),
      fmt::format("{}{} to {}{}", kRow, first, kRow, rows - 1),
      first == 0 ? "rows count from 0" : "row 0 is where the motion starts");
  return -1;
}

void read_drive_value(StudyReader& reader, const Entry& entry, ConstantSpec c) {
  const Mechanism& mechanism = reader.scene.scene.mechanism;
  const std::string joint = only(*entry.table, "of");
  const toml::node& property = *strings(*entry.table, "property").front();
  const int number = joint_named(mechanism, joint);
  if (number < 0) {
    std::vector<std::string> names;
    for (const JointSpec& known : mechanism.joints) names.push_back(known.name);
    return reader.scene.problems.add(*strings(*entry.table, "of").front(),
                                     fmt::format("there is no joint '{}'", joint),
                                     "a joint with drive = { table = [[t, q], ...] }",
                                     suggestion(joint, names, "the scene has no joints"));
  }
  const auto drive = std::find_if(mechanism.drives.begin(), mechanism.drives.end(),
                                  [&](const DriveSpec& d) { return d.joint == number; });
  const toml::table* from = drive_of(reader, joint);
  if (drive == mechanism.drives.end() || !from)
    return reader.scene.problems.add(property,
                                     fmt::format("joint '{}' has no drive with a table", joint),
                                     "a joint with drive = { table = [[t, q], ...] }");
  c.drive = table_of(reader, static_cast<int>(drive - mechanism.drives.begin()), *from);
  const DriveTable& drive_table = reader.spec.drives[static_cast<std::size_t>(c.drive)];
  c.row = row_of(reader, property, joint, drive_table);
  if (c.row < 0) return;
  const JointKind& kind = kind_of(mechanism.joints[static_cast<std::size_t>(number)].type);
  c.turns = std::string(kind.unit(drive->coordinate)) == "rad";
  if (!read_bounds(reader, *entry.table, drive_table.q[static_cast<std::size_t>(c.row)], c)) return;
  for (const ConstantSpec& other : reader.spec.constants)
    if (other.quantity == c.quantity && other.drive == c.drive && other.row == c.row)
      return reader.scene.problems.add(
          property, fmt::format("this is already varied by '{}'", other.name), "each number once");
  reader.spec.constants.push_back(c);
}

void read_duration(StudyReader& reader, const Entry& entry, ConstantSpec c) {
  const auto expect = [&](const char* key, const char* known, const char* what) {
    if (const std::string given = only(*entry.table, key); given != known)
      reader.scene.problems.add(*strings(*entry.table, key).front(),
                                fmt::format(fmt::runtime(what), given),
                                fmt::format("\"{}\"", known), suggestion(given, {known}));
  };
  expect("of", "simulation", "'{}' has no duration");
  expect("property", "duration", "a simulation has no '{}' that can vary");
  c.quantity = ConstantQuantity::Duration;
  reader.spec.duration = reader.scene.scene.simulation.duration;
  read_bounds(reader, *entry.table, reader.spec.duration, c);
  for (const ConstantSpec& other : reader.spec.constants)
    if (other.quantity == c.quantity)
      return reader.scene.problems.add(*entry.table->get("property"),
                                       fmt::format("this is already varied by '{}'", other.name),
                                       "each number once");
  reader.spec.constants.push_back(c);
}

}  // namespace

bool names_motion(const StudyReader& reader, const toml::table& table) {
  const std::string of = only(table, "of"), property = only(table, "property");
  if (of == "simulation" || property == "duration" || property.starts_with(kRows)) return true;
  const Mechanism& mechanism = reader.scene.scene.mechanism;
  if (joint_named(mechanism, of) < 0) return false;
  const bool elastic = std::any_of(mechanism.forces.begin(), mechanism.forces.end(),
                                   [&of](const ForceSpec& force) { return force.name == of; });
  return !elastic;
}

void read_motion_variable(StudyReader& reader, const Entry& entry) {
  ConstantSpec c;
  c.name = entry.name;
  c.quantity = ConstantQuantity::DriveValue;
  if (const toml::node* values = entry.table->get("values"))
    reader.scene.problems.add(
        *values, fmt::format("'{}' is a variable of the motion, of which no catalogue is", c.name),
        "sizes of sections, parameters of outlines, constants of forces and bodies");
  const bool of_simulation = only(*entry.table, "of") == "simulation";
  if (of_simulation || only(*entry.table, "property") == "duration")
    return read_duration(reader, entry, c);
  read_drive_value(reader, entry, c);
}

void check_motion_variables(StudyReader& reader) {
  const auto& constants = reader.spec.constants;
  const auto duration = std::find_if(constants.begin(), constants.end(), [](const ConstantSpec& c) {
    return c.quantity == ConstantQuantity::Duration;
  });
  Problems& problems = reader.scene.problems;
  if (!reader.spec.drives.empty() || duration != constants.end())
    if (const toml::node* scenarios = reader.root.get("scenarios"))
      problems.add(*scenarios, "scenarios, and variables of the motion itself", "one or the other",
                   "each scenario has a motion of its own");
  if (!reader.spec.drives.empty() || duration != constants.end())
    if (const toml::node* frequencies = reader.root.get("frequencies"))
      problems.add(*frequencies, "frequencies in a pose, and variables of the motion itself",
                   "one or the other", "the pose would follow the variables");
  if (duration == constants.end()) return;
  const toml::node& at = *reader.root["design"][duration->name].node();
  const Mechanism& mechanism = reader.scene.scene.mechanism;
  for (std::size_t d = 0; d < mechanism.drives.size(); ++d) {
    const std::string& joint =
        mechanism.joints[static_cast<std::size_t>(mechanism.drives[d].joint)].name;
    if (const toml::table* from = drive_of(reader, joint))
      table_of(reader, static_cast<int>(d), *from);
    else
      problems.add(at, fmt::format("the drive on '{}' has no table to stretch", joint),
                   "drives with tables", "drive = { table = [[t, q], ...] }");
  }
  for (const std::string& what : follows_time(mechanism))
    problems.add(at, what + " follows time, and not the duration", "what does not follow time");
}

}  // namespace liesl
