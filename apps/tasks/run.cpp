#include "apps/tasks/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <future>

#include "apps/tasks/collect.hpp"
#include "apps/tasks/collect_reference.hpp"
#include "apps/tasks/mode_values.hpp"
#include "apps/tasks/motion_notes.hpp"
#include "apps/tasks/part_summary.hpp"
#include "apps/tasks/run_summary.hpp"
#include "mbs/bodies/continuum.hpp"
#include "mbs/bodies/solid_body.hpp"
#include "mbs/linalg/stop_request.hpp"
#include "mbs/solvers/modes.hpp"
#include "mbs/system/constraint_rank.hpp"

namespace liesl {
namespace {

/// The state moved by so much of a shape: frames in their axes, amplitudes.
template <FrameGroup G>
void move(const Model<G>& model, const Eigen::VectorXd& shape, double size, State<G>& s) {
  model.retract(s, size * shape);
  model.complete(s);
}

/// Of nodes, those of meshes among them: the largest components of displacements and turns.
struct LargestMove {
  double displacement = 1e-300, turn = 1e-300;  ///< m, rad

  /// A size of the shape that is seen and still like it, whatever the unit of length.
  double size(double length) const {
    constexpr double kSeen = 0.1, kMostTurn = 0.25;  // of the length, rad
    return std::min(kSeen * length / displacement, kMostTurn / turn);
  }
};

template <FrameGroup G>
LargestMove largest_move(const Model<G>& model, const Eigen::VectorXd& shape) {
  LargestMove largest;
  for (size_t b = 0; b < model.bodies.size(); ++b) {
    const int first = model.first_node(static_cast<int>(b));
    const Body<G>& moved = *model.bodies[b];
    const int nodes = ContinuumBody<G>::of(moved) ? moved.nodes() : moved.points();
    const auto frames = shape.segment(G::dim * first, G::dim * nodes).reshaped(G::dim, nodes);
    const auto add = [](double& most, const auto& moves) {
      if (moves.size() > 0) most = std::max(most, moves.cwiseAbs().maxCoeff());
    };
    add(largest.displacement, frames.template topRows<G::space_dim>());
    add(largest.turn, frames.template bottomRows<G::rotation_dim>());
    const auto* body = SolidBody<G>::of(*model.bodies[b]);
    if (!body) continue;
    constexpr double kLittle = 1e-6;  // of the shape: its derivative at rest
    State<G> s = model.initial_state();
    move(model, shape, kLittle / std::max(shape.cwiseAbs().maxCoeff(), 1e-300), s);
    const Eigen::VectorXd e =
        body->coordinates({s.H.data() + first, nullptr, nullptr, s.w.data() + G::dim * first});
    add(largest.displacement, body->basis() * e * (shape.cwiseAbs().maxCoeff() / kLittle));
  }
  return largest;
}

/// The shapes in the sizes in which they are shown.
template <FrameGroup G>
Eigen::MatrixXd shown_shapes(const Model<G>& model, Eigen::MatrixXd shapes) {
  for (auto shape : shapes.colwise()) shape *= largest_move<G>(model, shape).size(model.length);
  return shapes;
}

/// Warns of meshed parts whose own modes are too few for the frequencies of the scene.
void warn_beyond_parts(output::RunSummary& summary, double highest) {
  if (summary.more.contains("parts"))
    for (const auto& [name, part] : summary.more["parts"].items())
      if (const double limit = part["right_up_to_hz"]; limit < highest)
        summary.warnings.push_back(
            fmt::format("the modes of '{}' are accurate up to {:.4g} Hz only, below the highest "
                        "frequency asked for: more bodies.{}.solid.modes",
                        name, limit, name));
}

/// Frequencies and shapes: the shapes become records, abscissa = frequency.
template <FrameGroup G>
void run_modes(const Scene& scene, const Space<G>& space, RunOutcome& out) {
  Model<G> model = Model<G>::build(scene.mechanism, space);
  const ModesResult<G> modes = solve_modes(model, scene.simulation);
  out.status = modes.report.status;
  describe(out.summary, modes.report, modes.start, scene.mechanism, scene.simulation.type);
  out.summary.more["frequencies_hz"] = modes.frequency;
  out.summary.more["eigenvalues"] = modes.eigenvalue;
  if (modes.report.status != SolveStatus::Converged) return;
  out.summary.reason = fmt::format("{} mode{} found", modes.frequency.size(),
                                   modes.frequency.size() == 1 ? "" : "s");
  PartRanges<G> ranges(scene.mechanism, model);
  State<G> rest = modes.equilibrium;
  model.complete(rest);
  ranges.add(rest);
  out.status = describe_ranges(out.summary, scene.simulation, ranges, out.status);
  describe_parts(out.summary, scene.mechanism, model, Trajectory<G>(), false);
  warn_beyond_parts(out.summary, modes.frequency.empty() ? 0 : modes.frequency.back());
  Trajectory<G> shapes;
  const Eigen::MatrixXd shown = shown_shapes(model, modes.shapes);
  for (size_t m = 0; m < modes.frequency.size(); ++m) {
    State<G> s = modes.equilibrium;
    move<G>(model, shown.col(static_cast<int>(m)), 1, s);
    s.t = modes.frequency[m];
    s.lambda.setZero();
    shapes.record(s);
  }
  out.results = collect(scene, scene.mechanism, model, shapes);
  set_mode_values(scene, model, rest, shown, out.results);
  add_reference(scene.mechanism, model, modes.equilibrium, out.results);
  out.results.abscissa = "frequency";
  out.results.abscissa_unit = "Hz";
}

/// Drives that the other joints and drives leave no room for, at the start and at the end.
template <FrameGroup G>
void warn_overdriven(output::RunSummary& summary, const Model<G>& model, const Mobility& at_start,
                     const Trajectory<G>& trajectory) {
  State<G> end = model.initial_state();
  trajectory.read(trajectory.size() - 1, end);
  const Mobility at_end = mobility(model, end);
  for (const auto& name : at_start.overdriven)
    if (std::find(at_end.overdriven.begin(), at_end.overdriven.end(), name) !=
        at_end.overdriven.end())
      summary.warnings.push_back(fmt::format(
          "the drive of '{}' repeats other joints and drives: rigid bodies could not follow it, "
          "the flexible ones are forced to; take one drive out, or check the axes of the joints",
          name));
}

template <FrameGroup G>
void run_on(const Scene& scene, const Space<G>& space, const Progress& progress,
            output::BodySink* sink, RunOutcome& out) {
  if (scene.simulation.type == SimulationType::Modes) return run_modes(scene, space, out);
  Model<G> model = Model<G>::build(scene.mechanism, space);
  StepRecorder<G> steps(scene, scene.mechanism, model);
  PartRanges<G> ranges(scene.mechanism, model);
  const auto observe = [&](const State<G>& s, bool recorded) {
    steps(s, recorded);
    ranges.add(s);
  };
  const Simulation<G> simulation =
      run_simulation<G>(model, scene.simulation, progress, nullptr, observe);
  if (scene.simulation.type == SimulationType::Static) ranges.add(simulation.trajectory);
  out.status = simulation.report.status;
  describe(out.summary, simulation.report, simulation.start, scene.mechanism,
           scene.simulation.type);
  out.status = describe_ranges(out.summary, scene.simulation, ranges, out.status);
  describe_parts(out.summary, scene.mechanism, model, simulation.trajectory,
                 scene.simulation.type == SimulationType::Dynamic);
  const Unstopped written;  // what the motion has
  const Mobility m = mobility(model, model.initial_state());
  out.summary.more["mobility"] = m.free;
  out.summary.more["redundant_if_rigid"] = m.redundant;
  if (simulation.trajectory.size() > 1)
    warn_overdriven(out.summary, model, m, simulation.trajectory);
  if (!simulation.critical.empty()) {
    auto& list = out.summary.more["critical_loads"] = nlohmann::ordered_json::array();
    for (const auto& c : simulation.critical)
      list.push_back({{"load", c.load},
                      {"before", c.before},
                      {"after", c.after},
                      {"limit_point", c.limit_point}});
  }
  auto leaving = std::async([&] {
    const Unstopped whole;
    return leaving_plane(scene, model, simulation.trajectory);
  });
  out.results = collect(scene, scene.mechanism, model, simulation.trajectory, &steps, sink);
  describe_responses(out.summary, out.results);
  for (auto notes : {leaving.get(), struck_start(scene, model, simulation.trajectory, out.results)})
    out.summary.warnings.insert(out.summary.warnings.end(), notes.begin(), notes.end());
  out.status = describe_doubts(out.summary, scene, scene.mechanism, out.results, out.status);
}

}  // namespace

RunOutcome run_task(const Scene& scene, const ChosenSpace& space, const Progress& progress,
                    output::BodySink* sink) {
  RunOutcome out;
  describe(out.summary, scene, space);
  std::visit([&](const auto& s) { run_on(scene, s, progress, sink, out); }, space.space);
  return out;
}

}  // namespace liesl
