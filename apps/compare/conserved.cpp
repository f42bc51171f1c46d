#include "apps/compare/conserved.hpp"

#include <algorithm>
#include <cmath>

#include "mbs/system/response_value.hpp"

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

template <FrameGroup G>
double kinetic_energy(const Model<G>& model, const State<G>& s) {
  double sum = 0;
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    sum += model.bodies[b]->energy(model.body_state(s, static_cast<int>(b)), model.gravity).kinetic;
  return sum;
}

}  // namespace

template <FrameGroup G>
typename G::Tangent momentum(const Model<G>& model, const State<G>& s) {
  // A rigid velocity e of the whole, seen from a node: Ad(H^-1) e.
  typename G::Tangent p;
  const double size = std::max(1e-3, s.v.cwiseAbs().maxCoeff());
  State<G> shifted = s;
  for (int i = 0; i < G::dim; ++i) {
    double energy[2];
    for (const int side : {0, 1}) {
      const typename G::Tangent e = (side == 0 ? size : -size) * G::Tangent::Unit(i);
      for (std::size_t b = 0; b < model.bodies.size(); ++b)
        for (int point = 0; point < model.bodies[b]->points(); ++point) {
          const int k = model.first_node(static_cast<int>(b)) + point, at = G::dim * k;
          shifted.v.template segment<G::dim>(at) =
              s.v.template segment<G::dim>(at) + s.H[k].AdInv() * e;
        }
      energy[side] = kinetic_energy(model, shifted);
    }
    p[i] = (energy[0] - energy[1]) / (2 * size);
  }
  return p;
}

template <FrameGroup G>
Drift drift(const Mechanism& mechanism, const Model<G>& model, const Trajectory<G>& trajectory) {
  constexpr int sd = G::space_dim, rd = G::rotation_dim;
  const int first = free_from(mechanism, trajectory);
  Drift drift;
  if (trajectory.size() - first < 2 || !keeps_energy(mechanism)) return drift;
  const bool free = keeps_momentum(mechanism);
  ResponseSpec energy;
  energy.kind = ResponseKind::Energy;
  const ResponseValues<G> values(mechanism, model);
  State<G> s = model.initial_state();
  double E0 = 0, dE = 0, du = 0, dw = 0;
  typename G::Tangent p0 = G::Tangent::Zero();
  for (int n = first; n < trajectory.size(); ++n) {
    trajectory.read(n, s);
    const double E = values(energy, s)[0];
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

template SE2::Tangent momentum(const Model<SE2>&, const State<SE2>&);
template SE3::Tangent momentum(const Model<SE3>&, const State<SE3>&);
template Drift drift(const Mechanism&, const Model<SE2>&, const Trajectory<SE2>&);
template Drift drift(const Mechanism&, const Model<SE3>&, const Trajectory<SE3>&);

}  // namespace liesl
