#include <fmt/format.h>

#include "apps/cli/command.hpp"

#ifndef LIESL_OPTIM

#include "apps/output/io_error.hpp"

namespace liesl {

int esl_command(const CommandOptions& options) {
  throw output::IoError("extract loads of", options.file,
                        "this build has no load extraction; configure with -DLIESL_OPTIM=ON");
}

}  // namespace liesl

#else

#include "apps/cli/run_summary.hpp"
#include "apps/output/atomic_folder.hpp"
#include "apps/output/file.hpp"
#include "apps/output/hdf5_file.hpp"
#include "apps/output/write_results.hpp"
#include "esl/solid_loads.hpp"
#include "mbs/system/spatial_view.hpp"

namespace liesl {
namespace {

/// Loads of one part in space: load cases x nodes x 6, in the nodes' own axes.
template <FrameGroup G>
std::vector<double> in_space(const Mechanism& mechanism, const Model<G>& model,
                             const LoadSet& set) {
  const SpatialView<G> view(mechanism, model);
  std::vector<double> values;
  for (int n = 0; n < set.f.cols(); ++n)
    for (int k = 0; k < model.bodies[set.body]->nodes(); ++k) {
      const SE3::Tangent f =
          view.local(set.f.col(n).template segment<G::dim>(G::dim * k), set.body, k);
      values.insert(values.end(), f.data(), f.data() + 6);
    }
  return values;
}

/// Force and moment on each node of each part by time, as a table.
std::string loads_csv(const Mechanism& mechanism, const std::vector<LoadSet>& sets,
                      const std::vector<std::vector<double> >& values) {
  std::string text = "time [s],body,node,Fx [N],Fy [N],Fz [N],Mx [N m],My [N m],Mz [N m]\n";
  for (size_t i = 0; i < sets.size(); ++i) {
    const size_t nodes = values[i].size() / 6 / std::max<size_t>(1, sets[i].t.size());
    for (size_t n = 0; n < sets[i].t.size(); ++n)
      for (size_t k = 0; k < nodes; ++k) {
        text += fmt::format("{},{},{}", sets[i].t[n], mechanism.bodies[sets[i].body].name, k);
        for (int c = 0; c < 6; ++c) text += fmt::format(",{}", values[i][6 * (nodes * n + k) + c]);
        text += "\n";
      }
  }
  return text;
}

/// Loads of the meshed parts: what they are combined of, and the combinations by time.
template <FrameGroup G>
void write_solid_loads(const Mechanism& mechanism, const Model<G>& model,
                       const Trajectory<G>& trajectory, output::Hdf5File& file,
                       nlohmann::ordered_json& identity, bool quiet) {
  for (size_t b = 0; b < model.bodies.size(); ++b) {
    const auto* solid = std::get_if<SolidSpec>(&mechanism.bodies[b].kind);
    if (!solid || model.bodies[b]->nodes() == 1 || model.formalism == Formalism::Rigid) continue;
    const SolidLoadSet set = extract_solid_loads(model, trajectory, static_cast<int>(b));
    const std::string& body = model.bodies[b]->name;
    const auto write = [&](const std::string& name, const Eigen::MatrixXd& rows, const char* unit) {
      file.write(name, std::vector<double>(rows.data(), rows.data() + rows.size()),
                 {static_cast<hsize_t>(rows.cols()), static_cast<hsize_t>(rows.rows())});
      file.attribute(name, "unit", unit);
    };
    file.group("/loads/" + body);
    write("/loads/" + body + "/coordinates", set.e, "m, rad and amplitudes");
    write("/loads/" + body + "/shapes", set.shapes, "N, N m a unit of the coordinates");
    const Identity id = check_identity(*solid, set);
    identity[body] = {{"nonlinear", id.nonlinear}, {"linear", id.linear}, {"cases", id.cases}};
    if (!quiet)
      fmt::print("  {:<16} {} load cases of {} shapes; static = dynamic deformation: {:.1e}\n",
                 body, set.t.size(), set.e.rows(), id.linear);
  }
}

template <FrameGroup G>
int esl_on(const Scene& scene, const Space<G>& space, const CommandOptions& options,
           output::AtomicFolder& folder, output::RunSummary& summary) {
  Model<G> model = Model<G>::build(scene.mechanism, space);
  Simulation<G> simulation;
  {
    const bool dynamic = scene.simulation.type == SimulationType::Dynamic;
    output::Progress line("simulating",
                          dynamic ? scene.simulation.duration : scene.simulation.max_load,
                          dynamic ? "s" : "load", options.quiet);
    simulation = run_simulation(model, scene.simulation, watch(line));
  }
  describe(summary, simulation.report, simulation.start, scene.mechanism);
  const output::Results results = collect(scene, scene.mechanism, model, simulation.trajectory);
  describe_responses(summary, results);
  output::write_results(folder.path(), results);

  std::vector<LoadSet> sets;
  std::vector<std::vector<double> > values;
  output::Hdf5File file(folder.path() / "loads.h5");
  file.group("/loads");
  auto& identity = summary.more["identity"] = nlohmann::ordered_json::object();
  for (size_t b = 0; b < model.bodies.size(); ++b) {
    if (model.bodies[b]->elements() == 0) continue;
    sets.push_back(extract_loads(model, simulation.trajectory, static_cast<int>(b)));
    values.push_back(in_space(scene.mechanism, model, sets.back()));
    const std::string name = "/loads/" + model.bodies[b]->name;
    file.write(name, values.back(),
               {sets.back().t.size(), static_cast<hsize_t>(model.bodies[b]->nodes()), 6});
    file.attribute(name, "unit", "N, N m in the axes of the nodes");
    const Identity id = check_identity(model, simulation.trajectory, sets.back());
    identity[model.bodies[b]->name] = {
        {"nonlinear", id.nonlinear}, {"linear", id.linear}, {"cases", id.cases}};
    if (!options.quiet)
      fmt::print(
          "  {:<16} {} load cases; static = dynamic deformation: nonlinear {:.1e}, linear {:.1e}\n",
          model.bodies[b]->name, sets.back().t.size(), id.nonlinear, id.linear);
  }
  write_solid_loads(scene.mechanism, model, simulation.trajectory, file, identity, options.quiet);
  if (!results.times.empty()) file.write("/time", results.times, {results.times.size()});
  file.close();
  output::write_file(folder.path() / "loads.csv", loads_csv(scene.mechanism, sets, values));
  return exit_code(simulation.report.status);
}

}  // namespace

int esl_command(const CommandOptions& options) {
  const Stopwatch clock;
  const Scene scene = load_scene(options.file, options.set);
  const ChosenSpace space = choose_space(scene);
  output::AtomicFolder folder(options.out, options.force);
  output::RunSummary summary;
  summary.command = "esl";
  summary.overrides = options.set;
  describe(summary, scene, space);
  const int code = std::visit(
      [&](const auto& s) { return esl_on(scene, s, options, folder, summary); }, space.space);
  summary.wall_s = clock.seconds();
  output::write_summary(folder.path() / "summary.json", output::to_json(summary));
  folder.commit();
  print_figures(summary, options.out, options.quiet);
  return code;
}

}  // namespace liesl

#endif
