#include "mbs/bodies/beam.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace liesl {

template <FrameGroup G, class E>
ChainBeam<G, E>::ChainBeam(std::string body_name, std::vector<G> nodes_at_rest,
                           const std::vector<ElementSection<G>>& sections, double damping)
    : Body<G>(std::move(body_name), std::move(nodes_at_rest)), damping_(damping) {
  this->M_.resize(this->nodes());
  this->K_.resize(this->nodes());
  int lawless = -1;  // slot of the element without a law
  for (int e = 0; e + 1 < this->nodes(); ++e) {
    const bool acts = !sections[e].K.isZero(0) || !sections[e].M.isZero(0);
    if (acts || lawless < 0) {
      elements_.emplace_back(this->reference[e], this->reference[e + 1], sections[e].K,
                             sections[e].M);
      if (!acts) lawless = static_cast<int>(elements_.size()) - 1;
    }
    slot_.push_back(acts ? static_cast<int>(elements_.size()) - 1 : lawless);
    if (!acts) continue;
    acting_.push_back(e);
    this->M_.add_element(e, element(e).mass());
    this->K_.add_element(e, element(e).constant_tangent());
  }
}

template <FrameGroup G, class E>
void ChainBeam<G, E>::add_inertia(const BodyState<G>& s, const Vector& gravity, double* r,
                                  ForceScale& scale) const {
  Pair acceleration, g;
  const bool heavy = gravity.squaredNorm() > 0;
  int known = -1;  // node whose acceleration is the second one
  for (const int e : acting_) {
    acceleration.template head<dim>() = known == e ? Tangent(acceleration.template tail<dim>())
                                                   : apparent_acceleration<G>(s, e, gravity);
    known = e + 1;
    acceleration.template tail<dim>() = apparent_acceleration<G>(s, e + 1, gravity);
    element(e).inertia_force(s.H[e], s.H[e + 1], s.v + dim * e, acceleration, g);
    if (heavy) element(e).add_weight_curvature(s.H[e], s.H[e + 1], gravity, g);
    Eigen::Map<Pair>(r + dim * e) += g;
    scale.add<G>(g.template head<dim>());
    scale.add<G>(g.template tail<dim>());
  }
}

template <FrameGroup G, class E>
void ChainBeam<G, E>::add_internal(const BodyState<G>& s, double* r, ForceScale& scale) const {
  Pair g;
  for (const int e : acting_) {
    element(e).internal_force(s.H[e], s.H[e + 1], s.v + dim * e, damping_, g);
    Eigen::Map<Pair>(r + dim * e) += g;
    scale.add<G>(g.template head<dim>());
  }
}

/// With damping c the stress is n + c K P v/L, whose strain rate P(d) v changes with d, too.
template <FrameGroup G, class E>
auto ChainBeam<G, E>::element_stiffness(const BodyState<G>& s, int e, Tangent n, const Pair& a,
                                        const Vector& gravity) const -> PairMatrix {
  const Element& element = this->element(e);
  const G &A = s.H[e], &B = s.H[e + 1];
  const double* v = s.v + dim * e;
  PairMatrix k = element.inertia_stiffness(A, B, v, a, gravity);
  if (damping_ > 0) {
    const Tangent d = Element::relative(A, B);
    const typename Element::Gradient P = Element::P(d);
    const typename G::Matrix K = element.section_stiffness() * (damping_ / element.length());
    n += K * (P * Eigen::Map<const Pair>(v));
    k += P.transpose() * K * Element::dP(d, v) * P;
  }
  return k + element.tangent(A, B, n);
}

template <FrameGroup G, class E>
void ChainBeam<G, E>::exact_tangent(const BodyState<G>& s, const Vector& gravity, TangentWeights w,
                                    const Tangent* stress, Matrices& A) const {
  A.set_zero();
  for (int e = 0; e < elements(); ++e) {
    const Element& element = this->element(e);
    const G &a = s.H[e], &b = s.H[e + 1];
    PairMatrix k = PairMatrix::Zero();
    if (w.stiffness != 0) {
      Pair acceleration;
      acceleration << apparent_acceleration<G>(s, e, gravity),
          apparent_acceleration<G>(s, e + 1, gravity);
      k = w.stiffness *
          element_stiffness(s, e, stress ? stress[e] : section_force(s, e, ElementPlace::Middle),
                            acceleration, gravity);
    }
    if (w.damping != 0) {
      k += w.damping * element.gyroscopic_tangent(a, b, s.v + dim * e);
      if (damping_ > 0) k += w.damping * damping_ * element.material_tangent(a, b);
    }
    if (w.mass != 0) k += w.mass * element.mass(a, b);
    A.add_element(e, k);
  }
}

template <FrameGroup G, class E>
void ChainBeam<G, E>::add_spread_curvature(const BodyState<G>& s, const Vector& q,
                                           double* r) const {
  if constexpr (Element::kTurnsSpreadLoads)
    for (int e = 0; e < elements(); ++e)
      Eigen::Map<Pair>(r + dim * e) += element(e).spread_curvature(s.H[e], s.H[e + 1], q);
}

template <FrameGroup G, class E>
void ChainBeam<G, E>::add_spread_curvature_tangent(const BodyState<G>& s, const Vector& q,
                                                   Matrices& A) const {
  if constexpr (Element::kTurnsSpreadLoads)
    for (int e = 0; e < elements(); ++e)
      A.add_element(e, element(e).spread_curvature_tangent(s.H[e], s.H[e + 1], q));
}

template <FrameGroup G, class E>
typename ChainBeam<G, E>::Matrices ChainBeam<G, E>::load_distribution() const {
  Matrices W(this->nodes());
  for (int e = 0; e < elements(); ++e) W.add_element(e, element(e).integral(G::Matrix::Identity()));
  return W;
}

template <FrameGroup G, class E>
typename ChainBeam<G, E>::Tangent ChainBeam<G, E>::strain(const BodyState<G>& s, int e) const {
  return element(e).strain(s.H[e], s.H[e + 1]);
}

template <FrameGroup G, class E>
typename ChainBeam<G, E>::Tangent ChainBeam<G, E>::section_force(const BodyState<G>& s, int e,
                                                                 ElementPlace at) const {
  const Tangent n = element(e).section_stiffness() * strain(s, e);
  if (at == ElementPlace::Middle) return n;
  const auto P = Element::P(Element::relative(s.H[e], s.H[e + 1]));
  if (at == ElementPlace::First) return -P.template leftCols<dim>().transpose() * n;
  return P.template rightCols<dim>().transpose() * n;
}

template <FrameGroup G, class E>
void ChainBeam<G, E>::extrapolate_stress(const BodyState<G>& s, const double* delta,
                                         Tangent* stress) const {
  for (int e = 0; e < elements(); ++e) {
    const Element& element = this->element(e);
    const Tangent d = Element::relative(s.H[e], s.H[e + 1]);
    const Tangent change = Element::P(d) * Eigen::Map<const Pair>(delta + dim * e);
    stress[e] = element.section_stiffness() * (d - element.d0() + change) / element.length();
  }
}

template <FrameGroup G, class E>
BodyEnergy ChainBeam<G, E>::energy(const BodyState<G>& s, const Vector& gravity) const {
  BodyEnergy energy;
  for (int e = 0; e < elements(); ++e) {
    const Element& element = this->element(e);
    const Eigen::Map<const Pair> v(s.v + dim * e);
    const Tangent eps = strain(s, e);
    energy.kinetic += 0.5 * v.dot(element.mass(s.H[e], s.H[e + 1]) * v);
    energy.elastic += 0.5 * element.length() * eps.dot(element.section_stiffness() * eps);
    energy.potential += element.weight_potential(s.H[e], s.H[e + 1], gravity);
  }
  return energy;
}

template <FrameGroup G, class E>
double ChainBeam<G, E>::dissipation(const BodyState<G>& s) const {
  double power = 0;
  for (int e = 0; e < elements() && damping_ > 0; ++e) {
    const Element& element = this->element(e);
    const Tangent rate =
        Element::P(Element::relative(s.H[e], s.H[e + 1])) * Eigen::Map<const Pair>(s.v + dim * e);
    power += damping_ / element.length() * rate.dot(element.section_stiffness() * rate);
  }
  return power;
}

template <FrameGroup G, class E>
double ChainBeam<G, E>::total_mass() const {
  double m = 0;
  for (const auto& e : elements_) m += e.length() * e.section_inertia()(0, 0);
  return m;
}

template <FrameGroup G, class E>
double ChainBeam<G, E>::axial_stiffness() const {
  double k = 0;
  for (const auto& e : elements_) k = std::max(k, e.section_stiffness()(0, 0) / e.length());
  return k;
}

/// In the middle that of the strain, at the nodes the transposed tangent of the elastic force.
template <FrameGroup G, class E>
void ChainBeam<G, E>::add_section_force_gradient(const BodyState<G>& s, int e, ElementPlace at,
                                                 const Tangent& f, double* h) const {
  const Element& element = this->element(e);
  const G &A = s.H[e], &B = s.H[e + 1];
  Eigen::Map<Pair> on_h(h + dim * e);
  if (at == ElementPlace::Middle) {
    const Tangent on_strain = element.section_stiffness().transpose() * f / element.length();
    on_h += Element::P(Element::relative(A, B)).transpose() * on_strain;
    return;
  }
  const PairMatrix k = element.tangent(A, B, section_force(s, e, ElementPlace::Middle));
  if (at == ElementPlace::First)
    on_h -= k.template topRows<dim>().transpose() * f;
  else
    on_h += k.template bottomRows<dim>().transpose() * f;
}

/// dT/dv = M v, dV/dh = P^T K eps.
template <FrameGroup G, class E>
void ChainBeam<G, E>::add_energy_gradient(const BodyState<G>& s, const Vector& gravity,
                                          const BodyEnergy& weight, double* h, double* v) const {
  for (int e = 0; e < elements(); ++e) {
    const Element& element = this->element(e);
    const G &A = s.H[e], &B = s.H[e + 1];
    const Eigen::Map<const Pair> V(s.v + dim * e);
    Eigen::Map<Pair> on_h(h + dim * e), on_v(v + dim * e);
    on_v += weight.kinetic * (element.mass(A, B) * V);
    on_h += weight.kinetic * element.kinetic_gradient(A, B, s.v + dim * e);
    on_h += weight.potential * element.weight_gradient(A, B, gravity);
    on_h += weight.elastic * (Element::P(Element::relative(A, B)).transpose() *
                              section_force(s, e, ElementPlace::Middle));
  }
}

template <FrameGroup G, class E>
std::unique_ptr<Body<G>> ChainBeam<G, E>::derivative(const LawDerivative<G>& law) const {
  const auto* sections = std::get_if<std::vector<ElementSection<G>>>(&law);
  if (!sections || static_cast<int>(sections->size()) != elements())
    throw std::invalid_argument("derivative of beam '" + this->name +
                                "': expected d(K, M_s)/dp of " + std::to_string(elements()) +
                                " elements");
  return std::make_unique<ChainBeam>(this->name, this->reference, *sections, damping_);
}

template class ChainBeam<SE2, BeamElement<SE2>>;
template class ChainBeam<SE3, BeamElement<SE3>>;
template class ChainBeam<SE2, ReissnerElement<SE2>>;
template class ChainBeam<SE3, ReissnerElement<SE3>>;

}  // namespace liesl
