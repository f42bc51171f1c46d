#include "apps/tasks/motion_notes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "mbs/solvers/plane_stability.hpp"
#include "mbs/solvers/statics.hpp"
#include "mbs/system/constraint_rank.hpp"
#include "mbs/system/response_value.hpp"

namespace liesl {
namespace {

constexpr int kStates = 21;         // at which stability is asked
constexpr double kGrown = 1;        // exponent of a disturbance that a user should know of
constexpr double kStruck = 0.1;     // of the largest value
constexpr double kOvershoot = 0.5;  // of the swing
constexpr double kStatic = 1e-8;    // tolerance of the equilibrium

/// Of deformation and internal forces: what a start can strike.
bool is_struck(ResponseKind kind) {
  switch (kind) {
    case ResponseKind::Displacement:
    case ResponseKind::Deflection:
    case ResponseKind::Elongation:
    case ResponseKind::JointForce:
    case ResponseKind::SectionForce:
    case ResponseKind::Stress:
    case ResponseKind::Compliance:
      return true;
    default:
      return false;
  }
}

/// The equilibrium under the loads of t = 0. @returns false if there is none
template <FrameGroup G>
bool equilibrium(const Model<G>& model, SimulationOptions o, State<G>& s) {
  o.type = SimulationType::Static;
  o.tolerance = kStatic;
  o.at = 0;
  o.max_load = 1;
  o.arc_length = o.critical = false;
  const StaticResult<G> found = solve_static(model, o);
  if (found.report.status != SolveStatus::Converged) return false;
  found.trajectory.read(found.trajectory.size() - 1, s);
  model.complete(s);
  return true;
}

}  // namespace

bool has_planar_mesh(const Mechanism& mechanism) {
  return std::any_of(mechanism.bodies.begin(), mechanism.bodies.end(), [](const BodySpec& body) {
    return std::holds_alternative<SolidSpec>(body.kind);
  });
}

template <>
std::vector<std::string> leaving_plane(const Scene&, const Model<SE3>&, const Trajectory<SE3>&) {
  return {};
}

template <>
std::vector<std::string> leaving_plane(const Scene& scene, const Model<SE2>& model,
                                       const Trajectory<SE2>& trajectory) {
  const SimulationOptions& o = scene.simulation;
  if (o.type != SimulationType::Dynamic || o.space != SpaceChoice::Auto) return {};
  if (has_planar_mesh(scene.mechanism) || trajectory.size() < 2) return {};
  PlaneStability stability(scene.mechanism, model);
  State<SE2> s = model.initial_state();
  const int last = trajectory.size() - 1, count = std::min(kStates, trajectory.size());
  double exponent = 0, fastest = 0, at = 0;
  for (int i = 0; i < count; ++i) {
    trajectory.read(static_cast<int>(static_cast<long>(last) * i / (count - 1)), s);
    const auto growth = stability.growth(s);
    if (!growth) return {};
    exponent += *growth * trajectory.time(last) / count;
    if (*growth > fastest) {
      fastest = *growth;
      at = s.t;
    }
  }
  if (exponent <= kGrown) return {};
  return {fmt::format(
      "the motion may leave the plane: at t = {:.4g} s a disturbance out of it grows by e in "
      "{:.3g} s, while none is in the scene; simulation.space = \"spatial\" with a small load or "
      "offset out of the plane shows it, \"planar\" keeps the plane and this note away",
      at, 1 / fastest)};
}

template <FrameGroup G>
std::vector<std::string> struck_start(const Scene& scene, const Model<G>& model,
                                      const Trajectory<G>& trajectory,
                                      const output::Results& results) {
  const SimulationOptions& o = scene.simulation;
  const Formalism formalism = scene.mechanism.formalism;
  if (o.type != SimulationType::Dynamic || o.start != StartChoice::Assembled ||
      trajectory.size() < 2 || formalism == Formalism::Rigid ||
      scene.responses.size() != results.responses.size())
    return {};
  if (std::none_of(scene.responses.begin(), scene.responses.end(),
                   [](const ResponseSpec& r) { return is_struck(r.kind); }))
    return {};
  Mechanism still = scene.mechanism;  // floating frames are for motions only
  const bool floating = formalism == Formalism::Floating;
  if (floating) still.formalism = Formalism::SE3;
  std::optional<Model<G>> nodal;
  if (floating) nodal = Model<G>::build(still, model.space);
  const Model<G>& of = floating ? *nodal : model;
  State<G> start = of.initial_state(), rest = start;
  if (!floating) trajectory.read(0, start);
  if (mobility(of, start).free > 0 || !equilibrium(of, o, rest)) return {};
  const ResponseValues<G> values(still, of);
  std::vector<std::string> names;
  double largest_share = 0;
  for (std::size_t i = 0; i < scene.responses.size(); ++i) {
    const ResponseSpec& r = scene.responses[i];
    const auto& peak = results.responses[i].peak;
    if (!is_struck(r.kind) || !peak || peak->size == 0) continue;
    const Eigen::VectorXd at_rest = values(r, rest);
    const double swing = (at_rest - values(r, start)).norm();
    if (swing <= kStruck * peak->size || peak->size < at_rest.norm() + kOvershoot * swing) continue;
    names.push_back("'" + r.name + "'");
    largest_share = std::max(largest_share, swing / peak->size);
  }
  if (names.empty()) return {};
  return {fmt::format(
      "weight, loads or springs strike the undeformed scene at t = 0: the vibration of this start "
      "makes up to {:.0f} % of the largest {}; simulation.start = \"equilibrium\", or a ramp of "
      "gravity_scale and loads.*.scale, is without it",
      100 * largest_share, fmt::join(names, ", "))};
}

template std::vector<std::string> struck_start(const Scene&, const Model<SE2>&,
                                               const Trajectory<SE2>&, const output::Results&);
template std::vector<std::string> struck_start(const Scene&, const Model<SE3>&,
                                               const Trajectory<SE3>&, const output::Results&);

}  // namespace liesl
