#pragma once
/// @file
/// What a motion that was computed should make a user look twice at.

#include <string>
#include <vector>

#include "apps/output/results.hpp"
#include "apps/scene/space.hpp"
#include "mbs/solvers/simulation.hpp"

namespace liesl {

/// Whether a part is meshed in the plane, which keeps a mechanism there.
bool has_planar_mesh(const Mechanism& mechanism);

/// Whether a motion in a plane that was found (`simulation.space = "auto"`) could leave it: a
/// disturbance out of the plane grows by more than e while it lasts (PlaneStability, at up to 21
/// records). None in space, or where the scene asks for the plane.
template <FrameGroup G>
std::vector<std::string> leaving_plane(const Scene& scene, const Model<G>& model,
                                       const Trajectory<G>& trajectory);

/// Responses whose largest value is that of the vibration after a start that strikes: weight, loads
/// and relaxed springs of t = 0 act at once on the undeformed scene. With y_0 its value at the
/// start and y_s in the equilibrium under the same loads, the vibration swings by |y_s - y_0| about
/// y_s: named where that is more than a tenth of the largest value, which exceeds |y_s| by at least
/// half of it. Asked of structures and driven mechanisms only, whose equilibrium is near the start.
template <FrameGroup G>
std::vector<std::string> struck_start(const Scene& scene, const Model<G>& model,
                                      const Trajectory<G>& trajectory,
                                      const output::Results& results);

}  // namespace liesl
