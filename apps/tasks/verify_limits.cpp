#ifdef LIESL_OPTIM

#include "apps/tasks/verify_limits.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "apps/scene/load_scene.hpp"
#include "apps/tasks/run.hpp"

namespace liesl {
namespace {

bool is_peak(const ConstraintSpec& c) {
  return c.treatment != Treatment::Functional && c.treatment != Treatment::PNorm;
}

/// Names that no response of the scene has.
std::vector<ResponseSpec> limited(const StudySpec& spec) {
  std::vector<ResponseSpec> out;
  for (const ConstraintSpec& c : spec.constraints)
    if (is_peak(c)) {
      out.push_back(c.response);
      out.back().name = "limit " + c.response.name;
    }
  return out;
}

}  // namespace

void verify_limits(const std::string& design, const Study& study, output::OptimizeSummary& summary,
                   const Progress& progress) {
  VerifiedScene source{design, "design.toml", {}, limited(study.spec)};
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
  double worst = 0;
  for (std::size_t i = 0; i < study.spec.constraints.size(); ++i) {
    const ConstraintSpec& c = study.spec.constraints[i];
    const auto& all = given.summary.responses;
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& r) {
      return r.name == "limit " + c.response.name;
    });
    if (found == all.end() || i >= summary.constraints.size()) continue;
    summary.constraints[i].error_mesh = found->error_mesh;
    summary.constraints[i].error_step = found->error_step;
    for (const auto& [part, known] : {std::pair("mesh", found->error_mesh.has_value()),
                                      std::pair("step", found->error_step.has_value())})
      if (!known)
        summary.warnings.push_back(
            fmt::format("limit {}: its error by the {} is not known", c.response.name, part));
    const double error = found->error_mesh.value_or(0) + found->error_step.value_or(0);
    worst = std::max(worst, error / c.limit);
    if (error > study.spec.cycle.feasibility * c.limit)
      summary.warnings.push_back(fmt::format(
          "limit {} is known to {:.2g} % only: mesh {:.2g} %, step {:.2g} %; beams of order = 4, "
          "more elements or a smaller step make it certain",
          c.response.name, 100 * error / c.limit, 100 * found->error_mesh.value_or(0) / c.limit,
          100 * found->error_step.value_or(0) / c.limit));
  }
  summary.more["verification"] = given.summary.more["verification"];
  summary.more["worst_constraint_error"] = worst;
  summary.warnings.insert(summary.warnings.end(), given.summary.warnings.begin(),
                          given.summary.warnings.end());
}

}  // namespace liesl

#endif
