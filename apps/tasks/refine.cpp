#ifdef LIESL_OPTIM

#include "apps/tasks/refine.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "apps/input/problem.hpp"
#include "apps/lean/setting.hpp"
#include "apps/tasks/error_estimate.hpp"

namespace liesl {
namespace {

constexpr double kShare = 0.25;     // of what is allowed, for each of mesh and step
constexpr double kFalls = 0.7;      // an error that refinement leaves above this share stays
constexpr int kMostAtOnce = 3;      // doublings
constexpr double kMostSteps = 1e5;  // of a motion, which a study keeps whole for its gradients

using Changes = std::vector<std::string>;

/// The error of the limit that needs refinement most, with its order if it was observed.
struct LargestError {
  double error = 0;
  std::optional<double> order = {};
};

LargestError largest_error(const std::vector<VerifiedLimit>& limits, double feasibility,
                           bool mesh) {
  LargestError w;
  for (const VerifiedLimit& l : limits)
    if (const double e = mesh ? l.mesh : l.step; !l.certain(feasibility) && e > w.error)
      w = {e, mesh ? l.mesh_order : l.step_order};
  return w;
}

/// A power of two. An order below a half tells nothing but that the model is too coarse for one.
int refinement_factor(const LargestError& w, double allowed, double order) {
  const bool told = w.order && *w.order > 0.5;
  const double p = told ? std::clamp(*w.order, 1.0, order) : order;
  const double doublings = std::ceil(std::log2(w.error / allowed) / p);
  return 1 << static_cast<int>(std::clamp(doublings, 1.0, double(kMostAtOnce)));
}

/// To one digit.
double rounded_up(double value) {
  const double digit = std::pow(10, std::floor(std::log10(value)));
  return std::ceil(value / digit * (1 - 1e-12)) * digit;
}

/// What errors by mesh and step that do not fall below one are good for; of a limit's size:
/// nothing.
std::string within_reach(double error) {
  const double feasibility = rounded_up(error / kShare);
  return feasibility < 1 ? fmt::format("; cycle.feasibility = {:g} is within reach", feasibility)
                         : "";
}

/// By which factor an error has to shrink, and the largest one of elements or steps that there is
/// room for.
struct Refinable {
  double shrinks = 1, order = 4, room = 1;

  /// Of elements or steps.
  double factor() const { return std::pow(shrinks, 1 / order); }
  /// How many times as large the error stays; at least 1.
  double missing() const {
    return shrinks > 1 ? std::max(1.0, shrinks / std::pow(room, order)) : 1.0;
  }
};

/// One study, to be read with a finer model.
class FinerStudy {
 public:
  FinerStudy(const Study& study, const Changes& before, const ReadStudy& read)
      : study_(study), before_(before), read_(read), given_(setting_of(with_limits(study))) {}

  FinerModel model(const LargestError& mesh, const LargestError& step, double allowed) {
    FinerModel out;
    out.exhausted = out_of_reach(mesh, step, allowed);
    if (!out.exhausted.empty()) return out;
    if (mesh.error > allowed) refine_mesh(mesh, allowed, out);
    if (step.error > allowed) refine_step(step, allowed, out);
    return out;
  }

 private:
  /// With the places that limits name.
  static Scene with_limits(const Study& study) {
    Scene scene = study.scene;
    for (const ConstraintSpec& c : study.spec.constraints) scene.responses.push_back(c.response);
    return scene;
  }

  /// Where the supports of a beam are, as shares of its length.
  static std::vector<double> held_places(const Study& study, int body) {
    std::vector<double> list;
    const auto held = study.spec.supports.find(body);
    if (held == study.spec.supports.end()) return list;
    const Mechanism& m = study.scene.mechanism;
    const BodySpec& of = m.bodies[static_cast<std::size_t>(body)];
    for (const std::string& text : held->second)
      if (const auto port = m.port(of.name + "." + text.substr(0, text.find(':'))))
        list.push_back(static_cast<double>(port->node) /
                       static_cast<double>(std::get<BeamSpec>(of.kind).sections.size()));
    return list;
  }

  std::optional<Study> readable(const Changes& more) const {
    Changes all = before_;
    all.insert(all.end(), more.begin(), more.end());
    try {
      return read_(all);
    } catch (const InputError&) {
      return {};
    }
  }

  /// A beam with other elements and the places that it has now; none: it cannot have them.
  std::optional<BeamSetting> with_elements(std::size_t of, int elements) const {
    Setting finer = given_;
    BeamSetting& b = finer.beams[of];
    const int body = study_.scene.mechanism.body(b.name);
    for (const int numbering : {0, b.elements}) {
      b.elements = elements;
      b.numbering = numbering;
      const auto read = readable(changes(finer, given_));
      if (read && places(with_limits(*read), body) == places(with_limits(study_), body) &&
          held_places(*read, body) == held_places(study_, body))
        return b;
    }
    return {};
  }

  const BeamSpec& beam(const BeamSetting& of) const {
    const Mechanism& m = study_.scene.mechanism;
    return std::get<BeamSpec>(m.bodies[static_cast<std::size_t>(m.body(of.name))].kind);
  }

  /// Those of order 2 that can be of order 4.
  Changes order_4() const {
    Changes all;
    for (const BeamSetting& b : given_.beams)
      if (beam(b).order == 2) all.push_back(fmt::format("bodies.{}.beam.order=4", b.name));
    if (all.empty() || readable(all)) return all;
    Changes some;
    std::copy_if(all.begin(), all.end(), std::back_inserter(some),
                 [this](const std::string& change) { return readable({change}); });
    return some;
  }

  /// Parts with other cells are other parts of the study, whose outlines start anew.
  std::vector<std::string> parts() const {
    std::vector<std::string> names;
    for (const BodySpec& body : study_.scene.mechanism.bodies)
      if (std::holds_alternative<SolidSpec>(body.kind)) names.push_back(body.name);
    return names;
  }

  int order_of_beams() const {
    int order = 4;
    for (const BeamSetting& b : given_.beams) order = std::min(order, beam(b).order);
    return order;
  }

  /// By the orders that are expected: it takes no less. Empty: as far as they tell, both errors can
  /// become small enough.
  std::string out_of_reach(const LargestError& mesh, const LargestError& step,
                           double allowed) const {
    Refinable elements{mesh.error / allowed, double(order_of_beams())},
        steps{step.error / allowed, kStepOrder,
              std::max(1.0, kMostSteps / std::max(1.0, double(given_.steps)))};
    for (const BeamSetting& b : given_.beams)
      if (b.multiple > 0)
        elements.room = std::max(elements.room, double(kMostElements) / b.elements);
    // As `refine_mesh` says; what order 4 gains is to be seen.
    if (elements.room < 2 || !parts().empty() || !order_4().empty()) elements.shrinks = 1;
    const bool by_mesh = elements.missing() > steps.missing();
    const double missing = std::max({kResolution / allowed, elements.missing(), steps.missing()});
    if (missing <= 1) return "";
    const std::string reach = within_reach(missing * allowed);
    if (allowed < kResolution)
      return fmt::format("errors below {:.0e} of a limit are rounding{}", kResolution, reach);
    return fmt::format(
        "to become certain takes {:.2g} times as many {}, of which {} are the most{}",
        by_mesh ? elements.factor() : steps.factor(), by_mesh ? "elements" : "steps",
        by_mesh ? kMostElements : static_cast<int>(kMostSteps), reach);
  }

  void refine_mesh(const LargestError& error, double allowed, FinerModel& out) const {
    out.changes = order_4();
    if (!out.changes.empty()) return;
    if (const auto meshed = parts(); !meshed.empty()) {
      out.exhausted = fmt::format(
          "a study does not refine the cells of {} {}: more in the scene "
          "(bodies.{}.solid.mesh.cells) make it certain",
          meshed.size() == 1 ? "part" : "parts", fmt::join(meshed, ", "),
          meshed.size() == 1 ? meshed.front() : "NAME");
      return;
    }
    const int order = order_of_beams();
    Setting finer = given_;
    for (std::size_t i = 0; i < finer.beams.size(); ++i) {
      BeamSetting& b = finer.beams[i];
      std::optional<BeamSetting> refined;
      for (int f = refinement_factor(error, allowed, order); b.multiple > 0 && f > 1 && !refined;
           f /= 2)
        if (f * b.elements <= kMostElements) refined = with_elements(i, f * b.elements);
      if (refined) b = *refined;
    }
    out.changes = changes(finer, given_);
    out.mesh = !out.changes.empty();
    if (!out.mesh) out.exhausted = no_room();
  }

  std::string no_room() const {
    for (const BeamSetting& b : given_.beams)
      if (2 * b.elements > kMostElements)
        return fmt::format("beam {} has no room for twice its {} elements, {} is the most", b.name,
                           b.elements, kMostElements);
    return "no beam of the scene can have more elements";
  }

  void refine_step(const LargestError& error, double allowed, FinerModel& out) const {
    Setting finer = given_;
    const int factor = refinement_factor(error, allowed, kStepOrder);
    finer.steps *= factor;
    finer.record_every *= factor;
    const Changes step = changes(finer, given_);
    const std::string scenario = keeps_its_step(step);
    if (!scenario.empty()) {
      out.exhausted = scenario;
      return;
    }
    out.changes.insert(out.changes.end(), step.begin(), step.end());
    out.step = true;
  }

  /// The scenario that names a step of its own; empty: none.
  std::string keeps_its_step(const Changes& step) const {
    Changes all = before_;
    all.insert(all.end(), step.begin(), step.end());
    const Study finer = read_(all);
    for (std::size_t s = 0; s < study_.scenarios.size(); ++s)
      if (finer.scenarios[s].simulation.step == study_.scenarios[s].simulation.step)
        return fmt::format("scenario '{}' sets simulation.step itself",
                           study_.spec.scenarios[s + 1]);
    return finer.scene.simulation.step == study_.scene.simulation.step
               ? fmt::format("scenario '{}' sets simulation.step itself",
                             study_.spec.scenarios.front())
               : "";
  }

  const Study& study_;
  const Changes& before_;
  const ReadStudy& read_;
  const Setting given_;
};

}  // namespace

FinerModel finer_model(const Study& study, const std::vector<VerifiedLimit>& limits,
                       double feasibility, const Changes& before, const ReadStudy& read) {
  for (const VerifiedLimit& l : limits)
    if (l.joints > kShare * feasibility && !l.certain(feasibility))
      return {.exhausted = "penalties let the joints open: simulation.constraints = \"augmented\""};
  return FinerStudy(study, before, read)
      .model(largest_error(limits, feasibility, true), largest_error(limits, feasibility, false),
             kShare * feasibility);
}

std::string not_converging(const std::vector<VerifiedLimit>& before,
                           const std::vector<VerifiedLimit>& now, const FinerModel& refined,
                           double feasibility) {
  for (const VerifiedLimit& limit : now) {
    const auto old = std::find_if(before.begin(), before.end(),
                                  [&](const VerifiedLimit& l) { return l.name == limit.name; });
    if (old == before.end()) continue;
    for (const bool mesh : {true, false}) {
      if (!(mesh ? refined.mesh : refined.step)) continue;
      const double was = mesh ? old->mesh : old->step, is = mesh ? limit.mesh : limit.step;
      if (is <= kShare * feasibility || is <= kFalls * was || limit.certain(feasibility)) continue;
      const auto order = mesh ? limit.mesh_order : limit.step_order;
      return fmt::format(
          "limit {} does not converge: its error by the {} is {:.2g} %, was {:.2g} "
          "% before it was refined{}{}",
          limit.name, mesh ? "mesh" : "step", 100 * is, 100 * was,
          order ? fmt::format(", order {:.2g} observed", *order) : "", within_reach(is));
    }
  }
  return "";
}

}  // namespace liesl

#endif
