#include "apps/tasks/run.hpp"

#include "apps/cli/result_files.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/input/document.hpp"
#include "apps/output/atomic_folder.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/tasks/verify.hpp"

namespace liesl {
namespace {

/// Of a run that reached its end, of what it was asked for.
void add_errors(const CommandOptions& options, const Scene& scene, const Progress& progress,
                RunOutcome& out) {
  std::string why;
  if (out.status != SolveStatus::Converged)
    why = "the run ended with status '" + out.summary.status + "'";
  else if (scene.responses.empty())
    why = "the scene asks for no responses";
  if (why.empty())
    verify({load_document(options.file).text, options.file, options.set}, scene, out.summary,
           progress);
  else
    out.summary.warnings.push_back("not verified: " + why);
}

}  // namespace

int run_command(const CommandOptions& options) {
  const Stopwatch clock;
  const Scene scene = load_scene(options.file, options.set);
  if (options.verify) check_verifiable(scene.simulation);
  const ChosenSpace space = choose_space(scene);
  output::AtomicFolder folder(options.out, options.force);
  SimulationLine line(scene.simulation, options.quiet);
  output::Hdf5Writer numbers(folder.path() / "results.h5");
  RunOutcome out = run_task(scene, space, std::ref(line), &numbers);
  if (options.verify) add_errors(options, scene, std::ref(line), out);
  line.clear();
  out.summary.overrides = options.set;
  out.summary.more["input"] = options.file;
  out.summary.wall_s = clock.seconds();
  write_run(folder.path(), out, &numbers);
  add_report(folder.path(), options);
  folder.commit();
  print_figures(out.summary, options.out, options.quiet);
  return out.status == SolveStatus::Converged ? 0 : 1;
}

}  // namespace liesl
