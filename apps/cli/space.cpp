#include <fmt/format.h>

#include "apps/cli/command.hpp"
#include "apps/scene/problem.hpp"

namespace liesl {

ChosenSpace choose_space(const Scene& scene) {
  const SpaceChoice asked = scene.simulation.space;
  if (asked == SpaceChoice::Spatial) return {Space<SE3>(), "spatial", "the scene asks for it"};
  const PlaneSearch found = find_plane(scene.mechanism);
  if (found.plane) return {*found.plane, "planar", found.reason};
  if (asked == SpaceChoice::Planar)
    throw InputError(
        {{scene.file, 0, 0, "simulation.space = \"planar\", but " + found.reason,
          "a mechanism that is symmetric to a plane", "use space = \"auto\" or \"spatial\""}});
  return {Space<SE3>(), "spatial", found.reason};
}

}  // namespace liesl
