#include <fmt/format.h>

#include "apps/cli/command.hpp"

#ifndef LIESL_OPTIM

#include "apps/output/io_error.hpp"

namespace liesl {

int optimize_command(const CommandOptions& options) {
  throw output::without_optimisation("optimise", options.file);
}

}  // namespace liesl

#else

#include "apps/cli/checkpoint.hpp"
#include "apps/cli/optimize_terminal.hpp"
#include "apps/cli/result_files.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/input/problem.hpp"
#include "apps/output/atomic_folder.hpp"
#include "apps/output/file.hpp"
#include "apps/output/interrupt.hpp"
#include "apps/study/load_study.hpp"
#include "apps/tasks/run_summary.hpp"
#include "apps/tasks/sensitivity.hpp"
#include "optim/cycle/design_model.hpp"

namespace liesl {
namespace {

/// What the options of the command ask of a study.
void check_options(const Study& study, const CommandOptions& options) {
  const auto refuse = [&study](const char* what, const char* expected, const char* hint) {
    throw InputError({{study.file, 0, 0, what, expected, hint}});
  };
  if (options.nucleate > 0 && study.spec.shapes.empty())
    refuse("--nucleate: the study changes no outline", "a study with variables of a meshed part",
           "run without --nucleate");
}

/// The cycles of each model so far, and which one is the present one.
struct CyclesOfModels {
  ModelHistory all;
  std::size_t now = 0;
  RoundHistory& rounds() {
    if (all.size() <= now) all.resize(now + 1);
    return all[now];
  }
  /// Cycles of the models before the present one.
  int before() const {
    std::size_t count = 0;
    for (std::size_t m = 0; m < now; ++m)
      for (const History& round : all[m]) count += round.size();
    return static_cast<int>(count);
  }
};

/// Lines on the terminal, and a folder that is complete after every cycle.
OptimizeHooks hooks_of(const Study& study, const CommandOptions& options, const Stopwatch& clock,
                       output::AtomicFolder& folder, SimulationLine& line, CyclesOfModels& models) {
  OptimizeHooks hooks;
  hooks.progress = std::ref(line);
  hooks.keep_going = [] { return output::interrupted() == 0; };
  const auto save = [&clock, &folder](output::OptimizeSummary so_far) {
    so_far.wall_s = clock.seconds();
    output::write_summary(folder.path() / "summary.json", output::to_json(so_far));
    folder.commit();
  };
  hooks.on_cycle = [&study, &folder, &line, &options, &models, save](
                       const output::OptimizeSummary& so_far, const RoundHistory& rounds) {
    line.clear();
    Cycle cycle = rounds.back().back();
    cycle.number += models.before();
    print_cycle(cycle, study.spec.objective, options.quiet);
    models.rounds() = rounds;
    write_checkpoint(folder.path() / "checkpoint.json", models.all,
                     output::sha256(study.resumable));
    save(so_far);
  };
  hooks.on_hole = [&options](const std::string& feature, const Nucleus& n) {
    print_hole(feature, n, options.quiet);
  };
  hooks.on_box = [&options](const std::string& branch) {
    if (!options.quiet) fmt::print("      {}\n", branch);
  };
  return hooks;
}

/// Gradients of the motion's limits against differences, at the point where those of the static
/// problem were checked. True: right, or not to be judged.
bool check_motion_derivatives(const Study& study, const ChosenSpace& space,
                              const DerivativeReport& before) {
  fmt::print("\nthe motion{}: largest value of each response, by sensitivities\n",
             before.kinks.empty() ? "" : " at the same point");
  const auto design = std::make_shared<const Design>(study.spec, study.scene.mechanism);
  SensitivityCheck check;
  try {
    SensitivityRequest peaks;
    peaks.functionals = {{FunctionalKind::Peak, 0}};
    const Eigen::VectorXd x = before.kinks.empty() ? design->start() : before.x;
    check = sensitivity_check(study_problem(study, study.scene, design, x), space, peaks);
  } catch (const std::invalid_argument& error) {
    fmt::print("  not checked: {}\n", error.what());
    return true;
  }
  fmt::print("{}", check.text);
  return check.right;
}

/// Gradients of the limits of equilibria against differences. True: right, or not to be judged.
bool check_equilibrium_derivatives(const Study& study, const ChosenSpace& space) {
  fmt::print(
      "\nthe equilibria: each limit at the load step where it is largest, by sensitivities\n");
  try {
    const DerivativeReport report = equilibrium_derivatives_task(study, space);
    fmt::print("{}", report.text());
    return report.right;
  } catch (const std::invalid_argument& error) {
    fmt::print("  not checked: {}\n", error.what());
    return true;
  }
}

bool check_all_derivatives(const Study& study, const ChosenSpace& space) {
  fmt::print("the static problem of the start design\n");
  const DerivativeReport report = derivatives_task(study, space);
  fmt::print("{}", report.text());
  if (!study.spec.loads.empty()) return report.right;
  const bool right = study.scene.simulation.type == SimulationType::Static
                         ? check_equilibrium_derivatives(study, space)
                         : check_motion_derivatives(study, space, report);
  return report.right && right;
}

/// What stands between a study and its method, said at the study.
InputError no_method(const Study& study, const NoSensitivities& error) {
  if (!study.spec.loads.empty())
    return InputError(
        {{study.file, 0, 0, error.what(), "an objective that some of the loads make greater than 0",
          "other loads, or another objective"}});
  return InputError(
      {{study.file, 0, 0,
        "cycle.method needs sensitivities, which this motion has not: " + std::string(error.what()),
        "a motion with sensitivities, or \"esl\"", "leave cycle.method out"}});
}

/// Runs it. @throws InputError: there is no method for the study
VerifiedOptimum optimum_of(const Study& study, const CommandOptions& options,
                           const ChosenSpace& space, const output::OptimizeSummary& summary,
                           const OptimizeHooks& hooks, CyclesOfModels& models) {
  VerifiedOptions how;
  how.verify = !options.no_verify;
  how.refine = study.refine && options.nucleate == 0;
  how.nucleate = options.nucleate;
  how.read = [&options](std::vector<std::string> changes) {
    changes.insert(changes.begin(), options.set.begin(), options.set.end());
    return load_study(options.file, changes);
  };
  how.on_refinement = [&options, &models](const std::string& text) {
    ++models.now;
    if (!options.quiet) fmt::print("      {}\n", text);
  };
  const ModelHistory resume = models.all;
  try {
    return optimize_verified(study, space, summary, hooks, how, resume);
  } catch (const NoStaticsOfMechanism& error) {
    throw InputError({{study.file, 0, 0, error.what(), "", ""}});
  } catch (const NoSensitivities& error) {
    throw no_method(study, error);
  }
}

}  // namespace

int optimize_command(const CommandOptions& options) {
  const Stopwatch clock;
  const Study study = load_study(options.file, options.set);
  if (study.scene.simulation.type == SimulationType::Modes)
    throw InputError(
        {{study.scene.file, 0, 0, "simulation.type = \"modes\" has no loads to size a part for",
          "\"dynamic\" or \"static\"", ""}});
  const ChosenSpace space = choose_space(study.scene);
  if (options.check_derivatives) return check_all_derivatives(study, space) ? 0 : 1;
  check_options(study, options);
  output::OptimizeSummary summary;
  summary.command = "optimize";
  summary.overrides = options.set;
  describe(summary, study.scene, space);
  summary.name = study.spec.name;
  summary.input_sha256 = output::sha256(study.input);
  CyclesOfModels models;
  if (options.resume)
    models.all = read_checkpoint(std::filesystem::path(options.out) / "checkpoint.json",
                                 output::sha256(study.resumable));
  output::AtomicFolder folder(options.out, options.force || options.resume);
  SimulationLine line(study.scene.simulation, options.quiet);
  const OptimizeHooks hooks = hooks_of(study, options, clock, folder, line, models);
  VerifiedOptimum optimum = optimum_of(study, options, space, summary, hooks, models);
  OptimizeOutcome& out = optimum.out;
  line.clear();
  out.summary.more["input"] = options.file;
  out.summary.wall_s = clock.seconds();
  write_optimization(folder.path(), out, optimum.study);
  add_report(folder.path(), options);
  folder.commit();
  print_result(out.summary, options.out, options.quiet);
  if (!options.quiet && out.holes) print_holes(*out.holes, options.nucleate);
  return closed(out.status) ? 0 : 1;
}

}  // namespace liesl

#endif
