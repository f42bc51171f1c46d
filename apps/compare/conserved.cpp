#include "apps/compare/conserved.hpp"

#include <algorithm>
#include <cmath>

#include "mbs/system/energy.hpp"

namespace liesl {

namespace {

/// Does a drive or a law put energy in or take it out?
bool keeps_energy(const Mechanism& m) {
  const auto still = [](const TimeFunction& f) { return f.is_constant(); };
  return std::all_of(m.drives.begin(), m.drives.end(),
                     [&](const DriveSpec& d) { return still(d.motion); }) &&
         std::all_of(m.forces.begin(), m.forces.end(),
                     [&](const ForceSpec& f) {
                       return f.damping == 0 && still(f.force) && f.force(0) == 0;
                     }) &&
         std::all_of(m.bodies.begin(), m.bodies.end(), [](const BodySpec& b) {
           const auto* beam = std::get_if<BeamSpec>(&b.kind);
           return !beam || beam->damping == 0;
         });
}

bool keeps_momentum(const Mechanism& m) {
  const auto free = [](const Port& a, const Port& b) { return a.body >= 0 && b.body >= 0; };
  return m.gravity.isZero() &&
         std::all_of(m.joints.begin(), m.joints.end(),
                     [&](const JointSpec& j) { return free(j.a, j.b); }) &&
         std::all_of(m.forces.begin(), m.forces.end(),
                     [&](const ForceSpec& f) { return f.joint >= 0 || free(f.a, f.b); });
}

/// First record from which on no load acts.
template <FrameGroup G>
int free_from(const Mechanism& m, const Trajectory<G>& trajectory) {
  int n = trajectory.size();
  const auto acts = [&](double t) {
    return std::any_of(m.loads.begin(), m.loads.end(),
                       [&](const LoadSpec& load) { return load.scale(t) != 0; });
  };
  while (n > 0 && !acts(trajectory.time(n - 1))) --n;
  return n;
}

}  // namespace

template <FrameGroup G>
Drift drift(const Mechanism& mechanism, const Model<G>& model, const Trajectory<G>& trajectory) {
  constexpr int sd = G::space_dim, rd = G::rotation_dim;
  const int first = free_from(mechanism, trajectory);
  Drift drift;
  if (trajectory.size() - first < 2 || !keeps_energy(mechanism)) return drift;
  const bool free = keeps_momentum(mechanism);
  State<G> s = model.initial_state();
  double E0 = 0, dE = 0, du = 0, dw = 0;
  typename G::Tangent p0 = G::Tangent::Zero();
  for (int n = first; n < trajectory.size(); ++n) {
    trajectory.read(n, s);
    const double E = total(mechanical_energy(model, s));
    if (n == first) E0 = E;
    dE = std::max(dE, std::abs(E - E0));
    if (!free) continue;
    const typename G::Tangent p = momentum(model, s);
    if (n == first) p0 = p;
    du = std::max(du, (p - p0).template head<sd>().norm());
    dw = std::max(dw, (p - p0).template tail<rd>().norm());
  }
  drift.energy = dE;
  if (free) {
    drift.momentum = du;
    drift.angular_momentum = dw;
  }
  return drift;
}

template Drift drift(const Mechanism&, const Model<SE2>&, const Trajectory<SE2>&);
template Drift drift(const Mechanism&, const Model<SE3>&, const Trajectory<SE3>&);

}  // namespace liesl
