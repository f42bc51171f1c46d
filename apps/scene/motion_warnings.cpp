/// @file
/// What a motion cannot be computed with, or not well: drives that jump, functions of time that
/// change within a step or are not finite, damping and tolerances that decide the result; statics
/// before a ramp has begun.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "apps/scene/reader.hpp"
#include "mbs/sections/section_law.hpp"
#include "mbs/solids/solid_model.hpp"

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
  double jump = 0, jump_at = 0;       ///< within it in no time; s
  double change = 0;                  ///< from its start to its end
  std::optional<double> broken = {};  ///< where it is first not finite, s
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
  const std::vector<double> knots = f.knots();
  std::size_t knot = 0;
  double low = f(0), high = low;
  for (long n = 0; n < static_cast<long>(steps); ++n) {
    const double a = static_cast<double>(n) * o.step, b = a + o.step, fa = f(a), fb = f(b);
    const auto look = [&](double share) {
      const double value = f(a + share * o.step);
      if (!std::isfinite(value)) s.broken = a + share * o.step;
      low = std::min(low, value);
      high = std::max(high, value);
      const double off = std::abs(value - (1 - share) * fa - share * fb);
      if (off > s.off) s = {0, off, a, b, 0, 0, fb - fa, s.broken};
    };
    for (int i = 0; i <= inside && !s.broken; ++i) look(static_cast<double>(i) / inside);
    for (; knot < knots.size() && knots[knot] < b && !s.broken; ++knot)
      if (knots[knot] > a) look((knots[knot] - a) / o.step);
    if (s.broken) return s;
  }
  s.range = high - low;
  if (!(s.range > 0)) return {};
  s.off /= s.range;
  if (s.off > kUnresolved) find_jump(f, s);
  return s;
}

/// Is the function finite between the steps, too? Says where it is not.
bool check_finite(Reader& reader, const toml::node* at, const std::string& what, const Sampled& s) {
  if (s.broken)
    reader.problems.add(at ? *at : static_cast<const toml::node&>(reader.root),
                        fmt::format("{} is not finite at t = {:.6g} s", what, *s.broken),
                        "a finite number during the simulation");
  return !s.broken;
}

void check_drives(Reader& reader) {
  const Mechanism& m = reader.scene.mechanism;
  for (const DriveSpec& drive : m.drives) {
    const std::string& joint = m.joints[static_cast<std::size_t>(drive.joint)].name;
    const Sampled s = sample(drive.motion, reader.scene.simulation);
    const toml::node* at = reader.root["joints"][joint]["drive"].node();
    if (!check_finite(reader, at, fmt::format("the drive of '{}'", joint), s)) continue;
    if (s.off <= kUnresolved) continue;
    if (std::abs(s.jump) > kJump * s.range) {
      reader.problems.add(
          at ? *at : static_cast<const toml::node&>(reader.root),
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
      reader.scene.unfollowed.push_back(reader.scene.warnings.back());
    }
  }
}

/// A load may jump once: the step is then one of switching on or off.
void check_load(Reader& reader, const toml::node* at, const std::string& what,
                const TimeFunction& f) {
  const Sampled s = sample(f, reader.scene.simulation);
  if (!check_finite(reader, at, what, s)) return;
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

/// The same of a bar as long and as high as the mesh of a part; 0 without a mesh.
double damping_ratio(const SolidSpec& part) {
  if (!part.model) return 0;  // it is refused
  const SolidMesh& mesh = part.mesh();
  if (mesh.cell_count() == 0 || !(part.model->material().rho > 0)) return 0;
  const Eigen::VectorXd extent =
      (mesh.nodes.rowwise().maxCoeff() - mesh.nodes.rowwise().minCoeff()).head(mesh.dim);
  const double c = std::sqrt(part.model->material().E / part.model->material().rho);
  const double omega =
      std::pow(std::numbers::pi / extent.maxCoeff(), 2) * c * extent.minCoeff() / std::sqrt(12);
  return 0.5 * part.damping * omega;
}

void check_damping(Reader& reader) {
  const auto say = [&reader](const std::string& name, const char* kind, double damping,
                             double ratio) {
    if (ratio > 1)
      reader.scene.warnings.push_back(fmt::format(
          "bodies.{0}.{1}.damping = {2:g} s is {4}{3:.3g} of the critical damping of its first "
          "bending mode: the {5} creeps instead of vibrating; steel has about 1e-6 to 1e-4 s",
          name, kind, damping, ratio, kind == std::string("beam") ? "" : "about ",
          kind == std::string("beam") ? "beam" : "part"));
  };
  for (const BodySpec& body : reader.scene.mechanism.bodies) {
    if (const auto* beam = std::get_if<BeamSpec>(&body.kind); beam && beam->damping > 0)
      say(body.name, "beam", beam->damping, damping_ratio(*beam));
    if (const auto* part = std::get_if<SolidSpec>(&body.kind); part && part->damping > 0)
      say(body.name, "solid", part->damping, damping_ratio(*part));
  }
}

/// Every function of time that pushes, with the key that it is written at.
template <class See>
void each_push(Reader& reader, const See& see) {
  const Mechanism& m = reader.scene.mechanism;
  const auto root = toml::node_view<toml::node>(reader.root);
  if (m.gravity.norm() > 0)
    see(root["gravity_scale"].node(), std::string("gravity_scale"), m.gravity_scale);
  for (const ForceSpec& force : m.forces) {
    const toml::node* at = root["forces"][force.name].node();
    see(at ? at : root["joints"][force.name].node(), fmt::format("the force of '{}'", force.name),
        force.force);
  }
  for (const LoadSpec& load : m.loads)
    see(root["loads"][load.name]["scale"].node(), fmt::format("the scale of load '{}'", load.name),
        load.scale);
}

/// Static problems and modes have one instant, at which a ramp may not have begun.
void check_instant(Reader& reader) {
  const double t = reader.scene.simulation.at;
  each_push(reader, [&](const toml::node*, const std::string& what, const TimeFunction& f) {
    if (f.is_constant() || f(t) != 0) return;
    reader.scene.warnings.push_back(
        fmt::format("{} is 0 at simulation.at = {:g} s, where statics and modes take it: it does "
                    "nothing; simulation.at is the instant that is meant",
                    what, t));
  });
}

}  // namespace

void check_motion(Reader& reader) {
  const SimulationOptions& o = reader.scene.simulation;
  if (reader.fixed_loads) return;
  for (const char* group : {"bodies", "joints", "forces", "loads", "simulation"})
    if (reader.broken.contains(group)) return;
  if (!o.errors().empty()) return;
  if (o.type != SimulationType::Dynamic) return check_instant(reader);
  check_drives(reader);
  each_push(reader, [&](const toml::node* at, const std::string& what, const TimeFunction& f) {
    check_load(reader, at, what, f);
  });
  check_damping(reader);
  const PenaltySpec& penalty = reader.scene.mechanism.penalty;
  if (penalty.form == ConstraintForm::Augmented && penalty.damping > 0)
    reader.scene.warnings.push_back(
        "simulation.penalty_damping has no effect on augmented joints, which are closed: leave it "
        "out, or take simulation.constraints = \"penalty\"");
  if (o.tolerance > kLooseTolerance)
    reader.scene.warnings.push_back(
        fmt::format("simulation.tolerance = {:g} leaves that share of the forces unbalanced in "
                    "every step: compare with {:g}",
                    o.tolerance, 1e-2 * kLooseTolerance));
}

}  // namespace liesl
