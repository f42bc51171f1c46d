#include <fmt/format.h>

#include "apps/cli/part_summary.hpp"
#include "apps/cli/run_summary.hpp"
#include "apps/output/atomic_folder.hpp"
#include "apps/output/write_results.hpp"
#include "mbs/bodies/solid_body.hpp"
#include "mbs/solvers/modes.hpp"
#include "mbs/system/constraint_rank.hpp"

namespace liesl {
namespace {

double end_of(const SimulationOptions& o) {
  return o.type == SimulationType::Dynamic ? o.duration : o.max_load;
}

/// The state moved by so much of a shape: frames in their axes, amplitudes.
template <FrameGroup G>
void move(const Model<G>& model, const Eigen::VectorXd& shape, double size, State<G>& s) {
  model.retract(s, size * shape);
  model.complete(s);
}

/// The largest component of the displacements and turns of nodes, those of meshes among them.
template <FrameGroup G>
double largest_move(const Model<G>& model, const Eigen::VectorXd& shape) {
  double largest = 0;
  for (size_t b = 0; b < model.bodies.size(); ++b) {
    const int first = model.first_node(static_cast<int>(b));
    const auto frames = shape.segment(G::dim * first, G::dim * model.bodies[b]->points());
    largest = std::max(largest, frames.cwiseAbs().maxCoeff());
    const auto* body = dynamic_cast<const SolidBody<G>*>(model.bodies[b].get());
    if (!body) continue;
    constexpr double kLittle = 1e-6;  // of the shape: its derivative at rest
    State<G> s = model.initial_state();
    move(model, shape, kLittle / std::max(shape.cwiseAbs().maxCoeff(), 1e-300), s);
    const Eigen::VectorXd e =
        body->coordinates({s.H.data() + first, nullptr, nullptr, s.w.data() + G::dim * first});
    largest = std::max(
        largest, (body->basis() * e).cwiseAbs().maxCoeff() * shape.cwiseAbs().maxCoeff() / kLittle);
  }
  return largest;
}

/// Are the modes of the scene within reach of those of its meshed parts?
void warn_beyond_parts(output::RunSummary& summary, double highest) {
  if (summary.more.contains("parts"))
    for (const auto& [name, part] : summary.more["parts"].items())
      if (const double reach = part["right_up_to_hz"]; reach < highest)
        summary.warnings.push_back(
            fmt::format("the modes of '{}' are right up to {:.4g} Hz only, below the highest "
                        "frequency asked for: more bodies.{}.solid.modes",
                        name, reach, name));
}

/// Frequencies and shapes: the shapes become records, abscissa = frequency.
template <FrameGroup G>
int run_modes(const Scene& scene, const Space<G>& space, output::RunSummary& summary,
              output::Results& results) {
  Model<G> model = Model<G>::build(scene.mechanism, space);
  const ModesResult<G> modes = solve_modes(model, scene.simulation);
  describe(summary, modes.report, modes.start, scene.mechanism);
  summary.more["frequencies_hz"] = modes.frequency;
  summary.more["eigenvalues"] = modes.eigenvalue;
  if (modes.report.status != SolveStatus::Converged) return 1;
  describe_parts(summary, scene.mechanism, model, Trajectory<G>(), false);
  warn_beyond_parts(summary, modes.frequency.empty() ? 0 : modes.frequency.back());
  Trajectory<G> shapes;
  for (size_t m = 0; m < modes.frequency.size(); ++m) {
    State<G> s = modes.equilibrium;
    const Eigen::VectorXd shape = modes.shapes.col(static_cast<int>(m));
    move(model, shape, 0.1 * model.length / std::max(largest_move(model, shape), 1e-300), s);
    s.t = modes.frequency[m];
    s.lambda.setZero();
    shapes.record(s);
  }
  results = collect(scene, scene.mechanism, model, shapes);
  results.abscissa = "frequency";
  results.abscissa_unit = "Hz";
  return 0;
}

template <FrameGroup G>
int run_scene(const Scene& scene, const Space<G>& space, bool quiet, output::RunSummary& summary,
              output::Results& results) {
  if (scene.simulation.type == SimulationType::Modes)
    return run_modes(scene, space, summary, results);
  Model<G> model = Model<G>::build(scene.mechanism, space);
  Simulation<G> simulation;
  {
    output::Progress line("simulating", end_of(scene.simulation),
                          scene.simulation.type == SimulationType::Dynamic ? "s" : "load", quiet);
    simulation = run_simulation(model, scene.simulation, watch(line));
  }
  describe(summary, simulation.report, simulation.start, scene.mechanism);
  describe_parts(summary, scene.mechanism, model, simulation.trajectory,
                 scene.simulation.type == SimulationType::Dynamic);
  State<G> start = model.initial_state();
  const Mobility m = mobility(model, start);
  summary.more["mobility"] = m.free;
  summary.more["redundant_if_rigid"] = m.redundant;
  if (!simulation.critical.empty()) {
    auto& list = summary.more["critical_loads"] = nlohmann::ordered_json::array();
    for (const auto& c : simulation.critical)
      list.push_back({{"load", c.load},
                      {"before", c.before},
                      {"after", c.after},
                      {"limit_point", c.limit_point}});
  }
  results = collect(scene, scene.mechanism, model, simulation.trajectory);
  describe_responses(summary, results);
  describe_energy(summary, results);
  return exit_code(simulation.report.status);
}

}  // namespace

int run_command(const CommandOptions& options) {
  const Stopwatch watch_all;
  const Scene scene = load_scene(options.file, options.set);
  const ChosenSpace space = choose_space(scene);
  output::AtomicFolder folder(options.out, options.force);
  output::RunSummary summary;
  summary.overrides = options.set;
  describe(summary, scene, space);
  output::Results results;
  const int code = std::visit(
      [&](const auto& s) { return run_scene(scene, s, options.quiet, summary, results); },
      space.space);
  if (!results.times.empty()) output::write_results(folder.path(), results);
  summary.wall_s = watch_all.seconds();
  output::write_summary(folder.path() / "summary.json", output::to_json(summary));
  folder.commit();
  print_figures(summary, options.out, options.quiet);
  return code;
}

}  // namespace liesl
