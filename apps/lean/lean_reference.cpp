/// @file
/// The scene as given, its space, the reference, and the check on a run that decided nothing.

#include <fmt/format.h>

#include <limits>
#include <optional>

#include "apps/input/problem.hpp"
#include "apps/lean/lean_stages.hpp"
#include "mbs/solvers/richardson.hpp"

namespace liesl {

namespace {

constexpr int kMostRefinement = 16;  // of the reference, from the scene as given
constexpr double kInfinity = std::numeric_limits<double>::infinity();

void refuse_what_it_cannot_judge(const Scene& scene) {
  for (const BodySpec& body : scene.mechanism.bodies) {
    const auto* beam = std::get_if<BeamSpec>(&body.kind);
    if (beam && model_of(*beam, scene.mechanism.formalism) == BeamModel::Segments)
      throw InputError({{scene.file, 0, 0,
                         "'" + body.name +
                             "' is a chain of segments, which no other model of a "
                             "beam here contains",
                         "beams of another formalism",
                         "--set simulation.formalism=\"se3\", without 'potential' and 'mass'"}});
  }
  const SimulationOptions& o = scene.simulation;
  if (o.type == SimulationType::Modes)
    throw InputError({{scene.file, 0, 0, "simulation.type = \"modes\" has no response over time",
                       "\"dynamic\" or \"static\"", ""}});
  if (o.type == SimulationType::Static && o.arc_length)
    throw InputError(
        {{scene.file, 0, 0, "simulation.arc_length: two paths have no load factors in common",
          "load steps", "--set simulation.arc_length=false"}});
}

/// A mesh that moves a named place is no choice.
void keep_places(LeanRuns& runs) {
  for (auto& beam : runs.lean.beams) {
    Setting other = runs.result.given;
    for (auto& b : other.beams)
      if (b.name == beam.name) b.elements *= 2;
    try {
      const Scene as = runs.given_scene(), moved = runs.scene(other);
      const int body = as.mechanism.body(beam.name);
      if (places(as, body) == places(moved, body)) continue;
    } catch (const InputError&) {
    }
    beam.multiple = 0;
    runs.result.warnings.push_back(fmt::format(
        "beam {} keeps its mesh: the scene names nodes or elements of it by number", beam.name));
  }
}

}  // namespace

bool run_as_given(LeanRuns& runs) {
  const Scene scene = runs.given_scene();
  refuse_what_it_cannot_judge(scene);
  runs.result.given = setting_of(scene);
  runs.lean = runs.result.given;
  for (BeamSetting& beam : runs.lean.beams) beam.order = 2;  // that of the estimates
  const Trial& t = runs.trial(runs.result.given);
  runs.result.space = t.space;
  runs.result.space_reason = t.space_reason;
  if (!t.ok) {
    runs.result.reason = "the scene as given does not reach its end: " + t.reason;
    return false;
  }
  if (size_of(t.series, output::Norm::Max) == 0)
    throw InputError({{"--response", 0, 0, "the response is zero throughout",
                       "a response that the tolerance can be relative to", ""}});
  keep_places(runs);
  return true;
}

void choose_space(LeanRuns& runs) {
  Setting in_space = runs.lean;
  in_space.space = "spatial";
  const Trial &now = runs.trial(runs.lean), &other = runs.trial(in_space);
  if (now.space != "planar") {
    Setting planar = runs.lean;
    planar.space = "planar";
    const Trial& tried = runs.trial(planar);
    if (!tried.ok || tried.space != "planar")
      return runs.decide({"space", "spatial", 0, 0, now.space_reason});
  }
  Setting planar = runs.lean;
  planar.space = "planar";
  if (!other.ok) {
    runs.lean.space = runs.result.space = "planar";
    return runs.decide(
        {"space", "planar", 0, 0, "the spatial scene does not run: " + other.reason});
  }
  const double difference = runs.distance(planar, in_space);
  const bool equal = difference <= kReferenceShare * runs.tolerance();
  runs.lean.space = equal ? "planar" : "spatial";
  runs.result.space = runs.lean.space;
  const auto [in_plane, of_space] = runs.times(planar, in_space);
  runs.decide(
      {"space", runs.lean.space, difference, kReferenceShare * runs.tolerance(),
       fmt::format("{}; {} from the spatial run, {:.3g} s instead of {:.3g} s",
                   runs.trial(planar).space_reason, percent(difference), in_plane, of_space)});
}

bool find_reference(LeanRuns& runs) {
  Setting before;
  std::optional<double> last;
  std::string path;
  for (double factor = 0.5; factor <= kMostRefinement; factor *= 2) {
    const Setting s = runs.lean.refined(factor);
    if (!runs.trial(s).ok || !runs.whole_steps(s)) continue;
    const double difference =
        before.duration > 0 ? runs.distance(before, s) : std::numeric_limits<double>::quiet_NaN();
    const bool compared = before.duration > 0;
    before = s;
    if (!compared) continue;
    const double estimate = error_of_finer(difference, last);
    path +=
        fmt::format("{}{}x {}", path.empty() ? "differences " : ", ", factor, percent(difference));
    last = difference;
    if (factor < 2 || estimate > kReferenceShare * runs.tolerance()) continue;
    runs.result.reference = s;
    runs.result.reference_error = estimate;
    runs.decide(
        {"reference", text_of(s), estimate, kReferenceShare * runs.tolerance(),
         fmt::format("{} from the run before; estimated error {}", path, percent(estimate))});
    return true;
  }
  runs.decide(
      {"reference", "none", last.value_or(kInfinity), kReferenceShare * runs.tolerance(), path});
  return false;
}

bool check_held_out(LeanRuns& runs) {
  Setting finer = runs.result.reference.refined(2);
  if (finer.steps > 0) finer.record_every = 2 * runs.result.reference.record_every;
  runs.result.held_out = finer;
  const Trial& check = runs.trial(finer);
  runs.result.error = runs.distance(runs.lean, finer);
  runs.result.error_given = runs.distance(runs.result.given, finer);
  const auto [lean, given] = runs.times(runs.lean, runs.result.given);
  runs.result.time = lean;
  runs.result.time_given = given;
  runs.result.time_reference = runs.trial(runs.result.reference).cpu_s;
  runs.result.time_held_out = check.cpu_s;
  runs.result.corrections = runs.trial(runs.lean).corrections;
  runs.result.corrections_given = runs.trial(runs.result.given).corrections;
  const bool met = runs.result.error <= runs.tolerance();
  runs.decide({"held-out", met ? "met" : "missed", runs.result.error, runs.tolerance(),
               check.ok
                   ? fmt::format("{} from a run of {}", percent(runs.result.error), text_of(finer))
                   : "the held-out run fails: " + check.reason});
  if (met || !check.ok) return met;
  runs.result.reference_error = error_of_finer(runs.distance(runs.result.reference, finer));
  runs.result.reference = finer;
  runs.result.reference.record_every = runs.result.given.record_every;
  return false;
}

}  // namespace liesl
