/// @file
/// The cheapest mesh and step within the budget.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "apps/lean/lean_stages.hpp"
#include "mbs/solvers/richardson.hpp"

namespace liesl {

namespace {

/// Where the estimates say to start, and single levels from there.
class MeshAndStep {
 public:
  MeshAndStep(LeanRuns& runs, const std::string& of) : runs_(runs), of_(of) {}

  bool choose() {
    counts_ = step_counts();
    Setting s = planned();
    const bool found = refine(s);
    if (found) coarsen(s);
    runs_.lean = s;
    if (runs_.result.given.record_every > 1 && s.steps > 0)
      runs_.lean.record_every = static_cast<int>(std::max<long>(
          1, std::lround(static_cast<double>(runs_.result.given.record_every * s.steps) /
                         static_cast<double>(runs_.result.given.steps))));
    runs_.decide({"mesh and step" + of_, text_of(s), runs_.error(s), runs_.budget(),
                  found
                      ? fmt::format("{} from the reference; one level coarser{}",
                                    percent(runs_.error(s)), limits_of(s))
                      : "the finest choice is " + percent(runs_.error(s)) + " from the reference"});
    return found;
  }

 private:
  bool movable(const BeamSetting& beam) const { return !beam.rigid && beam.multiple > 0; }

  /// That of the error by a mesh.
  static double order_of(const BeamSetting& beam) { return beam.segments ? kOrder : beam.order; }

  /// Richardson's estimate of what the mesh of a beam, or the step (beam < 0), costs.
  double cost_of(int beam, const Setting& s) {
    Setting finer = s;
    double order = kOrder;
    if (beam < 0) {
      finer.steps *= 2;
    } else {
      BeamSetting& b = finer.beams[static_cast<std::size_t>(beam)];
      b.elements *= 2;
      order = order_of(b);
    }
    return error_of_coarser(runs_.distance(s, finer), order);
  }

  /// Numbers of steps whose instants are instants of the reference, and enough of them: read there
  /// alone, the reference itself is within the budget.
  std::vector<long> step_counts() {
    if (!runs_.dynamic()) return {0};
    const output::Series& series = runs_.trial(runs_.result.reference).series;
    auto counts = divisors(runs_.result.reference.steps);
    const auto records = static_cast<long>(series.t.size()) - 1;
    const auto shows = [&](long n) {
      return n >= records ||
             relative_distance(thinned(series, records / n), series) <= runs_.budget();
    };
    counts.erase(counts.begin(), std::find_if(counts.begin(), counts.end(), shows));
    return counts;
  }

  /// Where the estimates say to start.
  Setting planned() {
    Setting from = runs_.lean;
    from.steps = runs_.result.given.steps;
    for (std::size_t i = 0; i < from.beams.size(); ++i)
      if (movable(from.beams[i])) from.beams[i].elements = runs_.result.given.beams[i].elements;
    const double step_error = from.steps > 0 ? cost_of(-1, from) : 0;
    std::vector<MeshError> meshes;
    std::vector<std::size_t> which;
    std::string text = from.steps > 0 ? fmt::format("step {}", percent(step_error)) : "";
    for (std::size_t i = 0; i < from.beams.size(); ++i) {
      const BeamSetting& beam = from.beams[i];
      if (!movable(beam)) continue;
      which.push_back(i);
      meshes.push_back({beam.elements, cost_of(static_cast<int>(i), from), beam.multiple,
                        runs_.result.reference.beams[i].elements, order_of(beam)});
      text += fmt::format("{}{} {} (order {:g})", text.empty() ? "" : ", ", beam.name,
                          percent(meshes.back().error), meshes.back().order);
    }
    const double others = static_cast<double>(from.beams.size() - which.size()) + 1;
    const Plan plan = cheapest(counts_, from.steps, step_error, meshes, others, runs_.budget());
    from.steps = plan.steps;
    for (std::size_t k = 0; k < which.size(); ++k) from.beams[which[k]].elements = plan.elements[k];
    runs_.decide({"estimate" + of_, text_of(from), plan.error, runs_.budget(),
                  "errors of step and mesh as given: " + text});
    return from;
  }

  /// One level coarser or finer in the step (beam < 0) or one mesh; empty at the end of the scale.
  std::optional<Setting> moved(Setting s, int beam, bool finer) const {
    if (beam >= 0) {
      BeamSetting& b = s.beams[static_cast<std::size_t>(beam)];
      const int most = runs_.result.reference.beams[static_cast<std::size_t>(beam)].elements;
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
    while (!runs_.good(s)) {
      std::optional<Setting> best;
      if (s.steps > 0 && !runs_.whole_steps(s)) best = moved(s, -1, true);
      if (best) {
        s = *best;
        continue;
      }
      for (const int choice : choices(s))
        if (const auto next = moved(s, choice, true);
            next && (!best || runs_.error(*next) < runs_.error(*best)))
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
        if (const auto next = moved(s, choice, false); next && runs_.good(*next)) {
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
      text += choice < 0 ? fmt::format("; {} steps: {}", next->steps, runs_.verdict(*next))
                         : fmt::format("; {} {}: {}", next->beams[beam].name,
                                       next->beams[beam].elements, runs_.verdict(*next));
    }
    return text.empty() ? " there is none" : text;
  }

  LeanRuns& runs_;
  const std::string of_;
  std::vector<long> counts_;  ///< candidates for the number of steps
};

}  // namespace

bool choose_mesh_and_step(LeanRuns& runs, const std::string& of) {
  return MeshAndStep(runs, of).choose();
}

}  // namespace liesl
