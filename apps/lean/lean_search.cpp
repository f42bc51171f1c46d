#include "apps/lean/lean_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "mbs/solvers/generalized_alpha.hpp"
#include "mbs/solvers/richardson.hpp"

namespace liesl {

namespace {

constexpr double kReferenceShare = 0.2;  // of the tolerance, for the error of the reference
constexpr double kRigidShare = 0.5;      // of what is left, for beams made rigid
constexpr int kMostRefinement = 16;      // of the reference, from the scene as given
constexpr int kMostChecks = 3;
constexpr int kMostModes = 8;
constexpr double kFaster = 0.9;  // of the time; less is within its scatter
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string percent(double x) { return std::isfinite(x) ? fmt::format("{:.3g} %", 100 * x) : "-"; }

std::string text_of(const Setting& s) {
  std::string text = s.steps > 0 ? fmt::format("{} steps of {:.4g} s", s.steps, s.step()) : "";
  for (const auto& beam : s.beams) {
    text += fmt::format("{}{} ", text.empty() ? "" : ", ", beam.name);
    text += beam.rigid ? "rigid" : fmt::format("{} elements", beam.elements);
    if (beam.modes >= 0) text += fmt::format(" in {} modes", beam.modes);
  }
  return text.empty() ? "nothing to refine" : text;
}

void refuse_what_has_no_records(const Scene& scene) {
  const SimulationOptions& o = scene.simulation;
  if (o.type == SimulationType::Modes)
    throw InputError({{scene.file, 0, 0, "simulation.type = \"modes\" has no response over time",
                       "\"dynamic\" or \"static\"", ""}});
  if (o.type == SimulationType::Static && o.arc_length)
    throw InputError(
        {{scene.file, 0, 0, "simulation.arc_length: two paths have no load factors in common",
          "load steps", "--set simulation.arc_length=false"}});
}

/// The state of one search.
class LeanSearch {
 public:
  LeanSearch(Trials& trials, double tolerance, const std::function<void(const Decision&)>& said)
      : trials_(trials), tolerance_(tolerance), said_(said) {}

  LeanResult run() {
    if (!as_given()) return finish(LeanStatus::Failed, r_.reason);
    space();
    if (!reference())
      return finish(LeanStatus::NotConverged,
                    "refinement does not settle the response: " + r_.decisions.back().evidence);
    rigid_beams();
    for (int check = 0; check < kMostChecks; ++check) {
      if (!mesh_and_step()) break;
      modes();
      tangent();
      if (held_out())
        return finish(LeanStatus::Done,
                      fmt::format("the lean model is within {} of a run twice as fine as its "
                                  "reference: {}",
                                  percent(tolerance_), percent(r_.error)));
    }
    return finish(LeanStatus::Missed,
                  "no model within the tolerance was found: " + r_.decisions.back().evidence);
  }

 private:
  // --- runs

  const Trial& trial(const Setting& s) { return trials_.run(changes(s, r_.given)); }
  Trials::Times times(const Setting& a, const Setting& b) {
    return trials_.times(changes(a, r_.given), changes(b, r_.given));
  }
  double off(const Setting& s, const Setting& from) {
    const Trial &a = trial(s), &b = trial(from);
    return a.ok && b.ok ? relative_distance(a.series, b.series) : kInfinity;
  }
  double error(const Setting& s) { return off(s, r_.reference); }
  double budget() const { return tolerance_ - r_.reference_error; }
  /// Steps that the integrator has to halve are not the steps of the setting.
  bool whole_steps(const Setting& s) { return trial(s).rejected <= trial(r_.given).rejected; }
  bool good(const Setting& s) { return whole_steps(s) && error(s) <= budget(); }
  /// Why a setting is not good, or how good it is.
  std::string verdict(const Setting& s) {
    if (!trial(s).ok) return "does not run";
    return whole_steps(s) ? percent(error(s)) : "steps have to be halved";
  }

  void decide(Decision decision) {
    said_(decision);
    r_.decisions.push_back(std::move(decision));
  }

  LeanResult finish(LeanStatus status, const std::string& reason) {
    r_.status = status;
    r_.reason = reason;
    r_.runs = trials_.runs();
    r_.changes = changes(lean_, r_.given);
    r_.lean = lean_;
    return r_;
  }

  // --- 1. the scene as given

  bool as_given() {
    const Scene scene = trials_.scene({});
    refuse_what_has_no_records(scene);
    r_.given = setting_of(scene);
    lean_ = r_.given;
    const Trial& t = trial(r_.given);
    r_.space = t.space;
    r_.space_reason = t.space_reason;
    if (!t.ok) {
      r_.reason = "the scene as given does not reach its end: " + t.reason;
      return false;
    }
    if (size_of(t.series, output::Norm::Max) == 0)
      throw InputError({{"--response", 0, 0, "the response is zero throughout",
                         "a response that the tolerance can be relative to", ""}});
    keep_places();
    return true;
  }

  /// A mesh that moves a named place is no choice.
  void keep_places() {
    for (auto& beam : lean_.beams) {
      Setting other = r_.given;
      for (auto& b : other.beams)
        if (b.name == beam.name) b.elements *= 2;
      try {
        const Scene as = trials_.scene({}), moved = trials_.scene(changes(other, r_.given));
        const int body = as.mechanism.body(beam.name);
        if (places(as, body) == places(moved, body)) continue;
      } catch (const InputError&) {
      }
      beam.multiple = 0;
      r_.warnings.push_back(fmt::format(
          "beam {} keeps its mesh: the scene names nodes or elements of it by number", beam.name));
    }
  }

  void space() {
    Setting in_space = lean_;
    in_space.space = "spatial";
    const Trial &now = trial(lean_), &other = trial(in_space);
    if (now.space != "planar") {
      Setting planar = lean_;
      planar.space = "planar";
      const Trial& tried = trial(planar);
      if (!tried.ok || tried.space != "planar")
        return decide({"space", "spatial", 0, 0, now.space_reason});
    }
    Setting planar = lean_;
    planar.space = "planar";
    if (!other.ok) {
      lean_.space = r_.space = "planar";
      return decide({"space", "planar", 0, 0, "the spatial scene does not run: " + other.reason});
    }
    const double difference = off(planar, in_space);
    const bool equal = difference <= kReferenceShare * tolerance_;
    lean_.space = equal ? "planar" : "spatial";
    r_.space = lean_.space;
    const auto [in_plane, of_space] = times(planar, in_space);
    decide({"space", lean_.space, difference, kReferenceShare * tolerance_,
            fmt::format("{}; {} from the spatial run, {:.3g} s instead of {:.3g} s",
                        trial(planar).space_reason, percent(difference), in_plane, of_space)});
  }

  // --- 2. the reference

  bool reference() {
    Setting before;
    std::optional<double> last;
    std::string path;
    for (double factor = 0.5; factor <= kMostRefinement; factor *= 2) {
      const Setting s = lean_.refined(factor);
      if (!trial(s).ok || !whole_steps(s)) continue;
      const double difference =
          before.duration > 0 ? off(before, s) : std::numeric_limits<double>::quiet_NaN();
      const bool compared = before.duration > 0;
      before = s;
      if (!compared) continue;
      const double estimate = error_of_finer(difference, last);
      path += fmt::format("{}{}x {}", path.empty() ? "differences " : ", ", factor,
                          percent(difference));
      last = difference;
      if (factor < 2 || estimate > kReferenceShare * tolerance_) continue;
      r_.reference = s;
      r_.reference_error = estimate;
      decide({"reference", text_of(s), estimate, kReferenceShare * tolerance_,
              fmt::format("{} from the run before; estimated error {}", path, percent(estimate))});
      return true;
    }
    decide({"reference", "none", last.value_or(kInfinity), kReferenceShare * tolerance_, path});
    return false;
  }

  // --- 3. rigid beams

  void rigid_beams() {
    if (r_.given.steps == 0) return;  // statics: only the mesh
    struct Candidate {
      std::size_t beam;
      double figure;
    };
    std::vector<Candidate> candidates;
    const Setting flexible = lean_;
    const double limit = kRigidShare * budget();
    for (std::size_t i = 0; i < lean_.beams.size(); ++i) {
      Setting s = flexible;
      s.beams[i].rigid = true;
      candidates.push_back({i, off(s, flexible)});
    }
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b) { return a.figure < b.figure; });
    for (const auto& [i, alone] : candidates) {
      Setting s = lean_;
      s.beams[i].rigid = true;
      const double together = alone <= limit ? off(s, flexible) : alone;
      const bool stiff = together <= limit;
      if (stiff) lean_ = s;
      const std::string why =
          std::isfinite(together)
              ? fmt::format("rigid, it changes the response by {}{}", percent(together),
                            stiff ? " (with those before)" : "")
              : "rigid, the scene does not run: " + trial(s).reason;
      decide({"beam " + s.beams[i].name, stiff ? "rigid" : "flexible", together, limit, why});
    }
  }

  // --- 4. mesh and step

  bool movable(const BeamSetting& beam) const { return !beam.rigid && beam.multiple > 0; }

  /// Richardson's estimate of what the mesh of a beam, or the step (beam < 0), costs.
  double cost_of(int beam, const Setting& s) {
    Setting finer = s;
    if (beam < 0)
      finer.steps *= 2;
    else
      finer.beams[static_cast<std::size_t>(beam)].elements *= 2;
    return error_of_finer(off(s, finer)) * std::exp2(kOrder);
  }

  /// Numbers of steps whose instants are instants of the reference, and enough of them: read there
  /// alone, the reference itself is within the budget.
  std::vector<long> step_counts() {
    if (r_.given.steps == 0) return {0};
    const output::Series& series = trial(r_.reference).series;
    auto counts = divisors(r_.reference.steps);
    const auto records = static_cast<long>(series.t.size()) - 1;
    const auto shows = [&](long n) {
      return n >= records || relative_distance(thinned(series, records / n), series) <= budget();
    };
    counts.erase(counts.begin(), std::find_if(counts.begin(), counts.end(), shows));
    return counts;
  }

  /// Where the estimates say to start.
  Setting planned() {
    Setting from = lean_;
    from.steps = r_.given.steps;
    for (std::size_t i = 0; i < from.beams.size(); ++i)
      if (movable(from.beams[i])) from.beams[i].elements = r_.given.beams[i].elements;
    const double step_error = from.steps > 0 ? cost_of(-1, from) : 0;
    std::vector<MeshError> meshes;
    std::vector<std::size_t> which;
    std::string text = from.steps > 0 ? fmt::format("step {}", percent(step_error)) : "";
    for (std::size_t i = 0; i < from.beams.size(); ++i) {
      const BeamSetting& beam = from.beams[i];
      if (!movable(beam)) continue;
      which.push_back(i);
      meshes.push_back({beam.elements, cost_of(static_cast<int>(i), from), beam.multiple,
                        r_.reference.beams[i].elements});
      text +=
          fmt::format("{}{} {}", text.empty() ? "" : ", ", beam.name, percent(meshes.back().error));
    }
    const double others = static_cast<double>(from.beams.size() - which.size()) + 1;
    const Plan plan = cheapest(counts_, from.steps, step_error, meshes, others, budget());
    from.steps = plan.steps;
    for (std::size_t k = 0; k < which.size(); ++k) from.beams[which[k]].elements = plan.elements[k];
    decide({"estimate", text_of(from), plan.error, budget(),
            "errors of mesh and step as given, of order 2: " + text});
    return from;
  }

  /// One level coarser or finer in the step (beam < 0) or one mesh; empty at the end of the scale.
  std::optional<Setting> moved(Setting s, int beam, bool finer) const {
    if (beam >= 0) {
      BeamSetting& b = s.beams[static_cast<std::size_t>(beam)];
      const int most = r_.reference.beams[static_cast<std::size_t>(beam)].elements;
      b.elements += finer ? b.multiple : -b.multiple;
      return b.elements >= 1 && b.elements <= most ? std::optional(s) : std::nullopt;
    }
    const auto here = std::lower_bound(counts_.begin(), counts_.end(), s.steps);
    if (here == (finer ? counts_.end() - 1 : counts_.begin())) return {};
    s.steps = *(finer ? here + 1 : here - 1);
    return s;
  }

  /// What can be made finer or coarser: the step (-1) and the meshes of beams.
  std::vector<int> choices(const Setting& s) const {
    std::vector<int> list;
    if (s.steps > 0) list.push_back(-1);
    for (std::size_t i = 0; i < s.beams.size(); ++i)
      if (movable(s.beams[i])) list.push_back(static_cast<int>(i));
    return list;
  }

  /// Finer, by the choice that helps most, until the error is within the budget. Against steps that
  /// have to be halved, only smaller steps help.
  bool refine(Setting& s) {
    while (!good(s)) {
      std::optional<Setting> best;
      if (s.steps > 0 && !whole_steps(s)) best = moved(s, -1, true);
      if (best) {
        s = *best;
        continue;
      }
      for (const int choice : choices(s))
        if (const auto next = moved(s, choice, true);
            next && (!best || error(*next) < error(*best)))
          best = next;
      if (!best) return false;
      s = *best;
    }
    return true;
  }

  /// Coarser, one level of each choice in turn, until none is within the budget.
  void coarsen(Setting& s) {
    for (bool any = true; any;) {
      any = false;
      for (const int choice : choices(s))
        if (const auto next = moved(s, choice, false); next && good(*next)) {
          s = *next;
          any = true;
        }
    }
  }

  /// What is wrong with one level coarser in each choice.
  std::string limits_of(const Setting& s) {
    std::string text;
    for (const int choice : choices(s)) {
      const auto next = moved(s, choice, false);
      if (!next) continue;
      const auto beam = static_cast<std::size_t>(choice);
      text += choice < 0 ? fmt::format("; {} steps: {}", next->steps, verdict(*next))
                         : fmt::format("; {} {}: {}", next->beams[beam].name,
                                       next->beams[beam].elements, verdict(*next));
    }
    return text.empty() ? " there is none" : text;
  }

  bool mesh_and_step() {
    counts_ = step_counts();
    Setting s = planned();
    const bool found = refine(s);
    if (found) coarsen(s);
    lean_ = s;
    if (r_.given.record_every > 1 && s.steps > 0)
      lean_.record_every = static_cast<int>(
          std::max<long>(1, std::lround(static_cast<double>(r_.given.record_every * s.steps) /
                                        static_cast<double>(r_.given.steps))));
    decide({"mesh and step", text_of(s), error(s), budget(),
            found ? fmt::format("{} from the reference; one level coarser{}", percent(error(s)),
                                limits_of(s))
                  : "the finest choice is " + percent(error(s)) + " from the reference"});
    return found;
  }

  // --- 5. what is only faster

  /// Why the other model is not taken, or empty if its time is worth to be measured.
  std::string objection(const Setting& other) {
    const Trial &now = trial(lean_), &then = trial(other);
    if (!then.ok) return "does not run: " + then.reason;
    if (!good(other)) return verdict(other) + " from the reference";
    const bool alike = other.tangent != lean_.tangent && now.corrections == then.corrections &&
                       now.factorizations == then.factorizations;
    return alike ? fmt::format("the same {} corrections and {} factorizations", then.corrections,
                               then.factorizations)
                 : "";
  }

  /// Takes the other model if it is as good and measured to be faster.
  void faster(const Setting& other, const std::string& about, const std::string& choice) {
    std::string evidence = objection(other);
    bool taken = false;
    if (evidence.empty()) {
      const auto [then, now] = times(other, lean_);
      taken = then < kFaster * now;
      evidence = fmt::format("{:.3g} s instead of {:.3g} s, {} from the reference", then, now,
                             percent(error(other)));
    }
    decide({about, choice + (taken ? ": taken" : ": no"), error(other), budget(), evidence});
    if (taken) lean_ = other;
  }

  void modes() {
    if (r_.given.steps == 0) return;
    for (std::size_t i = 0; i < lean_.beams.size(); ++i) {
      if (lean_.beams[i].rigid || lean_.beams[i].modes >= 0) continue;
      Setting s = lean_;
      for (int count = 0; count <= kMostModes; count = count == 0 ? 1 : 2 * count) {
        s.beams[i].modes = count;
        if (good(s)) break;
      }
      faster(s, "beam " + s.beams[i].name, fmt::format("{} modes", s.beams[i].modes));
    }
  }

  void tangent() {
    if (r_.given.steps == 0) return;
    const std::string given = lean_.tangent == "auto"
                                  ? text_of(tangent_strategy(TangentStrategy::Auto,
                                                             trials_.scene({}).mechanism.formalism))
                                  : lean_.tangent;
    for (const char* strategy : {"constant", "adaptive", "exact"}) {
      Setting s = lean_;
      s.tangent = strategy;
      if (given != strategy) faster(s, "tangent", strategy);
    }
  }

  // --- 6. the check

  bool held_out() {
    Setting finer = r_.reference.refined(2);
    if (finer.steps > 0) finer.record_every = 2 * r_.reference.record_every;
    r_.held_out = finer;
    const Trial& check = trial(finer);
    r_.error = off(lean_, finer);
    r_.error_given = off(r_.given, finer);
    const auto [lean, given] = times(lean_, r_.given);
    r_.time = lean;
    r_.time_given = given;
    r_.time_reference = trial(r_.reference).cpu_s;
    r_.time_held_out = check.cpu_s;
    r_.corrections = trial(lean_).corrections;
    r_.corrections_given = trial(r_.given).corrections;
    const bool met = r_.error <= tolerance_;
    decide({"held-out", met ? "met" : "missed", r_.error, tolerance_,
            check.ok ? fmt::format("{} from a run of {}", percent(r_.error), text_of(finer))
                     : "the held-out run fails: " + check.reason});
    if (met || !check.ok) return met;
    r_.reference_error = error_of_finer(off(r_.reference, finer));
    r_.reference = finer;
    r_.reference.record_every = r_.given.record_every;
    return false;
  }

  Trials& trials_;
  double tolerance_;
  const std::function<void(const Decision&)>& said_;
  LeanResult r_;
  Setting lean_;
  std::vector<long> counts_;  ///< candidates for the number of steps
};

}  // namespace

const char* to_string(LeanStatus status) {
  switch (status) {
    case LeanStatus::Done:
      return "done";
    case LeanStatus::Missed:
      return "tolerance missed";
    case LeanStatus::NotConverged:
      return "not converged";
    case LeanStatus::Failed:
      return "simulation failed";
  }
  return "";
}

LeanResult find_lean(Trials& trials, double tolerance,
                     const std::function<void(const Decision&)>& said) {
  return LeanSearch(trials, tolerance, said).run();
}

}  // namespace liesl
