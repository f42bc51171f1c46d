#include <fmt/format.h>

#include "apps/batch/batch.hpp"
#include "apps/cli/command.hpp"
#include "apps/cli/load_sensitivity.hpp"
#include "apps/compare/comparison.hpp"
#include "apps/input/document.hpp"
#include "apps/input/problem.hpp"
#include "apps/output/plot_program.hpp"
#include "apps/output/result_summary.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/study/load_study.hpp"
#include "apps/tasks/sensitivity.hpp"

namespace liesl {

int check_command(const CommandOptions& options) {
  const FileKind kind = kind_of(load_document(options.file).root);
  if (kind == FileKind::Batch) {
    const Batch batch = load_batch(options.file, options.set);
    if (!options.quiet)
      fmt::print("{}: a good batch of {} cases of {}\n", options.file, batch.cases.rows.size(),
                 batch.of.string());
    return 0;
  }
  if (kind == FileKind::Comparison) {
    const Comparison comparison = load_comparison(options.file, options.set);
    if (!options.quiet)
      fmt::print("{}: a good comparison of {} rows of {}\n", options.file,
                 comparison.rows.cases.rows.size(), comparison.rows.of.string());
    return 0;
  }
  if (kind == FileKind::Sensitivity) {
    const SensitivityFile file = load_sensitivity(options.file, options.set);
    const SensitivityProblem problem = scene_problem(file.scene, file.by);
    require_times(file.request.functionals, problem.scene.simulation.duration,
                  options.file + ": functionals =");
    if (!options.quiet)
      fmt::print("{}: a good sensitivity of {} responses by {} parameters of {}\n", options.file,
                 problem.scene.responses.size(), problem.parameters.size(), file.scene.file);
    return 0;
  }
  const bool study = kind == FileKind::Study;
  const Scene scene =
      study ? load_study(options.file, options.set).scene : load_scene(options.file, options.set);
  const ChosenSpace space = choose_space(scene);
  if (!options.quiet)
    fmt::print("{}: a good {} of {} bodies and {} joints; {}: {}\n", options.file,
               study ? "study" : "scene", scene.mechanism.bodies.size(),
               scene.mechanism.joints.size(), space.name, space.reason);
  for (const auto& warning : scene.warnings)
    if (!options.quiet) fmt::print("  note: {}\n", warning);
  return 0;
}

int plot_command(const CommandOptions& options) {
  output::read_whole_summary(options.file, "plot");
  for (const auto& picture : output::draw(options.file, options.x, options.y))
    if (!options.quiet) fmt::print("{}\n", picture.string());
  return 0;
}

}  // namespace liesl
