/// @file
/// What a motion cannot be computed with, or not well: drives that jump, functions of time that
/// change within a step, damping and tolerances that decide the result.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/scene/reader.hpp"
#include "mbs/sections/section_law.hpp"

namespace liesl {

namespace {

constexpr double kUnresolved = 0.2;  // of the range: off the straight line within a step; a sine
                                     // with fewer than five steps a period
constexpr double kJump = 0.2;        // of the range, in no time
constexpr double kNoTime = 1e-9;     // of a step
constexpr double kMostSamples = 2e5;
constexpr double kMostSteps = 1e6;
constexpr double kLooseTolerance = 1e-4;

/// How a function of time looks from the steps of a simulation.
struct Sampled {
  double range = 0;         ///< largest less smallest value
  double off = 0;           ///< largest distance from the straight line over a step, of the range
  double from = 0, to = 0;  ///< that step, s
  double jump = 0, jump_at = 0;  ///< within it in no time; s
  double change = 0;             ///< from its start to its end
};

/// Halves the interval to where the function changes most.
void find_jump(const TimeFunction& f, Sampled& s) {
  double a = s.from, b = s.to;
  while (b - a > kNoTime * (s.to - s.from) && b - a > 1e-14 * std::abs(b)) {
    const double m = 0.5 * (a + b);
    (std::abs(f(m) - f(a)) > std::abs(f(b) - f(m)) ? b : a) = m;
  }
  s.jump = f(b) - f(a);
  s.jump_at = b;
}

Sampled sample(const TimeFunction& f, const SimulationOptions& o) {
  Sampled s;
  if (f.is_constant()) return s;
  const double steps = std::min(std::ceil(o.duration / o.step), kMostSteps);
  const int inside = static_cast<int>(std::clamp(kMostSamples / steps, 2., 8.));
  double low = f(0), high = low;
  for (long n = 0; n < static_cast<long>(steps); ++n) {
    const double a = static_cast<double>(n) * o.step, b = a + o.step, fa = f(a), fb = f(b);
    for (int i = 0; i <= inside; ++i) {
      const double share = static_cast<double>(i) / inside;
      const double value = f(a + share * o.step);
      low = std::min(low, value);
      high = std::max(high, value);
      const double off = std::abs(value - (1 - share) * fa - share * fb);
      if (off > s.off) s = {0, off, a, b, 0, 0, fb - fa};
    }
  }
  s.range = high - low;
  if (!(s.range > 0)) return {};
  s.off /= s.range;
  if (s.off > kUnresolved) find_jump(f, s);
  return s;
}

void check_drives(Reader& reader) {
  const Mechanism& m = reader.scene.mechanism;
  for (const DriveSpec& drive : m.drives) {
    const std::string& joint = m.joints[static_cast<std::size_t>(drive.joint)].name;
    const Sampled s = sample(drive.motion, reader.scene.simulation);
    if (s.off <= kUnresolved) continue;
    if (std::abs(s.jump) > kJump * s.range) {
      const auto at = reader.root["joints"][joint]["drive"];
      reader.problems.add(
          at.node() ? *at.node() : static_cast<const toml::node&>(reader.root),
          fmt::format("the drive of '{}' jumps by {:.4g} at t = {:.6g} s: a motion without a "
                      "velocity",
                      joint, s.jump, s.jump_at),
          "a continuous function of time",
          "a table with interpolation = \"cubic\", or a ramp over several steps");
    } else {
      reader.scene.warnings.push_back(fmt::format(
          "the drive of '{}' changes within a step ({:.2g} of its range off the straight line "
          "between {:.6g} s and {:.6g} s): the motion does not follow it; use a smaller "
          "simulation.step",
          joint, s.off, s.from, s.to));
    }
  }
}

/// A load may jump once: the step is then one of switching on or off.
void check_load(Reader& reader, const std::string& what, const TimeFunction& f) {
  const Sampled s = sample(f, reader.scene.simulation);
  if (s.off <= kUnresolved) return;
  if (std::abs(s.jump) > kJump * s.range && std::abs(s.change) > 0.5 * std::abs(s.jump)) return;
  reader.scene.warnings.push_back(fmt::format(
      "{} changes within a step ({:.2g} of its range off the straight line between {:.6g} s and "
      "{:.6g} s): the steps do not see it; use a smaller simulation.step",
      what, s.off, s.from, s.to));
}

/// Half of damping times the circular frequency of the first bending mode between hinges.
double damping_ratio(const BeamSpec& beam) {
  double length = 0, softest = 0;  // EI/(rho A) of the softest element and direction
  for (std::size_t e = 0; e < beam.sections.size(); ++e) {
    length += (beam.nodes[e + 1].x - beam.nodes[e].x).norm();
    const SectionLaw law = section_law(beam.sections[e], beam.material);
    if (!(law.M(0, 0) > 0)) return 0;
    const double c2 = std::min(law.K(4, 4), law.K(5, 5)) / law.M(0, 0);
    softest = e == 0 ? c2 : std::min(softest, c2);
  }
  const double omega = std::pow(std::numbers::pi / length, 2) * std::sqrt(softest);
  return 0.5 * beam.damping * omega;
}

void check_damping(Reader& reader) {
  for (const BodySpec& body : reader.scene.mechanism.bodies) {
    const auto* beam = std::get_if<BeamSpec>(&body.kind);
    if (!beam || beam->damping == 0) continue;
    if (const double ratio = damping_ratio(*beam); ratio > 1)
      reader.scene.warnings.push_back(fmt::format(
          "bodies.{}.beam.damping = {:g} s is {:.3g} of the critical damping of its first bending "
          "mode: the beam creeps instead of vibrating; steel has about 1e-6 to 1e-4 s",
          body.name, beam->damping, ratio));
  }
}

}  // namespace

void check_motion(Reader& reader) {
  const SimulationOptions& o = reader.scene.simulation;
  if (o.type != SimulationType::Dynamic || reader.fixed_loads) return;
  for (const char* group : {"bodies", "joints", "forces", "loads", "simulation"})
    if (reader.broken.contains(group)) return;
  if (!o.errors().empty()) return;
  check_drives(reader);
  check_load(reader, "gravity_scale", reader.scene.mechanism.gravity_scale);
  for (const ForceSpec& force : reader.scene.mechanism.forces)
    check_load(reader, fmt::format("the force of '{}'", force.name), force.force);
  for (const LoadSpec& load : reader.scene.mechanism.loads)
    check_load(reader, fmt::format("the scale of load '{}'", load.name), load.scale);
  check_damping(reader);
  if (o.tolerance > kLooseTolerance)
    reader.scene.warnings.push_back(
        fmt::format("simulation.tolerance = {:g} leaves that share of the forces unbalanced in "
                    "every step: compare with {:g}",
                    o.tolerance, 1e-2 * kLooseTolerance));
}

}  // namespace liesl
