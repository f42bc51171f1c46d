#include "mbs/system/energy.hpp"

#include <algorithm>

#include "mbs/system/penalty.hpp"

namespace liesl {
namespace {

template <FrameGroup G>
double kinetic_energy(const Model<G>& model, const State<G>& s) {
  double sum = 0;
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    sum += model.bodies[b]->energy(model.body_state(s, static_cast<int>(b)), model.gravity).kinetic;
  return sum;
}

}  // namespace

template <FrameGroup G>
BodyEnergy mechanical_energy(const Model<G>& model, const State<G>& s) {
  BodyEnergy sum;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyEnergy e =
        model.bodies[b]->energy(model.body_state(s, static_cast<int>(b)), model.gravity_at(s.t));
    sum.kinetic += e.kinetic;
    sum.elastic += e.elastic;
    sum.potential += e.potential;
  }
  for (const auto& c : model.couplings)
    for (std::size_t i = 0; i < c.rows.size(); ++i)
      if (c.rows[i].role == Role::Compliant)
        sum.elastic += c.rows[i].law.energy(s.rows[c.first_row + static_cast<int>(i)]);
  sum.elastic += penalty_energy(model, s);
  return sum;
}

template <FrameGroup G>
double weight_potential(const Model<G>& model, const State<G>& s) {
  double sum = 0;
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    sum +=
        model.bodies[b]->energy(model.body_state(s, static_cast<int>(b)), model.gravity).potential;
  return sum;
}

/// Do the gradients or rates of couplings enter the power?
template <FrameGroup G>
bool needs_couplings(const Model<G>& model) {
  return std::any_of(model.couplings.begin(), model.couplings.end(),
                     [](const Coupling<G>& c) { return c.acting > c.constraints; });
}

template <FrameGroup G>
double power(const Model<G>& model, Equations<G>& eq, const State<G>& s) {
  double p = 0;
  for (const auto& c : model.couplings)
    for (int i = 0; i < c.constraints; ++i)
      p -= s.lambda[c.first_constraint + i] * c.rows[i].target.rate(s.t);
  if (needs_couplings(model)) eq.evaluate(s, s.rows, {s.t, 1});
  for (std::size_t k = 0; k < model.couplings.size(); ++k) {
    const auto& c = model.couplings[k];
    for (int i = c.constraints; i < c.acting; ++i) {
      const ForceLaw& law = c.rows[i].law;
      const double rate = eq.couplings[k].rate[i];
      p += (law.force(s.t) - law.damping * rate) * rate;
    }
  }
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    p -= model.bodies[b]->dissipation(model.body_state(s, static_cast<int>(b)));
  return p + eq.load_power(s);
}

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

template BodyEnergy mechanical_energy(const Model<SE2>&, const State<SE2>&);
template BodyEnergy mechanical_energy(const Model<SE3>&, const State<SE3>&);
template double weight_potential(const Model<SE2>&, const State<SE2>&);
template double weight_potential(const Model<SE3>&, const State<SE3>&);
template double power(const Model<SE2>&, Equations<SE2>&, const State<SE2>&);
template double power(const Model<SE3>&, Equations<SE3>&, const State<SE3>&);
template SE2::Tangent momentum(const Model<SE2>&, const State<SE2>&);
template SE3::Tangent momentum(const Model<SE3>&, const State<SE3>&);

}  // namespace liesl
