#ifdef LIESL_OPTIM

#include "apps/tasks/esl.hpp"

#include <fmt/format.h>

#include "apps/input/problem.hpp"
#include "apps/tasks/collect.hpp"
#include "apps/tasks/describe_identity.hpp"
#include "apps/tasks/run_summary.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/volume_fraction.hpp"
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

template <FrameGroup G>
void beam_loads(const Scene& scene, const Model<G>& model, const Trajectory<G>& trajectory,
                EslOutcome& out) {
  for (size_t b = 0; b < model.bodies.size(); ++b) {
    if (model.bodies[b]->elements() == 0) continue;
    BeamLoads loads{model.bodies[b]->name,
                    model.bodies[b]->nodes(),
                    extract_loads(model, trajectory, static_cast<int>(b)),
                    {},
                    {}};
    loads.values = in_space(scene.mechanism, model, loads.set);
    loads.identity = check_identity(model, trajectory, loads.set);
    out.run.summary.more["identity"][loads.name] =
        describe_identity(loads.identity, loads.name, out.run.summary.warnings);
    out.beams.push_back(std::move(loads));
  }
}

template <FrameGroup G>
void solid_loads(const Scene& scene, const Model<G>& model, const Trajectory<G>& trajectory,
                 EslOutcome& out) {
  for (size_t b = 0; b < model.bodies.size(); ++b) {
    const auto* solid = std::get_if<SolidSpec>(&scene.mechanism.bodies[b].kind);
    if (!solid || model.bodies[b]->nodes() == 1 || model.formalism == Formalism::Rigid) continue;
    SolidLoads loads{
        model.bodies[b]->name, extract_solid_loads(model, trajectory, static_cast<int>(b)), {}};
    loads.identity = check_identity(*solid->model, solid_fractions(*solid).value, loads.set);
    out.run.summary.more["identity"][loads.name] =
        describe_identity(loads.identity, loads.name, out.run.summary.warnings);
    out.solids.push_back(std::move(loads));
  }
}

template <FrameGroup G>
void esl_on(const Scene& scene, const Space<G>& space, const Progress& progress,
            output::BodySink* sink, EslOutcome& out) {
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
  out.run.status = simulation.report.status;
  describe(out.run.summary, simulation.report, simulation.start, scene.mechanism,
           scene.simulation.type);
  out.run.status = describe_ranges(out.run.summary, scene.simulation, ranges, out.run.status);
  out.run.results = collect(scene, scene.mechanism, model, simulation.trajectory, &steps, sink);
  describe_responses(out.run.summary, out.run.results);
  out.run.status =
      describe_doubts(out.run.summary, scene, scene.mechanism, out.run.results, out.run.status);
  out.run.summary.more["identity"] = nlohmann::ordered_json::object();
  beam_loads(scene, model, simulation.trajectory, out);
  solid_loads(scene, model, simulation.trajectory, out);
}

}  // namespace

EslOutcome esl_task(const Scene& scene, const ChosenSpace& space, const Progress& progress,
                    output::BodySink* sink) {
  for (const BodySpec& body : scene.mechanism.bodies)
    if (const auto* solid = std::get_if<SolidSpec>(&body.kind);
        solid && solid->as == SolidMotion::Continuum)
      throw InputError({{scene.file, 0, 0,
                         fmt::format("part '{}' is a continuum: its load sets would be of a linear "
                                     "part",
                                     body.name),
                         fmt::format("bodies.{}.solid.as = \"reduced\"", body.name), ""}});
  EslOutcome out;
  out.run.summary.command = "esl";
  describe(out.run.summary, scene, space);
  std::visit([&](const auto& s) { esl_on(scene, s, progress, sink, out); }, space.space);
  return out;
}

}  // namespace liesl

#endif
