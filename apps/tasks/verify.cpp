#include "apps/tasks/verify.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "apps/input/problem.hpp"
#include "apps/lean/setting.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/scene/space.hpp"
#include "apps/tasks/part_grids.hpp"
#include "apps/tasks/run.hpp"
#include "mbs/solvers/richardson.hpp"

namespace liesl {
namespace {

constexpr double kHalf = 0.5;         // an observed order this close to the expected one is it
constexpr double kLeastOrder = 0.5;   // below, nothing converges
constexpr double kResolution = 1e-9;  // of the largest value: differences below are rounding
constexpr double kRounding = 1e-12;   // the same, of the largest response of its unit
constexpr double kIterated = 1e-8;    // tolerance that leaves nothing of the iterations to see

using Peaks = std::map<std::string, double>;
using Changes = std::vector<std::string>;  // "key.path=value"

/// The same place of a response where beams have `n / before` times as many elements.
void move_element(ResponseSpec& r, int n, int before) {
  const int middle = (2 * r.element + 1) * n / before;  // of the element, in halves of the new ones
  if (r.place == ElementPlace::Middle && middle % 2 == 0) {
    r.element = middle / 2 - 1;
    r.place = ElementPlace::Last;
  } else if (r.place == ElementPlace::Middle) {
    r.element = middle / 2;
  } else if (r.place == ElementPlace::Last) {
    r.element = (r.element + 1) * n / before - 1;
  } else {
    r.element = r.element * n / before;
  }
}

/// The same place of a response where beams have other numbers of elements.
ResponseSpec on_mesh(ResponseSpec r, const Mechanism& from, const Mechanism& to) {
  const auto count = [](const Mechanism& m, int body) {
    const auto* beam =
        body >= 0 ? std::get_if<BeamSpec>(&m.bodies[static_cast<size_t>(body)].kind) : nullptr;
    return beam ? static_cast<int>(beam->sections.size()) : 1;
  };
  for (Port* port : {&r.at, &r.to})
    port->node = port->node * count(to, port->body) / count(from, port->body);
  move_element(r, count(to, r.body), count(from, r.body));
  return r;
}

/// The runs of one verification.
class Verification {
 public:
  Verification(const VerifiedScene& source, const Scene& scene, output::RunSummary& summary,
               const Progress& progress)
      : source_(source),
        overrides_(source.overrides),
        mechanism_(scene.mechanism),
        summary_(summary),
        progress_(progress),
        given_(setting_of(scene)) {
    if (!summary.space.empty())
      overrides_.push_back(fmt::format("simulation.space=\"{}\"", summary.space));
    for (const auto& r : summary.responses) peaks_[r.name] = r.max_abs;
    if (scene.simulation.tolerance > kIterated)
      iterated_.push_back(fmt::format("simulation.tolerance={}", kIterated));
    if (scene.simulation.type == SimulationType::Dynamic && scene.simulation.adaptive)
      error_tolerance_ = scene.simulation.error_tolerance;
    keep_named_places(scene);
    find_grids(scene);
    find_order(scene);
  }

  void run() {
    const Changes fine_mesh = with_mesh(2), fine_step = with_steps(2);
    const bool by_mesh = !fine_mesh.empty(), by_step = !fine_step.empty();
    const Peaks mesh = by_mesh ? peaks(fine_mesh, "mesh") : Peaks{};
    const Peaks step = by_step ? peaks(fine_step, "step") : Peaks{};
    const bool mesh_costs_more = largest_change(mesh) >= largest_change(step);
    Peaks coarse_mesh, coarse_step;
    if (!mesh.empty() && mesh_costs_more && halves())
      coarse_mesh = peaks(with_mesh(0.5), "mesh");
    else if (!step.empty() && !mesh_costs_more && given_.steps % 2 == 0)
      coarse_step = peaks(with_steps(0.5), "step");
    auto& json = summary_.more["verification"];
    json["runs"] = runs_ + 1;
    if (!left_out_.empty()) json["mesh"]["left_out"] = left_out_;
    for (const auto& r : summary_.responses)
      largest_[r.unit] = std::max(largest_[r.unit], r.max_abs);
    for (auto& r : summary_.responses) {
      const auto mesh_error = estimate(r, "mesh", mesh, coarse_mesh, mesh_order_, json);
      auto step_error = estimate(r, "step", step, coarse_step, kStepOrder, json);
      if (step_error && r.missed > step_error->error) {
        step_error->error = r.missed;
        step_error->below = true;
      }
      set_errors(r, mesh_error, step_error,
                 (mesh_error || step_error) && mesh_error.has_value() == by_mesh &&
                     step_error.has_value() == by_step && left_out_.empty());
    }
  }

 private:
  static std::string twice_the_elements(const BeamSetting& beam) {
    return fmt::format("bodies.{}.beam.elements={}", beam.name, 2 * beam.elements);
  }

  std::optional<Scene> readable(const Changes& changes) const {
    try {
      return read(changes);
    } catch (const InputError&) {
      return {};
    }
  }

  /// A mesh that moves a place which the scene names by number is of another mechanism.
  void keep_named_places(const Scene& scene) {
    std::vector<std::string> all;
    for (const auto& beam : given_.beams)
      if (2 * beam.elements <= kMostElements) all.push_back(twice_the_elements(beam));
    const std::optional<Scene> finer = readable(all);
    for (auto& beam : given_.beams) {
      const int body = scene.mechanism.body(beam.name);
      bool moved = 2 * beam.elements > kMostElements;
      if (!moved) {
        const auto alone = finer ? std::nullopt : readable({twice_the_elements(beam)});
        const Scene* with = finer ? &*finer : alone ? &*alone : nullptr;
        moved = !with || places(scene, body) != places(*with, body);
      }
      if (!moved) continue;
      beam.multiple = 0;
      leave_out("beam " + beam.name, 2 * beam.elements > kMostElements
                                         ? "it has no room for twice its elements"
                                         : "the scene names nodes or elements by number");
    }
  }

  void leave_out(const std::string& what, const std::string& why) {
    left_out_.push_back(what);
    summary_.warnings.push_back(fmt::format("the error of the mesh leaves out {}: {}", what, why));
  }

  /// Of the meshed parts, those that can have twice their cells in each direction.
  void find_grids(const Scene& scene) {
    for (const PartGrid& grid :
         part_grids({source_.text, source_.file, overrides_}, scene.mechanism))
      if (grid.cells.empty())
        leave_out("part " + grid.name, "its mesh is not a grid of the scene");
      else if (!readable(grid_changes({grid}, 2)))
        leave_out("part " + grid.name, "it has no room for twice its cells");
      else
        grids_.push_back(grid);
  }

  /// The lowest of beams and parts: that of their elements, 2 for the constant sections of a taper.
  void find_order(const Scene& scene) {
    mesh_order_ = 4;
    for (const auto& setting : given_.beams) {
      const auto& body =
          scene.mechanism.bodies[static_cast<size_t>(scene.mechanism.body(setting.name))];
      const auto& beam = std::get<BeamSpec>(body.kind);
      if (setting.multiple > 0)
        mesh_order_ = std::min(mesh_order_, beam.ends.empty() ? beam.order : 2);
    }
    for (const PartGrid& grid : grids_) mesh_order_ = std::min(mesh_order_, grid.order);
  }

  Setting beams(double factor) const {
    Setting s = given_.refined(factor);
    s.steps = given_.steps;
    return s;
  }
  Changes with_mesh(double factor) const {
    Changes all = changes(beams(factor), given_);
    const Changes grids = grid_changes(grids_, factor);
    all.insert(all.end(), grids.begin(), grids.end());
    return all;
  }
  /// A local error, which an adapted step keeps, is of the third order in the step.
  Changes with_steps(double factor) const {
    Setting s = given_;
    s.steps = std::lround(factor * static_cast<double>(given_.steps));
    Changes all = changes(s, given_);
    if (all.empty()) return all;
    all.insert(all.end(), iterated_.begin(), iterated_.end());
    if (error_tolerance_)
      all.push_back(fmt::format("simulation.error_tolerance={:.12g}",
                                *error_tolerance_ / std::pow(factor, kStepOrder + 1)));
    return all;
  }

  /// Can every mesh that is refined have exactly half of its elements?
  bool halves() const {
    const Setting half = beams(0.5);
    for (std::size_t i = 0; i < half.beams.size(); ++i)
      if (given_.beams[i].multiple > 0 && 2 * half.beams[i].elements != given_.beams[i].elements)
        return false;
    return grids_.empty() || !grid_changes(grids_, 0.5).empty();
  }

  Scene read(const Changes& more) const {
    auto all = overrides_;
    all.insert(all.end(), more.begin(), more.end());
    Scene scene = read_scene(source_.text, source_.file, all);
    if (!source_.responses.empty()) scene.responses.clear();
    for (const ResponseSpec& r : source_.responses)
      scene.responses.push_back(on_mesh(r, mechanism_, scene.mechanism));
    return scene;
  }

  /// Empty if the run does not reach its end, or the scene does not allow it (sections by element
  /// have no coarser mesh).
  Peaks peaks(const Changes& changed, const char* of) {
    Scene scene;
    try {
      scene = read(changed);
    } catch (const InputError&) {
      return {};
    }
    ++runs_;
    const RunOutcome out = run_task(scene, choose_space(scene), progress_);
    Peaks found;
    if (out.status != SolveStatus::Converged) {
      summary_.warnings.push_back(
          fmt::format("the error of the {} is not known: the run with {} did not reach its end: {}",
                      of, fmt::join(changed, ", "), out.summary.reason));
      return found;
    }
    for (const auto& r : out.summary.responses) found[r.name] = r.max_abs;
    return found;
  }

  double largest_change(const Peaks& finer) const {
    double largest = 0;
    for (const auto& [name, value] : finer)
      if (const double size = peaks_.at(name); size > 0)
        largest = std::max(largest, std::abs(value - size) / size);
    return largest;
  }

  static void set_errors(output::ResponseFigure& r, const std::optional<ErrorEstimate>& by_mesh,
                         const std::optional<ErrorEstimate>& by_step, bool all_known) {
    double total = 0;
    for (const auto* e : {&by_mesh, &by_step})
      if (*e) total += (*e)->below ? -(*e)->error : (*e)->error;
    if (by_mesh) r.error_mesh = by_mesh->error;
    if (by_step) r.error_step = by_step->error;
    if (all_known) r.error_total = std::abs(total);
  }

  std::optional<ErrorEstimate> estimate(const output::ResponseFigure& response, const char* of,
                                        const Peaks& finer, const Peaks& coarser, double order,
                                        nlohmann::ordered_json& json) {
    const std::string& name = response.name;
    if (!finer.contains(name)) return {};
    Refinement r{peaks_.at(name), finer.at(name)};
    if (coarser.contains(name)) r.coarser = coarser.at(name);
    const ErrorEstimate e = estimate_error(
        r, order, std::max(kResolution * std::abs(r.given), kRounding * largest_[response.unit]));
    auto& entry = json[of];
    entry["order"] = order;
    if (e.observed) entry["observed"][name] = *e.observed;
    if (!e.as_expected) warn_of_order(name, of, *e.observed, order);
    return e;
  }

  /// The given run has the error of its iterations, those of other steps have not.
  void warn_of_order(const std::string& name, const std::string& of, double observed,
                     double order) {
    summary_.warnings.push_back(
        fmt::format("response {}: order {:.2g} of the {} observed, {:g} expected{}{}", name,
                    observed, of, order,
                    observed < kLeastOrder
                        ? ": it does not converge yet, and the error is the largest difference seen"
                        : "",
                    of == "step" && !iterated_.empty() && observed < kLeastOrder
                        ? "; or simulation.tolerance hides it"
                        : ""));
  }

  const VerifiedScene& source_;
  std::vector<std::string> overrides_;
  const Mechanism& mechanism_;
  output::RunSummary& summary_;
  const Progress& progress_;
  Setting given_;
  std::vector<PartGrid> grids_;            ///< that are refined
  std::vector<std::string> left_out_;      ///< "part rod"
  Changes iterated_;                       ///< what runs of other steps change besides
  std::optional<double> error_tolerance_;  ///< of an adapted step
  Peaks peaks_;
  std::map<std::string, double> largest_;  ///< by unit
  int mesh_order_ = 2, runs_ = 0;
};

}  // namespace

ErrorEstimate estimate_error(const Refinement& r, double order, double resolution) {
  const double fine = std::abs(r.finer - r.given);
  const auto by_order = [fine](double p) { return fine / (1 - std::exp2(-p)); };
  ErrorEstimate e{by_order(order), r.given < r.finer};
  if (!r.coarser || fine <= resolution) return e;
  const double coarse = std::abs(*r.coarser - r.given);
  if (coarse <= resolution) return e;
  e.observed = observed_order(coarse, fine);
  e.as_expected = std::abs(*e.observed - order) <= kHalf;
  if (e.as_expected) return e;
  if (*e.observed < kLeastOrder)
    e.error = std::max(coarse, e.error);
  else
    e.error = by_order(std::min(order, *e.observed));
  return e;
}

void check_verifiable(const SimulationOptions& o) {
  if (o.type == SimulationType::Modes || (o.type == SimulationType::Static && o.arc_length))
    throw InputError({{"--verify", 0, 0,
                       o.type == SimulationType::Modes
                           ? "natural frequencies have no responses to verify"
                           : "two paths by arc length have no load factors in common",
                       "a motion, or load steps", ""}});
}

void verify(const VerifiedScene& source, const Scene& scene, output::RunSummary& summary,
            const Progress& progress) {
  check_verifiable(scene.simulation);
  Verification(source, scene, summary, progress).run();
}

}  // namespace liesl
