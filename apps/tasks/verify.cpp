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
#include "apps/tasks/run.hpp"
#include "mbs/solvers/richardson.hpp"

namespace liesl {
namespace {

constexpr double kHalf = 0.5;         // an observed order this close to the expected one is it
constexpr double kLeastOrder = 0.5;   // below, nothing converges
constexpr double kResolution = 1e-9;  // of the largest value: differences below are rounding
constexpr double kIterated = 1e-8;    // tolerance that leaves nothing of the iterations to see

using Peaks = std::map<std::string, double>;

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
    adaptive_ = scene.simulation.type == SimulationType::Dynamic && scene.simulation.adaptive;
    if (scene.simulation.tolerance > kIterated)
      iterated_.push_back(fmt::format("simulation.tolerance={}", kIterated));
    keep_named_places(scene);
    name_what_stays(scene);
    find_order(scene);
  }

  void run() {
    const Setting fine_mesh = with_mesh(2), fine_step = with_steps(2);
    const bool by_mesh = differs(fine_mesh), by_step = differs(fine_step) && !adaptive_;
    const Peaks mesh = by_mesh ? peaks(fine_mesh, "mesh") : Peaks{};
    const Peaks step = by_step ? peaks(fine_step, "step", iterated_) : Peaks{};
    const bool mesh_costs_more = largest_change(mesh) >= largest_change(step);
    Peaks coarse_mesh, coarse_step;
    if (!mesh.empty() && mesh_costs_more && halves(with_mesh(0.5)))
      coarse_mesh = peaks(with_mesh(0.5), "mesh");
    else if (!step.empty() && !mesh_costs_more && given_.steps % 2 == 0)
      coarse_step = peaks(with_steps(0.5), "step", iterated_);
    auto& json = summary_.more["verification"];
    json["runs"] = runs_ + 1;
    for (auto& r : summary_.responses) {
      const auto mesh_error = estimate(r.name, "mesh", mesh, coarse_mesh, mesh_order_, json);
      auto step_error = estimate(r.name, "step", step, coarse_step, kStepOrder, json);
      if (step_error && r.missed > step_error->error) {
        step_error->error = r.missed;
        step_error->below = true;
      }
      set_errors(r, mesh_error, step_error,
                 (mesh_error || step_error) && mesh_error.has_value() == by_mesh &&
                     step_error.has_value() == by_step);
    }
    if (adaptive_)
      summary_.warnings.push_back(
          "no error of the step and its iterations: its length is adapted to "
          "simulation.error_tolerance");
  }

 private:
  static std::string twice_the_elements(const BeamSetting& beam) {
    return fmt::format("bodies.{}.beam.elements={}", beam.name, 2 * beam.elements);
  }

  std::optional<Scene> readable(const std::vector<std::string>& changes) const {
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
      summary_.warnings.push_back(fmt::format(
          "the error of the mesh leaves out beam {}: {}", beam.name,
          2 * beam.elements > kMostElements ? "it has no room for twice its elements"
                                            : "the scene names nodes or elements by number"));
    }
  }

  void name_what_stays(const Scene& scene) {
    for (const auto& body : scene.mechanism.bodies)
      if (std::holds_alternative<SolidSpec>(body.kind))
        summary_.warnings.push_back(fmt::format(
            "the error of the mesh leaves out part {}: the elements of beams are refined only",
            body.name));
  }

  /// The lowest of the beams: that of their elements, 2 for the constant sections of a taper.
  void find_order(const Scene& scene) {
    mesh_order_ = 4;
    for (const auto& setting : given_.beams) {
      const auto& body =
          scene.mechanism.bodies[static_cast<size_t>(scene.mechanism.body(setting.name))];
      const auto& beam = std::get<BeamSpec>(body.kind);
      if (setting.multiple > 0)
        mesh_order_ = std::min(mesh_order_, beam.ends.empty() ? beam.order : 2);
    }
  }

  Setting with_mesh(double factor) const {
    Setting s = given_.refined(factor);
    s.steps = given_.steps;
    return s;
  }
  Setting with_steps(double factor) const {
    Setting s = given_;
    s.steps = std::lround(factor * static_cast<double>(given_.steps));
    return s;
  }
  bool differs(const Setting& s) const { return !changes(s, given_).empty(); }

  /// Has every mesh that is refined exactly half of its elements?
  bool halves(const Setting& s) const {
    for (std::size_t i = 0; i < s.beams.size(); ++i)
      if (given_.beams[i].multiple > 0 && 2 * s.beams[i].elements != given_.beams[i].elements)
        return false;
    return true;
  }

  Scene read(std::vector<std::string> more) const {
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
  Peaks peaks(const Setting& s, const char* of, const std::vector<std::string>& more = {}) {
    auto changed = changes(s, given_);
    changed.insert(changed.end(), more.begin(), more.end());
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

  std::optional<ErrorEstimate> estimate(const std::string& name, const char* of, const Peaks& finer,
                                        const Peaks& coarser, double order,
                                        nlohmann::ordered_json& json) {
    if (!finer.contains(name)) return {};
    Refinement r{peaks_.at(name), finer.at(name)};
    if (coarser.contains(name)) r.coarser = coarser.at(name);
    const ErrorEstimate e = estimate_error(r, order, kResolution * std::abs(r.given));
    auto& entry = json[of];
    entry["order"] = order;
    if (e.observed) entry["observed"][name] = *e.observed;
    if (!e.as_expected)
      summary_.warnings.push_back(
          fmt::format("response {}: order {:.2g} of the {} observed, {:g} expected{}", name,
                      *e.observed, of, order,
                      *e.observed < kLeastOrder ? ": it does not converge yet, and the error is "
                                                  "the largest difference seen"
                                                : ""));
    return e;
  }

  const VerifiedScene& source_;
  std::vector<std::string> overrides_;
  const Mechanism& mechanism_;
  output::RunSummary& summary_;
  const Progress& progress_;
  Setting given_;
  std::vector<std::string> iterated_;  ///< what runs of other steps change besides
  Peaks peaks_;
  int mesh_order_ = 2, runs_ = 0;
  bool adaptive_ = false;
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
