#include <fmt/format.h>

#include <cmath>

#include "apps/cli/command.hpp"

#ifndef LIESL_OPTIM

#include "apps/output/io_error.hpp"

namespace liesl {

int esl_command(const CommandOptions& options) {
  throw output::without_optimisation("extract loads of", options.file);
}

}  // namespace liesl

#else

#include "apps/cli/terminal.hpp"
#include "apps/output/atomic_folder.hpp"
#include "apps/output/file.hpp"
#include "apps/output/hdf5_file.hpp"
#include "apps/output/write_results.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/tasks/describe_identity.hpp"
#include "apps/tasks/esl.hpp"

namespace liesl {
namespace {

/// Force and moment on each node of each part by time, as a table.
std::string loads_csv(const std::vector<BeamLoads>& beams, const output::Results& results) {
  std::string text = results.abscissa + " [" + results.abscissa_unit +
                     "],body,node,Fx [N],Fy [N],Fz [N],Mx [N m],My [N m],Mz [N m]\n";
  for (const BeamLoads& beam : beams) {
    const size_t nodes = beam.values.size() / 6 / std::max<size_t>(1, beam.set.t.size());
    for (size_t n = 0; n < beam.set.t.size(); ++n)
      for (size_t k = 0; k < nodes; ++k) {
        text += fmt::format("{},{},{}", beam.set.t[n], beam.name, k);
        for (size_t c = 0; c < 6; ++c)
          text += fmt::format(",{}", beam.values[6 * (nodes * n + k) + c]);
        text += "\n";
      }
  }
  return text;
}

void write(output::Hdf5File& file, const BeamLoads& beam) {
  const std::string name = "/loads/" + beam.name;
  file.write(name, beam.values, {beam.set.t.size(), static_cast<hsize_t>(beam.nodes), 6});
  file.attribute(name, "unit", "N, N m in the axes of the nodes");
}

/// What the loads of a meshed part are combined of, and the combinations by time.
void write(output::Hdf5File& file, const SolidLoads& solid) {
  const auto rows = [&](const char* what, const Eigen::MatrixXd& m, const char* unit) {
    const std::string name = "/loads/" + solid.name + "/" + what;
    file.write(name, std::vector<double>(m.data(), m.data() + m.size()),
               {static_cast<hsize_t>(m.cols()), static_cast<hsize_t>(m.rows())});
    file.attribute(name, "unit", unit);
  };
  file.group("/loads/" + solid.name);
  rows("coordinates", solid.set.e, "m, rad and amplitudes");
  rows("shapes", solid.set.shapes, "N, N m a unit of the coordinates");
}

std::string percent_text(double difference) {
  return std::isfinite(difference) ? size_percent(difference) : "no solution";
}

void print(const EslOutcome& out) {
  constexpr double kLinear = 0.02;  // more shows in a deflection
  const auto cases = [](std::size_t n) {
    return fmt::format("{} load case{}", n, n == 1 ? "" : "s");
  };
  for (const BeamLoads& beam : out.beams) {
    fmt::print(
        "  {:<16} {}; difference of the strains under them, of the largest: {}, of a linear static "
        "problem {}\n",
        beam.name, cases(beam.set.t.size()), percent_text(beam.identity.nonlinear),
        percent_text(beam.identity.linear));
    if (beam.identity.linear > kLinear)
      fmt::print(
          "  {:<16} (an axial force changes the bending of a slender part, which linear problems "
          "leave out)\n",
          "");
  }
  for (const SolidLoads& solid : out.solids)
    fmt::print(
        "  {:<16} {} of {} shapes; difference of the displacements under them, of the largest: "
        "{}\n",
        solid.name, cases(solid.set.t.size()), solid.set.e.rows(),
        percent_text(solid.identity.linear));
}

}  // namespace

int esl_command(const CommandOptions& options) {
  const Stopwatch clock;
  const Scene scene = load_scene(options.file, options.set);
  const ChosenSpace space = choose_space(scene);
  output::AtomicFolder folder(options.out, options.force);
  SimulationLine line(scene.simulation, options.quiet);
  output::Hdf5Writer numbers(folder.path() / "results.h5");
  EslOutcome out = esl_task(scene, space, std::ref(line), &numbers);
  line.clear();
  const std::vector<double>& times = out.run.results.times;
  output::write_results(folder.path(), out.run.results, &numbers);
  output::Hdf5File file(folder.path() / "loads.h5");
  file.group("/loads");
  for (const BeamLoads& beam : out.beams) write(file, beam);
  for (const SolidLoads& solid : out.solids) write(file, solid);
  if (!times.empty()) file.write("/time", times, {times.size()});
  file.close();
  output::write_file(folder.path() / "loads.csv", loads_csv(out.beams, out.run.results));
  if (!options.quiet) print(out);
  out.run.summary.overrides = options.set;
  out.run.summary.more["input"] = options.file;
  out.run.summary.wall_s = clock.seconds();
  output::write_summary(folder.path() / "summary.json", output::to_json(out.run.summary));
  folder.commit();
  print_figures(out.run.summary, options.out, options.quiet);
  return out.run.status == SolveStatus::Converged ? 0 : 1;
}

}  // namespace liesl

#endif
