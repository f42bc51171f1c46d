#include "apps/tasks/part_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>

#include "mbs/linalg/stop_request.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/volume_fraction.hpp"
#include "mbs/solvers/part_motion.hpp"

namespace liesl {
namespace {

using Eigen::VectorXd;

constexpr int kCompared = 12;       // frequencies, or as many as are below what is wanted
constexpr int kMostCompared = 192;  // but no more
constexpr int kMostModes = 200;     // of bodies.*.solid.modes
constexpr double kNearEnough = 0.01;
constexpr double kLeftOut = 1e-3;  // share of the loads' energy above the highest harmonic kept

/// The lowest frequency that is off, or the highest compared: what all are right below.
double right_up_to(const VectorXd& full, const VectorXd& reduced) {
  for (Eigen::Index i = 0; i < full.size(); ++i)
    if (i >= reduced.size() || std::abs(reduced[i] / full[i] - 1) > kNearEnough) return full[i];
  return full.size() > 0 ? full[full.size() - 1] : 0;
}

/// Lowest frequencies of the mesh, up to above `wanted`.
VectorXd mesh_frequencies(const SolidModel& solid, const VectorXd& v, double wanted) {
  const int most = std::min(kMostCompared, solid.size() - solid.rigid_count() - 1);
  VectorXd full;
  for (int count = std::min(kCompared, most);; count = std::min(2 * count, most)) {
    full = free_frequencies(solid, v, count);
    if (full.size() < count || count == most || full[count - 1] > wanted) return full;
  }
}

/// Free-free frequencies with so many internal modes.
using ByModes = std::function<VectorXd(int)>;

/// The fewest modes, up to `most`, that are right up to `wanted`; more never make them worse.
std::optional<int> fewest_modes(const VectorXd& full, const ByModes& reduced, int most,
                                double wanted) {
  std::vector<int> numbers(most + 1);
  std::iota(numbers.begin(), numbers.end(), 0);
  const auto found = std::partition_point(numbers.begin(), numbers.end(), [&](int kept) {
    return right_up_to(full, reduced(kept)) < wanted;
  });
  return found == numbers.end() ? std::nullopt : std::optional(*found);
}

/// ... of the part with twice as many modes, and so on.
std::optional<int> more_modes(const SolidModel& solid, const VectorXd& v, const VectorXd& full,
                              int modes, double wanted) {
  const int rigid = solid.rigid_count(), ports = rigid * solid.ports(),
            most = std::min(kMostModes, solid.size() - ports - 1);
  while (modes < most) {
    modes = std::min(most, std::max(kCompared, 2 * modes));
    const ReducedSolid all = reduce(solid, v, ReductionKind::CraigBampton, modes);
    if (!all.converged) return {};
    const auto reduced = [&](int kept) {
      ReducedSolid part;
      part.K = all.K.topLeftCorner(ports + kept, ports + kept);
      part.M = all.M.topLeftCorner(ports + kept, ports + kept);
      return free_frequencies(part, rigid, static_cast<int>(full.size()));
    };
    if (const auto found = fewest_modes(full, reduced, modes, wanted)) return found;
  }
  return {};
}

/// @param harmonic the highest of its loads, Hz; 0: there are none
template <FrameGroup G>
void describe_part(output::RunSummary& summary, const SolidBody<G>& body, const SolidSpec& spec,
                   double harmonic) {
  const SolidModel& solid = body.model();
  const VectorXd &v = body.fractions(), full = mesh_frequencies(solid, v, 2 * harmonic);
  // Where even the frequencies of the mesh end below, these are all that can be asked for.
  const double wanted = std::min(2 * harmonic, full.size() > 0 ? full[full.size() - 1] : 0);
  const auto reduced = [&](int kept) {
    return body.free_frequencies(static_cast<int>(full.size()), kept);
  };
  const VectorXd own = reduced(spec.modes);
  const double limit = right_up_to(full, own);
  const auto needed = limit < wanted ? more_modes(solid, v, full, spec.modes, wanted)
                                     : fewest_modes(full, reduced, spec.modes, wanted);
  nlohmann::ordered_json& part = summary.more["parts"][body.name];
  part = {{"cells", spec.mesh().cell_count()},
          {"unknowns", body.basis().cols()},
          {"modes", spec.modes},
          {"mass", body.total_mass()},
          {"free_hz", std::vector<double>(full.begin(), full.end())},
          {"reduced_hz", std::vector<double>(own.begin(), own.end())},
          {"right_up_to_hz", limit},
          {"harmonic_hz", harmonic},
          {"harmonic_share", kLeftOut},
          {"modes_needed", nullptr}};
  if (needed) part["modes_needed"] = *needed;
  if (limit < wanted)
    summary.warnings.push_back(fmt::format(
        "the modes of '{}' are accurate up to {:.4g} Hz only, twice the highest harmonic of its "
        "loads is {:.4g} Hz: {}",
        body.name, limit, 2 * harmonic,
        needed ? fmt::format("bodies.{}.solid.modes = {} would do", body.name, *needed)
               : "the modes that were tried do not do, the mesh may be too coarse"));
}

}  // namespace

template <FrameGroup G>
void describe_parts(output::RunSummary& summary, const Mechanism& mechanism, const Model<G>& model,
                    const Trajectory<G>& trajectory, bool motion) {
  std::vector<double> times;  // of records, which are not read where there are no parts
  for (size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const auto* body = SolidBody<G>::of(*model.bodies[b]);
    if (!body) continue;
    for (int n = static_cast<int>(times.size()); n < trajectory.size(); ++n)
      times.push_back(trajectory.time(n));
    const Eigen::MatrixXd e = part_coordinates(*body, model.first_node(int(b)), trajectory);
    try {
      describe_part(summary, *body, std::get<SolidSpec>(mechanism.bodies[b].kind),
                    motion ? bandwidth(times, energy_signals(*body, e), kLeftOut) : 0);
    } catch (const Stopped&) {
      summary.warnings.push_back(fmt::format(
          "the modes of '{}' were not compared with its mesh: stopped on request", body->name));
    }
  }
}

template void describe_parts(output::RunSummary&, const Mechanism&, const Model<SE2>&,
                             const Trajectory<SE2>&, bool);
template void describe_parts(output::RunSummary&, const Mechanism&, const Model<SE3>&,
                             const Trajectory<SE3>&, bool);

}  // namespace liesl
