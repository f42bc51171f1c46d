#include "apps/tasks/sensitivity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/cli/load_sensitivity.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/input/document.hpp"
#include "apps/output/atomic_folder.hpp"
#include "apps/output/csv_writer.hpp"
#include "apps/output/file.hpp"
#include "apps/output/io_error.hpp"
#include "apps/output/plot_program.hpp"
#include "apps/study/load_study.hpp"

namespace liesl {
namespace {

constexpr std::size_t kShown = 8;  // parameters of a gradient on the terminal

struct Task {
  SensitivityProblem problem;
  SensitivityRequest request;
};

/// What is given on the command line goes before what a file says.
Task task_of(const CommandOptions& options) {
  const FileKind kind = kind_of(load_document(options.file).root);
  Task task;
  std::vector<std::string> by = options.by;
  if (kind == FileKind::Sensitivity) {
    const SensitivityFile file = load_sensitivity(options.file, options.set);
    task = {scene_problem(file.scene, by.empty() ? file.by : by), file.request};
    task.problem.scene.mechanism.name = file.name;
    task.problem.scene.input = file.input;
  } else if (kind == FileKind::Study) {
    if (!by.empty())
      throw InputError({{options.file, 0, 0, "--by: a study is differentiated by its variables",
                         "a scene", "liesl sensitivity SCENE --by KEY, or leave --by out"}});
    task.problem = study_problem(load_study(options.file, options.set));
  } else {
    task.problem =
        scene_problem({load_text(options.file, "a scene in TOML"), options.file, options.set}, by);
  }
  if (!options.functionals.empty() || task.request.functionals.empty())
    task.request.functionals = functionals_of(options.functionals, "--functionals");
  require_times(task.request.functionals, task.problem.scene.simulation.duration,
                options.functionals.empty() ? options.file + ": functionals =" : "--functionals");
  if (options.method != "auto") task.request.method = method_of(options.method);
  return task;
}

void print(const output::Sensitivities& s) {
  std::vector<std::size_t> order(s.parameters.size());
  for (const auto& g : s.gradients) {
    fmt::print("  {}, {}: {:.6g} {}{}\n", g.response, g.functional, g.value, g.unit,
               std::isfinite(g.at_time) ? fmt::format(" at {:.6g} s", g.at_time) : "");
    for (std::size_t p = 0; p < order.size(); ++p) order[p] = p;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return std::abs(output::relative(s, g, a)) > std::abs(output::relative(s, g, b));
    });
    for (std::size_t i = 0; i < std::min(kShown, order.size()); ++i)
      fmt::print("    by {:<28} {:>13.6g}   {:+.3g} % a per cent\n", s.parameters[order[i]].name,
                 g.by_parameter[order[i]], output::relative(s, g, order[i]));
    if (order.size() > kShown) fmt::print("    ... of {}: gradients.csv\n", order.size());
  }
}

/// Pictures; where they cannot be drawn, the tables are there nevertheless.
void draw(const CommandOptions& options) {
  try {
    output::draw(options.out, "", "");
  } catch (const output::IoError& error) {
    if (!options.quiet) fmt::print("  note: no picture: {}\n", error.what());
  }
}

}  // namespace

int sensitivity_command(const CommandOptions& options) {
  const Stopwatch clock;
  const auto [problem, request] = task_of(options);
  const ChosenSpace space = choose_space(problem.scene);
  if (options.check) {
    output::Progress line("checking", 100, "%", options.quiet);
    const SensitivityCheck check =
        sensitivity_check(problem, space, request,
                          {options.fits, [&line](double share) { line.update(100 * share); }});
    line.clear();
    if (!options.quiet || !check.right) fmt::print("{}", check.text);
    return check.right ? 0 : 1;
  }
  output::AtomicFolder folder(options.out, options.force);
  SimulationLine line(problem.scene.simulation, options.quiet);
  SensitivityOutcome out = sensitivity_task(problem, space, request, std::ref(line));
  line.clear();
  if (!out.result.gradients.empty()) {
    output::Results values;
    values.times = out.result.times;
    values.responses = out.result.responses;
    output::write_responses_csv(folder.path() / "responses.csv", values);
    output::write_gradients_csv(folder.path() / "gradients.csv", out.result);
    output::write_sensitivities_h5(folder.path() / "sensitivities.h5", out.result);
    if (!out.result.derivatives.empty())
      output::write_sensitivities_csv(folder.path() / "sensitivities.csv", out.result);
  }
  out.summary.overrides = options.set;
  out.summary.more["input"] = options.file;
  out.summary.wall_s = clock.seconds();
  output::write_summary(folder.path() / "summary.json", output::to_json(out.summary));
  folder.commit();
  const bool good = out.status == SolveStatus::Converged;
  if (good) draw(options);
  if (!options.quiet && good) print(out.result);
  print_figures(out.summary, options.out, options.quiet);
  return good ? 0 : 1;
}

}  // namespace liesl
