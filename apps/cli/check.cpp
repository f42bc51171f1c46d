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
namespace {

/// "1 body", "2 bodies".
std::string counted(std::size_t n, const char* one, const char* more) {
  return fmt::format("{} {}", n, n == 1 ? one : more);
}

}  // namespace

int check_command(const CommandOptions& options) {
  const FileKind kind = kind_of(load_document(options.file).root);
  if (kind == FileKind::Batch) {
    const Batch batch = load_batch(options.file, options.set);
    if (!options.quiet)
      fmt::print("{}: a good batch of {} of {}\n", options.file,
                 counted(batch.cases.rows.size(), "case", "cases"), batch.of.string());
    return 0;
  }
  if (kind == FileKind::Comparison) {
    const Comparison comparison = load_comparison(options.file, options.set);
    if (!options.quiet)
      fmt::print("{}: a good comparison of {} of {}\n", options.file,
                 counted(comparison.rows.cases.rows.size(), "row", "rows"),
                 comparison.rows.of.string());
    return 0;
  }
  if (kind == FileKind::Sensitivity) {
    const SensitivityFile file = load_sensitivity(options.file, options.set);
    const SensitivityProblem problem = scene_problem(file.scene, file.by);
    require_times(file.request.functionals, problem.scene.simulation.duration,
                  options.file + ": functionals =");
    if (!options.quiet)
      fmt::print("{}: a good sensitivity of {} by {} of {}\n", options.file,
                 counted(problem.scene.responses.size(), "response", "responses"),
                 counted(problem.parameters.size(), "parameter", "parameters"), file.scene.file);
    return 0;
  }
  const bool study = kind == FileKind::Study;
  const Scene scene =
      study ? load_study(options.file, options.set).scene : load_scene(options.file, options.set);
  const ChosenSpace space = choose_space(scene);
  if (!options.quiet)
    fmt::print("{}: a good {} of {} and {}; {}: {}\n", options.file, study ? "study" : "scene",
               counted(scene.mechanism.bodies.size(), "body", "bodies"),
               counted(scene.mechanism.joints.size(), "joint", "joints"), space.name, space.reason);
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
