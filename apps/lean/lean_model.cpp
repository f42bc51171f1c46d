/// @file
/// Models of beams that are cheaper: rigid, or linear with few modes; and the tangent.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/lean/lean_stages.hpp"
#include "mbs/solvers/generalized_alpha.hpp"

namespace liesl {

namespace {

constexpr double kRigidShare = 0.5;  // of what is left, for beams made rigid
constexpr int kMostModes = 8;
constexpr double kFaster = 0.9;  // of the time; less is within its scatter

/// Why the other model is not taken, or empty if its time is worth to be measured.
std::string objection(LeanRuns& runs, const Setting& other) {
  const Trial &now = runs.trial(runs.lean), &then = runs.trial(other);
  if (!then.ok) return "does not run: " + then.reason;
  if (!runs.good(other)) return runs.verdict(other) + " from the reference";
  const bool alike = other.tangent != runs.lean.tangent && now.corrections == then.corrections &&
                     now.factorizations == then.factorizations;
  if (alike)
    return fmt::format("the same {} corrections and {} factorizations", then.corrections,
                       then.factorizations);
  return runs.fault(other);
}

/// Takes the other model if it is as good and measured to be faster.
void take_if_faster(LeanRuns& runs, const Setting& other, const std::string& about,
                    const std::string& choice) {
  std::string evidence = objection(runs, other);
  bool taken = false;
  if (evidence.empty()) {
    const auto [then, now] = runs.times(other, runs.lean);
    taken = then < kFaster * now;
    evidence = fmt::format("{:.3g} s instead of {:.3g} s, {} from the reference", then, now,
                           percent(runs.error(other)));
  }
  runs.decide(
      {about, choice + (taken ? ": taken" : ": no"), runs.error(other), runs.budget(), evidence});
  if (taken) runs.lean = other;
}

/// Other elements for all flexible beams, with mesh and step of their own, where measured to be
/// faster.
template <class Change>
void try_elements(LeanRuns& runs, const std::string& about, const std::string& choice,
                  const Change& change) {
  const Setting before = runs.lean;
  for (BeamSetting& beam : runs.lean.beams)
    if (!beam.rigid && beam.modes < 0) change(beam);
  if (changes(runs.lean, before).empty()) return;
  const Trial& changed = runs.trial(runs.lean);
  const bool found = changed.ok && choose_mesh_and_step(runs, " of " + choice);
  const Setting s = std::exchange(runs.lean, before);
  if (found)
    take_if_faster(runs, s, about, choice);
  else
    runs.decide(
        {about, choice + ": no", 0, 0,
         changed.ok ? "no mesh and step within the budget" : "does not run: " + changed.reason});
}

}  // namespace

void make_rigid(LeanRuns& runs) {
  if (!runs.dynamic()) return;  // statics: only the mesh
  struct Candidate {
    std::size_t beam;
    double figure;
  };
  std::vector<Candidate> candidates;
  const Setting flexible = runs.lean;
  const double limit = kRigidShare * runs.budget();
  for (std::size_t i = 0; i < runs.lean.beams.size(); ++i) {
    Setting s = flexible;
    s.beams[i].rigid = true;
    candidates.push_back({i, runs.distance(s, flexible)});
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.figure < b.figure; });
  for (const auto& [i, alone] : candidates) {
    Setting s = runs.lean;
    s.beams[i].rigid = true;
    const double together = alone <= limit ? runs.distance(s, flexible) : alone;
    const bool stiff = together <= limit;
    if (stiff) runs.lean = s;
    const std::string why =
        std::isfinite(together)
            ? fmt::format("rigid, it changes the response by {}{}", percent(together),
                          stiff ? " (with those before)" : "")
            : "rigid, the scene does not run: " + runs.trial(s).reason;
    runs.decide({"beam " + s.beams[i].name, stiff ? "rigid" : "flexible", together, limit, why});
  }
}

void choose_order(LeanRuns& runs) {
  try_elements(runs, "order", "order 4", [](BeamSetting& beam) {
    beam.order = 4;
    beam.segments = false;
  });
}

void choose_segments(LeanRuns& runs) {
  try_elements(runs, "segments", "segments", [](BeamSetting& beam) {
    beam.order = 2;
    beam.segments = true;
  });
}

void choose_modes(LeanRuns& runs) {
  if (!runs.dynamic()) return;
  for (std::size_t i = 0; i < runs.lean.beams.size(); ++i) {
    if (runs.lean.beams[i].rigid || runs.lean.beams[i].modes >= 0) continue;
    Setting s = runs.lean;
    for (int count = 0; count <= kMostModes; count = count == 0 ? 1 : 2 * count) {
      s.beams[i].modes = count;
      s.beams[i].order = 2;
      s.beams[i].segments = false;
      if (runs.good(s)) break;
    }
    take_if_faster(runs, s, "beam " + s.beams[i].name, fmt::format("{} modes", s.beams[i].modes));
  }
}

void choose_tangent(LeanRuns& runs) {
  if (!runs.dynamic()) return;
  const std::string given =
      runs.lean.tangent == "auto"
          ? text_of(tangent_strategy(TangentStrategy::Auto, runs.given_scene().mechanism.formalism))
          : runs.lean.tangent;
  for (const char* strategy : {"constant", "adaptive", "exact"}) {
    Setting s = runs.lean;
    s.tangent = strategy;
    if (given != strategy) take_if_faster(runs, s, "tangent", strategy);
  }
}

}  // namespace liesl
