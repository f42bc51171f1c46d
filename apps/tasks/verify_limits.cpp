#ifdef LIESL_OPTIM

#include "apps/tasks/verify_limits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "apps/scene/load_scene.hpp"
#include "apps/tasks/run.hpp"
#include "optim/cycle/static_problem.hpp"

namespace liesl {
namespace {

/// Limits on the largest value of a response.
bool is_peak(const ConstraintSpec& c) {
  return !(c.weight > 0) && c.treatment != Treatment::Functional && c.treatment != Treatment::PNorm;
}

/// Under names that no response of the scene has.
std::vector<ResponseSpec> peaks(const StudySpec& spec) {
  std::vector<ResponseSpec> out;
  for (const ConstraintSpec& c : spec.constraints)
    if (is_peak(c)) {
      out.push_back(c.response);
      out.back().name = "limit " + c.response.name;
    }
  return out;
}

void name_what_is_left_out(const StudySpec& spec, std::vector<std::string>& warnings) {
  std::vector<std::string> names;
  for (const ConstraintSpec& c : spec.constraints)
    if (!is_peak(c) && !(c.weight > 0)) names.push_back(c.response.name);
  for (const FrequencyLimitSpec& f : spec.frequencies)
    if (!(f.weight > 0)) names.push_back(f.name);
  for (const PartLimitSpec& p : spec.part_limits) names.push_back(p.name);
  if (!names.empty())
    warnings.push_back(fmt::format("not verified, being no largest value of a response: limit {}",
                                   fmt::join(names, ", ")));
  if (spec.scenarios.size() > 1)
    warnings.push_back(fmt::format("verified in the scenario '{}' alone", spec.scenarios.front()));
}

/// The final design, run as a scene on finer meshes and steps.
struct Errors {
  const StudySpec& spec;
  output::OptimizeSummary& summary;
  double worst = 0;  ///< of all limits, of each

  void take(std::size_t i, const output::ResponseFigure& found) {
    const ConstraintSpec& c = spec.constraints[i];
    const std::string name = limit_name(spec, {static_cast<int>(i), c.response, 0});
    auto& all = summary.constraints;
    const auto limit =
        std::find_if(all.begin(), all.end(), [&](const auto& l) { return l.name == name; });
    if (limit == all.end()) return;
    limit->error_mesh = found.error_mesh;
    limit->error_step = found.error_step;
    for (const auto& [part, known] : {std::pair("mesh", found.error_mesh.has_value()),
                                      std::pair("step", found.error_step.has_value())})
      if (!known)
        summary.warnings.push_back(
            fmt::format("limit {}: its error by the {} is not known", name, part));
    const double mesh = 100 * found.error_mesh.value_or(0) / c.limit,
                 step = 100 * found.error_step.value_or(0) / c.limit, error = mesh + step;
    worst = std::max(worst, error / 100);
    if (error > 100 * spec.cycle.feasibility)
      summary.warnings.push_back(fmt::format(
          "limit {} is known to {:.2g} % only: mesh {:.2g} %, step {:.2g} %; beams of order = 4, "
          "more elements or a smaller step make it certain",
          name, error, mesh, step));
  }
};

}  // namespace

void verify_limits(const std::string& design, const Study& study, output::OptimizeSummary& summary,
                   const Progress& progress) {
  const StudySpec& spec = study.spec;
  name_what_is_left_out(spec, summary.warnings);
  VerifiedScene source{design, "design.toml", {}, peaks(spec)};
  if (source.responses.empty()) return;
  Scene scene = read_scene(design, source.file, {});
  scene.responses = source.responses;
  RunOutcome given = run_task(scene, choose_space(scene), progress);
  if (given.status != SolveStatus::Converged) {
    summary.warnings.push_back("the limits were not verified: " + given.summary.reason);
    return;
  }
  given.summary.warnings.clear();
  verify(source, scene, given.summary, progress);
  Errors errors{spec, summary};
  for (std::size_t i = 0; i < spec.constraints.size(); ++i)
    for (const auto& found : given.summary.responses)
      if (found.name == "limit " + spec.constraints[i].response.name) errors.take(i, found);
  summary.more["verification"] = given.summary.more["verification"];
  summary.more["worst_constraint_error"] = errors.worst;
  summary.warnings.insert(summary.warnings.end(), given.summary.warnings.begin(),
                          given.summary.warnings.end());
}

}  // namespace liesl

#endif
