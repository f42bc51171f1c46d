#include "apps/scene/space.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "apps/input/problem.hpp"

namespace liesl {

namespace {

constexpr double kMostSteps = 1e8;
constexpr double kMostBytes = 8e9;  // of the records of a run

/// Refuses a simulation of more steps than anyone waits for, or than could be kept.
void check_size(const Scene& scene) {
  const SimulationOptions& o = scene.simulation;
  if (o.type == SimulationType::Modes) return;
  const bool motion = o.type == SimulationType::Dynamic;
  double nodes = 0;
  for (const auto& body : scene.mechanism.bodies) {
    const auto* beam = std::get_if<BeamSpec>(&body.kind);
    nodes += beam ? static_cast<double>(beam->nodes.size()) : 1;
  }
  const double steps = motion ? o.duration / o.step : o.load_steps,
               bytes = 8 * 60 * nodes * steps / (motion ? o.output_every : 1);
  if (steps > kMostSteps || bytes > kMostBytes)
    throw InputError(
        {{scene.file, 0, 0,
          fmt::format("simulation: {:.3g} steps of {:.0f} nodes, about {:.3g} GB", steps, nodes,
                      1e-9 * bytes),
          fmt::format("at most {:.0e} steps and {:.0f} GB", kMostSteps, 1e-9 * kMostBytes),
          motion ? "use a shorter duration, a larger step or a larger simulation.output_every"
                 : "use fewer simulation.load_steps"}});
}

/// Does the scene ask for motions that need not stay in the plane of its own? (A mesh in the plane
/// has none out of it.)
bool leaves_plane(const Scene& scene) {
  const SimulationOptions& o = scene.simulation;
  if (o.type == SimulationType::Dynamic || (o.type == SimulationType::Static && !o.critical))
    return false;
  const auto& bodies = scene.mechanism.bodies;
  return std::none_of(bodies.begin(), bodies.end(), [](const BodySpec& body) {
    const auto* solid = std::get_if<SolidSpec>(&body.kind);
    return solid && solid->mesh().dim == 2;
  });
}

}  // namespace

ChosenSpace choose_space(const Scene& scene) {
  check_size(scene);
  const SpaceChoice asked = scene.simulation.space;
  if (asked == SpaceChoice::Spatial) return {Space<SE3>(), "spatial", "the scene asks for it"};
  const PlaneSearch found = find_plane(scene.mechanism);
  if (found.plane && asked == SpaceChoice::Auto && leaves_plane(scene))
    return {
        Space<SE3>(), "spatial",
        fmt::format("{}, but {} may leave the plane: simulation.space = \"planar\" keeps them "
                    "in it",
                    found.reason,
                    scene.simulation.type == SimulationType::Modes ? "modes" : "critical loads")};
  if (found.plane) return {*found.plane, "planar", found.reason};
  if (asked == SpaceChoice::Planar)
    throw InputError(
        {{scene.file, 0, 0, "simulation.space = \"planar\", but " + found.reason,
          "a mechanism that is symmetric to a plane", "use space = \"auto\" or \"spatial\""}});
  return {Space<SE3>(), "spatial", found.reason};
}

}  // namespace liesl
