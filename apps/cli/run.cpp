#include "apps/tasks/run.hpp"

#include "apps/cli/result_files.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/input/document.hpp"
#include "apps/output/atomic_folder.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/tasks/verify.hpp"

namespace liesl {

int run_command(const CommandOptions& options) {
  const Stopwatch clock;
  const Scene scene = load_scene(options.file, options.set);
  if (options.verify) check_verifiable(scene.simulation);
  const ChosenSpace space = choose_space(scene);
  output::AtomicFolder folder(options.out, options.force);
  SimulationLine line(scene.simulation, options.quiet);
  output::Hdf5Writer numbers(folder.path() / "results.h5");
  RunOutcome out = run_task(scene, space, std::ref(line), &numbers);
  if (options.verify && out.status == SolveStatus::Converged)
    verify({load_document(options.file).text, options.file, options.set}, scene, out.summary,
           std::ref(line));
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
