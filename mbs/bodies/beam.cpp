#include "mbs/bodies/beam.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace liesl {

template <FrameGroup G, class E>
ChainBeam<G, E>::ChainBeam(std::string body_name, std::vector<G> nodes_at_rest,
                           const std::vector<ElementSection<G>>& sections, double damping)
    : BeamChain<G>(std::move(body_name), std::move(nodes_at_rest)), damping_(damping) {
  int lawless = -1;  // slot of the element without a law
  for (int e = 0; e + 1 < this->nodes(); ++e) {
    const bool acts = !sections[e].K.isZero(0) || !sections[e].M.isZero(0);
    if (acts || lawless < 0) {
      elements_.emplace_back(this->reference[e], this->reference[e + 1], sections[e].K,
                             sections[e].M);
      if (!acts) lawless = static_cast<int>(elements_.size()) - 1;
    }
    slot_.push_back(acts ? static_cast<int>(elements_.size()) - 1 : lawless);
    if (acts) acting_.push_back(e);
  }
  assemble_constant_matrices();
  group_elements();
}

/// Those of fourth order, where each has a law.
template <FrameGroup G, class E>
void ChainBeam<G, E>::group_elements() {
  if constexpr (std::is_same_v<E, FourthOrderElement<G>>) {
    if (acting_.size() != slot_.size() ||
        !std::all_of(elements_.begin(), elements_.end(), FourElements<G>::takes))
      return;
    for (int e = 0; e < elements(); e += Lanes::size) groups_.emplace_back(elements_, e);
  }
}

template <FrameGroup G, class E>
ChainBeam<G, E>::ChainBeam(const ChainBeam& of, const std::vector<ElementSection<G>>& derivative)
    : BeamChain<G>(of.name, of.reference), damping_(of.damping_) {
  if constexpr (std::is_same_v<E, FourthOrderElement<G>>) {
    int lawless = -1;
    for (int e = 0; e < of.elements(); ++e) {
      const ElementSection<G>& by = derivative[e];
      const bool acts = !by.K.isZero(0) || !by.M.isZero(0);
      if (acts || lawless < 0) elements_.emplace_back(of.element(e), by.K, by.M);
      const int last = static_cast<int>(elements_.size()) - 1;
      if (!acts && lawless < 0) lawless = last;
      slot_.push_back(acts ? last : lawless);
      if (acts) acting_.push_back(e);
    }
    assemble_constant_matrices();
  }
}

template <FrameGroup G, class E>
void ChainBeam<G, E>::assemble_constant_matrices() {
  this->M_.resize(this->nodes());
  this->K_.resize(this->nodes());
  for (const int e : acting_) {
    this->M_.add_element(e, element(e).mass());
    this->K_.add_element(e, element(e).constant_tangent());
  }
}

template <FrameGroup G, class E>
auto ChainBeam<G, E>::rest_stiffness_of(int e, const Matrix& K) const -> Matrix {
  if constexpr (std::is_same_v<E, FourthOrderElement<G>>)
    return CondensedLaw<G>(d0(e), K).stiffness_at_rest();
  return K;
}

template <FrameGroup G, class E>
auto ChainBeam<G, E>::rest_stiffness_by(int e, const Matrix& K, const Matrix& dK) const -> Matrix {
  if constexpr (std::is_same_v<E, FourthOrderElement<G>>)
    return CondensedLaw<G>(d0(e), K).stiffness_at_rest_by(dK);
  return dK;
}

template <FrameGroup G, class E>
auto ChainBeam<G, E>::rest_stiffness_second(int e, const Matrix& K, const Matrix& K_x,
                                            const Matrix& K_y, const Matrix& K_xy) const -> Matrix {
  if constexpr (std::is_same_v<E, FourthOrderElement<G>>)
    return CondensedLaw<G>(d0(e), K).stiffness_at_rest_second(K_x, K_y, K_xy);
  return K_xy;
}

template <FrameGroup G, class E>
void ChainBeam<G, E>::add_inertia(const BodyState<G>& s, const Vector& gravity, double* r,
                                  ForceScale& scale) const {
  for (const auto& four : groups_) four.add_inertia(s, gravity, r, scale);
  if (!groups_.empty()) return;
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
  const bool grouped = !groups_.empty() && !s.stress;
  if (grouped)
    for (const auto& four : groups_) four.add_internal(s, damping_, r, scale);
  if (grouped) return;
  Pair g;
  for (const int e : acting_) {
    element(e).internal_force(s.H[e], s.H[e + 1], s.v + dim * e, damping_, g,
                              s.stress ? s.stress + dim * e : nullptr);
    Eigen::Map<Pair>(r + dim * e) += g;
    scale.add<G>(g.template head<dim>());
  }
}

template <FrameGroup G, class E>
void ChainBeam<G, E>::exact_tangent(const BodyState<G>& s, const Vector& gravity, TangentWeights w,
                                    const Tangent* stress, Matrices& A) const {
  A.set_zero();
  for (const auto& four : groups_) four.add_tangent(s, gravity, w, damping_, stress, A);
  if (!groups_.empty()) return;
  for (int e = 0; e < elements(); ++e) {
    const Element& element = this->element(e);
    const G &a = s.H[e], &b = s.H[e + 1];
    PairMatrix k = PairMatrix::Zero();
    if (w.stiffness != 0) {
      Pair acceleration;
      acceleration << apparent_acceleration<G>(s, e, gravity),
          apparent_acceleration<G>(s, e + 1, gravity);
      const double* v = s.v + dim * e;
      k = w.stiffness *
          (element.inertia_stiffness(a, b, v, acceleration, gravity) +
           element.damped_tangent(a, b, stress ? stress[e] : element.stress(a, b), v, damping_));
    }
    if (w.damping != 0) {
      k += w.damping * element.gyroscopic_tangent(a, b, s.v + dim * e);
      if (damping_ > 0) k += w.damping * element.damping_tangent(a, b, s.v + dim * e, damping_);
    }
    if (w.mass != 0) k += w.mass * element.mass(a, b);
    A.add_element(e, k);
  }
}

template <FrameGroup G, class E>
void ChainBeam<G, E>::exact_tangents(const BodyState<G>& s, const Vector& gravity,
                                     const Tangent* stress, Matrices& K, Matrices& C,
                                     Matrices& M) const {
  for (Matrices* A : {&K, &C, &M}) A->set_zero();
  for (const auto& four : groups_) four.add_tangents(s, gravity, damping_, stress, K, C, M);
  if (!groups_.empty()) return;
  Pair acceleration;
  acceleration.template tail<dim>() = apparent_acceleration<G>(s, 0, gravity);
  for (int e = 0; e < elements(); ++e) {
    const Element& element = this->element(e);
    const G &a = s.H[e], &b = s.H[e + 1];
    const double* v = s.v + dim * e;
    acceleration.template head<dim>() = acceleration.template tail<dim>();
    acceleration.template tail<dim>() = apparent_acceleration<G>(s, e + 1, gravity);
    K.add_element(e, element.inertia_stiffness(a, b, v, acceleration, gravity));
    K.add_element(
        e, element.damped_tangent(a, b, stress ? stress[e] : element.stress(a, b), v, damping_));
    C.add_element(e, element.gyroscopic_tangent(a, b, v));
    if (damping_ > 0) C.add_element(e, element.damping_tangent(a, b, v, damping_));
    M.add_element(e, element.mass(a, b));
  }
}

template <FrameGroup G, class E>
void ChainBeam<G, E>::add_spread_curvature(const BodyState<G>& s, const SpreadLoad<G>& load,
                                           double* r) const {
  if constexpr (Element::kTurnsSpreadLoads)
    for (int e = 0; e < elements(); ++e)
      Eigen::Map<Pair>(r + dim * e) += element(e).spread_curvature(s.H[e], s.H[e + 1], load);
}

template <FrameGroup G, class E>
void ChainBeam<G, E>::add_spread_curvature_tangent(const BodyState<G>& s, const SpreadLoad<G>& load,
                                                   Matrices& A) const {
  if constexpr (Element::kTurnsSpreadLoads)
    for (int e = 0; e < elements(); ++e)
      A.add_element(e, element(e).spread_curvature_tangent(s.H[e], s.H[e + 1], load));
}

template <FrameGroup G, class E>
void ChainBeam<G, E>::add_spread_derivative(const BodyState<G>& s, const SpreadLoad<G>& load,
                                            double* r) const {
  if constexpr (std::is_same_v<E, FourthOrderElement<G>>)
    for (const int e : acting_)
      Eigen::Map<Pair>(r + dim * e) += element(e).spread_derivative(s.H[e], s.H[e + 1], load);
}

template <FrameGroup G, class E>
typename ChainBeam<G, E>::Matrices ChainBeam<G, E>::load_distribution() const {
  Matrices W(this->nodes());
  for (int e = 0; e < elements(); ++e) W.add_element(e, element(e).load_shares());
  return W;
}

template <FrameGroup G, class E>
typename ChainBeam<G, E>::Tangent ChainBeam<G, E>::strain(const BodyState<G>& s, int e) const {
  return element(e).strain(s.H[e], s.H[e + 1]);
}

/// Linear in u; of a Reissner beam those of its own strains, which are linear to first order only.
template <FrameGroup G, class E>
typename Body<G>::Strains ChainBeam<G, E>::strains_at_rest(const Eigen::VectorXd& u) const {
  if (std::is_same_v<E, ReissnerElement<G>>) return Body<G>::strains_at_rest(u);
  typename Body<G>::Strains eps(dim, elements());
  for (int e = 0; e < elements(); ++e)
    eps.col(e) = BeamElement<G>::P(d0(e)) * u.segment<2 * dim>(dim * e) / length(e);
  return eps;
}

template <FrameGroup G, class E>
typename ChainBeam<G, E>::Tangent ChainBeam<G, E>::section_force(const BodyState<G>& s, int e,
                                                                 ElementPlace at) const {
  if (at == ElementPlace::Middle) return element(e).stress(s.H[e], s.H[e + 1]);
  return end_forces(s, e)[static_cast<std::size_t>(node_of(at))];
}

/// -g_A and g_B.
template <FrameGroup G, class E>
auto ChainBeam<G, E>::end_forces(const BodyState<G>& s, int e) const -> std::array<Tangent, 2> {
  Pair g;
  element(e).internal_force(s.H[e], s.H[e + 1], nullptr, 0, g);
  return {-g.template head<dim>(), g.template tail<dim>()};
}

template <FrameGroup G, class E>
void ChainBeam<G, E>::all_strains(const BodyState<G>& s, Tangent* eps) const {
  for (const auto& four : groups_) four.strains(s, eps);
  if (groups_.empty()) Body<G>::all_strains(s, eps);
}

template <FrameGroup G, class E>
void ChainBeam<G, E>::all_end_forces(const BodyState<G>& s, std::array<Tangent, 2>* n) const {
  for (const auto& four : groups_) four.end_forces(s, n);
  if (groups_.empty()) Body<G>::all_end_forces(s, n);
}

template <FrameGroup G, class E>
void ChainBeam<G, E>::extrapolate_stress(const BodyState<G>& s, const double* delta,
                                         Tangent* stress) const {
  for (int e = 0; e < elements(); ++e)
    stress[e] = element(e).extrapolated(s.H[e], s.H[e + 1], stress[e],
                                        Eigen::Map<const Pair>(delta + dim * e));
}

template <FrameGroup G, class E>
BodyEnergy ChainBeam<G, E>::energy(const BodyState<G>& s, const Vector& gravity) const {
  BodyEnergy energy;
  for (const auto& four : groups_) four.add_energy(s, gravity, energy);
  if (!groups_.empty()) return energy;
  for (int e = 0; e < elements(); ++e) {
    const Element& element = this->element(e);
    energy.kinetic += element.kinetic_energy(s.H[e], s.H[e + 1], s.v + dim * e);
    energy.elastic += element.elastic_energy(s.H[e], s.H[e + 1]);
    energy.potential += element.weight_potential(s.H[e], s.H[e + 1], gravity);
  }
  return energy;
}

template <FrameGroup G, class E>
double ChainBeam<G, E>::dissipation(const BodyState<G>& s) const {
  double power = 0;
  for (int e = 0; e < elements() && damping_ > 0; ++e)
    power += element(e).dissipation(s.H[e], s.H[e + 1], s.v + dim * e, damping_);
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
  for (const auto& e : elements_) k = std::max(k, e.axial_stiffness());
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
    const Tangent on_d = element.stress_gradient(A, B).transpose() * f;
    on_h += Element::P(Element::relative(A, B)).transpose() * on_d;
    return;
  }
  const PairMatrix k = element.tangent(A, B, element.stress(A, B));
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
    on_h += weight.elastic *
            (Element::P(Element::relative(A, B)).transpose() * element.conjugate(A, B));
  }
}

template <FrameGroup G, class E>
std::unique_ptr<Body<G>> ChainBeam<G, E>::derivative(const LawDerivative<G>& law) const {
  const auto* sections = std::get_if<std::vector<ElementSection<G>>>(&law);
  if (!sections || static_cast<int>(sections->size()) != elements())
    throw std::invalid_argument("derivative of beam '" + this->name +
                                "': expected d(K, M_s)/dp of " + std::to_string(elements()) +
                                " elements");
  if constexpr (std::is_same_v<E, FourthOrderElement<G>>)
    return std::unique_ptr<Body<G>>(new ChainBeam(*this, *sections));
  return std::make_unique<ChainBeam>(this->name, this->reference, *sections, damping_);
}

template class ChainBeam<SE2, BeamElement<SE2>>;
template class ChainBeam<SE3, BeamElement<SE3>>;
template class ChainBeam<SE2, FourthOrderElement<SE2>>;
template class ChainBeam<SE3, FourthOrderElement<SE3>>;
template class ChainBeam<SE2, ReissnerElement<SE2>>;
template class ChainBeam<SE3, ReissnerElement<SE3>>;

}  // namespace liesl
