#include "optim/study/study_errors.hpp"

#include <fmt/format.h>

#include <set>
#include <stdexcept>

#include "mbs/sections/shape_dimensions.hpp"

namespace liesl {
namespace {

using Errors = std::vector<std::string>;

class StudyCheck {
 public:
  StudyCheck(const StudySpec& study, const Mechanism& mechanism)
      : study_(study),
        bodies_(mechanism.bodies),
        forces_(static_cast<int>(mechanism.forces.size())) {}

  Errors run() {
    for (const DesignSpec& d : study_.design) check(d);
    for (const ConstantSpec& c : study_.constants) check(c);
    check_objective();
    for (const ConstraintSpec& c : study_.constraints) {
      const std::string place = "constraint '" + c.response.name + "'";
      if (deformed_body(c.response) >= 0) body(place, deformed_body(c.response));
      expect(c.limit > 0, place, "a limit > 0", c.limit);
    }
    for (const auto& [index, shape] : study_.shapes) {
      const SolidSpec* solid = meshed("design of an outline", index);
      if (solid && solid->outline.features.empty())
        errors_.push_back("design of an outline: '" + bodies_[std::size_t(index)].name +
                          "' has no outline; expected features");
    }
    for (const PartLimitSpec& l : study_.part_limits) {
      const std::string place = "part limit '" + l.name + "'";
      meshed(place, l.body);
      expect(l.limit > 0, place, "a limit > 0", l.limit);
      expect(l.count >= 1, place, "a count >= 1", l.count);
      if (l.quantity == SolidResponse::Output)
        errors_.push_back(place + ": expected compliance, stress, mass or frequency, got output");
    }
    for (const FrequencyLimitSpec& l : study_.frequencies) {
      expect(l.least > 0, "frequency '" + l.name + "'", "a least value > 0", l.least);
      expect(l.count >= 1, "frequency '" + l.name + "'", "a count >= 1", l.count);
    }
    for (const MassLimitSpec& l : study_.mass_limits) {
      expect(l.limit > 0, "mass limit '" + l.name + "'", "a limit > 0", l.limit);
      for (const int index : l.bodies) body("mass limit '" + l.name + "'", index);
    }
    for (const FixedLoad& load : study_.loads) meshed("load '" + load.load_case + "'", load.body);
    for (const auto& [index, support] : study_.supports) body("support", index);
    expect(study_.stress.p >= 1, "stress.p", ">= 1", study_.stress.p);
    for (const std::string& error : study_.cycle.errors()) errors_.push_back("cycle." + error);
    return std::move(errors_);
  }

 private:
  void expect(bool holds, const std::string& place, const char* expected, double got) {
    if (!holds) errors_.push_back(fmt::format("{}: expected {}, got {:g}", place, expected, got));
  }

  const BodySpec* body(const std::string& place, int index) {
    if (index >= 0 && index < static_cast<int>(bodies_.size())) return &bodies_[std::size_t(index)];
    errors_.push_back(
        fmt::format("{}: expected a body in 0 .. {}, got {}", place, bodies_.size() - 1, index));
    return nullptr;
  }

  template <class Spec>
  const Spec* of_kind(const std::string& place, int index, const char* kind) {
    const BodySpec* b = body(place, index);
    const Spec* spec = b ? std::get_if<Spec>(&b->kind) : nullptr;
    if (b && !spec)
      errors_.push_back(
          fmt::format("{}: expected {}, got '{}', which is none", place, kind, b->name));
    return spec;
  }
  const SolidSpec* meshed(const std::string& place, int index) {
    return of_kind<SolidSpec>(place, index, "a meshed part");
  }

  void check(const DesignSpec& d) {
    const std::string place = "design '" + d.name + "'";
    if (d.bodies.empty()) errors_.push_back(place + ": expected at least one beam, got none");
    if (d.properties.empty()) errors_.push_back(place + ": expected a dimension, got none");
    if (!(d.lower > 0 && d.lower < d.upper))
      errors_.push_back(fmt::format("{}: expected bounds 0 < lower < upper, got [{:g}, {:g}]",
                                    place, d.lower, d.upper));
    expect(d.groups >= 1, place, "at least one group", d.groups);
    if (!d.group_bounds.empty())
      expect(static_cast<int>(d.group_bounds.size()) == d.groups, place,
             "narrower bounds of every group", static_cast<double>(d.group_bounds.size()));
    const auto starts = static_cast<int>(d.start.size());
    if (starts > 1 && starts != d.groups)
      errors_.push_back(
          fmt::format("{}: expected no start, one, or one for each of {} groups, got {}", place,
                      d.groups, starts));
    for (const int index : d.bodies)
      if (const auto* beam = of_kind<BeamSpec>(place, index, "a beam")) check(d, place, *beam);
  }

  void check(const DesignSpec& d, const std::string& place, const BeamSpec& beam) {
    if (d.groups > static_cast<int>(beam.sections.size()))
      errors_.push_back(fmt::format("{}: expected at most {} groups, one an element, got {}", place,
                                    beam.sections.size(), d.groups));
    std::set<std::string> said;
    for (const Section& section : beam.sections)
      for (const std::string& property : d.properties) try {
          dimension(section.shape, property);
        } catch (const std::invalid_argument& error) {
          if (said.insert(error.what()).second) errors_.push_back(place + ": " + error.what());
        }
  }

  void check(const ConstantSpec& c) {
    const std::string place = "design '" + c.name + "'";
    const bool one = !c.values.empty() && c.lower == c.upper;  // of a catalogue
    if (!(c.lower < c.upper || one))
      errors_.push_back(fmt::format("{}: expected bounds lower < upper, got [{:g}, {:g}]", place,
                                    c.lower, c.upper));
    if (c.quantity == ConstantQuantity::Duration)
      expect(c.lower > 0 && c.start && study_.duration > 0, place, "a duration > 0 with a start",
             c.lower);
    else if (c.quantity == ConstantQuantity::DriveValue)
      expect(c.drive >= 0 && c.drive < static_cast<int>(study_.drives.size()) && c.row >= 0 &&
                 c.row < static_cast<int>(study_.drives[std::size_t(c.drive)].q.size()) && c.start,
             place, "a row of the table of a drive, with a start", c.row);
    else if (c.quantity == ConstantQuantity::Mass)
      of_kind<RigidSpec>(place, c.body, "a rigid body");
    else
      expect(c.force >= 0 && c.force < forces_, place, "a force of the scene", c.force);
  }

  void check_objective() {
    std::set<int> counted;
    for (const int index : study_.mass_of) {
      body("objective", index);
      if (!counted.insert(index).second)
        errors_.push_back(fmt::format("objective: expected each body once, got {} twice", index));
    }
  }

  const StudySpec& study_;
  const std::vector<BodySpec>& bodies_;
  const int forces_;
  Errors errors_;
};

}  // namespace

std::vector<std::string> CycleOptions::errors() const {
  Errors list;
  const auto expect = [&list](bool holds, const char* name, const char* range, double got) {
    if (!holds) list.push_back(fmt::format("{}: expected {}, got {:g}", name, range, got));
  };
  const auto share = [](double v) { return v > 0 && v <= 1; };
  expect(max >= 1, "max", ">= 1", max);
  expect(share(tolerance), "tolerance", "in (0, 1]", tolerance);
  expect(share(objective_tolerance), "objective_tolerance", "in (0, 1]", objective_tolerance);
  expect(share(feasibility), "feasibility", "in (0, 1]", feasibility);
  expect(share(move_limit), "move_limit", "in (0, 1]", move_limit);
  expect(screening >= 0 && screening <= 1, "screening", "in [0, 1]", screening);
  expect(min_cases >= 1, "min_cases", ">= 1", min_cases);
  expect(gap >= 0, "gap", ">= 0", gap);
  expect(max_designs >= 1, "max_designs", ">= 1", max_designs);
  expect(restarts >= 0 && restarts <= kMostRestarts, "restarts", "0 to 5", restarts);
  expect(continuation >= 0 && continuation <= kMostStages, "continuation", "0 to 20", continuation);
  expect(move_cells > 0, "move_cells", "> 0", move_cells);
  return list;
}

std::vector<std::string> study_errors(const StudySpec& study, const Mechanism& mechanism) {
  return StudyCheck(study, mechanism).run();
}

const StudySpec& checked(const StudySpec& study, const Mechanism& mechanism) {
  const Errors errors = study_errors(study, mechanism);
  if (errors.empty()) return study;
  std::string text = "invalid study:";
  for (const std::string& error : errors) text += "\n  " + error;
  throw std::invalid_argument(text);
}

}  // namespace liesl
