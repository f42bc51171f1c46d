#include "apps/tasks/verify.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "apps/input/problem.hpp"
#include "apps/scene/space.hpp"
#include "apps/tasks/error_estimate.hpp"
#include "apps/tasks/run.hpp"

namespace liesl {
namespace {

constexpr double kUnknown = 0.25;    // of an error, as it is an estimate
constexpr double kRounding = 1e-12;  // the same, of the largest response of its unit

using Figures = std::map<std::string, output::ResponseFigure>;  // by name
using Changes = FinerScenes::Changes;

/// The runs of one verification.
class Verification {
 public:
  Verification(const VerifiedScene& source, const Scene& scene, output::RunSummary& summary,
               const Progress& progress)
      : scenes_(source, scene, summary.space, summary.warnings),
        summary_(summary),
        progress_(progress) {
    for (const auto& r : summary.responses)
      largest_[r.unit] = std::max(largest_[r.unit], r.max_abs);
  }

  void run() {
    const Changes fine_mesh = scenes_.with_mesh(2), fine_step = scenes_.with_steps(2);
    by_mesh_ = {"mesh", double(scenes_.mesh_order()), !fine_mesh.empty(), {}, {}};
    by_step_ = {"step", kStepOrder, !fine_step.empty(), {}, {}};
    if (by_mesh_.asked) by_mesh_.finer = figures(fine_mesh, "the error of the mesh is not known");
    if (by_step_.asked) {
      by_step_.finer = figures(fine_step, "the error of the step is not known");
      if (!by_step_.finer.empty() && steps_ == summary_.steps) same_steps();
    }
    if (!by_mesh_.finer.empty() && scenes_.mesh_halves())
      by_mesh_.coarser = figures(scenes_.with_mesh(0.5), "the order of the mesh was not observed");
    if (!by_step_.finer.empty() && scenes_.steps_halve())
      by_step_.coarser = figures(scenes_.with_steps(0.5), "the order of the step was not observed");
    auto& json = summary_.more["verification"];
    json["runs"] = runs_ + 1;
    if (!scenes_.left_out().empty()) json["mesh"]["left_out"] = scenes_.left_out();
    for (const By& by : {by_mesh_, by_step_})
      if (by.asked) json[by.what]["order"] = by.order;
    for (auto& r : summary_.responses) set_errors(r);
  }

 private:
  /// One of mesh and step: is it asked for, and the figures of runs with half and twice of it.
  struct By {
    std::string what;
    double order = 2;
    bool asked = false;
    Figures finer, coarser;
  };

  /// Empty if the run does not reach its end, or the scene does not allow it (sections by element
  /// have no coarser mesh). @param otherwise what its end would have told
  Figures figures(const Changes& changed, const char* otherwise) {
    Scene scene;
    try {
      scene = scenes_.read(changed);
    } catch (const InputError&) {
      return {};
    }
    ++runs_;
    const RunOutcome out = run_task(scene, choose_space(scene), progress_);
    Figures found;
    if (out.status != SolveStatus::Converged) {
      summary_.warnings.push_back(fmt::format("{}: the run with {} did not reach its end: {}",
                                              otherwise, fmt::join(changed, ", "),
                                              out.summary.reason));
      return found;
    }
    for (const auto& r : out.summary.responses) found[r.name] = r;
    steps_ = out.summary.steps;
    return found;
  }

  /// Both runs had to halve theirs down to the same ones.
  void same_steps() {
    by_step_.finer.clear();
    summary_.warnings.push_back(
        fmt::format("the error of the step is not known: half of it takes the same {} steps, as "
                    "both were halved on the way; a smaller simulation.step has an error",
                    steps_));
  }

  void set_errors(output::ResponseFigure& r) {
    std::optional<ErrorEstimate> mesh = of_peak(r, by_mesh_);
    if (mesh && r.between > mesh->error) *mesh = {r.between, true};
    std::optional<ErrorEstimate> step = of_peak(r, by_step_);
    if (step && r.missed > step->error) *step = {r.missed, true};
    double total = 0;
    for (const auto& e : {mesh, step})
      if (e) total += e->below ? -e->error : e->error;
    if (mesh) r.error_mesh = mesh->error;
    if (step) r.error_step = step->error;
    const auto end_by_mesh = of_end(r, by_mesh_), end_by_step = of_end(r, by_step_);
    if (end_by_mesh) r.end_error_mesh = end_by_mesh->norm();
    if (end_by_step) r.end_error_step = end_by_step->norm();
    if (!(mesh || step) || mesh.has_value() != by_mesh_.asked ||
        step.has_value() != by_step_.asked || !scenes_.left_out().empty())
      return;
    r.error_total = together(std::abs(total), r.error_mesh, r.error_step);
    r.end_error_total = together(!end_by_step   ? *r.end_error_mesh
                                 : !end_by_mesh ? *r.end_error_step
                                                : (*end_by_mesh + *end_by_step).norm(),
                                 r.end_error_mesh, r.end_error_step);
  }

  /// Of two errors that cancel is left what they are not known to.
  static double together(double sum, std::optional<double> mesh, std::optional<double> step) {
    return std::max(sum, kUnknown * std::max(mesh.value_or(0), step.value_or(0)));
  }

  double resolution(const output::ResponseFigure& r) {
    return std::max(kResolution * r.max_abs, kRounding * largest_[r.unit]);
  }

  std::optional<ErrorEstimate> of_peak(const output::ResponseFigure& response, const By& by) {
    const std::string& name = response.name;
    if (!by.finer.contains(name)) return {};
    Refinement r{response.max_abs, by.finer.at(name).max_abs};
    if (by.coarser.contains(name)) r.coarser = by.coarser.at(name).max_abs;
    const ErrorEstimate e = estimate_error(r, by.order, resolution(response));
    if (e.observed) summary_.more["verification"][by.what]["observed"][name] = *e.observed;
    if (!e.as_expected) warn_of_order(name, by, *e.observed);
    return e;
  }

  /// Of the value at the end: along its change on the finer one, of the size that the sizes of the
  /// changes tell.
  std::optional<Eigen::VectorXd> of_end(const output::ResponseFigure& response, const By& by) {
    const std::string& name = response.name;
    const auto change = [&](const Figures& other) {
      using Values = Eigen::Map<const Eigen::VectorXd>;
      const std::vector<double>&end = other.at(name).final, &given = response.final;
      const auto n = static_cast<Eigen::Index>(std::min(end.size(), given.size()));
      return Eigen::VectorXd(Values(end.data(), n) - Values(given.data(), n));
    };
    if (!by.finer.contains(name)) return {};
    const Eigen::VectorXd fine = change(by.finer);
    Refinement r{0, fine.norm()};
    if (by.coarser.contains(name)) r.coarser = change(by.coarser).norm();
    const double error = estimate_error(r, by.order, resolution(response)).error;
    return Eigen::VectorXd(error * fine.normalized());
  }

  /// The given run has the error of its iterations, those of other steps have not.
  void warn_of_order(const std::string& name, const By& by, double observed) {
    const bool converges = observed >= kLeastOrder;
    summary_.warnings.push_back(fmt::format(
        "response {}: order {:.2g} of the {} observed, {:g} expected{}{}", name, observed, by.what,
        by.order,
        converges ? "" : ": it does not converge yet, and the error is the largest difference seen",
        converges || by.what == "mesh" || scenes_.iterated()
            ? ""
            : "; or simulation.tolerance hides it"));
  }

  FinerScenes scenes_;
  output::RunSummary& summary_;
  const Progress& progress_;
  std::map<std::string, double> largest_;  ///< by unit
  By by_mesh_, by_step_;
  int runs_ = 0;
  int steps_ = 0;  ///< of the last one
};

}  // namespace

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
